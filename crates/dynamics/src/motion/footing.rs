//! Where the feet stand: what stability is judged by.

use nalgebra::Vector3;
use pulp::NullaryFnOnce;

use super::{Glance, Motion, Signal};
use crate::kinematics::BodyFrame;
use crate::products::times;
use crate::quad::{LANES, MOST_LEGS, Quad, groups_of};
use crate::registers::Registers;
use crate::state::State;
use crate::wide::Abreast;

/// Feet and hardpoints of a vehicle over the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footing<const LEGS: usize> {
    /// Footpad pivots (7) relative to the CG, in ground axes, ft.
    pub feet: [Vector3<f64>; LEGS],
    /// Depth of the CG below the surface, ft (negative above).
    pub depth: f64,
    /// Depth of the lower hardpoints (6) below the surface, ft (negative above).
    pub hardpoint_depths: [f64; LEGS],
}

impl<const LEGS: usize> Footing<LEGS> {
    /// As the signals of all legs tell it, with the CG at a depth (ft) below the surface.
    pub fn told(signals: &Glance<LEGS>, depth: f64) -> Self {
        let foot = [Signal::FootX, Signal::FootY, Signal::FootZ];
        Self {
            feet: std::array::from_fn(|j| foot.map(|signal| signals.of(j, signal)).into()),
            depth,
            hardpoint_depths: std::array::from_fn(|j| signals.of(j, Signal::HardpointDepth)),
        }
    }
}

impl<const LEGS: usize> Motion<LEGS> {
    /// Where the feet stand at a state.
    pub fn footing(&self, state: &State<f64, LEGS>) -> Footing<LEGS> {
        let mut footing = Footing {
            feet: [Vector3::zeros(); LEGS],
            depth: 0.0,
            hardpoint_depths: [0.0; LEGS],
        };
        self.registers
            .dispatch(FootingAt(self, state, &mut footing));
        footing
    }
}

/// Writes the footing at a state.
struct FootingAt<'a, const LEGS: usize>(
    &'a Motion<LEGS>,
    &'a State<f64, LEGS>,
    &'a mut Footing<LEGS>,
);

impl<const LEGS: usize> NullaryFnOnce for FootingAt<'_, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, state, footing) = self;
        let body = motion.surface().frame(&state.body());
        let frame: BodyFrame<Quad> = body.shared();
        let mut feet = [Vector3::zeros(); MOST_LEGS];
        let mut depths = [0.0; MOST_LEGS];
        for index in 0..const { groups_of(LEGS) } {
            let geometry = &motion.equations.groups[index].geometry;
            let link_angle = state.legs_abreast(index).link_angle;
            let pivots = times(&frame.rotation, &geometry.pivot(link_angle));
            let hardpoints = frame.depth + frame.normal.dot(&geometry.lower_hardpoint());
            for lane in 0..LANES {
                feet[index * LANES + lane] = Vector3::lane(&pivots, lane);
                depths[index * LANES + lane] = hardpoints.0[lane];
            }
        }
        footing.feet.copy_from_slice(&feet[..LEGS]);
        footing.hardpoint_depths.copy_from_slice(&depths[..LEGS]);
        footing.depth = body.depth;
    }
}
