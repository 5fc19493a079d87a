//! Landings on every core.
//!
//! Work is shared out point by point, so that all cores are busy to the end; results are collected
//! in grid order and no landing knows of another, so that they do not depend on the threads.

use std::fmt;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;
use touchdown_dynamics::landing::{Landing, land};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use crate::boundary::{Boundary, Trial};
use crate::case::CaseFault;
use crate::scene_input::SceneFault;
use crate::sweep_file::Sweep;

/// Whoever wants to know how far a run is. Called from all threads.
pub trait Observer: Sync {
    /// A landing has been computed.
    fn landing(&self) {}
    /// A point of the grid, or a case, is done.
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

    /// Searches the boundary at every point of a sweep, in grid order.
    ///
    /// # Errors
    /// When `cancel` became true; it is looked at before every landing.
    pub fn sweep<const LEGS: usize>(
        &self,
        sweep: &Sweep<LEGS>,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<Vec<Boundary>, RunError> {
        self.each(sweep.grid.count(), |point| {
            let boundary = search_point(sweep, point, observer, cancel)?;
            observer.point();
            Ok(boundary)
        })
    }

    /// Computes one landing for every scene, in their order.
    ///
    /// # Errors
    /// When `cancel` became true; it is looked at before every landing.
    pub fn cases<const LEGS: usize>(
        &self,
        vehicle: &Vehicle<LEGS>,
        scenes: &[Scene],
        settings: &Settings,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<Vec<Landing<LEGS>>, RunError> {
        self.each(scenes.len(), |case| {
            go_on(cancel)?;
            let landing = land(vehicle, &scenes[case], settings);
            observer.landing();
            observer.point();
            Ok(landing)
        })
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

fn go_on(cancel: &AtomicBool) -> Result<(), RunError> {
    if cancel.load(Ordering::Relaxed) {
        Err(RunError::Cancelled)
    } else {
        Ok(())
    }
}

fn search_point<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    point: usize,
    observer: &impl Observer,
    cancel: &AtomicBool,
) -> Result<Boundary, RunError> {
    let invalid = |fault| RunError::Point {
        place: sweep.place(point),
        fault,
    };
    let case = sweep.case(point).map_err(invalid)?;
    case.search.boundary(|speed| {
        go_on(cancel)?;
        let faster = case
            .scene
            .with_horizontal_velocity(speed)
            .map_err(|fault| {
                invalid(CaseFault::Scene(SceneFault {
                    name: crate::scene_input::HORIZONTAL_VELOCITY,
                    value: Some(fault.value),
                    allowed: fault.allowed,
                }))
            })?;
        let landing = land(&case.vehicle, &faster, &case.settings);
        observer.landing();
        Ok(Trial {
            least_angle: landing.min_stability_angle,
            outcome: landing.outcome,
            evaluations: landing.evaluations,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn cancelling_stops_before_the_next_landing() {
        let cancel = AtomicBool::new(false);
        let outcome = workers(1).each(100, |n| {
            go_on(&cancel)?;
            cancel.store(n == 3, Ordering::Relaxed);
            assert!(n <= 3);
            Ok(())
        });
        assert!(matches!(outcome, Err(RunError::Cancelled)));
    }
}
