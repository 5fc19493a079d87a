//! One landing: integrate from first contact until an outcome, and report.

mod account;
pub mod critical_feet;
pub mod energy;
mod events;
mod hidden_forces;
mod history;
mod hull;
mod kinks;
mod peaks;
mod ranges;
mod rates;
pub mod record;
mod rest;
mod signal_history;
mod simulation;
pub mod stability;
mod steadiness;
mod step_attempt;
mod stiffness;
mod strut_peaks;
mod thrust;
pub mod touchdown;
mod trajectory;
mod verdict;
mod within;

use crate::outcome::Outcome;
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;

use history::History;

pub(crate) use rates::final_rates;
pub(crate) use simulation::{NextStart, Simulation};
pub(crate) use step_attempt::{StepKind, TakeStep, Workspace};

pub use record::{Energies, FinalRates, Instant, Landing, LegInstant, LegWork};

/// Computes a landing with its events located. Reports its state every `interval` seconds from first contact on, and at
/// the end.
pub fn land_located(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> Landing {
    let history = interval
        .is_finite()
        .then(|| History::new(interval, observe));
    let mut simulation = Simulation::new(vehicle, scene, settings, history);
    let outcome = simulation.run(&mut Workspace::new(&simulation.trajectory.motion));
    simulation.trajectory.report_end();
    simulation.result(outcome)
}

/// Like [`land_located`], but returns `None` once `goes_on`, asked before every step, says no. An infinite `interval`
/// (s) reports nothing.
pub fn land_located_while(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
    mut goes_on: impl FnMut() -> bool,
) -> Option<Landing> {
    let history = interval
        .is_finite()
        .then(|| History::new(interval, observe));
    let mut simulation = Simulation::new(vehicle, scene, settings, history);
    let mut workspace = Workspace::new(&simulation.trajectory.motion);
    let mut stepped = simulation.begin();
    loop {
        match stepped {
            Err(outcome) => {
                simulation.trajectory.report_end();
                return Some(simulation.result(outcome));
            }
            Ok(()) if goes_on() => stepped = simulation.step(&mut workspace),
            Ok(()) => return None,
        }
    }
}

/// Computes a landing with its events located, until all footpads have touched. If it has not ended by then, its
/// outcome is [`Outcome::TimeExpired`].
pub fn land_until_all_pads_touch(vehicle: &Vehicle, scene: &Scene, settings: &Settings) -> Landing {
    let mut simulation = Simulation::new(vehicle, scene, settings, None);
    let mut workspace = Workspace::new(&simulation.trajectory.motion);
    let mut goes_on = simulation.begin();
    while goes_on.is_ok()
        && simulation
            .trajectory
            .pad_contact
            .iter()
            .any(Option::is_none)
    {
        goes_on = simulation.step(&mut workspace);
    }
    simulation.result(goes_on.err().unwrap_or(Outcome::TimeExpired))
}
