//! Sliding friction of the 1966 program: viscous near rest, then falling, then steady.
//!
//! With profile C, which it used, μ(S) = 24 S μ0 up to 0.05 ft/s, μ0 (1.21 − 0.2 S) up to
//! 1.05 ft/s, μ0 above. Profiles A and B (4.1.5) are viscous over less.

use crate::integrator::event::Bounds;
use crate::lanes::per_lane;
use crate::scalar::Real;

pub use crate::rules::FrictionProfile;

/// Active branch of the friction profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sliding {
    /// S up to the profile's viscous limit.
    Viscous,
    /// From there to 1.05 ft/s.
    Falling,
    /// S > 1.05 ft/s.
    Steady,
}

/// Coefficients of the active branch: μ/S = μ0 (constant / S + viscous).
#[derive(Debug, Clone, Copy)]
pub struct FrictionPiece<S> {
    constant: S,
    viscous: S,
}

per_lane!(FrictionPiece { constant, viscous });

const STEADY_LIMIT: f64 = 1.05;
/// Slack of the squared-speed guard, ft²/s².
const SLACK: f64 = 1e-13;

impl Sliding {
    /// The branch of a profile that holds at squared sliding speed S², ft²/s².
    pub fn at(profile: FrictionProfile, speed_squared: f64) -> Self {
        if speed_squared <= profile.viscous_limit() * profile.viscous_limit() {
            Self::Viscous
        } else if speed_squared <= STEADY_LIMIT * STEADY_LIMIT {
            Self::Falling
        } else {
            Self::Steady
        }
    }

    /// Coefficients of this branch.
    pub fn piece<S: Real>(self, profile: FrictionProfile) -> FrictionPiece<S> {
        let (constant, viscous) = match self {
            Self::Viscous => (0.0, profile.viscous()),
            Self::Falling => (1.21, -0.2),
            Self::Steady => (1.0, 0.0),
        };
        FrictionPiece {
            constant: S::constant(constant),
            viscous: S::constant(viscous),
        }
    }

    /// Range of S² over which this branch holds.
    pub fn bounds(self, profile: FrictionProfile) -> Bounds {
        let limit = profile.viscous_limit();
        let (low, high) = (limit * limit, STEADY_LIMIT * STEADY_LIMIT);
        match self {
            Self::Viscous => Bounds::below(low),
            Self::Falling => Bounds::between(low, high),
            Self::Steady => Bounds::above(high),
        }
        .widened(SLACK.min(1e-6 * low))
    }

    /// The branch next to this one, faster or slower.
    pub fn neighbour(self, faster: bool) -> Self {
        match (self, faster) {
            (Self::Viscous, true) | (Self::Steady, false) => Self::Falling,
            (Self::Falling, true) | (Self::Steady, true) => Self::Steady,
            (Self::Falling, false) | (Self::Viscous, false) => Self::Viscous,
        }
    }
}

impl<S: Real> FrictionPiece<S> {
    /// No friction.
    pub fn none() -> Self {
        Self {
            constant: S::zero(),
            viscous: S::zero(),
        }
    }

    /// dμ/dS over μ0 at any speed of this branch, s/ft.
    #[inline(always)]
    pub fn change(&self) -> S {
        self.viscous
    }

    /// μ(S)/S over μ0, s/ft: multiplies the sliding velocity to give the friction force per pound
    /// of normal force.
    #[inline(always)]
    pub fn per_speed(&self, speed_squared: S) -> S {
        // The floor only keeps 0 · (1/0) out of the viscous branch.
        self.constant / speed_squared.max(S::constant(1e-30)).sqrt() + self.viscous
    }
}
