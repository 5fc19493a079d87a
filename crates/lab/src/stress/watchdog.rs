//! Which landings are under way: among them are those that panic, and those that take forever.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use touchdown_sweep::threads::run::Observer;

/// Time between two checks for landings that take too long.
const POLL_INTERVAL: Duration = Duration::from_secs(1);

/// An observer that records the landings under way and passes everything on to another.
pub struct Watchdog<'o, O> {
    observer: &'o O,
    underway: Mutex<HashMap<usize, Instant>>,
}

impl<'o, O: Observer> Watchdog<'o, O> {
    /// A watchdog in front of an observer.
    pub fn before(observer: &'o O) -> Self {
        Self {
            observer,
            underway: Mutex::default(),
        }
    }

    /// Runs work and observes its landings; `on_timeout` is called with those that have not ended within
    /// `patience`.
    ///
    /// # Errors
    /// The landings under way when one panicked.
    pub fn over<T>(
        &self,
        patience: Duration,
        on_timeout: impl Fn(&[usize]) + Send,
        work: impl FnOnce() -> T,
    ) -> Result<T, Vec<usize>> {
        let (end, ended) = channel::<()>();
        thread::scope(|scope| {
            scope.spawn(move || {
                while ended.recv_timeout(POLL_INTERVAL.min(patience))
                    == Err(RecvTimeoutError::Timeout)
                {
                    let old = self.older_than(patience);
                    if !old.is_empty() {
                        on_timeout(&old);
                    }
                }
            });
            // Other threads end what they have begun with: what is still under way then, lay beside what panicked.
            let done = catch_unwind(AssertUnwindSafe(work));
            drop(end);
            done.map_err(|_| self.older_than(Duration::ZERO))
        })
    }

    fn older_than(&self, age: Duration) -> Vec<usize> {
        let underway = self.underway();
        let old = underway.iter().filter(|(_, since)| since.elapsed() >= age);
        let mut old: Vec<usize> = old.map(|(point, _)| *point).collect();
        old.sort_unstable();
        old
    }

    fn underway(&self) -> MutexGuard<'_, HashMap<usize, Instant>> {
        self.underway.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<O: Observer> Observer for Watchdog<'_, O> {
    fn begin(&self, point: usize) {
        self.underway().insert(point, Instant::now());
        self.observer.begin(point);
    }

    fn more(&self, points: usize) {
        self.observer.more(points);
    }

    fn skip(&self, points: usize) {
        self.observer.skip(points);
    }

    fn landing(&self) {
        self.observer.landing();
    }

    fn point(&self, point: usize) {
        self.underway().remove(&point);
        self.observer.point(point);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Duration = Duration::from_secs(100);

    #[test]
    fn landings_that_panic_are_among_those_known() {
        let guard = Watchdog::before(&());
        let land = |point: usize| {
            guard.begin(point);
            assert_ne!(point, 2);
            guard.point(point);
        };
        assert_eq!(guard.over(LONG, |_| (), || [0, 1].map(land)), Ok([(); 2]));
        assert_eq!(
            guard.over(LONG, |_| (), || [1, 2, 3].map(land)),
            Err(vec![2])
        );
    }

    #[test]
    fn landings_that_take_forever_are_known() {
        let guard = Watchdog::before(&());
        let (on_timeout, timed_out) = channel();
        let work = || {
            guard.begin(7);
            // Forever: until somebody has despaired of it.
            let old = timed_out.recv();
            guard.point(7);
            old
        };
        let on_timeout = |old: &[usize]| on_timeout.send(old.to_vec()).unwrap();
        let done = guard.over(Duration::from_millis(1), on_timeout, work);
        assert_eq!(done, Ok(Ok(vec![7])));
    }
}
