//! One point of a sweep: which landings it takes, and what they come to.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use touchdown_dynamics::vehicle::Vehicle;

use super::landing_queue::LandingQueue;
use super::run_error::{Observer, RunError};
use crate::case::{Case, CaseFault};
use crate::certainty::Variation;
use crate::findings::Finding;
use crate::landing_table;
use crate::scene_input::{HORIZONTAL_VELOCITY, SceneFault};
use crate::sensitivity;
use crate::sweep_file::{Job, Sweep};
use crate::trial::{Scales, Trial};

/// Whether a run goes on: not after it was cancelled from outside, or has decided itself to end.
pub(super) struct Stop<'c> {
    cancelled: &'c AtomicBool,
    ended: AtomicBool,
}

impl<'c> Stop<'c> {
    pub(super) fn on(cancelled: &'c AtomicBool) -> Self {
        let ended = AtomicBool::new(false);
        Self { cancelled, ended }
    }

    /// Ends the run.
    pub(super) fn stop(&self) {
        self.ended.store(true, Ordering::Relaxed);
    }

    /// # Errors
    /// When the run is to end.
    pub(super) fn check(&self) -> Result<(), RunError> {
        match self.cancelled.load(Ordering::Relaxed) || self.ended.load(Ordering::Relaxed) {
            true => Err(RunError::Cancelled),
            false => Ok(()),
        }
    }
}

/// Computes what the sweep asks at a point: one landing, or a search for its transitions, and sensitivities.
///
/// # Errors
/// When the point has no valid input, or the run is to end.
pub(super) async fn compute(
    sweep: &Sweep,
    point: usize,
    queue: &LandingQueue,
    observer: &impl Observer,
    stop: &Stop<'_>,
) -> Result<Finding, RunError> {
    let invalid = |fault| RunError::Point {
        place: sweep.place(point),
        fault,
    };
    let case = sweep.case(point).map_err(invalid)?;
    let land = async |vehicle: &Arc<Vehicle>, scene, settings| {
        stop.check()?;
        let vehicle = Arc::clone(vehicle);
        let landing = queue.landing(point, vehicle, scene, settings).await;
        let landing = landing.ok_or(RunError::Cancelled)?;
        observer.landing();
        Ok(landing)
    };
    let Job::Boundary(search) = case.job else {
        let landing = land(&case.vehicle, case.scene, case.settings).await?;
        let cells = landing_table::columns(&landing)
            .into_iter()
            .map(|(_, cell)| cell);
        return Ok(Finding::Landing {
            cells: cells.collect(),
            outcome: landing.outcome,
        });
    };
    let trial = async |case: &Case, speed, variation: Variation| {
        let varied = case
            .scene
            .with_horizontal_velocity(speed)
            .and_then(|faster| variation.of(&faster, &case.settings));
        let (varied, settings) = varied.map_err(|fault| {
            invalid(CaseFault::Scene(SceneFault {
                name: HORIZONTAL_VELOCITY,
                value: Some(fault.value),
                allowed: fault.allowed,
            }))
        })?;
        let landing = land(&case.vehicle, varied, settings).await?;
        Ok(Trial::of(landing, &Scales::of(&case.vehicle)))
    };
    let boundary = search
        .boundary(async |speed, variation| trial(&case, speed, variation).await)
        .await?;
    if sweep.sensitivity.is_empty() {
        return Ok(Finding::Boundary(boundary));
    }
    let searched = (&case, &search);
    let sensitivity = sensitivity::of_point(sweep, point, searched, &boundary, &trial).await?;
    Ok(Finding::Sensitive {
        boundary,
        sensitivity,
    })
}
