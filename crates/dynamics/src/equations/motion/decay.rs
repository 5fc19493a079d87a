//! Upper bound of the decay rates of velocities, by which steps are found stiff.

use super::contact_response::{Contact, Posture};
use super::leg::LegMotion;
use super::pieces::Pressed;
use super::{LegPieces, Motion, Pieces, at_angle};
use crate::kinematics::BodyFrame;
use crate::response::inverse_inertias;
use crate::scalar::Real;
use crate::state::{LegState, State};

impl<S: Real> Motion<S> {
    /// Upper bound of the decay rates of velocities, 1/s: the trace of the damping matrix over the inertia.
    #[inline(always)]
    pub fn greatest_decay<const FACE: bool>(&self, state: &State<S>, pieces: &Pieces<S>) -> S {
        let frame = self.frame(&state.body());
        let per_body = inverse_inertias(self.mass, &self.inertia);
        let mut greatest = S::zero();
        for (j, leg) in self.legs.iter().enumerate() {
            let active = pieces.leg(j);
            let state = at_angle(active, state.leg(j));
            let (pieces, pressed) = (&active.leg, active.pressed);
            greatest += leg.greatest_decay::<FACE>(&frame, &state, pieces, pressed, &per_body);
        }
        greatest
    }
}

impl<S: Real> LegMotion<S> {
    /// The share of this leg, with the pad's turn as its angle.
    #[inline(always)]
    fn greatest_decay<const FACE: bool>(
        &self,
        body: &BodyFrame<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        pressed: Pressed,
        per_body: &[S; 6],
    ) -> S {
        let swings = pieces.hinge.swings();
        let link_inertia = if FACE {
            self.link_inertia + (S::one() - swings) * self.pad_inertia
        } else {
            self.link_inertia
        };
        let [per_link, per_pad] =
            [link_inertia, self.pad_inertia].map(|inertia| S::one() / inertia);
        let run_down = pieces.link.run_down() * self.link_inertia;
        let on_hinge = if FACE {
            self.hinge_damping * swings * (pieces.link.free * per_link + per_pad)
        } else {
            S::zero()
        };
        // Legs that hang in the air have no other forces.
        if !pressed.pads && !pressed.blocks && pieces.link.free.is_zero() {
            return run_down.max(S::zero()) * per_link + on_hinge;
        }
        let frame = self.frame(body);
        let pose = self.geometry.pose(&frame, leg.link_angle, leg.pad_turn);
        let posture = Posture {
            body,
            frame: &frame,
            pose: &pose,
            leg,
            pieces,
        };
        let (stroke, lever) = (pose.stroke, pose.strut_lever);
        let strut = pieces.strut.damping(stroke, leg.link_rate, lever);
        let damping = run_down + pieces.link.free * strut * lever;
        let mut greatest = damping.max(S::zero()) * per_link + on_hinge;
        let per_leg = [per_link, per_pad];
        if pressed.pads {
            let [along, across] = if FACE {
                let pressures = self.pad_pressures(&frame, &pose, leg, pieces, pressed.drag);
                let press = self.press(&pressures, &frame, &pose, pieces);
                Contact::of_face(self, &posture, press.place).decays(
                    press.normal,
                    per_body,
                    per_leg,
                )
            } else {
                let [outer, inner] =
                    self.pad_section_forces(&frame, &pose, leg, pieces, pressed.drag);
                let force = outer + inner + self.edge_load(&frame, &pose, pieces);
                Contact::of_pad(self, &posture).decays(force, per_body, per_leg)
            };
            greatest += along;
            greatest += across;
        }
        if pressed.blocks {
            let force = self.block_normal(&frame, &pose, pieces, pressed.drag);
            let contact = Contact::of_block(self, &posture);
            let [along, across] = contact.decays(force, per_body, per_leg);
            greatest += along;
            greatest += across;
        }
        greatest
    }
}
