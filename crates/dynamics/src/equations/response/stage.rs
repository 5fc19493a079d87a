//! The linear equations of a stage of an implicit step, and their solution.

use arrayvec::ArrayVec;
use nalgebra::{Vector3, Vector4, Vector6};

use super::factors::Factors;
use super::{Response, none, product};
use crate::integrator::rosenbrock::StageEquations;
use crate::per_leg::MOST_LEGS;
use crate::products::{times, transposed_times};
use crate::scalar::Real;
use crate::state::{Body, LegState, State, quaternion_rate};

impl<S: Real> Response<S> {
    /// The equations of an implicit stage of weight τ (s), with their factors in the given place, as they are long to
    /// copy.
    #[inline(always)]
    pub fn over<'a>(&'a self, tau: S, factors: &'a mut Factors<S>) -> System<'a, S> {
        factors.set(self, tau);
        System {
            response: self,
            factors,
        }
    }
}

/// The equations (1/τ − J) u = r of an implicit stage, factored. J is the derivative of the motion, as far as
/// derivatives of the forces are known; u and r are states.
#[derive(Debug, Clone, Copy)]
pub struct System<'a, S> {
    response: &'a Response<S>,
    factors: &'a Factors<S>,
}

impl<S: Real> StageEquations<S, State<S>> for System<'_, S> {
    #[inline(always)]
    fn solve(&self, r: &State<S>, u: &mut State<S>) {
        let tau = self.factors.tau;
        let response = self.response;
        let given = r.body();
        let translation = transposed_times(&response.rotation, &given.position);
        let turn = turn(&response.quaternion, &given.quaternion);
        let known = Vector6::new(
            translation.x,
            translation.y,
            translation.z,
            turn.x,
            turn.y,
            turn.z,
        );
        let push = transposed_times(&response.rotation, &given.velocity) * response.mass;
        let twist = times(&response.inertia, &given.rate);
        let mut body = Vector6::new(push.x, push.y, push.z, twist.x, twist.y, twist.z);
        let mut rates = ArrayVec::<_, MOST_LEGS>::new();
        for leg in 0..response.legs.len() {
            let (forces, rate) = self.leg_pushes(leg, &known, &r.leg(leg));
            rates.push(rate);
            for i in 0..6 {
                body[i] += forces[i];
            }
        }
        body *= tau;
        self.factors.body.solve(&mut body);
        let velocity = times(&response.rotation, &Vector3::new(body[0], body[1], body[2]));
        let rate = Vector3::new(body[3], body[4], body[5]);
        let turning = quaternion_rate(&response.quaternion, &rate);
        u.set_body(&Body {
            position: (given.position + velocity) * tau,
            velocity,
            quaternion: (given.quaternion + turning) * tau,
            rate,
        });
        for (leg, rates) in rates.iter().enumerate() {
            u.set_leg(leg, &self.leg_follows(leg, &body, &r.leg(leg), rates));
        }
    }

    #[inline(always)]
    fn accumulate(
        &self,
        before: &State<S>,
        h: S,
        slopes: [&State<S>; 3],
        after: &mut State<S>,
        error: &mut State<S>,
    ) {
        for (leg, response) in self.response.legs.iter().enumerate() {
            after.accumulate(
                leg,
                before,
                h,
                slopes,
                [response.hinge_gain, response.pad_error_share],
                error,
            );
        }
    }
}

impl<S: Real> System<'_, S> {
    /// Forces of a leg on the body over τ, with the body's velocities yet to be found, and rates of link and pad if the
    /// body stood still.
    #[inline(always)]
    fn leg_pushes(
        &self,
        leg: usize,
        known: &Vector6<S>,
        given: &LegState<S>,
    ) -> (Vector6<S>, [S; 2]) {
        let (leg, eliminated) = (&self.response.legs[leg], &self.factors.legs[leg]);
        let tau = self.factors.tau;
        let known = known * tau;
        let link = given.link_angle * tau;
        let [_, bends] = leg.pad_turn;
        let pad = given.pad_turn * tau * bends;
        let mut forces: Vector6<S> = none();
        let mut on_link = leg.inertia[0] * given.link_rate + leg.link_torque.dot(&known, link, pad);
        let in_link = given.pad_rate - given.link_rate;
        let mut on_pad = leg.inertia[1] * in_link + leg.hinge_torque.dot(&known, link, pad);
        for derivative in leg.derivatives() {
            let reached = derivative.displacement.dot(&known, link, pad);
            forces += derivative.force.body * reached;
            on_link += derivative.force.link * reached;
            on_pad += derivative.force.pad * reached;
        }
        let [[a, b], [c, d]] = eliminated.inverse;
        let link = a * on_link + b * on_pad;
        let pad = c * on_link + d * on_pad;
        let rates = [link * tau, pad * tau];
        forces -= eliminated.columns[0] * link;
        if leg.swings_pads {
            forces -= eliminated.columns[1] * pad;
        }
        (forces, rates)
    }

    /// Motion of link and pad for this motion of the body.
    #[inline(always)]
    fn leg_follows(
        &self,
        leg: usize,
        body: &Vector6<S>,
        given: &LegState<S>,
        rates: &[S; 2],
    ) -> LegState<S> {
        let (leg, eliminated) = (&self.response.legs[leg], &self.factors.legs[leg]);
        let [mut link_rate, mut pad_in_link] = *rates;
        link_rate -= product(&eliminated.rows[0], body);
        if leg.swings_pads {
            pad_in_link -= product(&eliminated.rows[1], body);
        }
        let pad_rate = pad_in_link + link_rate;
        let tau = self.factors.tau;
        let [follows, _] = leg.pad_turn;
        LegState {
            link_angle: (given.link_angle + leg.link_moves * link_rate) * tau,
            link_rate,
            pad_turn: (given.pad_turn + follows * pad_rate) * tau,
            pad_rate,
            work: [S::zero(); 6],
        }
    }
}

/// Rotation (vehicle axes) that a change of the quaternion (w, x, y, z) amounts to: twice the vector part of q⁻¹ ∘ δq.
#[inline(always)]
pub(crate) fn turn<S: Real>(quaternion: &Vector4<S>, change: &Vector4<S>) -> Vector3<S> {
    let (w, x, y, z) = (quaternion.x, quaternion.y, quaternion.z, quaternion.w);
    let d = change;
    Vector3::new(
        w * d.y - x * d.x - y * d.w + z * d.z,
        w * d.z + x * d.w - y * d.x - z * d.y,
        w * d.w - x * d.z + y * d.y - z * d.x,
    ) * (S::constant(2.0) / (w * w + x * x + y * y + z * z))
}
