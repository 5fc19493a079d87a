//! Pressures on the sections of a footpad, and the normal forces (29) that they make.
//!
//! Soil that is pushed aside adds α ż² to them, ż being the rate at which a section sinks (docs/model.md, "Soil").

use super::LegPieces;
use super::leg::LegMotion;
use crate::kinematics::{LegFrame, LegPose};
use crate::scalar::Real;
use crate::state::LegState;

impl<S: Real> LegMotion<S> {
    /// Normal force (29) on the footpad per unit of relative pressure in both sections, lb.
    #[inline(always)]
    pub(super) fn pad_force_per_pressure(&self, pose: &LegPose<S>) -> S {
        self.pad_strength * (pose.pad_upright + pose.pad_inclination)
    }

    /// Normal forces (29) on the outboard and inboard sections of the footpad, lb.
    #[inline(always)]
    pub(super) fn pad_section_forces(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        drags: bool,
    ) -> [S; 2] {
        let per_pressure = self.pad_force_per_pressure(pose);
        let pressures = self.pad_pressures(frame, pose, leg, pieces, drags);
        pressures.map(|pressure| per_pressure * pressure)
    }

    /// Relative pressures on the outboard and inboard section of the footpad, with that of soil that they push aside if it
    /// `drags`.
    #[inline(always)]
    pub(super) fn pad_pressures(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        drags: bool,
    ) -> [S; 2] {
        let mut pressures = self.still_pad_pressures(pose, pieces);
        if drags {
            let rates = self.pad_rates(frame, pose, leg, pieces);
            for k in [0, 1] {
                pressures[k] += pieces.pad[k].drag_at(rates[k]);
            }
        }
        pressures
    }

    /// Relative pressures on them but for that of soil that is pushed aside.
    #[inline(always)]
    pub(super) fn still_pad_pressures(&self, pose: &LegPose<S>, pieces: &LegPieces<S>) -> [S; 2] {
        let [outer, inner] = pose.pad_interference;
        [pieces.pad[0].at(outer), pieces.pad[1].at(inner)]
    }

    /// Rates of the interferences of both sections, ft/s.
    #[inline(always)]
    pub(super) fn pad_rates(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
    ) -> [S; 2] {
        let geometry = &self.geometry;
        let link_rate = pieces.link.moving * leg.link_rate;
        let pivot = frame.pivot_velocity(pose, geometry.link_length() * link_rate);
        let unclipped = pieces.hinge.unclipped_speed(leg.pad_turn, leg.pad_rate);
        let pad_speed = pieces.hinge.speed(unclipped);
        geometry.pad_interference_rates(frame, pose, pivot.inward, link_rate, pad_speed)
    }
}
