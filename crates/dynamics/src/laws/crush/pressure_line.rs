//! The line on which the pressure on an element is between events.

use crate::lanes::per_lane;
use crate::scalar::Real;

/// A straight line of relative pressure against interference (ft), and what soil that is pushed aside adds to it.
#[derive(Debug, Clone, Copy)]
pub struct PressureLine<S> {
    pub(super) offset: S,
    pub(super) slope: S,
    /// Relative pressure per squared rate of the interference, s²/ft².
    pub(super) drag: S,
}

per_lane!(PressureLine {
    offset,
    slope,
    drag
});

impl<S: Real> PressureLine<S> {
    /// No pressure at any interference.
    pub fn slack() -> Self {
        Self {
            offset: S::zero(),
            slope: S::zero(),
            drag: S::zero(),
        }
    }

    /// Returns whether there is no pressure at any interference.
    #[inline(always)]
    pub fn is_slack(&self) -> bool {
        self.offset.is_zero() && self.slope.is_zero()
    }

    /// Change of relative pressure with interference, 1/ft.
    #[inline(always)]
    pub fn slope(&self) -> S {
        self.slope
    }

    /// Relative pressure at interference I.
    #[inline(always)]
    pub fn at(&self, interference: S) -> S {
        self.offset + self.slope * interference
    }

    /// Returns whether the rate of the interference matters.
    #[inline(always)]
    pub fn has_drag(&self) -> bool {
        !self.drag.is_zero()
    }

    /// Relative pressure that an interference growing at this rate (ft/s) adds.
    #[inline(always)]
    pub fn drag_at(&self, rate: S) -> S {
        self.drag * rate * rate.max(S::zero())
    }

    /// Change of that pressure with the rate, s/ft.
    #[inline(always)]
    pub fn drag_damping(&self, rate: S) -> S {
        S::constant(2.0) * self.drag * rate.max(S::zero())
    }
}
