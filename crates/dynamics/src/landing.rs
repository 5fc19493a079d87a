//! One landing: integrate from first contact until an outcome, and report.

mod account;
mod events;
mod kinks;
mod peaks;
mod ranges;
mod rates;
mod simulation;
mod step_attempt;
mod stiffness;
mod trail;
mod trajectory;
mod verdict;
mod within;

use crate::methods::{self, Method};
pub use crate::record::{Energies, FinalRates, Instant, Landing, LegInstant, LegWork};
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;

use account::History;

pub(crate) use rates::final_rates;
pub(crate) use simulation::{NextStart, Simulation};
pub(crate) use step_attempt::{Respond, StepKind, TakeStep};

/// Computes a landing.
pub fn land(vehicle: &Vehicle, scene: &Scene, settings: &Settings) -> Landing {
    land_observed(vehicle, scene, settings, f64::INFINITY, &mut |_| {})
}

/// Computes a landing and reports its state every `interval` seconds from first contact on, and
/// at the end.
pub fn land_observed(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> Landing {
    if settings.method() != Method::Located {
        return methods::land_observed(vehicle, scene, settings, interval, observe).0;
    }
    let history = interval
        .is_finite()
        .then(|| History::new(interval, observe));
    let mut simulation = Simulation::new(vehicle, scene, settings, history);
    let outcome = simulation.run();
    simulation.report_end();
    simulation.conclude(outcome)
}
