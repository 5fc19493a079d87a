//! Landings on all cores.
//!
//! Many points are searched concurrently, and their landings are distributed one by one, so that all cores and all lanes
//! are busy to the end. The result of a point goes to the journal at once and does not stay in memory. A landing does not
//! depend on any other, so results do not depend on the number of threads.

use std::cell::Cell;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::task::{Poll, ready};

use futures::executor::block_on;
use futures::future::poll_fn;
use futures::stream::{self, StreamExt};
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::landing::Landing;

use super::landing_queue::{CloseOnDrop, LandingQueue};
use super::point::{self, Stop};
pub use super::run_error::{Observer, RunError};
use crate::early_stop::EarlyStop;
use crate::findings::Finding;
use crate::journal::{JournalError, Opened};
use crate::shard::Shard;
use crate::sweep_file::Sweep;

/// Points searched concurrently for each thread: as many as the landings that it has under way, if each search requests one
/// at a time.
const SEARCHES: usize = 16;

/// Threads allowed for each core, and on any machine. More only slow a run down.
const THREADS_PER_CORE: usize = 4;
const LEAST_THREAD_LIMIT: usize = 16;

/// The threads that compute landings.
#[derive(Debug)]
pub struct Workers {
    pool: rayon::ThreadPool,
}

impl Workers {
    /// Starts `threads` threads, or one for each core.
    ///
    /// # Errors
    /// When they are more than four a core, and more than 16, or the system does not let them start.
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

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Runs other work on these threads, so that its parallel parts start no more.
    pub fn lend<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// Computes every point of a shard that the journal does not have yet, into the journal.
    ///
    /// # Errors
    /// When `cancel` becomes true, which is checked before every landing, or a result cannot be written. The journal keeps
    /// what was written until then.
    pub fn sweep(
        &self,
        sweep: &Sweep,
        shard: Shard,
        opened: &mut Opened,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<(), RunError> {
        let mut early_stop = EarlyStop::of(sweep, shard, opened).map_err(RunError::Journal)?;
        let Opened { journal, done, .. } = opened;
        let points = done.missing().map(|index| shard.point(index));
        let stop = Stop::on(cancel);
        if early_stop.is_enough {
            return Ok(());
        }
        let search = async |point, queue: &LandingQueue| {
            observer.begin(point);
            let finding = point::compute(sweep, point, queue, observer, &stop).await?;
            observer.point(point);
            Ok(finding)
        };
        let result = self.search(points, &stop, search, |finished| {
            if let Some((point, finding)) = finished {
                journal.add(point, &finding.encode())?;
                if early_stop.is_enough_with(sweep, point, finding) {
                    stop.stop();
                }
            }
            journal.tick()
        });
        let result = match (early_stop.is_enough, result) {
            (true, Err(RunError::Cancelled)) if !cancel.load(Ordering::Relaxed) => Ok(()),
            (_, result) => result,
        };
        // The journal is finished in any case; the first error counts.
        result.and(journal.finish().map_err(RunError::Journal))
    }

    /// Computes some points, in their order.
    ///
    /// # Errors
    /// When the input of one of them is not valid.
    pub fn points(&self, sweep: &Sweep, points: &[usize]) -> Result<Vec<Finding>, RunError> {
        let never = AtomicBool::new(false);
        let stop = Stop::on(&never);
        let mut findings: Vec<(usize, Finding)> = Vec::with_capacity(points.len());
        let search = async |index: usize, queue: &LandingQueue| {
            point::compute(sweep, points[index], queue, &(), &stop).await
        };
        self.search(0..points.len(), &stop, search, |finished| {
            findings.extend(finished);
            Ok(())
        })?;
        findings.sort_by_key(|(index, _)| *index);
        Ok(findings.into_iter().map(|(_, finding)| finding).collect())
    }

    /// Runs `search` for many points concurrently while all threads compute their landings, and passes each result to `keep`.
    /// `keep` is also called without a result from time to time.
    ///
    /// # Errors
    /// The first error of a search or of `keep`, or that the run is to end.
    fn search<T>(
        &self,
        points: impl Iterator<Item = usize>,
        stop: &Stop,
        search: impl AsyncFn(usize, &LandingQueue) -> Result<T, RunError>,
        mut keep: impl FnMut(Option<(usize, T)>) -> Result<(), JournalError>,
    ) -> Result<(), RunError> {
        let queue = &LandingQueue::new(self.threads());
        self.pool.in_place_scope(|scope| {
            scope.spawn_broadcast(move |_, _| queue.land());
            let _close = CloseOnDrop(queue);
            let search = &search;
            let searches = points.map(|point| async move { (point, search(point, queue).await) });
            let mut searches = stream::iter(searches).buffer_unordered(SEARCHES * self.threads());
            block_on(poll_fn(|context| {
                // Polled whenever a search has received a landing.
                stop.check()?;
                keep(None).map_err(RunError::Journal)?;
                while let Some((point, result)) = ready!(searches.poll_next_unpin(context)) {
                    keep(Some((point, result?))).map_err(RunError::Journal)?;
                }
                Poll::Ready(Ok(()))
            }))
        })
    }

    /// Computes `count` landings in batches on all threads. `request` gives each by its index, which is its key too.
    ///
    /// # Errors
    /// When `cancel` becomes true, which is checked before every landing.
    pub fn cases(
        &self,
        count: usize,
        request: impl Fn(usize) -> Request + Sync,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<Vec<Landing>, RunError> {
        let stop = Stop::on(cancel);
        let next_key = AtomicUsize::new(0);
        let landings = Mutex::new(vec![None; count]);
        // A batch leaves an equal share to the other threads.
        let share = count.div_ceil(self.threads());
        self.pool.broadcast(|_| {
            let under_way = Cell::new(0);
            let mut next = || {
                if under_way.get() == share || stop.check().is_err() {
                    return None;
                }
                let key = next_key.fetch_add(1, Ordering::Relaxed);
                if key >= count {
                    return None;
                }
                under_way.set(under_way.get() + 1);
                Some(request(key))
            };
            land_many(&mut next, &mut |key, landing| {
                under_way.set(under_way.get() - 1);
                observer.landing();
                observer.point(key);
                landings.lock().unwrap_or_else(PoisonError::into_inner)[key] = Some(landing);
            });
        });
        let landings = landings
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner);
        landings
            .into_iter()
            .collect::<Option<_>>()
            .ok_or(RunError::Cancelled)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use touchdown_dynamics::land::land;
    use touchdown_dynamics::scene::{CrushRule, Scene, Settings};
    use touchdown_dynamics::vehicle::Vehicle;

    use super::*;
    use crate::measured_scenes::near_boundary;
    use crate::vehicle_file::VehicleFile;

    fn workers(threads: usize) -> Workers {
        Workers::start(NonZeroUsize::new(threads)).unwrap()
    }

    /// The vehicle, scenes and settings of short landings.
    fn short_landings() -> (Arc<Vehicle>, Vec<Scene>, Settings) {
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../sweeps/vehicles/surveyor-table-4-1.toml"
        );
        let vehicle = VehicleFile::read(Path::new(file)).unwrap().vehicle;
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
    fn cases_come_in_order_for_any_number_of_threads_and_stop_when_cancelled() {
        let (vehicle, scenes, settings) = short_landings();
        // More than all threads have under way at once.
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
    fn searches_receive_the_landings_they_request_and_every_point_is_kept_once() {
        let (vehicle, scenes, settings) = short_landings();
        let land = |point: usize| land(&vehicle, &scenes[point % scenes.len()], &settings);
        // Some searches request nothing.
        let landings = |point| (point..point + point % 5).collect::<Vec<usize>>();
        let expected: Vec<(usize, Vec<Landing>)> = (0..100)
            .map(|point| (point, landings(point).into_iter().map(land).collect()))
            .collect();
        let cancel = AtomicBool::new(false);
        for threads in [1, 2, 3] {
            let stop = Stop::on(&cancel);
            let search = async |point: usize, queue: &LandingQueue| {
                let mut landed = Vec::new();
                for landing in landings(point) {
                    let scene = scenes[landing % scenes.len()];
                    let landing = queue.landing(point, Arc::clone(&vehicle), scene, settings);
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
                .search(0..100, &stop, search, keep)
                .unwrap();
            kept.sort_by_key(|(point, _)| *point);
            assert_eq!(kept, expected);
        }
    }

    #[test]
    fn a_failure_to_keep_a_result_ends_the_run() {
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
        let ended = workers(2).search(0.., &stop, search, keep);
        assert!(matches!(ended, Err(RunError::Journal(_))));
        assert_eq!(kept, 5);
    }

    #[test]
    fn cancelling_stops_before_the_next_landing() {
        let (vehicle, scenes, settings) = short_landings();
        let cancel = AtomicBool::new(false);
        let landings = AtomicUsize::new(0);
        let stop = Stop::on(&cancel);
        let search = async |point: usize, queue: &LandingQueue| {
            loop {
                stop.check()?;
                let scene = scenes[point % scenes.len()];
                let landing = queue.landing(point, Arc::clone(&vehicle), scene, settings);
                assert!(landing.await.is_some());
                if landings.fetch_add(1, Ordering::Relaxed) == 50 {
                    cancel.store(true, Ordering::Relaxed);
                }
            }
        };
        let ended = workers(2).search(0.., &stop, search, |_: Option<(usize, ())>| Ok(()));
        assert!(matches!(ended, Err(RunError::Cancelled)));
        assert_eq!(landings.into_inner(), 51);
    }
}
