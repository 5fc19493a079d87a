//! Derivatives of the forces on a leg with respect to the motion.

use nalgebra::{Matrix3, Vector3, Vector4};

use super::contact_response::{Contact, Posture};
use super::leg::LegMotion;
use super::pieces::Pressed;
use super::{LegPieces, Motion, Pieces, at_angle};
use crate::kinematics::{BodyFrame, PlaneDirection, turned};
use crate::per_leg::PerLeg;
use crate::response::{Coordinates, ForceDerivative, LegResponse, Response};
use crate::scalar::Real;
use crate::state::{LegState, State};

/// Share of the error of a pad's rate that counts where the ground acts at its face. Friction makes the rate follow
/// body and link at once; it hardly influences them or the pad's angle, whose errors count in full.
const PAD_ERROR_SHARE: f64 = 0.1;

impl<S: Real> Motion<S> {
    /// Response of a vehicle that hangs in the air, to be overwritten by [`Self::respond`].
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
    pub fn respond<const FACE: bool>(
        &self,
        state: &State<S>,
        pieces: &Pieces<S>,
        response: &mut Response<S>,
    ) {
        let body = state.body();
        let frame = self.frame(&body);
        response.rotation = frame.rotation;
        response.quaternion = body.quaternion;
        // Landings in lanes change, and their bodies with them.
        response.mass = self.mass;
        response.inertia = self.inertia;
        for leg in 0..self.legs.len() {
            let active = pieces.leg(leg);
            self.legs[leg].respond::<FACE>(
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
    /// Writes the derivatives of the forces on this leg, with the pad's turn as its angle: those of the results of
    /// [`Self::action`], but for attitude factors and levers of the body.
    #[inline(always)]
    pub(super) fn respond<const FACE: bool>(
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
        if FACE {
            let swings = pieces.hinge.swings();
            response.inertia[0] += (S::one() - swings) * self.pad_inertia;
            self.hinge_responds(swings, pieces, response);
            response.pad_error_share = S::constant(PAD_ERROR_SHARE);
        }
        // Legs that hang in the air have no other forces.
        if !pressed.pads && !pressed.blocks && pieces.link.free.is_zero() {
            return;
        }
        let frame = self.frame(body);
        let pose = geometry.pose(&frame, leg.link_angle, pad_angle);
        let posture = Posture {
            body,
            frame: &frame,
            pose: &pose,
            leg,
            pieces,
        };
        if pressed.pads {
            if FACE {
                self.face_responds(&posture, pressed.drag, response);
            } else {
                self.footpad_responds(&posture, pressed.drag, response);
            }
        }
        if pressed.blocks {
            self.block_responds::<FACE>(&posture, pressed.drag, response);
        }
        self.strut_responds(&posture, response);
    }

    /// Footpad: normal force (29), friction (39), torque about its hinge (52), (69), and the link's share (49), (68).
    #[inline(always)]
    fn footpad_responds(
        &self,
        posture: &Posture<'_, S>,
        drags: bool,
        response: &mut LegResponse<S>,
    ) {
        let Posture {
            frame,
            pose,
            leg,
            pieces,
            ..
        } = *posture;
        let geometry = &self.geometry;
        let contact = Contact::of_pad(self, posture);
        let line = contact.line();
        let along_line = contact.along(&line);
        let per_pressure = self.pad_force_per_pressure(pose);
        let section_forces = self.pad_section_forces(frame, pose, leg, pieces, drags);
        let mut hinge_lever = PlaneDirection::zero();
        let (mut press, mut drag) = (Coordinates::zero(), Coordinates::zero());
        for k in [0, 1] {
            let centroid = geometry.section_centroid(pose, k);
            let borne = section_forces[k];
            let deeper = contact.deeper(pose, &centroid);
            let slope = pieces.pad[k].slope();
            press.add(slope, &deeper);
            if drags {
                let rate = self.pad_rates(frame, pose, leg, pieces)[k];
                drag.add(pieces.pad[k].drag_damping(rate), &deeper);
            }
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
        let edge_stiffness = pieces.edge.load.slope();
        if !edge_stiffness.is_zero() {
            let deeper = contact.lowered(&geometry.edge(frame, pose));
            press.add(edge_stiffness / per_pressure, &deeper);
        }
        let edge_load = self.edge_load(frame, pose, pieces);
        let force = section_forces[0] + section_forces[1] + edge_load;
        let [along, across] = contact.rub(force, &hinge_lever);
        response.push(&along);
        response.push(&across);
        response.push(&ForceDerivative {
            force: contact.force(&along_line, -per_pressure, S::zero()),
            velocity: drag,
            displacement: press,
        });
        let force = line * -force;
        response.link_torque = contact.turned(
            &contact.swing.cross(&force),
            turned(&contact.swing).dot(&force),
        );
    }

    /// Response of the forces of ground that acts at the face of the footpad.
    #[inline(always)]
    fn face_responds(&self, posture: &Posture<'_, S>, drags: bool, response: &mut LegResponse<S>) {
        let Posture {
            frame,
            pose,
            leg,
            pieces,
            ..
        } = *posture;
        let still = self.still_pad_pressures(pose, pieces);
        let pressures = self.pad_pressures(frame, pose, leg, pieces, drags);
        let press = self.press(&pressures, frame, pose, pieces);
        let contact = Contact::of_face(self, posture, press.place);
        for rubbing in contact.rub(press.normal, &PlaneDirection::zero()) {
            response.push(&rubbing);
        }
        let line = contact.line();
        let force = line * -press.normal;
        let by_hinge = turned(&press.place);
        // Torque (52) under constant forces: its levers turn with the pad, and the forces with the ground.
        let mut on_hinge = contact.turned(&force.cross(&by_hinge), S::zero());
        let per_pressure = self.pad_force_per_pressure(pose);
        let (cosine, sine) = (pose.pad_inclination, pose.pad_y_normal);
        let two = S::constant(2.0);
        let upright = pose.pad_z.in_leg_axes();
        let lean = contact.turned(&upright.cross(&frame.pad.normal), S::zero());
        let mut leaning = S::zero();
        for k in [0, 1] {
            let centroid = self.geometry.section_centroid(pose, k);
            let (pressure, slope) = (still[k], pieces.pad[k].slope());
            let borne = per_pressure * pressures[k];
            let deeper = contact.deeper(pose, &centroid);
            let stored = self.pad_leaning * pressure;
            leaning += stored * pressure;
            let leaning_change = two * stored * slope * cosine;
            let mut force = contact.push_back(
                frame,
                pose,
                &centroid.in_leg_axes(),
                [borne, per_pressure * slope],
            );
            force.add(-leaning_change, &lean);
            response.push(&ForceDerivative {
                force,
                velocity: Coordinates::zero(),
                displacement: deeper,
            });
            let torque = borne * pose.pad_y.dot(&line) - leaning_change * sine;
            on_hinge.add(torque, &deeper);
            if drags {
                let rate = self.pad_rates(frame, pose, leg, pieces)[k];
                let damping = per_pressure * pieces.pad[k].drag_damping(rate);
                let along = contact.along_beside(&line, &centroid.in_leg_axes());
                response.push(&ForceDerivative {
                    force: contact.force(&along, -damping, S::zero()),
                    velocity: deeper,
                    displacement: Coordinates::zero(),
                });
            }
        }
        let edge_stiffness = pieces.edge.load.slope();
        if !edge_stiffness.is_zero() {
            let along_line = contact.along(&line);
            response.push(&ForceDerivative {
                force: contact.force(&along_line, -edge_stiffness, S::zero()),
                velocity: Coordinates::zero(),
                displacement: contact.lowered(&press.place),
            });
        }
        let turning = turned(&by_hinge).dot(&force) + leaning * (cosine * cosine - sine * sine);
        on_hinge.pad += turning;
        on_hinge.link -= turning;
        let swings = contact.swings;
        response.hinge_torque.add(swings, &on_hinge);
        response.link_torque = contact.turned(
            &contact.swing.cross(&force),
            turned(&contact.swing).dot(&force),
        );
        // A pad that is one with its link does not turn against it.
        on_hinge.pad = S::zero();
        (response.link_torque).add(swings - S::one(), &on_hinge);
    }

    /// Damping of the hinge of a footpad that swings by itself.
    #[inline(always)]
    fn hinge_responds(&self, swings: S, pieces: &LegPieces<S>, response: &mut LegResponse<S>) {
        if self.hinge_damping.is_zero() {
            return;
        }
        let mut opening = Coordinates::zero();
        opening.link = S::one();
        opening.pad = S::one();
        let damping = self.hinge_damping * swings;
        let mut force = Coordinates::zero();
        force.link = -(pieces.link.free * damping);
        force.pad = -damping;
        response.push(&ForceDerivative {
            force,
            velocity: opening,
            displacement: Coordinates::zero(),
        });
    }

    /// Block: normal force (33), friction (39).
    #[inline(always)]
    fn block_responds<const FACE: bool>(
        &self,
        posture: &Posture<'_, S>,
        drags: bool,
        response: &mut LegResponse<S>,
    ) {
        let Posture {
            frame,
            pose,
            pieces,
            ..
        } = *posture;
        let contact = Contact::of_block(self, posture);
        let force = self.block_normal(frame, pose, pieces, drags);
        let [along, across] = contact.rub(force, &PlaneDirection::zero());
        response.push(&along);
        response.push(&across);
        let per_pressure = self.block_force_per_pressure(frame);
        let per_depth = per_pressure * pieces.block.slope();
        let along_line = contact.along(&contact.line());
        let mut deeper = contact.along(&frame.block.normal);
        // Change of an interference per depth.
        deeper.body *= frame.block.upright;
        if drags {
            let rate = frame.block_interference_rate(contact.velocity.inward);
            let damping = per_pressure * pieces.block.drag_damping(rate);
            response.push(&ForceDerivative {
                force: contact.force(&along_line, -damping, S::zero()),
                velocity: deeper,
                displacement: Coordinates::zero(),
            });
        }
        let mut push = contact.force(&along_line, -per_depth, S::zero());
        if FACE {
            // A block gets shorter and leans on the ground.
            let (zero, n) = (S::zero(), &frame.block.normal);
            let shorter = Vector3::new(zero, zero, -force);
            push.add(S::one(), &contact.displaced(frame, &shorter, &shorter));
            let (pressure, slope) = (
                pieces.block.at(pose.block_interference),
                pieces.block.slope(),
            );
            let factor = S::one() + S::constant(3.0) * n.z * n.z;
            let change = S::constant(2.0) * self.block_leaning * factor * pressure * slope;
            push.add(
                change,
                &contact.turned(&Vector3::new(n.y, -n.x, zero), zero),
            );
        }
        response.push(&ForceDerivative {
            force: push,
            velocity: Coordinates::zero(),
            displacement: deeper,
        });
    }

    /// Strut (42)-(45) on the link (68), which may be held.
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
