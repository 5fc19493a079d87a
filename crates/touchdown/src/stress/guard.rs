//! Which landings are under way: of them are those that panic, and those that take forever.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use touchdown_sweep::run::Observer;

/// How often it is seen whether a landing takes forever.
const GLANCE: Duration = Duration::from_secs(1);

/// An observer that stands before another and knows what is under way.
pub struct Guard<'o, O> {
    observer: &'o O,
    underway: Mutex<HashMap<ThreadId, (usize, Instant)>>,
}

impl<'o, O: Observer> Guard<'o, O> {
    /// Stands before an observer.
    pub fn before(observer: &'o O) -> Self {
        Self {
            observer,
            underway: Mutex::default(),
        }
    }

    /// Does work that this guard observes; `despair` is called with the landings that have not ended
    /// within `patience`.
    ///
    /// # Errors
    /// The landings that panicked.
    pub fn over<T>(
        &self,
        patience: Duration,
        despair: impl Fn(&[usize]) + Send,
        work: impl FnOnce() -> T,
    ) -> Result<T, Vec<usize>> {
        let (end, ended) = channel::<()>();
        thread::scope(|scope| {
            scope.spawn(move || {
                while ended.recv_timeout(GLANCE.min(patience)) == Err(RecvTimeoutError::Timeout) {
                    let old = self.older_than(patience);
                    if !old.is_empty() {
                        despair(&old);
                    }
                }
            });
            // Threads that go on do so to the end of the work: what is still under way then, panicked.
            let done = catch_unwind(AssertUnwindSafe(work));
            drop(end);
            done.map_err(|_| self.older_than(Duration::ZERO))
        })
    }

    fn older_than(&self, age: Duration) -> Vec<usize> {
        let underway = self.underway();
        let old = underway
            .values()
            .filter(|(_, since)| since.elapsed() >= age);
        old.map(|(point, _)| *point).collect()
    }

    fn underway(&self) -> MutexGuard<'_, HashMap<ThreadId, (usize, Instant)>> {
        self.underway.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<O: Observer> Observer for Guard<'_, O> {
    fn begin(&self, point: usize) {
        let now = Instant::now();
        self.underway().insert(thread::current().id(), (point, now));
        self.observer.begin(point);
    }

    fn landing(&self) {
        self.observer.landing();
    }

    fn point(&self) {
        self.underway().remove(&thread::current().id());
        self.observer.point();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Duration = Duration::from_secs(100);

    #[test]
    fn landings_that_panic_are_known() {
        let guard = Guard::before(&());
        let land = |point: usize| {
            guard.begin(point);
            assert_ne!(point, 2);
            guard.point();
        };
        assert_eq!(guard.over(LONG, |_| (), || [0, 1].map(land)), Ok([(); 2]));
        assert_eq!(
            guard.over(LONG, |_| (), || [1, 2, 3].map(land)),
            Err(vec![2])
        );
    }

    #[test]
    fn landings_that_take_forever_are_known() {
        let guard = Guard::before(&());
        let (despair, despaired) = channel();
        let work = || {
            guard.begin(7);
            // Forever: until somebody has despaired of it.
            let old = despaired.recv();
            guard.point();
            old
        };
        let despair = |old: &[usize]| despair.send(old.to_vec()).unwrap();
        let done = guard.over(Duration::from_millis(1), despair, work);
        assert_eq!(done, Ok(Ok(vec![7])));
    }
}
