//! A landing by the method in its settings.

use crate::landing::{Instant, Landing, land_located};
use crate::methods::{
    IntegrationSummary, Method, Milne, RungeKutta, StepDoubling, Trapezoidal, check, land_by,
};
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;

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
    land_with_summary(vehicle, scene, settings, interval, observe).0
}

/// Computes a landing by the method of the settings and reports its state every `interval` seconds from first contact
/// on, and at the end. Also returns the account of its integration; the method that locates events has its own account
/// in the landing and an empty one here.
pub fn land_with_summary(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> (Landing, IntegrationSummary) {
    let touchdown = (vehicle, scene);
    match settings.method() {
        Method::Located => {
            let landing = land_located(vehicle, scene, settings, interval, observe);
            (landing, IntegrationSummary::default())
        }
        Method::Report(control) => {
            let mut stepper =
                StepDoubling::new(check(&control, vehicle.leg_count()), control.intervals());
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
            let mut stepper = Milne::new(check(&control, vehicle.leg_count()), control.intervals());
            let landing = land_by(&mut stepper, touchdown, settings, interval, observe);
            (landing, stepper.into_summary())
        }
    }
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
