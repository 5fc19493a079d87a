//! The greatest force of each strut at the ends of steps, and its greatest stroke.

use crate::per_leg::PerLeg;

/// Greatest values so far; forces are those at the ends of steps.
#[derive(Debug, Clone, Copy)]
pub(super) struct StrutPeaks {
    /// Magnitude of the force F, lb.
    pub(super) force: PerLeg<f64>,
    /// Stroke δ, ft.
    pub(super) stroke: PerLeg<f64>,
}

impl StrutPeaks {
    pub(super) fn none(legs: usize) -> Self {
        Self {
            force: PerLeg::same(legs, 0.0),
            stroke: PerLeg::same(legs, 0.0),
        }
    }
}
