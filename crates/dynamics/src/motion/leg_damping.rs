//! What friction and struts of the legs do to the velocities: the damping matrix at a state.

use pulp::NullaryFnOnce;

use super::leg::LegMotion;
use super::{Group, LegPieces, Motion, Pieces};
use crate::damping::{Damping, LegDamping};
use crate::friction::FrictionPiece;
use crate::kinematics::{BodyFrame, LegFrame, LegPose, PlanePoint, PointVelocity};
use crate::quad::{Abreast, LANES, Quad, groups_of};
use crate::scalar::Real;
use crate::state::{LegState, State};

impl<const LEGS: usize> Motion<LEGS> {
    /// Damping matrix at a state.
    pub fn damping(&self, state: &State<f64, LEGS>, pieces: &Pieces<LEGS>) -> Damping<f64, LEGS> {
        let frame = self.surface.frame(&state.body());
        let mut damping = Damping::none();
        for index in 0..const { groups_of(LEGS) } {
            let group = self.group(index, &frame, state, pieces);
            let legs = self.arch.dispatch(GroupDamping(group));
            let first = index * LANES;
            for j in first..LEGS.min(first + LANES) {
                damping.add(j, &LegDamping::lane(&legs, j - first));
            }
        }
        damping
    }
}

/// What a group of legs does to the velocities.
struct GroupDamping<'a, const LEGS: usize>(Group<'a, LEGS>);

impl<const LEGS: usize> NullaryFnOnce for GroupDamping<'_, LEGS> {
    type Output = LegDamping<Quad>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Group {
            index,
            state,
            frame,
            motion,
            pieces,
        } = self.0;
        motion.damping(&frame.shared(), &state.legs_abreast(index), pieces)
    }
}

impl<S: Real> LegMotion<S> {
    /// What friction and strut of this leg do to the velocities.
    #[inline(always)]
    fn damping(
        &self,
        body: &BodyFrame<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
    ) -> LegDamping<S> {
        let mut damping = LegDamping::none();
        let is_pad_slack = pieces.pad[0].is_slack() && pieces.pad[1].is_slack();
        let is_block_slack = pieces.block.is_slack();
        // Legs that hang in the air damp nothing.
        if is_pad_slack && is_block_slack && pieces.link.free.is_zero() {
            return damping;
        }
        let frame = self.geometry.frame(body);
        let pose = self.geometry.pose(&frame, leg.link_angle, leg.pad_angle);
        let [outer, inner] = pose.pad_interference;
        if !is_pad_slack {
            let velocity = frame.pivot_velocity(&pose, self.geometry.link_length() * leg.link_rate);
            let per_pressure = self.pad_force_per_pressure(&pose);
            let normal = per_pressure * (pieces.pad[0].at(outer) + pieces.pad[1].at(inner));
            let rub = Rub {
                point: pose.pivot,
                velocity,
                strength: self.pad_friction * normal.max(S::zero()),
                piece: pieces.pad_friction,
                swing: self.geometry.link_length() * pieces.link.free,
            };
            self.add_rub(&mut damping, body, &frame, &pose, &rub);
        }
        if !is_block_slack {
            let velocity = frame.velocity_at(&pose.block_center);
            let normal = self.block_normal(&frame, &pose, pieces);
            let rub = Rub {
                point: pose.block_center,
                velocity,
                strength: self.block_friction * normal.max(S::zero()),
                piece: pieces.block_friction,
                swing: S::zero(),
            };
            self.add_rub(&mut damping, body, &frame, &pose, &rub);
        }
        let strut = pieces
            .strut
            .damping(pose.stroke, leg.link_rate, pose.strut_lever);
        damping.add_to_link((pieces.link.free * strut * pose.strut_lever).max(S::zero()));
        damping
    }
    /// Adds what friction at one point does, along and across its sliding.
    #[inline(always)]
    fn add_rub(
        &self,
        damping: &mut LegDamping<S>,
        body: &BodyFrame<S>,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        rub: &Rub<S>,
    ) {
        let (along, across) = frame.tangents(&rub.velocity);
        let across_rate = rub.piece.per_speed(rub.velocity.sliding_squared);
        for (direction, rate) in [(along, rub.piece.growth()), (across, across_rate)] {
            let force = body.rotation * self.geometry.in_vehicle_axes(&direction);
            let moment = self.geometry.in_vehicle_axes(&rub.point.moment(&direction));
            let link = rub.swing * pose.link_normal.dot(&direction);
            damping.add(rub.strength * rate, &force, &moment, link);
        }
    }
}

/// A point that rubs on the surface.
struct Rub<S> {
    point: PlanePoint<S>,
    velocity: PointVelocity<S>,
    /// Nominal coefficient of friction times normal force, lb.
    strength: S,
    piece: FrictionPiece<S>,
    /// Velocity of the point per link rate, ft.
    swing: S,
}
