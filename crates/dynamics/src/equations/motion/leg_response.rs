//! Derivatives of the forces on a leg with respect to the motion.

use nalgebra::{Matrix3, Vector3, Vector4, Vector6};

use super::leg::LegMotion;
use super::pieces::Pressed;
use super::{LegPieces, Motion, Pieces, at_angle};
use crate::friction::FrictionPiece;
use crate::kinematics::{
    BodyFrame, LegFrame, LegGeometry, LegPose, PlaneDirection, PlanePoint, PointVelocity,
    SeenAlongLeg,
};
use crate::per_leg::PerLeg;
use crate::response::{Coordinates, ForceDerivative, LegResponse, Response};
use crate::scalar::Real;
use crate::state::{LegState, State};

impl<S: Real> Motion<S> {
    /// The response of a vehicle that hangs in the air, to be overwritten by [`Self::respond`].
    pub fn response(&self) -> Response<S> {
        let (zero, one) = (S::zero(), S::one());
        Response {
            rotation: Matrix3::from([[zero; 3]; 3]),
            quaternion: Vector4::from([one, zero, zero, zero]),
            mass: self.mass,
            inertia: self.inertia,
            legs: PerLeg::same(self.legs.len(), LegResponse::none()),
        }
    }

    /// Writes the derivatives of the forces at a state.
    #[inline(always)]
    pub fn respond(&self, state: &State<S>, pieces: &Pieces<S>, response: &mut Response<S>) {
        let body = state.body();
        let frame = self.frame(&body);
        response.rotation = frame.rotation;
        response.quaternion = body.quaternion;
        // Landings come and go in lanes, and their bodies with them.
        response.mass = self.mass;
        response.inertia = self.inertia;
        for leg in 0..self.legs.len() {
            let active = pieces.leg(leg);
            self.legs[leg].respond(
                &frame,
                &at_angle(active, state.leg(leg)),
                &active.leg,
                active.pressed,
                &mut response.legs[leg],
            );
        }
    }
}

impl<S: Real> LegMotion<S> {
    /// Writes the derivatives of the forces on this leg, the pad's turn being its angle: those of what
    /// [`Self::action`] computes, but for attitude factors and for levers of the body.
    #[inline(always)]
    pub(super) fn respond(
        &self,
        body: &BodyFrame<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        pressed: Pressed,
        response: &mut LegResponse<S>,
    ) {
        let geometry = &self.geometry;
        response.clear();
        response.inertia = [self.link_inertia, self.pad_inertia];
        response.link_moves = pieces.link.moving;
        response.link_damping = pieces.link.run_down() * self.link_inertia;
        let pad_angle = leg.pad_turn;
        response.pad_turn = pieces.hinge.turn_changes(pad_angle);
        response.hinge_gain = pieces.hinge.gain_at(pad_angle);
        response.swings_pads = !response.hinge_gain.is_zero();
        // Legs that hang in the air have no other forces.
        if !pressed.pads && !pressed.blocks && pieces.link.free.is_zero() {
            return;
        }
        let seen;
        let grounds = if self.ground.is_even() {
            [&body.surface; 2]
        } else {
            seen = self.ground.seen(body);
            [&seen[0], &seen[1]]
        };
        let frame = geometry.frame(body, grounds);
        let pose = geometry.pose(&frame, leg.link_angle, pad_angle);
        let posture = Posture {
            body,
            frame: &frame,
            pose: &pose,
            leg,
            pieces,
        };
        if pressed.pads {
            self.footpad_responds(&posture, response);
        }
        if pressed.blocks {
            self.block_responds(&posture, response);
        }
        self.strut_responds(&posture, response);
    }

    /// Footpad: normal force (29), friction (39), torque about its hinge (52), (69), and what the link bears of it
    /// (49), (68).
    #[inline(always)]
    fn footpad_responds(&self, posture: &Posture<'_, S>, response: &mut LegResponse<S>) {
        let Posture {
            body,
            frame,
            pose,
            leg,
            pieces,
        } = *posture;
        let geometry = &self.geometry;
        let length = geometry.link_length();
        let swing = pose.link_normal.in_leg_axes() * length;
        // The pivot swings on a circle about the hardpoint.
        let toward_hardpoint = Vector3::new(-swing.z, S::zero(), swing.x);
        let velocity = frame.pivot_velocity(pose, length * leg.link_rate);
        let contact = Contact {
            geometry,
            body,
            ground: &frame.pad,
            point: &pose.pivot,
            velocity: &velocity,
            carried: frame.carried_round(&pose.pivot) + swing * leg.link_rate,
            swing,
            bend: frame.rate().cross(&swing) + toward_hardpoint * leg.link_rate,
            link_share: pieces.link.free,
            friction: &pieces.pad_friction,
            coefficient: self.pad_friction,
        };
        let line = contact.line();
        let along_line = contact.along(&line);
        let per_pressure = self.pad_force_per_pressure(pose);
        let mut force = S::zero();
        let mut hinge_lever = PlaneDirection::zero();
        let mut press = Coordinates::zero();
        for k in [0, 1] {
            let centroid = geometry.section_centroid(pose, k);
            let borne = per_pressure * pieces.pad[k].at(pose.pad_interference[k]);
            force += borne;
            let deeper = contact.deeper(pose, &centroid);
            let slope = pieces.pad[k].slope();
            press.add(slope, &deeper);
            if response.swings_pads {
                // The lever of (52).
                let lever = centroid.turned();
                hinge_lever.add(borne, &lever);
                let torque =
                    borne * pose.pad_y.dot(&line) + per_pressure * slope * lever.dot(&line);
                response.hinge_torque.add(torque, &deeper);
                // As the pad tilts, its levers turn with it.
                let leaning = borne * centroid.dot(&line);
                response.hinge_torque.pad += leaning;
                response.hinge_torque.link -= leaning;
            }
        }
        let [along, across] = contact.rub(force, &hinge_lever);
        response.push(&along);
        response.push(&across);
        response.push(&ForceDerivative {
            force: contact.force(&along_line, -per_pressure, S::zero()),
            velocity: Coordinates::zero(),
            displacement: press,
        });
        let force = line * -force;
        response.link_torque = contact.turned(&swing.cross(&force), toward_hardpoint.dot(&force));
    }

    /// Block: normal force (33), friction (39).
    #[inline(always)]
    fn block_responds(&self, posture: &Posture<'_, S>, response: &mut LegResponse<S>) {
        let Posture {
            body,
            frame,
            pose,
            pieces,
            ..
        } = *posture;
        let point = &pose.block_center;
        let none = Vector3::from([S::zero(); 3]);
        let velocity = frame.block_velocity(pose);
        let contact = Contact {
            geometry: &self.geometry,
            body,
            ground: &frame.block,
            point,
            velocity: &velocity,
            carried: frame.carried_round(point),
            swing: none,
            bend: none,
            link_share: S::zero(),
            friction: &pieces.block_friction,
            coefficient: self.block_friction,
        };
        let force = self.block_normal(frame, pose, pieces);
        let [along, across] = contact.rub(force, &PlaneDirection::zero());
        response.push(&along);
        response.push(&across);
        let per_depth = self.block_force_per_pressure(frame) * pieces.block.slope();
        let along_line = contact.along(&contact.line());
        let mut deeper = contact.along(&frame.block.normal);
        // An interference grows by so much per depth.
        deeper.body *= frame.block.upright;
        response.push(&ForceDerivative {
            force: contact.force(&along_line, -per_depth, S::zero()),
            velocity: Coordinates::zero(),
            displacement: deeper,
        });
    }

    /// Strut (42)-(45) on the link (68), which may not be free to move.
    #[inline(always)]
    fn strut_responds(&self, posture: &Posture<'_, S>, response: &mut LegResponse<S>) {
        let Posture {
            pose, leg, pieces, ..
        } = *posture;
        let free = pieces.link.free;
        let (stroke, lever) = (pose.stroke, pose.strut_lever);
        let damping = pieces.strut.damping(stroke, leg.link_rate, lever);
        let lever_change = self.geometry.strut_lever_change(stroke, lever);
        let strut = (pieces.strut).torque_change(stroke, leg.link_rate, lever, lever_change);
        response.link_damping += free * damping * lever;
        response.link_torque.link += strut;
        response.link_torque.body *= free;
        response.link_torque.link *= free;
    }
}

/// Where a leg is and which pieces of its laws are active.
#[derive(Clone, Copy)]
struct Posture<'a, S> {
    body: &'a BodyFrame<S>,
    frame: &'a LegFrame<S>,
    pose: &'a LegPose<S>,
    leg: &'a LegState<S>,
    pieces: &'a LegPieces<S>,
}

/// A footpad's pivot or a block's crushed centre, pressed on the surface; vectors in leg axes.
struct Contact<'a, S> {
    geometry: &'a LegGeometry<S>,
    body: &'a BodyFrame<S>,
    ground: &'a SeenAlongLeg<S>,
    point: &'a PlanePoint<S>,
    velocity: &'a PointVelocity<S>,
    /// Its velocity relative to the CG, ft/s.
    carried: Vector3<S>,
    /// Its velocity per link rate, ft.
    swing: Vector3<S>,
    /// Change of its velocity per link angle, ft/s.
    bend: Vector3<S>,
    /// 1 where the force turns the link, else 0.
    link_share: S,
    friction: &'a FrictionPiece<S>,
    /// Nominal coefficient of friction.
    coefficient: S,
}

impl<S: Real> Contact<'_, S> {
    /// n + μ t̂.
    #[inline(always)]
    fn line(&self) -> Vector3<S> {
        let per_speed = self.friction.per_speed(self.velocity.sliding_squared);
        self.ground.normal + self.velocity.sliding * (self.coefficient * per_speed)
    }

    /// A quantity that changes with rotation of the body and with the link.
    #[inline(always)]
    fn turned(&self, rotation: &Vector3<S>, link: S) -> Coordinates<S> {
        let r = self.geometry.in_vehicle_axes(rotation);
        let zero = S::zero();
        Coordinates {
            body: Vector6::new(zero, zero, zero, r.x, r.y, r.z),
            link,
            pad: zero,
        }
    }

    /// A quantity that changes with translation of the body (vehicle axes), with its rotation about the centre (leg axes)
    /// and with the link.
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
    fn along(&self, direction: &Vector3<S>) -> Coordinates<S> {
        self.moved(
            &self.geometry.in_vehicle_axes(direction),
            &self.point.moment(direction),
            self.swing.dot(direction),
        )
    }

    /// What a force (lb) does that acts `along` a direction, with a torque on the pad's hinge.
    #[inline(always)]
    fn force(&self, along: &Coordinates<S>, force: S, on_hinge: S) -> Coordinates<S> {
        Coordinates {
            body: along.body * force,
            link: self.link_share * (along.link * force),
            pad: on_hinge,
        }
    }

    /// Interference (19) of the pad section at this crushed centroid, per displacement.
    #[inline(always)]
    fn deeper(&self, pose: &LegPose<S>, centroid: &PlaneDirection<S>) -> Coordinates<S> {
        let n = &self.ground.normal;
        let up = pose.pad_upright;
        // The pad tilts with its link, and against its own angle.
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

    /// Derivatives of friction under a normal force (lb) with respect to sliding along and across. `hinge_lever` is the lever
    /// of the pad's hinge times the normal force.
    #[inline(always)]
    fn rub(&self, force: S, hinge_lever: &PlaneDirection<S>) -> [ForceDerivative<S>; 2] {
        let (along, across) = self.ground.tangents(self.velocity);
        let across_rate = self.friction.per_speed(self.velocity.sliding_squared);
        [
            self.rub_along(&along, self.friction.change(), force, hinge_lever),
            self.rub_along(&across, across_rate, force, hinge_lever),
        ]
    }

    /// The same for one direction, at this rate dμ/dS over the nominal coefficient, s/ft.
    #[inline(always)]
    fn rub_along(
        &self,
        direction: &Vector3<S>,
        rate: S,
        force: S,
        hinge_lever: &PlaneDirection<S>,
    ) -> ForceDerivative<S> {
        let rate = -(self.coefficient * rate);
        let velocity = self.along(direction);
        let on_hinge = -(rate * hinge_lever.dot(direction));
        ForceDerivative {
            force: self.force(&velocity, force * rate, on_hinge),
            velocity,
            displacement: self.turned(&self.carried.cross(direction), self.bend.dot(direction)),
        }
    }
}
