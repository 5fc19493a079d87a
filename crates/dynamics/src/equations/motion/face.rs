//! Action of the ground on the face of a footpad and the end of a block ([`crate::rules::ContactRule::Face`]).
//!
//! Forces act where the ground is touched and follow the velocity of that place. The energy that an element stores
//! elastically is a function of depth and inclination, of which the forces are the derivatives: crush and friction only
//! take energy.

use nalgebra::Vector3;

use super::LegPieces;
use super::leg::{LegMotion, Touch};
use crate::kinematics::{LegFrame, LegPose, PlaneDirection, turned};
use crate::scalar::Real;
use crate::state::LegState;

/// Place and magnitude of the ground's push on a footpad.
pub(super) struct Press<S> {
    /// Centre of pressure of the sections, or lowest point of the rim, relative to the pivot in leg axes, ft.
    pub(super) place: Vector3<S>,
    /// Normal force, lb.
    pub(super) normal: S,
    /// Change of the sections' stored energy with cos ξ at the same depth, ft·lb.
    pub(super) leaning: S,
}

impl<S: Real> LegMotion<S> {
    /// Place and magnitude of the ground's push on a footpad by these relative pressures on its sections. Their normal
    /// forces amount to one at their centre of pressure, with one friction force. Between unloaded sections the centre is in
    /// the middle.
    #[inline(always)]
    pub(super) fn press(
        &self,
        pressures: &[S; 2],
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        pieces: &LegPieces<S>,
    ) -> Press<S> {
        let (zero, one) = (S::zero(), S::one());
        // What drags stores nothing.
        let [outer, inner] = self.still_pad_pressures(pose, pieces);
        let leaning = self.pad_leaning * pose.pad_inclination * (outer * outer + inner * inner);
        let [outer, inner] = *pressures;
        let on_face = self.pad_force_per_pressure(pose) * (outer + inner);
        // The stages of a step may pull a little.
        let (outer, inner) = (outer.max(zero), inner.max(zero));
        let sum = outer + inner;
        let share = sum.where_zero(S::constant(0.5), outer / sum);
        let mut center = PlaneDirection::zero();
        center.add(share, &self.geometry.section_centroid(pose, 0));
        center.add(one - share, &self.geometry.section_centroid(pose, 1));
        let (center, edge) = (center.in_leg_axes(), self.geometry.edge(frame, pose));
        let on_edge = pieces.edge.is_active;
        Press {
            place: Vector3::new(
                on_edge.where_zero(center.x, edge.x),
                on_edge.where_zero(center.y, edge.y),
                on_edge.where_zero(center.z, edge.z),
            ),
            normal: on_face + self.edge_load(frame, pose, pieces),
            leaning,
        }
    }

    /// Action of the ground on a footpad; its torque (52) on the hinge, opening positive (ft·lb); and the power that leaning
    /// takes up (ft·lb/s).
    #[inline(always)]
    pub(super) fn face_touch(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        drags: bool,
    ) -> (Touch<S>, S, S) {
        let n = &frame.pad.normal;
        let swing = self.geometry.link_length() * leg.link_rate;
        let pressures = self.pad_pressures(frame, pose, leg, pieces, drags);
        let press = self.press(&pressures, frame, pose, pieces);
        let turning = pieces.hinge.pad_turning(leg.link_rate, leg.pad_rate);
        let by_hinge = turned(&press.place);
        let at = pose.pivot.in_leg_axes() + press.place;
        let own = pose.link_normal.in_leg_axes() * swing + by_hinge * turning;
        let velocity = frame.pad_velocity(&at, &own);
        let drag = self.pad_friction * pieces.pad_friction.per_speed(velocity.sliding_squared);
        let line = n + velocity.sliding * drag;
        let force = line * -press.normal;
        let lean = pose.pad_z.in_leg_axes().cross(n) * press.leaning;
        let touch = Touch {
            moment: at.cross(&force) - lean,
            velocity,
            normal: press.normal,
            drag,
            line,
            force,
        };
        (
            touch,
            -(by_hinge.dot(&force) + press.leaning * pose.pad_y_normal),
            press.leaning * frame.inclination_rate(pose, turning),
        )
    }

    /// Moment on the body (leg axes, ft·lb) and power (ft·lb/s) of a block that leans on the ground: its stored energy
    /// changes with cos ξ_B at the same depth.
    #[inline(always)]
    pub(super) fn block_leaning(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        pieces: &LegPieces<S>,
    ) -> (Vector3<S>, S) {
        let n = &frame.block.normal;
        let pressure = pieces.block.at(pose.block_interference);
        let factor = S::one() + S::constant(3.0) * n.z * n.z;
        let leaning = self.block_leaning * factor * (pressure * pressure);
        (
            Vector3::new(leaning * n.y, -(leaning * n.x), S::zero()),
            leaning * frame.block_inclination_rate(),
        )
    }
}
