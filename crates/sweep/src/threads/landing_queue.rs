//! The queue between searches, which request landings, and threads, which compute them.
//!
//! A search needs the results of some landings before it can request the next, while the lanes of a batch need many
//! landings at the same time. So many searches run concurrently. They take almost no time, so they all run on one of the
//! threads that compute batches, between its steps; their requests wait here for all threads.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::pin::pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll, Wake, Waker};

use futures::channel::oneshot;
use futures::executor::block_on;
use touchdown_dynamics::batch::{Occupancy, Request, land_many};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// Landings that were requested and not yet started.
pub(crate) struct LandingQueue {
    threads: usize,
    queue: Mutex<Queue>,
    changed: Condvar,
    /// Length of the queue, which threads read without the lock before every step.
    waiting: AtomicUsize,
    /// True if a search has received a landing and may continue.
    has_landed: AtomicBool,
}

/// A landing that a search waits for.
struct PendingLanding {
    request: Request,
    search: oneshot::Sender<Landing>,
}

struct Queue {
    /// Ordered by search, then by time of request, so that searches finish roughly in order.
    requests: BTreeMap<(usize, usize), PendingLanding>,
    /// Number of requests so far; it gives each its key.
    count: usize,
    /// Landings in progress.
    under_way: usize,
    /// Threads waiting for a request.
    idle: usize,
    is_closed: bool,
}

impl LandingQueue {
    /// An empty queue for a number of threads.
    pub(crate) fn new(threads: usize) -> Self {
        Self {
            threads,
            queue: Mutex::new(Queue {
                requests: BTreeMap::new(),
                count: 0,
                under_way: 0,
                idle: 0,
                is_closed: false,
            }),
            changed: Condvar::new(),
            waiting: AtomicUsize::new(0),
            has_landed: AtomicBool::new(true),
        }
    }

    fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Requests a landing for search number `search` and waits for it; `None` if the queue is closed.
    pub(crate) async fn landing(
        &self,
        search: usize,
        vehicle: Arc<Vehicle>,
        scene: Scene,
        settings: Settings,
    ) -> Option<Landing> {
        let (sender, landing) = oneshot::channel();
        self.request(search, vehicle, scene, settings, sender);
        landing.await.ok()
    }

    fn request(
        &self,
        search: usize,
        vehicle: Arc<Vehicle>,
        scene: Scene,
        settings: Settings,
        sender: oneshot::Sender<Landing>,
    ) {
        let mut queue = self.queue();
        if !queue.is_closed {
            let key = queue.count;
            let request = Request {
                key,
                vehicle,
                scene,
                settings,
            };
            let pending = PendingLanding {
                request,
                search: sender,
            };
            queue.requests.insert((search, key), pending);
            queue.count += 1;
            self.waiting.fetch_add(1, Ordering::Relaxed);
            if queue.idle > 0 {
                self.changed.notify_one();
            }
        }
    }

    /// Drops all requests. Threads return once they finish the landings in progress.
    pub(crate) fn close(&self) {
        let mut queue = self.queue();
        queue.is_closed = true;
        self.waiting.store(0, Ordering::Relaxed);
        self.changed.notify_all();
        let requests = std::mem::take(&mut queue.requests);
        // Dropping a request wakes its search, which locks the queue.
        drop(queue);
        drop(requests);
    }

    /// Waits for a request or, with `searches`, for a search that may continue; returns false if the queue is closed.
    fn wait(&self, searches: bool) -> bool {
        let is_idle = |queue: &mut Queue| {
            let may_search = searches && self.has_landed.load(Ordering::Acquire);
            !queue.is_closed && queue.requests.is_empty() && !may_search
        };
        let mut queue = self.queue();
        queue.idle += 1;
        let mut queue = (self.changed)
            .wait_while(queue, is_idle)
            .unwrap_or_else(PoisonError::into_inner);
        queue.idle -= 1;
        !queue.is_closed
    }

    /// Takes the next landing for a thread with `under_way` landings. A thread gets at most an equal share of all, so
    /// that none waits while another has many.
    fn take(&self, under_way: usize) -> Option<PendingLanding> {
        if self.waiting.load(Ordering::Relaxed) == 0 {
            return None;
        }
        let mut queue = self.queue();
        let all = queue.requests.len() + queue.under_way;
        if under_way >= all.div_ceil(self.threads) {
            return None;
        }
        let (_, request) = queue.requests.pop_first()?;
        queue.under_way += 1;
        self.waiting.fetch_sub(1, Ordering::Relaxed);
        Some(request)
    }

    /// Computes requested landings until the queue is closed.
    pub(crate) fn land(&self) {
        self.land_with(land_many, None);
    }

    /// Runs searches on this thread, computing landings in between; returns their result and closes the queue.
    pub(crate) fn search<T>(self: &Arc<Self>, searches: impl Future<Output = T>) -> T {
        let waker = Waker::from(Arc::clone(self));
        let mut context = Context::from_waker(&waker);
        let mut searches = pin!(searches);
        let mut result = None;
        let mut search = || {
            if result.is_none()
                && self.has_landed.swap(false, Ordering::AcqRel)
                && let Poll::Ready(found) = searches.as_mut().poll(&mut context)
            {
                result = Some(found);
                self.close();
            }
        };
        self.land_with(land_many, Some(&mut search));
        // A panic in another thread also closes the queue and drops the pending requests.
        result.unwrap_or_else(|| block_on(searches))
    }

    /// As [`Self::land`], with another function for batches and an action before every step.
    fn land_with(
        &self,
        land_many: impl Fn(
            &mut dyn FnMut() -> Option<Request>,
            &mut dyn FnMut(usize, Landing),
        ) -> Occupancy,
        mut search: Option<&mut dyn FnMut()>,
    ) {
        // If a landing panics, the other threads must not wait forever.
        let _close = CloseOnDrop(self);
        let under_way = RefCell::new(HashMap::new());
        while self.wait(search.is_some()) {
            let mut next = || {
                if let Some(search) = &mut search {
                    search();
                }
                let mut under_way = under_way.borrow_mut();
                let PendingLanding { request, search } = self.take(under_way.len())?;
                under_way.insert(request.key, search);
                Some(request)
            };
            land_many(&mut next, &mut |key, landing| {
                self.queue().under_way -= 1;
                if let Some(search) = under_way.borrow_mut().remove(&key) {
                    // The search may have been dropped.
                    let _ = search.send(landing);
                }
            });
        }
    }
}

/// A search has received a landing.
impl Wake for LandingQueue {
    fn wake(self: Arc<Self>) {
        self.has_landed.store(true, Ordering::Release);
        if self.queue().idle > 0 {
            self.changed.notify_all();
        }
    }
}

/// Closes a queue when dropped, also in a panic.
struct CloseOnDrop<'q>(&'q LandingQueue);

impl Drop for CloseOnDrop<'_> {
    fn drop(&mut self) {
        self.0.close();
    }
}

#[cfg(test)]
mod tests {

    use touchdown_dynamics::scene::CrushRule;

    use super::*;
    use crate::examples::surveyor;
    use touchdown_input::sweeps::measured_scenes::near_boundary;

    /// Requests a landing without waiting for it.
    fn ask(queue: &LandingQueue, search: usize) {
        let vehicle = surveyor().vehicle;
        let scene = near_boundary(false).unwrap()[0];
        let settings = Settings::new(3e-4, 0.05, CrushRule::default()).unwrap();
        let (sender, _) = oneshot::channel();
        queue.request(search, Arc::new(vehicle), scene, settings, sender);
    }

    /// A landing that panics.
    fn broken(
        next: &mut dyn FnMut() -> Option<Request>,
        _: &mut dyn FnMut(usize, Landing),
    ) -> Occupancy {
        assert!(next().is_none(), "broken");
        Occupancy::default()
    }

    #[test]
    fn a_panic_in_one_thread_ends_the_others() {
        let queue = LandingQueue::new(2);
        ask(&queue, 0);
        let panicked = std::thread::scope(|scope| {
            let threads = [(), ()].map(|()| scope.spawn(|| queue.land_with(broken, None)));
            threads.map(|thread| thread.join().is_err())
        });
        assert_eq!(panicked.iter().filter(|panicked| **panicked).count(), 1);
    }

    #[test]
    fn threads_take_the_first_searches_first_and_at_most_an_equal_share() {
        let queue = LandingQueue::new(2);
        assert!(queue.take(0).is_none());
        for search in [2, 1, 1] {
            ask(&queue, search);
        }
        let take = |under_way| queue.take(under_way).map(|pending| pending.request.key);
        assert_eq!([take(0), take(1), take(2)], [Some(1), Some(2), None]);
        assert_eq!([take(0), take(1)], [Some(0), None]);
        ask(&queue, 3);
        queue.close();
        ask(&queue, 3);
        assert_eq!((take(0), queue.wait(false)), (None, false));
    }
}
