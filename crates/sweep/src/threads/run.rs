//! Computes landings on all cores.
//!
//! Many points are searched at a time and landings are distributed one by one, so that all cores and the lanes of their
//! registers are busy to the end. The result of a point goes to the journal at once and is not kept in memory. Landings
//! are independent, so results do not depend on the threads.

mod cases;
mod points;

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Poll, ready};

use futures::future::poll_fn;
use futures::stream::{self, StreamExt};
use thiserror::Error;
use touchdown_input::sweeps::case::CaseFault;

use crate::journal::JournalError;
use crate::threads::landing_queue::LandingQueue;

/// Points searched at a time per thread: as many as it has landings in progress, if each asks for one at a time.
const SEARCHES: usize = 16;

/// Allowed threads per core, and the limit for few cores: more only slow a run down.
const THREADS_PER_CORE: usize = 4;
const LEAST_THREAD_LIMIT: usize = 16;

/// Progress callbacks, called from all threads.
pub trait Observer: Sync {
    /// Computation of a point of the grid, by number, begins, while others are in progress.
    fn begin(&self, _point: usize) {}
    /// The number of wanted points has grown by this much.
    fn more(&self, _points: usize) {}
    /// An earlier run has finished so many points.
    fn skip(&self, _points: usize) {}
    /// A landing was computed.
    fn landing(&self) {}
    /// A point of the grid, or a case, by number, is done.
    fn point(&self, _point: usize) {}
}

/// Ignores progress.
impl Observer for () {}

/// Reason why a run has no result.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RunError {
    /// The run was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// The run was cancelled; what is finished is kept in this journal.
    #[error("cancelled; what is finished is kept in {}", .0.display())]
    Kept(PathBuf),
    /// A point of the grid has no valid input.
    #[error("the point {place} has no valid input: {fault}")]
    Point {
        /// Its coordinates in words.
        place: String,
        /// The fault.
        fault: CaseFault,
    },
    /// Results could not be stored.
    #[error(transparent)]
    Journal(JournalError),
    /// More threads requested than allowed on this machine.
    #[error(
        "threads = {asked}: expected 1 to {most} on this machine; results do not depend on them"
    )]
    TooManyThreads {
        /// Threads requested.
        asked: usize,
        /// Greatest number allowed.
        most: usize,
    },
    /// The threads could not be started.
    #[error("threads cannot be started: {0}")]
    Threads(rayon::ThreadPoolBuildError),
}

/// The threads that compute landings.
#[derive(Debug)]
pub struct Workers {
    pool: rayon::ThreadPool,
}

impl Workers {
    /// Starts `threads` threads, or one per core.
    ///
    /// # Errors
    /// If they exceed both four per core and 16, or the system cannot start them.
    pub fn start(threads: Option<NonZeroUsize>) -> Result<Self, RunError> {
        let cores = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        let most = LEAST_THREAD_LIMIT.max(THREADS_PER_CORE * cores);
        if let Some(asked) = threads.map(NonZeroUsize::get)
            && asked > most
        {
            return Err(RunError::TooManyThreads { asked, most });
        }
        rayon::ThreadPoolBuilder::new()
            // Zero lets rayon count the cores.
            .num_threads(threads.map_or(0, NonZeroUsize::get))
            .build()
            .map(|pool| Self { pool })
            .map_err(RunError::Threads)
    }

    /// Runs `work` on these threads, which it may share with rayon.
    pub fn within<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Searches points with `search`, `at_a_time` per thread, and passes each result to `keep`; all threads compute
    /// their landings. Also calls `keep` from time to time without a new result.
    ///
    /// # Errors
    /// The first error of a search or of `keep`, or that the run was stopped.
    fn search<T>(
        &self,
        points: impl Iterator<Item = usize>,
        at_a_time: usize,
        stop: &Stop,
        search: impl AsyncFn(usize, &LandingQueue) -> Result<T, RunError>,
        mut keep: impl FnMut(Option<(usize, T)>) -> Result<(), JournalError>,
    ) -> Result<(), RunError> {
        let landing_queue = &Arc::new(LandingQueue::new(self.threads()));
        self.pool.in_place_scope(|scope| {
            // This thread is the first.
            for _ in 1..self.threads() {
                scope.spawn(|_| landing_queue.land());
            }
            let search = &search;
            let searches =
                points.map(|point| async move { (point, search(point, landing_queue).await) });
            let mut searches = stream::iter(searches).buffer_unordered(at_a_time * self.threads());
            landing_queue.search(poll_fn(|context| {
                // Runs whenever a search has received a landing.
                stop.go_on()?;
                keep(None).map_err(RunError::Journal)?;
                while let Some((point, result)) = ready!(searches.poll_next_unpin(context)) {
                    keep(Some((point, result?))).map_err(RunError::Journal)?;
                }
                Poll::Ready(Ok(()))
            }))
        })
    }
}

/// Stop flag: set if the run was cancelled from outside or has finished early.
struct Stop<'c> {
    cancelled: &'c AtomicBool,
    ended: AtomicBool,
}

impl<'c> Stop<'c> {
    fn on(cancelled: &'c AtomicBool) -> Self {
        let ended = AtomicBool::new(false);
        Self { cancelled, ended }
    }

    fn stop(&self) {
        self.ended.store(true, Ordering::Relaxed);
    }

    fn go_on(&self) -> Result<(), RunError> {
        match self.cancelled.load(Ordering::Relaxed) || self.ended.load(Ordering::Relaxed) {
            true => Err(RunError::Cancelled),
            false => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicUsize;

    use touchdown_dynamics::batch::Request;
    use touchdown_dynamics::land::land;
    use touchdown_dynamics::landing::Landing;
    use touchdown_dynamics::scene::{CrushRule, Scene, Settings};
    use touchdown_dynamics::vehicle::Vehicle;

    use super::*;
    use crate::examples::surveyor;
    use touchdown_input::sweeps::measured_scenes::near_boundary;

    fn workers(threads: usize) -> Workers {
        Workers::start(NonZeroUsize::new(threads)).unwrap()
    }

    /// The vehicle, scenes and settings of short landings.
    fn short_landings() -> (Arc<Vehicle>, Vec<Scene>, Settings) {
        let vehicle = surveyor().vehicle;
        let settings = Settings::new(3e-4, 0.3, CrushRule::default()).unwrap();
        (Arc::new(vehicle), near_boundary(false).unwrap(), settings)
    }

    /// Counts landings and cancels at one of them.
    struct CancelsAt<'c>(usize, AtomicUsize, &'c AtomicBool);

    impl Observer for CancelsAt<'_> {
        fn landing(&self) {
            if self.1.fetch_add(1, Ordering::Relaxed) + 1 == self.0 {
                self.2.store(true, Ordering::Relaxed);
            }
        }
    }

    #[test]
    fn cases_come_in_order_for_any_number_of_threads_and_stop_when_told() {
        let (vehicle, scenes, settings) = short_landings();
        // More than all threads have under way.
        let scenes = scenes.repeat(5);
        let expected: Vec<_> = (scenes.iter())
            .map(|scene| land(&vehicle, scene, &settings))
            .collect();
        for threads in [1, 2, 3] {
            let cancel = AtomicBool::new(false);
            let cases = |observer: &CancelsAt| {
                let request = |key: usize| Request {
                    key,
                    vehicle: Arc::clone(&vehicle),
                    scene: scenes[key],
                    settings,
                };
                workers(threads).cases(scenes.len(), request, observer, &cancel)
            };
            let never = CancelsAt(0, AtomicUsize::new(0), &cancel);
            assert_eq!(cases(&never).unwrap(), expected);
            assert_eq!(never.1.into_inner(), scenes.len());
            let soon = CancelsAt(3, AtomicUsize::new(0), &cancel);
            assert!(matches!(cases(&soon), Err(RunError::Cancelled)));
            assert!(soon.1.into_inner() < scenes.len());
        }
    }

    #[test]
    fn searches_get_the_landings_that_they_ask_for_and_every_point_is_kept_once() {
        let (vehicle, scenes, settings) = short_landings();
        let land = |point: usize| land(&vehicle, &scenes[point % scenes.len()], &settings);
        // As many landings as they may, and none too.
        let landings = |point| (point..point + point % 5).collect::<Vec<usize>>();
        let expected: Vec<(usize, Vec<Landing>)> = (0..100)
            .map(|point| (point, landings(point).into_iter().map(land).collect()))
            .collect();
        let cancel = AtomicBool::new(false);
        for threads in [1, 2, 3] {
            let stop = Stop::on(&cancel);
            let search = async |point: usize, landing_queue: &LandingQueue| {
                let mut landed = Vec::new();
                for landing in landings(point) {
                    let scene = scenes[landing % scenes.len()];
                    let landing =
                        landing_queue.landing(point, Arc::clone(&vehicle), scene, settings);
                    landed.push(landing.await.unwrap());
                }
                Ok(landed)
            };
            let mut kept = Vec::new();
            let keep = |finished: Option<_>| {
                kept.extend(finished);
                Ok(())
            };
            workers(threads)
                .search(0..100, SEARCHES, &stop, search, keep)
                .unwrap();
            kept.sort_by_key(|(point, _)| *point);
            assert_eq!(kept, expected);
        }
    }

    #[test]
    fn what_cannot_be_kept_ends_the_run() {
        let cancel = AtomicBool::new(false);
        let stop = Stop::on(&cancel);
        let mut kept = 0;
        let keep = |finished: Option<(usize, usize)>| {
            kept += usize::from(finished.is_some());
            match kept {
                5 => Err(JournalError::Gone("here".into())),
                _ => Ok(()),
            }
        };
        let search = async |point, _: &LandingQueue| Ok(point);
        let ended = workers(2).search(0.., SEARCHES, &stop, search, keep);
        assert!(matches!(ended, Err(RunError::Journal(_))));
        assert_eq!(kept, 5);
    }

    #[test]
    fn cancelling_stops_before_the_next_landing() {
        let (vehicle, scenes, settings) = short_landings();
        let cancel = AtomicBool::new(false);
        let landings = AtomicUsize::new(0);
        let stop = Stop::on(&cancel);
        let search = async |point: usize, landing_queue: &LandingQueue| {
            loop {
                stop.go_on()?;
                let scene = scenes[point % scenes.len()];
                let landing = landing_queue.landing(point, Arc::clone(&vehicle), scene, settings);
                assert!(landing.await.is_some());
                if landings.fetch_add(1, Ordering::Relaxed) == 50 {
                    cancel.store(true, Ordering::Relaxed);
                }
            }
        };
        let ended = workers(2).search(
            0..,
            SEARCHES,
            &stop,
            search,
            |_: Option<(usize, ())>| Ok(()),
        );
        assert!(matches!(ended, Err(RunError::Cancelled)));
        assert_eq!(landings.into_inner(), 51);
    }
}
