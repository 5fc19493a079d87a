//! The linear equations of a stage of an implicit step. Legs touch the body but not each other, so eliminating them
//! leaves six equations.

use arrayvec::ArrayVec;
use nalgebra::{Matrix6, Vector3, Vector4, Vector6};

use super::{LegResponse, Response, none, product};
use crate::integrator::rosenbrock::StageEquations;
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::products::{times, transposed_times};
use crate::scalar::Real;
use crate::state::{Body, LegState, State, quaternion_rate};

impl<S: Real> Response<S> {
    /// The equations of an implicit stage of weight τ (s), their factors in the place that is given: there is much of
    /// them to be copied.
    #[inline(always)]
    pub fn over<'a>(&'a self, tau: S, factors: &'a mut Factors<S>) -> System<'a, S> {
        let mut matrix = Matrix6::from([[S::zero(); 6]; 6]);
        for i in 0..3 {
            matrix[(i, i)] = self.mass;
            for k in 0..3 {
                matrix[(3 + i, 3 + k)] = self.inertia[(i, k)];
            }
        }
        let mut body = matrix;
        for (leg, eliminated) in self.legs.iter().zip(factors.legs.iter_mut()) {
            eliminated.set(leg, tau, &mut body);
            for column in 0..6 {
                for row in 0..6 {
                    S::keep_rounds_apart();
                    matrix[(row, column)] += body[(row, column)];
                }
            }
        }
        // L U in place, with ones on the diagonal of L and the inverse of that of U.
        for pivot in 0..6 {
            let inverse = S::one() / matrix[(pivot, pivot)];
            matrix[(pivot, pivot)] = inverse;
            for row in pivot + 1..6 {
                matrix[(row, pivot)] *= inverse;
            }
            for column in pivot + 1..6 {
                let above = matrix[(pivot, column)];
                for row in pivot + 1..6 {
                    let product = matrix[(row, pivot)] * above;
                    matrix[(row, column)] -= product;
                }
            }
        }
        factors.tau = tau;
        factors.body = matrix;
        System {
            response: self,
            factors,
        }
    }
}

/// Factors of the equations of an implicit stage.
#[derive(Debug, Clone, Copy)]
pub struct Factors<S> {
    tau: S,
    /// L and U of the equations of the body.
    body: Matrix6<S>,
    legs: PerLeg<Eliminated<S>>,
}

impl<S: Real> Factors<S> {
    /// A place for those of a vehicle with so many legs.
    pub fn none(legs: usize) -> Self {
        let zero = S::zero();
        Self {
            tau: zero,
            body: Matrix6::from([[zero; 6]; 6]),
            legs: PerLeg::same(
                legs,
                Eliminated {
                    columns: [none(); 2],
                    inverse: [[zero; 2]; 2],
                    rows: [none(); 2],
                },
            ),
        }
    }
}

/// Rows and columns of link and pad, eliminated from the equations of an implicit stage.
#[derive(Debug, Clone, Copy)]
struct Eliminated<S> {
    /// Forces on the body, times τ, per rate of link and of the pad against it.
    columns: [Vector6<S>; 2],
    /// Inverse of what is between link and pad.
    inverse: [[S; 2]; 2],
    /// What they move at per velocity of the body, the other way round.
    rows: [Vector6<S>; 2],
}

impl<S: Real> Eliminated<S> {
    /// Eliminates a leg; what that leaves of it in the equations of the body is written to `body`.
    #[inline(always)]
    fn set(&mut self, leg: &LegResponse<S>, tau: S, body: &mut Matrix6<S>) {
        let [follows, bends] = leg.pad_turn;
        let [link_inertia, pad_inertia] = leg.inertia;
        let squared = tau * tau;
        let link_way = tau * leg.link_moves;
        let pad_way = tau * follows * bends;
        let (link_torque, hinge_torque) = (&leg.link_torque, &leg.hinge_torque);

        *body = Matrix6::from([[S::zero(); 6]; 6]);
        let mut columns = [none(); 2];
        let mut rows = [link_torque.body * -squared, hinge_torque.body * -squared];
        let damping = leg.link_damping - link_way * link_torque.link;
        let hinge = tau * (link_way * hinge_torque.link + pad_way * hinge_torque.pad);
        let mut own = [
            [link_inertia + tau * damping, S::zero()],
            [-hinge, pad_inertia - tau * pad_way * hinge_torque.pad],
        ];
        for derivative in leg.derivatives() {
            let (velocity, displacement) = (&derivative.velocity, &derivative.displacement);
            let reach = velocity.body + displacement.body * tau;
            let pad_reach = pad_way * displacement.pad;
            let link_reach = velocity.link + link_way * displacement.link + pad_reach;
            let force = derivative.force.body * tau;
            for k in 0..6 {
                for i in 0..6 {
                    S::keep_rounds_apart();
                    body[(i, k)] -= force[i] * reach[k];
                }
            }
            let on_link = tau * derivative.force.link;
            columns[0] -= force * link_reach;
            rows[0] -= reach * on_link;
            own[0][0] -= on_link * link_reach;
            if leg.swings_pads {
                let on_pad = tau * derivative.force.pad;
                columns[1] -= force * pad_reach;
                rows[1] -= reach * on_pad;
                own[0][1] -= on_link * pad_reach;
                own[1][0] -= on_pad * link_reach;
                own[1][1] -= on_pad * pad_reach;
            }
        }
        let [[a, b], [c, d]] = own;
        let per_determinant = S::one() / (a * d - b * c);
        let inverse = [
            [d * per_determinant, -(b * per_determinant)],
            [-(c * per_determinant), a * per_determinant],
        ];
        let mut solved = [rows[0] * inverse[0][0], none()];
        if leg.swings_pads {
            solved[0] += rows[1] * inverse[0][1];
            solved[1] = rows[0] * inverse[1][0] + rows[1] * inverse[1][1];
        }
        for k in 0..6 {
            for i in 0..6 {
                S::keep_rounds_apart();
                body[(i, k)] -= columns[0][i] * solved[0][k];
            }
        }
        if leg.swings_pads {
            for k in 0..6 {
                for i in 0..6 {
                    S::keep_rounds_apart();
                    body[(i, k)] -= columns[1][i] * solved[1][k];
                }
            }
        }
        *self = Self {
            columns,
            inverse,
            rows: solved,
        };
    }
}

/// The equations (1/τ − J) u = r of an implicit stage, factored: J is the derivative of the motion as far as
/// the forces' derivatives are known, u and r are states.
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
        let f = &self.factors.body;
        for column in 0..5 {
            for row in column + 1..6 {
                let product = f[(row, column)] * body[column];
                body[row] -= product;
            }
        }
        for column in (0..6).rev() {
            body[column] *= f[(column, column)];
            for row in 0..column {
                let product = f[(row, column)] * body[column];
                body[row] -= product;
            }
        }
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
            after.accumulate(leg, before, h, slopes, response.hinge_gain, error);
        }
    }
}

impl<S: Real> System<'_, S> {
    /// Forces of a leg on the body, with the body's velocities yet to be found, over τ, and what link
    /// and pad would move at if the body did not.
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

    /// What link and pad do as the body does this.
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

/// Rotation (vehicle axes) that a change of the quaternion (w, x, y, z) amounts to: twice the vector part of
/// q⁻¹ ∘ δq.
#[inline(always)]
fn turn<S: Real>(quaternion: &Vector4<S>, change: &Vector4<S>) -> Vector3<S> {
    let (w, x, y, z) = (quaternion.x, quaternion.y, quaternion.z, quaternion.w);
    let d = change;
    Vector3::new(
        w * d.y - x * d.x - y * d.w + z * d.z,
        w * d.z + x * d.w - y * d.x - z * d.y,
        w * d.w - x * d.z + y * d.y - z * d.x,
    ) * (S::constant(2.0) / (w * w + x * x + y * y + z * z))
}
