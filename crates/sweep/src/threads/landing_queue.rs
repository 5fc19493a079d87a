//! Where searches ask for landings, and threads find them.
//!
//! A search has to know some landings before it asks for the next, while lanes want many landings at a time. So
//! many searches go on at a time, all of them on one thread, as next to nothing of the time is theirs; what
//! they ask for waits here for the threads that land side by side.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use futures::channel::oneshot;
use touchdown_dynamics::batch::{Occupancy, Request, land_many};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// Landings that were asked for and nobody has begun with.
pub(crate) struct LandingQueue {
    threads: usize,
    queue: Mutex<Queue>,
    changed: Condvar,
    /// How many are in the queue: threads look here before every step.
    waiting: AtomicUsize,
}

/// A landing that a search waits for.
struct PendingLanding {
    request: Request,
    search: oneshot::Sender<Landing>,
}

struct Queue {
    /// By the number of the search, and in what order they were asked for: what was begun with is to be ended first.
    asked: BTreeMap<(usize, usize), PendingLanding>,
    /// How many were ever asked for.
    count: usize,
    /// Landings that threads have begun with.
    under_way: usize,
    is_closed: bool,
}

impl LandingQueue {
    /// An landing_queue for so many threads that land.
    pub(crate) fn new(threads: usize) -> Self {
        Self {
            threads,
            queue: Mutex::new(Queue {
                asked: BTreeMap::new(),
                count: 0,
                under_way: 0,
                is_closed: false,
            }),
            changed: Condvar::new(),
            waiting: AtomicUsize::new(0),
        }
    }

    fn queue(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Asks for a landing of the `search`-th search and waits for it; `None` when the landing_queue was closed.
    pub(crate) async fn landing(
        &self,
        search: usize,
        vehicle: Arc<Vehicle>,
        scene: Scene,
        settings: Settings,
    ) -> Option<Landing> {
        let (sender, landing) = oneshot::channel();
        self.ask(search, vehicle, scene, settings, sender);
        landing.await.ok()
    }

    fn ask(
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
            let asked = PendingLanding {
                request,
                search: sender,
            };
            queue.asked.insert((search, key), asked);
            queue.count += 1;
            self.waiting.fetch_add(1, Ordering::Relaxed);
            self.changed.notify_one();
        }
    }

    /// Lets all threads go once they have ended what they have begun with.
    pub(crate) fn close(&self) {
        let mut queue = self.queue();
        queue.is_closed = true;
        queue.asked.clear();
        self.waiting.store(0, Ordering::Relaxed);
        self.changed.notify_all();
    }

    /// Waits until a landing is asked for; false when none will be.
    fn wait(&self) -> bool {
        let is_idle = |queue: &mut Queue| !queue.is_closed && queue.asked.is_empty();
        let queue = (self.changed)
            .wait_while(self.queue(), is_idle)
            .unwrap_or_else(PoisonError::into_inner);
        !queue.is_closed
    }

    /// The next landing for a thread that has so many under way. It gets no more than its share, so that none has
    /// many while another has few.
    fn take(&self, under_way: usize) -> Option<PendingLanding> {
        if self.waiting.load(Ordering::Relaxed) == 0 {
            return None;
        }
        let mut queue = self.queue();
        let all = queue.asked.len() + queue.under_way;
        if under_way >= all.div_ceil(self.threads) {
            return None;
        }
        let (_, request) = queue.asked.pop_first()?;
        queue.under_way += 1;
        self.waiting.fetch_sub(1, Ordering::Relaxed);
        Some(request)
    }

    /// Lands what is asked for until the landing_queue is closed.
    pub(crate) fn land(&self) {
        self.land_with(land_many);
    }

    /// The same with another way to land.
    fn land_with(
        &self,
        land_many: impl Fn(
            &mut dyn FnMut() -> Option<Request>,
            &mut dyn FnMut(usize, Landing),
        ) -> Occupancy,
    ) {
        // Should a landing panic, no other thread waits for more.
        let _rest = CloseOnDrop(self);
        let under_way = RefCell::new(HashMap::new());
        while self.wait() {
            let mut next = || {
                let mut under_way = under_way.borrow_mut();
                let PendingLanding { request, search } = self.take(under_way.len())?;
                under_way.insert(request.key, search);
                Some(request)
            };
            land_many(&mut next, &mut |key, landing| {
                self.queue().under_way -= 1;
                if let Some(search) = under_way.borrow_mut().remove(&key) {
                    // Nobody waits for the landings of a search that was given up.
                    let _ = search.send(landing);
                }
            });
        }
    }
}

/// CloseOnDrop an landing_queue in the end, come what may.
pub(crate) struct CloseOnDrop<'e>(pub(crate) &'e LandingQueue);

impl Drop for CloseOnDrop<'_> {
    fn drop(&mut self) {
        self.0.close();
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use touchdown_dynamics::scene::CrushRule;

    use super::*;
    use crate::measured_scenes::near_boundary;
    use crate::vehicle_file::VehicleFile;

    /// Asks for a landing that nobody waits for.
    fn ask(landing_queue: &LandingQueue, search: usize) {
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../sweeps/vehicles/surveyor-table-4-1.toml"
        );
        let vehicle = VehicleFile::read(Path::new(file)).unwrap().vehicle;
        let scene = near_boundary(false).unwrap()[0];
        let settings = Settings::new(3e-4, 0.05, CrushRule::default()).unwrap();
        let (sender, _) = oneshot::channel();
        landing_queue.ask(search, Arc::new(vehicle), scene, settings, sender);
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
    fn a_thread_that_panics_lets_the_others_go() {
        let landing_queue = LandingQueue::new(2);
        ask(&landing_queue, 0);
        let panicked = std::thread::scope(|scope| {
            let threads = [(), ()].map(|()| scope.spawn(|| landing_queue.land_with(broken)));
            threads.map(|thread| thread.join().is_err())
        });
        assert_eq!(panicked.iter().filter(|panicked| **panicked).count(), 1);
    }

    #[test]
    fn threads_get_the_first_searches_first_and_no_more_than_their_share() {
        let landing_queue = LandingQueue::new(2);
        assert!(landing_queue.take(0).is_none());
        for search in [2, 1, 1] {
            ask(&landing_queue, search);
        }
        let take = |under_way| landing_queue.take(under_way).map(|asked| asked.request.key);
        assert_eq!([take(0), take(1), take(2)], [Some(1), Some(2), None]);
        assert_eq!([take(0), take(1)], [Some(0), None]);
        ask(&landing_queue, 3);
        landing_queue.close();
        ask(&landing_queue, 3);
        assert_eq!((take(0), landing_queue.wait()), (None, false));
    }
}
