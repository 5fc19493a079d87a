//! Sliding friction, profile C of the 1966 program: viscous near rest, then falling, then steady.
//!
//! μ(S) = 24 S μ0 up to 0.05 ft/s, μ0 (1.21 − 0.2 S) up to 1.05 ft/s, μ0 above.

use crate::integrator::event::Bounds;
use crate::scalar::Real;

/// Active branch of the friction profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sliding {
    /// S ≤ 0.05 ft/s.
    Viscous,
    /// 0.05 < S ≤ 1.05 ft/s.
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

const VISCOUS_LIMIT: f64 = 0.05;
const STEADY_LIMIT: f64 = 1.05;
/// Slack of the squared-speed guard, ft²/s².
const SLACK: f64 = 1e-13;

impl Sliding {
    /// The branch that holds at squared sliding speed S², ft²/s².
    pub fn at(speed_squared: f64) -> Self {
        if speed_squared <= VISCOUS_LIMIT * VISCOUS_LIMIT {
            Self::Viscous
        } else if speed_squared <= STEADY_LIMIT * STEADY_LIMIT {
            Self::Falling
        } else {
            Self::Steady
        }
    }

    /// Coefficients of this branch.
    pub fn piece<S: Real>(self) -> FrictionPiece<S> {
        let (constant, viscous) = match self {
            Self::Viscous => (0.0, 24.0),
            Self::Falling => (1.21, -0.2),
            Self::Steady => (1.0, 0.0),
        };
        FrictionPiece {
            constant: S::constant(constant),
            viscous: S::constant(viscous),
        }
    }

    /// Range of S² over which this branch holds.
    pub fn bounds(self) -> Bounds {
        let (low, high) = (VISCOUS_LIMIT * VISCOUS_LIMIT, STEADY_LIMIT * STEADY_LIMIT);
        match self {
            Self::Viscous => Bounds::below(low),
            Self::Falling => Bounds::between(low, high),
            Self::Steady => Bounds::above(high),
        }
        .widened(SLACK)
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
    /// dμ/dS over μ0 at any speed of this branch, s/ft, or zero where friction falls with speed.
    #[inline(always)]
    pub fn growth(&self) -> S {
        self.viscous.max(S::zero())
    }

    /// μ(S)/S over μ0, s/ft: multiplies the sliding velocity to give the friction force per pound
    /// of normal force.
    #[inline(always)]
    pub fn per_speed(&self, speed_squared: S) -> S {
        // The floor only keeps 0 · (1/0) out of the viscous branch.
        self.constant / speed_squared.max(S::constant(1e-30)).sqrt() + self.viscous
    }
}
