//! The integrators of 1966: the report's own (3.2, 3.3) and those it was compared with (4.1.2).
//!
//! They know of no events: every evaluation chooses the active piece of each law from the state,
//! and what the elements keep of being crushed changes in trial stages too. Next to the method
//! that locates events they show what the report's published numbers owe to its integration.

mod bouncing_ball;
mod error_check;
mod error_control;
mod flight;
mod force_model;
mod integration_summary;
mod milne;
mod runge_kutta;
mod step_doubling;
mod system;
mod trapezoidal;
mod variables;

pub use bouncing_ball::BouncingBall;
pub use error_check::ErrorCheck;
pub use error_control::{ErrorControl, ErrorLimits, Intervals};
pub use force_model::ForceModel;
pub use integration_summary::IntegrationSummary;
pub use milne::Milne;
pub use runge_kutta::RungeKutta;
pub use step_doubling::StepDoubling;
pub use system::{Evaluator, Start, Stepper, System, Taken, Vector};
pub use trapezoidal::Trapezoidal;
pub use variables::names as variable_names;

use crate::invalid::{Invalid, require};
use crate::landing;
use crate::record::{Instant, Landing};
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;
use flight::Flight;

/// How the equations of motion are integrated.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Method {
    /// Every change of a law is located in time: [`crate::landing`].
    #[default]
    Located,
    /// The report's step doubling.
    Report(ErrorControl),
    /// Runge-Kutta of order 4 at a fixed interval.
    RungeKutta(FixedInterval),
    /// Trapezoidal at a fixed interval.
    Trapezoidal(FixedInterval),
    /// Milne's predictor and corrector.
    Milne(ErrorControl),
}

/// A checked fixed interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedInterval(f64);

impl FixedInterval {
    /// Checks an interval, s.
    ///
    /// # Errors
    /// It must lie in [1e-6, 1] s.
    pub fn new(seconds: f64) -> Result<Self, Invalid> {
        require("interval_s", seconds, "1e-6 ≤ value ≤ 1", |v| {
            (1e-6..=1.0).contains(&v)
        })?;
        Ok(Self(seconds))
    }

    /// The interval, s.
    pub fn seconds(self) -> f64 {
        self.0
    }
}

impl Default for FixedInterval {
    /// That of 4.1.2.
    fn default() -> Self {
        Self(0.002)
    }
}

/// Computes a landing by the method of the settings and reports its state every `interval` seconds
/// from first contact on, and at the end; with the account of its integration. The method that
/// locates events has its own account in the landing and an empty one here.
pub fn land_observed(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> (Landing, IntegrationSummary) {
    let touchdown = (vehicle, scene);
    match settings.method() {
        Method::Located => {
            let landing = landing::land_observed(vehicle, scene, settings, interval, observe);
            (landing, IntegrationSummary::default())
        }
        Method::Report(control) => {
            let mut stepper =
                StepDoubling::new(check(&control, vehicle.legs().len()), control.intervals());
            let landing = land_by(&mut stepper, touchdown, settings, interval, observe);
            (landing, stepper.into_summary())
        }
        Method::RungeKutta(fixed) => {
            let stepper = &mut RungeKutta {
                interval: fixed.seconds(),
            };
            counted(land_by(stepper, touchdown, settings, interval, observe))
        }
        Method::Trapezoidal(fixed) => {
            let stepper = &mut Trapezoidal {
                interval: fixed.seconds(),
            };
            counted(land_by(stepper, touchdown, settings, interval, observe))
        }
        Method::Milne(control) => {
            let mut stepper =
                Milne::new(check(&control, vehicle.legs().len()), control.intervals());
            let landing = land_by(&mut stepper, touchdown, settings, interval, observe);
            (landing, stepper.into_summary())
        }
    }
}

/// Computes a landing with any of these methods, whatever the settings say of the method.
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

/// The check of the errors of a vehicle with so many legs.
pub fn check(control: &ErrorControl, legs: usize) -> ErrorCheck {
    ErrorCheck::new(variables::limits(&control.limits(), legs))
}

/// The account of an integration at a fixed interval.
fn counted(landing: Landing) -> (Landing, IntegrationSummary) {
    let summary = IntegrationSummary {
        intervals: landing.steps,
        time: landing.end_time,
        ..IntegrationSummary::default()
    };
    (landing, summary)
}
