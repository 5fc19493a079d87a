//! Sensitivity of the transition velocity to the numbers of the input: dV_H/dp at every point.
//!
//! The transitions at p − h, p − h/2, p, p + h/2 and p + h are narrowed down in turn, each near the one before, and
//! their differences are judged ([`mod@difference`]).
//!
//! **The step.** A transition is known to ε = w + tol V_H. Here w is the width of its bracket, a tenth of the search's,
//! and tol V_H covers the solver's error (measured around the Surveyor's transitions: less than half of tol V_H). A
//! difference over ±h then has an error of at most ε/h, plus h² V'''/6 because V_H is curved. If V_H changes by its own
//! size over a scale L, the two are equal at
//!
//! > h = L (ε / V_H)^(1/3), a tenth of L at most.
//!
//! L is the magnitude of the parameter, 30 deg for angles (the lander of three legs goes from its best to its worst
//! side within 60), and 30 deg/s for rates of turn. For a length that is 0, L is the height of the CG of the standing
//! vehicle; for a product of inertia that is 0, the mean moment of inertia. Any other parameter that is 0 has no step.
//! With the customary search (bracket 0.001 ft/s, tolerance 3e-5) h is 3.4 % of the parameter, or 1 deg.
//!
//! **Without a derivative** a word replaces the number ([`Dependence`]). Where V_H has a kink, jumps or vanishes within
//! the step, ordinary searches give V_H at the ends of the parameter's span.

pub mod difference;
mod of_point;

use serde::{Deserialize, Serialize};
use touchdown_input::points::parameter::Parameter;

pub(crate) use of_point::of_point;

/// Span as a fraction of the parameter.
const SPAN: f64 = 0.1;
/// Span of angles and rates of turn, deg and deg/s.
const ANGULAR_SPAN: f64 = 1.0;

/// Sensitivities of the first transition of a point.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Sensitivity {
    /// The first transition, ft/s, narrowed further than by the search.
    pub speed: Option<f64>,
    /// One slope per parameter.
    pub slopes: Vec<Slope>,
    /// Landings in addition to those of the search.
    pub landings: u64,
    /// Evaluations of the equations of motion in these landings.
    pub evaluations: u64,
}

/// Dependence of the transition velocity on a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Slope {
    /// Step h to either side, in the unit of the parameter, if any.
    pub step: Option<f64>,
    /// Result.
    pub dependence: Dependence,
    /// V_H at p − span and p + span, ft/s, where V_H has a kink, jumps or vanishes; `None` where there is no transition,
    /// or where the input is not allowed.
    pub ends: [Option<f64>; 2],
}

impl Slope {
    /// A dependence without transitions at the ends of the span.
    pub(crate) fn new(step: Option<f64>, dependence: Dependence) -> Self {
        Self {
            step,
            dependence,
            ends: [None; 2],
        }
    }
}

/// Span of a parameter of this value: the change for which the change of V_H is told, in the unit of the parameter. It
/// is the step of the derivative where the value is 0.
pub(crate) fn span(parameter: &Parameter, value: f64, step: f64) -> f64 {
    if parameter.is_angular() {
        parameter.in_own_unit(ANGULAR_SPAN)
    } else if value == 0.0 {
        step
    } else {
        SPAN * value.abs()
    }
}

/// Dependence of the transition velocity on a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Dependence {
    /// Smooth.
    Smooth {
        /// dV_H/dp, ft/s per unit of the parameter.
        derivative: f64,
        /// Estimate of its greatest error, in the same unit.
        error: f64,
    },
    /// Different slopes on either side.
    Kinked,
    /// A jump within the step.
    Jumps,
    /// No transition any more within the step.
    Vanishes,
    /// The step leads to invalid input.
    NotAllowed,
    /// The transition is disputed: small changes of anything decide it.
    Disputed,
    /// No transition, or one below the lowest speed of the search.
    NoTransition,
    /// The parameter is 0 and neither an angle, a length nor a product of inertia, so there is no step.
    NoStep,
}

impl Dependence {
    /// True if V_H is told over the span of the parameter, by the derivative or at both ends.
    pub(crate) fn has_span(&self) -> bool {
        match self {
            Self::Smooth { .. } | Self::Kinked | Self::Jumps | Self::Vanishes => true,
            Self::NotAllowed | Self::Disputed | Self::NoTransition | Self::NoStep => false,
        }
    }

    /// Word in tables.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Smooth { .. } => "smooth",
            Self::Kinked => "kinked",
            Self::Jumps => "jumps",
            Self::Vanishes => "vanishes",
            Self::NotAllowed => "not-allowed",
            Self::Disputed => "disputed",
            Self::NoTransition => "none",
            Self::NoStep => "no-step",
        }
    }
}
