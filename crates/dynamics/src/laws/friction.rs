//! Sliding friction of the 1966 program: viscous near rest, then falling, then steady.
//!
//! With profile C, which it used, μ(S) = 24 S μ0 up to 0.05 ft/s, μ0 (1.21 − 0.2 S) up to
//! 1.05 ft/s, μ0 above. Profiles A and B (4.1.5) are viscous over less. A static friction of its own takes the place of
//! the 1.2 μ0 from which friction falls.

use crate::integrator::event::Bounds;
use crate::lanes::per_lane;
use crate::scalar::Real;

pub use crate::rules::FrictionProfile;

/// Friction over sliding speed S, as a multiple of μ0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionLaw {
    /// Speed up to which friction is viscous, ft/s.
    viscous_limit: f64,
    /// dμ/dS up to there, s/ft.
    viscous: f64,
    /// Value at rest and slope (s/ft) of the line from there to the steady branch.
    falling: [f64; 2],
}

/// Active branch of the friction law.
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

impl FrictionLaw {
    /// Friction of this profile, with this greatest friction near rest as a multiple of μ0, if not that of 1966.
    pub fn new(profile: FrictionProfile, static_ratio: Option<f64>) -> Self {
        let viscous_limit = profile.viscous_limit();
        let (viscous, falling) = match static_ratio {
            None => (profile.viscous(), [1.21, -0.2]),
            Some(ratio) => {
                let slope = (1.0 - ratio) / (STEADY_LIMIT - viscous_limit);
                (ratio / viscous_limit, [1.0 - slope * STEADY_LIMIT, slope])
            }
        };
        Self {
            viscous_limit,
            viscous,
            falling,
        }
    }

    /// Speed up to which friction is viscous, ft/s: the foot sticks.
    pub fn viscous_limit(&self) -> f64 {
        self.viscous_limit
    }

    /// Returns whether friction is viscous at a squared sliding speed S², ft²/s².
    pub fn is_viscous(&self, speed_squared: f64) -> bool {
        Sliding::at(self, speed_squared) == Sliding::Viscous
    }
}

impl Default for FrictionLaw {
    fn default() -> Self {
        Self::new(FrictionProfile::default(), None)
    }
}

impl Sliding {
    /// The branch of a law that holds at squared sliding speed S², ft²/s².
    pub fn at(law: &FrictionLaw, speed_squared: f64) -> Self {
        if speed_squared <= law.viscous_limit * law.viscous_limit {
            Self::Viscous
        } else if speed_squared <= STEADY_LIMIT * STEADY_LIMIT {
            Self::Falling
        } else {
            Self::Steady
        }
    }

    /// Coefficients of this branch.
    pub fn piece<S: Real>(self, law: &FrictionLaw) -> FrictionPiece<S> {
        let (constant, viscous) = match self {
            Self::Viscous => (0.0, law.viscous),
            Self::Falling => law.falling.into(),
            Self::Steady => (1.0, 0.0),
        };
        FrictionPiece {
            constant: S::constant(constant),
            viscous: S::constant(viscous),
        }
    }

    /// Range of S² over which this branch holds.
    pub fn bounds(self, law: &FrictionLaw) -> Bounds {
        let limit = law.viscous_limit;
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
