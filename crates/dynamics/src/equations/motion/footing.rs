//! Positions of the feet, by which stability is judged.

use nalgebra::Vector3;

use super::{Motion, Signal, Signals};
use crate::per_leg::PerLeg;
use crate::state::State;

/// Feet and hardpoints of a vehicle over the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footing {
    /// Footpad pivots (7) relative to the CG, in ground axes, ft.
    pub feet: PerLeg<Vector3<f64>>,
    /// Depth of the CG below the surface, ft (negative above).
    pub depth: f64,
    /// Depth of the lower hardpoints (6) below the ground of the blocks beside them, ft (negative above).
    pub hardpoint_depths: PerLeg<f64>,
}

impl Footing {
    /// Takes the footing from the signals of all legs, with the CG at a depth (ft) below the surface.
    #[inline(always)]
    pub fn from_signals(signals: &Signals<f64>, depth: f64) -> Self {
        let legs = signals.leg_count();
        let mut footing = Self::level(legs, depth);
        for j in 0..legs {
            let foot = &mut footing.feet[j];
            foot.x = signals.of(j, Signal::FootX);
            foot.y = signals.of(j, Signal::FootY);
            foot.z = signals.of(j, Signal::FootZ);
            footing.hardpoint_depths[j] = signals.of(j, Signal::HardpointDepth);
        }
        footing
    }

    /// Blank feet, with the CG at a depth (ft) below the surface.
    #[inline(always)]
    fn level(legs: usize, depth: f64) -> Self {
        Self {
            feet: PerLeg::same(legs, Vector3::from([0.0; 3])),
            depth,
            hardpoint_depths: PerLeg::same(legs, 0.0),
        }
    }
}

impl Motion<f64> {
    /// Positions of the feet at a state.
    #[inline(always)]
    pub fn footing(&self, state: &State<f64>) -> Footing {
        let body = state.body();
        let frame = self.frame(&body);
        let mut footing = Footing::level(self.leg_count(), self.surface.depth(&body.position));
        for (j, leg) in self.legs.iter().enumerate() {
            let pivot = leg.geometry.pivot(state.leg(j).link_angle);
            footing.feet[j] = frame.seen_from_center_of_gravity(&pivot);
            let [_, block] = self.ground(j, &frame);
            footing.hardpoint_depths[j] = block.depth_of(&leg.geometry.lower_hardpoint());
        }
        footing
    }
}
