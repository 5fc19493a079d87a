//! Where the feet stand, by which stability is judged.

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
    /// From the signals of all legs, with the CG at a depth (ft) below the surface.
    pub fn from_signals(signals: &Signals<f64>, depth: f64) -> Self {
        let legs = signals.leg_count();
        let foot = [Signal::FootX, Signal::FootY, Signal::FootZ];
        Self {
            feet: PerLeg::from_fn(legs, |j| foot.map(|signal| signals.of(j, signal)).into()),
            depth,
            hardpoint_depths: PerLeg::from_fn(legs, |j| signals.of(j, Signal::HardpointDepth)),
        }
    }
}

impl Motion<f64> {
    /// Where the feet stand at a state.
    pub fn footing(&self, state: &State<f64>) -> Footing {
        let body = state.body();
        let frame = self.frame(&body);
        Footing {
            feet: PerLeg::from_fn(self.leg_count(), |j| {
                let pivot = self.legs[j].geometry.pivot(state.leg(j).link_angle);
                frame.seen_from_center_of_gravity(&pivot)
            }),
            depth: self.surface.depth(&body.position),
            hardpoint_depths: PerLeg::from_fn(self.leg_count(), |j| {
                let [_, block] = self.ground(j, &frame);
                block.depth_of(&self.legs[j].geometry.lower_hardpoint())
            }),
        }
    }
}
