//! Where searches ask for landings, and threads find them.
//!
//! A search has to know one landing before it asks for the next, while lanes want many landings at a time. So
//! many searches go on at a time, all of them on one thread, as next to nothing of the time is theirs; what
//! they ask for waits here for the threads that land side by side.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::future::poll_fn;
use std::ops::Deref;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::task::Poll;

use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::landing::abreast::{Request, land_many};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// Landings that were asked for and nobody has begun with.
pub(crate) struct Exchange<V> {
    threads: usize,
    queue: Mutex<Queue<V>>,
    changed: Condvar,
    /// How many are in the queue: threads look here before every step.
    waiting: AtomicUsize,
}

struct Queue<V> {
    requests: VecDeque<Request<usize, V>>,
    /// Landings that threads have begun with.
    under_way: usize,
    is_closed: bool,
}

impl<V> Exchange<V> {
    /// An exchange for so many threads that land.
    pub(crate) fn between(threads: usize) -> Self {
        Self {
            threads,
            queue: Mutex::new(Queue {
                requests: VecDeque::new(),
                under_way: 0,
                is_closed: false,
            }),
            changed: Condvar::new(),
            waiting: AtomicUsize::new(0),
        }
    }

    fn queue(&self) -> MutexGuard<'_, Queue<V>> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Asks for a landing.
    pub(crate) fn ask(&self, request: Request<usize, V>) {
        self.queue().requests.push_back(request);
        self.waiting.fetch_add(1, Ordering::Relaxed);
        self.changed.notify_one();
    }

    /// Lets all threads go once they have ended what they have begun with.
    pub(crate) fn close(&self) {
        let mut queue = self.queue();
        queue.is_closed = true;
        queue.requests.clear();
        self.waiting.store(0, Ordering::Relaxed);
        self.changed.notify_all();
    }

    /// Waits until a landing is asked for; false when none will be.
    fn wait(&self) -> bool {
        let is_idle = |queue: &mut Queue<V>| !queue.is_closed && queue.requests.is_empty();
        let queue = (self.changed)
            .wait_while(self.queue(), is_idle)
            .unwrap_or_else(PoisonError::into_inner);
        !queue.is_closed
    }

    /// The next landing for a thread that has so many under way. It gets no more than its share, so that none has
    /// many while another has few.
    fn take(&self, under_way: usize) -> Option<Request<usize, V>> {
        if self.waiting.load(Ordering::Relaxed) == 0 {
            return None;
        }
        let mut queue = self.queue();
        let all = queue.requests.len() + queue.under_way;
        if under_way >= all.div_ceil(self.threads) {
            return None;
        }
        let request = queue.requests.pop_front()?;
        queue.under_way += 1;
        self.waiting.fetch_sub(1, Ordering::Relaxed);
        Some(request)
    }

    /// Lands what is asked for until the exchange is closed; `done` gets each landing with its key.
    pub(crate) fn land<const LEGS: usize>(&self, mut done: impl FnMut(usize, Landing<LEGS>))
    where
        V: Deref<Target = Vehicle<LEGS>>,
    {
        // Should a landing panic, no other thread waits for more.
        let _rest = Closes(self);
        let under_way = Cell::new(0);
        while self.wait() {
            let next = || {
                let request = self.take(under_way.get())?;
                under_way.set(under_way.get() + 1);
                Some(request)
            };
            land_many(next, |key, landing| {
                under_way.set(under_way.get() - 1);
                self.queue().under_way -= 1;
                done(key, landing);
            });
        }
    }
}

/// Closes an exchange in the end, come what may.
pub(crate) struct Closes<'e, V>(pub(crate) &'e Exchange<V>);

impl<V> Drop for Closes<'_, V> {
    fn drop(&mut self) {
        self.0.close();
    }
}

/// By which one search gets its landings.
pub(crate) struct Asker<'e, V, const LEGS: usize> {
    pub(crate) exchange: &'e Exchange<V>,
    /// What its landings are told by.
    pub(crate) key: usize,
    /// Where the landing goes that it asked for.
    pub(crate) answer: &'e RefCell<Option<Landing<LEGS>>>,
}

impl<V, const LEGS: usize> Asker<'_, V, LEGS> {
    /// Computes a landing, while other searches go on.
    pub(crate) async fn land(&self, vehicle: V, scene: Scene, settings: Settings) -> Landing<LEGS> {
        self.exchange.ask(Request {
            key: self.key,
            vehicle,
            scene,
            settings,
        });
        poll_fn(|_| match self.answer.take() {
            Some(landing) => Poll::Ready(landing),
            None => Poll::Pending,
        })
        .await
    }
}

#[cfg(test)]
mod tests {
    use touchdown_dynamics::scene::CrushRule;

    use super::*;
    use crate::measured_scenes::near_boundary;

    /// What no landing bears.
    struct Broken;

    impl Deref for Broken {
        type Target = Vehicle<3>;

        fn deref(&self) -> &Vehicle<3> {
            panic!("broken");
        }
    }

    fn request(key: usize) -> Request<usize, Broken> {
        Request {
            key,
            vehicle: Broken,
            scene: near_boundary(false).unwrap()[0],
            settings: Settings::new(3e-4, 0.05, CrushRule::default()).unwrap(),
        }
    }

    #[test]
    fn a_thread_that_panics_lets_the_others_go() {
        let exchange = Exchange::between(2);
        exchange.ask(request(0));
        let panicked = std::thread::scope(|scope| {
            let threads = [(), ()].map(|()| scope.spawn(|| exchange.land::<3>(|_, _| {})));
            threads.map(|thread| thread.join().is_err())
        });
        assert_eq!(panicked.iter().filter(|panicked| **panicked).count(), 1);
    }

    #[test]
    fn threads_get_what_was_asked_first_and_no_more_than_their_share() {
        let exchange = Exchange::between(2);
        assert!(exchange.take(0).is_none());
        (0..3).for_each(|key| exchange.ask(request(key)));
        let take = |under_way| exchange.take(under_way).map(|request| request.key);
        assert_eq!([take(0), take(1), take(2)], [Some(0), Some(1), None]);
        assert_eq!([take(0), take(1)], [Some(2), None]);
        exchange.ask(request(3));
        exchange.close();
        assert_eq!((take(0), exchange.wait()), (None, false));
    }
}
