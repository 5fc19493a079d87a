//! Landings on every core.
//!
//! Work is shared out point by point, so that all cores are busy to the end. What a point came to
//! goes to the journal as soon as it is known, and nothing of it stays in memory. No landing knows
//! of another, so that results do not depend on the threads.

use std::cell::Cell;
use std::fmt;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use rayon::prelude::*;
use touchdown_dynamics::landing::abreast::{Request, land_many};
use touchdown_dynamics::landing::{Landing, land};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use crate::case::{Case, CaseFault};
use crate::certainty::Variation;
use crate::findings::Finding;
use crate::journal::{JournalError, Opened};
use crate::known::Known;
use crate::landing_table;
use crate::scene_input::SceneFault;
use crate::sensitivity;
use crate::shard::Shard;
use crate::sweep_file::{Job, Sweep};
use crate::trial::{Scales, Trial};

/// Whoever wants to know how far a run is. Called from all threads.
pub trait Observer: Sync {
    /// A point of the grid, by its number, is about to be computed by this thread.
    fn begin(&self, _point: usize) {}
    /// A landing has been computed.
    fn landing(&self) {}
    /// A point of the grid, or a case, is done by this thread.
    fn point(&self) {}
}

/// Nobody.
impl Observer for () {}

/// Why a run has no result.
#[derive(Debug)]
pub enum RunError {
    /// It was told to stop.
    Cancelled,
    /// A point of the grid has no valid input.
    Point {
        /// Its coordinates in words.
        place: String,
        /// What is wrong.
        fault: CaseFault,
    },
    /// Results could not be kept.
    Journal(JournalError),
    /// The threads could not be started.
    Threads(rayon::ThreadPoolBuildError),
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("cancelled"),
            Self::Point { place, fault } => {
                write!(f, "the point {place} has no valid input: {fault}")
            }
            Self::Journal(error) => error.fmt(f),
            Self::Threads(error) => write!(f, "threads cannot be started: {error}"),
        }
    }
}

impl std::error::Error for RunError {}

/// The threads that compute landings.
#[derive(Debug)]
pub struct Workers {
    pool: rayon::ThreadPool,
}

impl Workers {
    /// Starts `threads` threads, or one for each core.
    ///
    /// # Errors
    /// When the system does not let them start.
    pub fn start(threads: Option<NonZeroUsize>) -> Result<Self, RunError> {
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

    /// Finds what the sweep asks at every point of a shard that is not `done`, into the journal.
    ///
    /// # Errors
    /// When `cancel` became true, which is looked at before every landing, or a result cannot be
    /// kept. What was journaled until then stays good.
    pub fn sweep<const LEGS: usize>(
        &self,
        sweep: &Sweep<LEGS>,
        shard: Shard,
        opened: &mut Opened,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<(), RunError> {
        let mut known = Known::of(sweep, shard, opened).map_err(RunError::Journal)?;
        let Opened { journal, done, .. } = opened;
        let points = done.missing().map(|index| shard.point(index));
        let stop = Stop::on(cancel);
        if known.is_enough {
            return Ok(());
        }
        let work = |point| {
            observer.begin(point);
            let finding = find(sweep, point, observer, &stop)?;
            observer.point();
            Ok(finding)
        };
        let streamed = self.stream(points, &stop, work, |finished| {
            if let Some((point, finding)) = finished {
                journal.add(point, &finding.encode())?;
                if known.is_enough_with(sweep, point, finding) {
                    stop.stop();
                }
            }
            journal.tick()
        });
        let streamed = match (known.is_enough, streamed) {
            (true, Err(RunError::Cancelled)) if !cancel.load(Ordering::Relaxed) => Ok(()),
            (_, streamed) => streamed,
        };
        // Also when the run was stopped, but not over the error that stopped it.
        streamed.and(journal.finish().map_err(RunError::Journal))
    }

    /// Finds what the sweep asks at some points, in their order.
    ///
    /// # Errors
    /// When the input of one of them is not valid.
    pub fn points<const LEGS: usize>(
        &self,
        sweep: &Sweep<LEGS>,
        points: &[usize],
    ) -> Result<Vec<Finding>, RunError> {
        let never = AtomicBool::new(false);
        let stop = Stop::on(&never);
        self.each(points.len(), |index| find(sweep, points[index], &(), &stop))
    }

    /// Gives points to threads as they become free, and results to `keep` as they become known;
    /// `keep` is also called when nothing is known for a while.
    fn stream<T: Send>(
        &self,
        points: impl Iterator<Item = usize> + Send,
        stop: &Stop,
        work: impl Fn(usize) -> Result<T, RunError> + Sync,
        mut keep: impl FnMut(Option<(usize, T)>) -> Result<(), JournalError>,
    ) -> Result<(), RunError> {
        const LONGEST_SILENCE: Duration = Duration::from_millis(100);
        let points = Mutex::new(points);
        let next = || points.lock().unwrap_or_else(PoisonError::into_inner).next();
        let (send, receive) = sync_channel(2 * self.threads());
        self.pool.in_place_scope(|scope| {
            // Ends with this closure, so that nobody waits to send what nobody receives.
            let receive = receive;
            for _ in 0..self.threads() {
                let send = send.clone();
                let (next, work) = (&next, &work);
                scope.spawn(move |_| {
                    while let Some(point) = next() {
                        let result = work(point);
                        let is_last = result.is_err();
                        if send.send((point, result)).is_err() || is_last {
                            break;
                        }
                    }
                });
            }
            drop(send);
            let mut ended = Ok(());
            loop {
                let kept = match receive.recv_timeout(LONGEST_SILENCE) {
                    Ok((point, Ok(result))) => keep(Some((point, result))),
                    Err(RecvTimeoutError::Timeout) => keep(None),
                    Err(RecvTimeoutError::Disconnected) => return ended,
                    Ok((_, Err(error))) => {
                        stop.stop();
                        // The first error says why the others were stopped.
                        ended = ended.and(Err(error));
                        continue;
                    }
                };
                if let Err(error) = kept {
                    stop.stop();
                    return Err(RunError::Journal(error));
                }
            }
        })
    }

    /// Computes one landing for every scene, in their order, of the vehicle that belongs to its index: several at a
    /// time on each thread, side by side.
    ///
    /// # Errors
    /// When `cancel` became true; it is looked at before every landing.
    pub fn cases<'v, const LEGS: usize>(
        &self,
        vehicle: impl Fn(usize) -> &'v Vehicle<LEGS> + Sync + Send,
        scenes: &[Scene],
        settings: &Settings,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<Vec<Landing<LEGS>>, RunError> {
        let stop = Stop::on(cancel);
        let unasked = AtomicUsize::new(0);
        let found = Mutex::new(vec![None; scenes.len()]);
        // No thread takes so many at once that another has none.
        let share = scenes.len().div_ceil(self.threads());
        self.pool.broadcast(|_| {
            let under_way = Cell::new(0);
            let next = || {
                if under_way.get() == share || stop.go_on().is_err() {
                    return None;
                }
                let key = unasked.fetch_add(1, Ordering::Relaxed);
                let scene = *scenes.get(key)?;
                under_way.set(under_way.get() + 1);
                Some(Request {
                    key,
                    vehicle: vehicle(key),
                    scene,
                    settings: *settings,
                })
            };
            land_many(next, |key: usize, landing| {
                under_way.set(under_way.get() - 1);
                observer.landing();
                observer.point();
                found.lock().unwrap_or_else(PoisonError::into_inner)[key] = Some(landing);
            });
        });
        let found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        found
            .into_iter()
            .collect::<Option<_>>()
            .ok_or(RunError::Cancelled)
    }

    fn each<T: Send>(
        &self,
        count: usize,
        work: impl Fn(usize) -> Result<T, RunError> + Sync + Send,
    ) -> Result<Vec<T>, RunError> {
        self.pool.install(|| {
            (0..count)
                .into_par_iter()
                .with_max_len(1)
                .map(work)
                .collect()
        })
    }
}

/// Whether to go on: not when the run was cancelled from outside or has come to an end within.
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

/// What a sweep asks at a point.
fn find<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    point: usize,
    observer: &impl Observer,
    stop: &Stop,
) -> Result<Finding, RunError> {
    let invalid = |fault| RunError::Point {
        place: sweep.place(point),
        fault,
    };
    let case = sweep.case(point).map_err(invalid)?;
    let landed = |vehicle: &Vehicle<LEGS>, scene: &Scene, settings: &Settings| {
        stop.go_on()?;
        let landing = land(vehicle, scene, settings);
        observer.landing();
        Ok(landing)
    };
    let Job::Boundary(search) = case.job else {
        let landing = landed(&case.vehicle, &case.scene, &case.settings)?;
        let cells = landing_table::columns(&landing)
            .into_iter()
            .map(|(_, cell)| cell);
        return Ok(Finding::Landing {
            cells: cells.collect(),
            outcome: landing.outcome,
        });
    };
    let mut trial = |case: &Case<LEGS>, speed, variation: Variation| {
        let varied = case
            .scene
            .with_horizontal_velocity(speed)
            .and_then(|faster| variation.of(&faster, &case.settings));
        let (varied, settings) = varied.map_err(|fault| {
            invalid(CaseFault::Scene(SceneFault {
                name: crate::scene_input::HORIZONTAL_VELOCITY,
                value: Some(fault.value),
                allowed: fault.allowed,
            }))
        })?;
        let landing = landed(&case.vehicle, &varied, &settings)?;
        Ok(Trial::of(landing, &Scales::of(&case.vehicle)))
    };
    let boundary = search.boundary(|speed, variation| trial(&case, speed, variation))?;
    if sweep.sensitivity.is_empty() {
        return Ok(Finding::Boundary(boundary));
    }
    let sensitivity = sensitivity::of_point(sweep, point, (&case, &search), &boundary, &mut trial)?;
    Ok(Finding::Sensitive {
        boundary,
        sensitivity,
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use touchdown_dynamics::scene::CrushRule;

    use super::*;
    use crate::measured_scenes::near_boundary;
    use crate::vehicle_file::VehicleFile;

    fn workers(threads: usize) -> Workers {
        Workers::start(NonZeroUsize::new(threads)).unwrap()
    }

    #[test]
    fn results_come_in_order_for_any_number_of_threads() {
        let expected: Vec<usize> = (0..100).map(|n| n * n).collect();
        for threads in [1, 2, 3] {
            let squares = workers(threads).each(100, |n| Ok(n * n)).unwrap();
            assert_eq!(squares, expected);
        }
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
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../sweeps/vehicles/surveyor-table-4-1.toml"
        );
        let vehicle: Vehicle<3> = VehicleFile::read(Path::new(file)).unwrap().vehicle;
        let scenes = near_boundary(false).unwrap();
        let settings = Settings::new(3e-4, 0.3, CrushRule::default()).unwrap();
        let expected: Vec<_> = (scenes.iter())
            .map(|scene| land(&vehicle, scene, &settings))
            .collect();
        for threads in [1, 2, 3] {
            let cancel = AtomicBool::new(false);
            let cases = |observer: &CancelsAt| {
                workers(threads).cases(|_| &vehicle, &scenes, &settings, observer, &cancel)
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
    fn every_point_is_kept_once_for_any_number_of_threads() {
        let cancel = AtomicBool::new(false);
        for threads in [1, 2, 3] {
            let mut kept = Vec::new();
            let keep = |finished: Option<(usize, usize)>| {
                kept.extend(finished);
                Ok(())
            };
            let stop = Stop::on(&cancel);
            let streamed = workers(threads).stream(0..1000, &stop, |n| Ok(n * n), keep);
            assert!(streamed.is_ok());
            kept.sort_unstable();
            let expected: Vec<_> = (0..1000).map(|n| (n, n * n)).collect();
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
        let work = |n| stop.go_on().map(|()| n);
        let streamed = workers(2).stream(0.., &stop, work, keep);
        assert!(matches!(streamed, Err(RunError::Journal(_))));
        assert_eq!(kept, 5);
    }

    #[test]
    fn cancelling_stops_before_the_next_landing() {
        let cancel = AtomicBool::new(false);
        let outcome = workers(1).each(100, |n| {
            Stop::on(&cancel).go_on()?;
            cancel.store(n == 3, Ordering::Relaxed);
            assert!(n <= 3);
            Ok(())
        });
        assert!(matches!(outcome, Err(RunError::Cancelled)));
    }
}
