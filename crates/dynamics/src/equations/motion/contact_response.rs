//! Changes of the forces on a footpad or block as it moves over the surface.

use nalgebra::{Vector3, Vector6};

use super::LegPieces;
use super::leg::LegMotion;
use crate::friction::FrictionPiece;
use crate::kinematics::{
    BodyFrame, LegFrame, LegGeometry, LegPose, PlaneDirection, PlanePoint, PointVelocity,
    SeenAlongLeg, turned,
};
use crate::response::{Coordinates, ForceDerivative, greatest_decay};
use crate::scalar::Real;
use crate::state::LegState;

/// Posture of a leg and the active pieces of its laws.
#[derive(Clone, Copy)]
pub(super) struct Posture<'a, S> {
    pub(super) body: &'a BodyFrame<S>,
    pub(super) frame: &'a LegFrame<S>,
    pub(super) pose: &'a LegPose<S>,
    pub(super) leg: &'a LegState<S>,
    pub(super) pieces: &'a LegPieces<S>,
}

/// A footpad's pivot or a block's crushed centre, pressed on the surface; with `FACE` the place where a footpad is
/// pressed. Vectors are in leg axes.
pub(super) struct Contact<'a, S, const FACE: bool> {
    pub(super) geometry: &'a LegGeometry<S>,
    pub(super) body: &'a BodyFrame<S>,
    pub(super) ground: &'a SeenAlongLeg<S>,
    pub(super) point: &'a PlanePoint<S>,
    /// Offset from there to the place where the force acts, ft.
    pub(super) offset: Vector3<S>,
    pub(super) velocity: PointVelocity<S>,
    /// Velocity of that place relative to the CG, ft/s.
    pub(super) carried: Vector3<S>,
    /// Velocity of the point per link rate, ft.
    pub(super) swing: Vector3<S>,
    /// Change of the velocity per link angle and per pad angle, ft/s.
    pub(super) bend: Vector3<S>,
    pub(super) pad_bend: Vector3<S>,
    /// 1 if the pad turns by itself, 0 if it is one with its link.
    pub(super) swings: S,
    /// Rate at which the pad turns in the vehicle, rad/s.
    pub(super) turning: S,
    /// 1 if the force turns the link, else 0.
    pub(super) link_share: S,
    pub(super) friction: &'a FrictionPiece<S>,
    /// Nominal coefficient of friction.
    pub(super) coefficient: S,
}

impl<'a, S: Real> Contact<'a, S, false> {
    /// A footpad's pivot, which swings on a circle about the hardpoint.
    #[inline(always)]
    pub(super) fn of_pad(motion: &'a LegMotion<S>, posture: &Posture<'a, S>) -> Self {
        let Posture {
            body,
            frame,
            pose,
            leg,
            pieces,
        } = *posture;
        let length = motion.geometry.link_length();
        let swing = pose.link_normal.in_leg_axes() * length;
        Self {
            geometry: &motion.geometry,
            body,
            ground: &frame.pad,
            point: &pose.pivot,
            velocity: frame.pivot_velocity(pose, length * leg.link_rate),
            carried: frame.carried_round(&pose.pivot) + swing * leg.link_rate,
            swing,
            bend: frame.rate().cross(&swing) + turned(&swing) * leg.link_rate,
            offset: none(),
            pad_bend: none(),
            swings: S::zero(),
            turning: S::zero(),
            link_share: pieces.link.free,
            friction: &pieces.pad_friction,
            coefficient: motion.pad_friction,
        }
    }

    /// A block's crushed centre, which the body carries.
    #[inline(always)]
    pub(super) fn of_block(motion: &'a LegMotion<S>, posture: &Posture<'a, S>) -> Self {
        let Posture {
            body,
            frame,
            pose,
            pieces,
            ..
        } = *posture;
        let point = &pose.block_center;
        Self {
            geometry: &motion.geometry,
            body,
            ground: &frame.block,
            point,
            velocity: frame.block_velocity(pose),
            carried: frame.carried_round(point),
            swing: none(),
            bend: none(),
            offset: none(),
            pad_bend: none(),
            swings: S::zero(),
            turning: S::zero(),
            link_share: S::zero(),
            friction: &pieces.block_friction,
            coefficient: motion.block_friction,
        }
    }
}

impl<'a, S: Real> Contact<'a, S, true> {
    /// The place where a footpad is pressed, at this offset from its pivot (leg axes, ft).
    #[inline(always)]
    pub(super) fn of_face(
        motion: &'a LegMotion<S>,
        posture: &Posture<'a, S>,
        offset: Vector3<S>,
    ) -> Self {
        let Posture {
            body,
            frame,
            pose,
            leg,
            pieces,
        } = *posture;
        let swing = pose.link_normal.in_leg_axes() * motion.geometry.link_length();
        let (by_hinge, turning) = (
            turned(&offset),
            pieces.hinge.pad_turning(leg.link_rate, leg.pad_rate),
        );
        let own = swing * leg.link_rate + by_hinge * turning;
        let place = pose.pivot.in_leg_axes() + offset;
        let pad_bend = frame.rate().cross(&by_hinge) + turned(&by_hinge) * turning;
        Self {
            geometry: &motion.geometry,
            body,
            ground: &frame.pad,
            point: &pose.pivot,
            velocity: frame.pad_velocity(&place, &own),
            carried: frame.place_carried_round(&place) + own,
            swing,
            bend: frame.rate().cross(&swing) + turned(&swing) * leg.link_rate + pad_bend,
            offset,
            pad_bend,
            swings: pieces.hinge.swings(),
            turning,
            link_share: pieces.link.free,
            friction: &pieces.pad_friction,
            coefficient: motion.pad_friction,
        }
    }

    /// Change of the forces on a footpad with the interference of the section at this crushed centroid: of its normal
    /// force (lb), with this stiffness (lb/ft), and of friction as its place moves.
    #[inline(always)]
    pub(super) fn push_back(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        centroid: &Vector3<S>,
        [normal, stiffness]: [S; 2],
    ) -> Coordinates<S> {
        let line = self.along_beside(&self.line(), centroid);
        let mut change = self.force(&line, -stiffness, S::zero());
        // The centre of pressure moves toward the section, which gets shorter.
        let shorter = pose.pad_z.in_leg_axes() * -normal;
        let moved = (centroid - self.offset) * stiffness + shorter;
        change.add(S::one(), &self.displaced(frame, &moved, &shorter));
        change
    }
}

impl<'a, S: Real, const FACE: bool> Contact<'a, S, FACE> {
    /// Change of the forces as the place of a normal force moves by `moved`, of which `shorter` is relative to its
    /// carrier (both times that force, lb·ft): the place then has another velocity, and the force another lever about
    /// the centre.
    #[inline(always)]
    pub(super) fn displaced(
        &self,
        frame: &LegFrame<S>,
        moved: &Vector3<S>,
        shorter: &Vector3<S>,
    ) -> Coordinates<S> {
        let mut change = self.turned(&self.line().cross(shorter), S::zero());
        let faster = frame.rate().cross(moved) + turned(moved) * self.turning;
        for Sliding { direction, rate } in self.slidings() {
            let force = rate * faster.dot(&direction);
            change.add(
                S::one(),
                &self.force(&self.along(&direction), force, S::zero()),
            );
        }
        change
    }

    /// n + μ t̂.
    #[inline(always)]
    pub(super) fn line(&self) -> Vector3<S> {
        let per_speed = self.friction.per_speed(self.velocity.sliding_squared);
        self.ground.normal + self.velocity.sliding * (self.coefficient * per_speed)
    }

    /// A quantity that changes with rotation of the body and with the link.
    #[inline(always)]
    pub(super) fn turned(&self, rotation: &Vector3<S>, link: S) -> Coordinates<S> {
        let r = self.geometry.in_vehicle_axes(rotation);
        let zero = S::zero();
        Coordinates {
            body: Vector6::new(zero, zero, zero, r.x, r.y, r.z),
            link,
            pad: zero,
        }
    }

    /// A quantity that changes with translation of the body (vehicle axes), with its rotation about the centre (leg
    /// axes) and with the link.
    #[inline(always)]
    fn moved(&self, translation: &Vector3<S>, rotation: &Vector3<S>, link: S) -> Coordinates<S> {
        let mut moved = self.turned(rotation, link);
        let of_center = self.body.moment_of_center(translation);
        for i in 0..3 {
            moved.body[i] = translation[i];
            moved.body[i + 3] += of_center[i];
        }
        moved
    }

    /// Velocity of this point in a direction per velocities; a force in that direction acts by the same numbers.
    #[inline(always)]
    pub(super) fn along(&self, direction: &Vector3<S>) -> Coordinates<S> {
        self.along_beside(direction, &self.offset)
    }

    /// Velocity in a direction, per velocities, of a place at this offset from the pivot, ft.
    #[inline(always)]
    pub(super) fn along_beside(
        &self,
        direction: &Vector3<S>,
        offset: &Vector3<S>,
    ) -> Coordinates<S> {
        let translation = self.geometry.in_vehicle_axes(direction);
        let moment = self.point.moment(direction);
        let link = self.swing.dot(direction);
        if !FACE {
            return self.moved(&translation, &moment, link);
        }
        let by_hinge = turned(offset).dot(direction);
        let with_link = (S::one() - self.swings) * by_hinge;
        let mut along = self.moved(
            &translation,
            &(moment + offset.cross(direction)),
            link + with_link,
        );
        along.pad = -(self.swings * by_hinge);
        along
    }

    /// Effect of a force (lb) that acts `along` a direction; if it acts at a pivot, with a torque on the pad's hinge.
    #[inline(always)]
    pub(super) fn force(&self, along: &Coordinates<S>, force: S, on_hinge: S) -> Coordinates<S> {
        Coordinates {
            body: along.body * force,
            link: self.link_share * (along.link * force),
            pad: if FACE { along.pad * force } else { on_hinge },
        }
    }

    /// Interference (19) per displacement of the pad section at this crushed centroid.
    #[inline(always)]
    pub(super) fn deeper(&self, pose: &LegPose<S>, centroid: &PlaneDirection<S>) -> Coordinates<S> {
        let n = &self.ground.normal;
        let up = pose.pad_upright;
        // The pad tilts with its link and against its own angle.
        let tilt = centroid.turned().dot(n) * up;
        let moment = self.point.moment(n) + centroid.in_leg_axes().cross(n);
        let mut deeper = self.moved(
            &(self.geometry.in_vehicle_axes(n) * up),
            &(moment * up),
            self.swing.dot(n) * up + tilt,
        );
        deeper.pad = -tilt;
        deeper
    }

    /// Depth per displacement of a place that the footpad carries at this offset from the pivot (ft).
    #[inline(always)]
    pub(super) fn lowered(&self, offset: &Vector3<S>) -> Coordinates<S> {
        let n = &self.ground.normal;
        let tilt = turned(offset).dot(n);
        let mut lowered = self.moved(
            &self.geometry.in_vehicle_axes(n),
            &(self.point.moment(n) + offset.cross(n)),
            self.swing.dot(n) + tilt,
        );
        lowered.pad = -tilt;
        lowered
    }

    /// Derivatives of friction under a normal force (lb) with respect to sliding along and across. `hinge_lever` is the
    /// lever about the pad's hinge times the normal force.
    #[inline(always)]
    pub(super) fn rub(&self, force: S, hinge_lever: &PlaneDirection<S>) -> [ForceDerivative<S>; 2] {
        let [along, across] = self.slidings();
        [
            self.rub_along(&along, force, hinge_lever),
            self.rub_along(&across, force, hinge_lever),
        ]
    }

    /// The same in one direction.
    #[inline(always)]
    fn rub_along(
        &self,
        sliding: &Sliding<S>,
        force: S,
        hinge_lever: &PlaneDirection<S>,
    ) -> ForceDerivative<S> {
        let Sliding { direction, rate } = sliding;
        let velocity = self.along(direction);
        let on_hinge = -(*rate * hinge_lever.dot(direction));
        let mut displacement =
            self.turned(&self.carried.cross(direction), self.bend.dot(direction));
        if FACE {
            displacement.pad = -self.pad_bend.dot(direction);
        }
        ForceDerivative {
            force: self.force(&velocity, force * *rate, on_hinge),
            velocity,
            displacement,
        }
    }

    /// Greatest decay rates of velocities along and across by friction under a normal force (lb), 1/s, with these
    /// inverses of the inertias of body, link and pad.
    #[inline(always)]
    pub(super) fn decays(&self, force: S, per_body: &[S; 6], per_leg: [S; 2]) -> [S; 2] {
        let [along, across] = self.slidings();
        [
            self.decay(&along, force, per_body, per_leg),
            self.decay(&across, force, per_body, per_leg),
        ]
    }

    /// The same in one direction.
    #[inline(always)]
    fn decay(&self, sliding: &Sliding<S>, force: S, per_body: &[S; 6], per_leg: [S; 2]) -> S {
        let velocity = self.along(&sliding.direction);
        let force = self.force(&velocity, force * sliding.rate, S::zero());
        greatest_decay(&force, &velocity, per_body, per_leg)
    }

    /// The directions along and across the sliding velocity.
    #[inline(always)]
    fn slidings(&self) -> [Sliding<S>; 2] {
        let (along, across) = self.ground.tangents(&self.velocity);
        let across_rate = self.friction.per_speed(self.velocity.sliding_squared);
        [
            Sliding {
                direction: along,
                rate: -(self.coefficient * self.friction.change()),
            },
            Sliding {
                direction: across,
                rate: -(self.coefficient * across_rate),
            },
        ]
    }
}

/// A direction of sliding, in leg axes.
struct Sliding<S> {
    direction: Vector3<S>,
    /// Change of the force along it over the normal force per speed, s/ft.
    rate: S,
}

/// No offset.
#[inline(always)]
fn none<S: Real>() -> Vector3<S> {
    Vector3::from([S::zero(); 3])
}
