//! What friction and struts of the legs do to the velocities: the damping matrix at a state.

use super::{LegMotion, LegPieces, Motion};
use crate::damping::Damping;
use crate::friction::FrictionPiece;
use crate::kinematics::{BodyFrame, PlanePoint, PointVelocity};
use crate::scalar::Real;
use crate::state::{LegState, State};

impl<S: Real, const LEGS: usize> Motion<S, LEGS> {
    /// Damping matrix at a state.
    #[inline(never)]
    pub fn damping(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
    ) -> Damping<S, LEGS> {
        let frame = self.surface.frame(&state.body());
        let mut damping = Damping::none();
        for (j, (leg, pieces)) in self.legs.iter().zip(pieces).enumerate() {
            leg.add_damping(j, &frame, &state.leg(j), pieces, &mut damping);
        }
        damping
    }
}

impl<S: Real> LegMotion<S> {
    /// Adds what friction and strut of this leg do to the velocities.
    #[inline(always)]
    fn add_damping<const LEGS: usize>(
        &self,
        j: usize,
        body: &BodyFrame<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        damping: &mut Damping<S, LEGS>,
    ) {
        let is_pad_slack = pieces.pad[0].is_slack() && pieces.pad[1].is_slack();
        let is_block_slack = pieces.block.is_slack();
        // A leg that hangs in the air damps nothing.
        if is_pad_slack && is_block_slack && pieces.link.free.is_zero() {
            return;
        }
        let frame = self.geometry.frame(body);
        let pose = self.geometry.pose(&frame, leg.link_angle, leg.pad_angle);
        let link_length = self.geometry.link_length() * pieces.link.free;
        let mut add = |point: &PlanePoint<S>,
                       velocity: &PointVelocity<S>,
                       strength: S,
                       piece: &FrictionPiece<S>,
                       swings: S| {
            let (along, across) = frame.tangents(velocity);
            let across_rate = piece.per_speed(velocity.sliding_squared);
            for (direction, rate) in [(along, piece.growth()), (across, across_rate)] {
                let force = body.rotation * self.geometry.in_vehicle_axes(&direction);
                let moment = self.geometry.in_vehicle_axes(&point.moment(&direction));
                let link = swings * pose.link_normal.dot(&direction);
                damping.add(j, strength * rate, &force, &moment, link);
            }
        };
        let [outer, inner] = pose.pad_interference;
        if !is_pad_slack {
            let velocity = frame.pivot_velocity(&pose, self.geometry.link_length() * leg.link_rate);
            let per_pressure = self.pad_force_per_pressure(&pose);
            let normal = per_pressure * (pieces.pad[0].at(outer) + pieces.pad[1].at(inner));
            add(
                &pose.pivot,
                &velocity,
                self.pad_friction * normal.max(S::zero()),
                &pieces.pad_friction,
                link_length,
            );
        }
        if !is_block_slack {
            let velocity = frame.velocity_at(&pose.block_center);
            let normal = self.block_normal(&frame, &pose, pieces);
            add(
                &pose.block_center,
                &velocity,
                self.block_friction * normal.max(S::zero()),
                &pieces.block_friction,
                S::zero(),
            );
        }
        let strut = pieces
            .strut
            .damping(pose.stroke, leg.link_rate, pose.strut_lever);
        damping.add_to_link(
            j,
            (pieces.link.free * strut * pose.strut_lever).max(S::zero()),
        );
    }
}
