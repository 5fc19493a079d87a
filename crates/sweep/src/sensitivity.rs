//! How much the transition velocity depends on the numbers of the input: dV_H/dp at every point.
//!
//! The transitions at p − h, p − h/2, p, p + h/2 and p + h are narrowed down one by one, each near
//! the one before, and their differences judged ([`mod@difference`]).
//!
//! **The step.** A transition is known to ε = w + tol V_H: the width w of its bracket, a tenth of the
//! search's, and what the solver's tolerance leaves open (measured around the Surveyor's transitions:
//! below half of tol V_H). A difference over ±h is then wrong by ε/h at most, and by h² V'''/6 because
//! V_H is curved. Where V_H changes by its own size over a scale L both are alike at
//!
//! > h = L (ε / V_H)^(1/3), a tenth of L at most.
//!
//! L is the magnitude of the parameter, 30 deg for angles (the lander of three legs goes from its best
//! to its worst side within 60), and 30 deg/s for rates of turn. Of a length that is 0, L is the height of
//! the CG of the standing vehicle, of a product of inertia that is 0 the mean moment of inertia. Any other
//! parameter that is 0 has no step. With the customary search (bracket 0.001 ft/s, tolerance 3e-5) h is 3.4 % of the
//! parameter, or 1 deg.
//!
//! **Where there is no derivative** a word says so instead of a number ([`Dependence`]).

pub mod difference;
mod follow;
mod of_point;

use serde::{Deserialize, Serialize};

pub(crate) use of_point::of_point;

/// What the first transition of a point depends on.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Sensitivity {
    /// The first transition, narrowed down further than the search does, ft/s.
    pub speed: Option<f64>,
    /// One for each parameter asked for.
    pub slopes: Vec<Slope>,
    /// Landings that this took beside those of the search.
    pub landings: u64,
    /// Evaluations of the equations of motion in them.
    pub evaluations: u64,
}

/// How the transition velocity depends on a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Slope {
    /// Step h to either side, in the unit of the parameter, where one was taken.
    pub step: Option<f64>,
    /// What came out.
    pub dependence: Dependence,
}

/// How the transition velocity goes with a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Dependence {
    /// Smoothly.
    Smooth {
        /// dV_H/dp, ft/s per unit of the parameter.
        derivative: f64,
        /// Estimate of its greatest error, in the same unit.
        error: f64,
    },
    /// With another slope to either side.
    Kinked,
    /// It jumps within the step.
    Jumps,
    /// Within the step the search finds no transition any more.
    Vanishes,
    /// The step leads to input that is not allowed.
    NotAllowed,
    /// The transition itself is disputed: small changes of anything decide.
    Disputed,
    /// There is no transition here, or it lies below the lowest speed of the search.
    NoTransition,
    /// The parameter is 0, and neither an angle, a length nor a product of inertia: no step follows.
    NoStep,
}

impl Dependence {
    /// Its word in tables.
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
