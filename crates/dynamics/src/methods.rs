//! The integrators of 1966: the report's own (3.2, 3.3) and those it was compared with (4.1.2).
//!
//! They know of no events. Every evaluation chooses the active piece of each law from the state, and trial stages too
//! change the sets of crushed elements. Compared with the method that locates events, they show what the report's
//! published numbers owe to its integration.

mod bouncing_ball;
mod fixed_interval;
mod flight;
mod force_model;
mod integration_summary;
mod milne;
mod step_doubling;
mod system;
mod variables;

pub use crate::method::{ErrorControl, ErrorLimits, FixedInterval, Intervals, Method};
pub use bouncing_ball::BouncingBall;
pub use fixed_interval::{RungeKutta, Trapezoidal};
pub use force_model::{ForceModel, Look};
pub use integration_summary::IntegrationSummary;
pub use milne::Milne;
pub use step_doubling::{ErrorCheck, StepDoubling, Worst};
pub use system::{Evaluator, Start, Stepper, System, Taken, Vector};
pub use variables::names as variable_names;

use crate::record::{Instant, Landing};
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;
use flight::Flight;

/// Computes a landing with any of these methods, whatever method the settings name.
pub fn land_by(
    stepper: &mut impl Stepper<ForceModel>,
    (vehicle, scene): (&Vehicle, &Scene),
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> Landing {
    let model = ForceModel::new(vehicle, scene, settings);
    Flight::new(vehicle, scene, settings, &model, interval, observe).run(stepper)
}

/// The error check for a vehicle with this many legs.
pub fn check(control: &ErrorControl, legs: usize) -> ErrorCheck {
    ErrorCheck::new(variables::limits(&control.limits(), legs))
}
