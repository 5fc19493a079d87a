//! Factors of the equations of an implicit stage. Legs touch the body but not each other: eliminating them leaves six
//! equations.

use nalgebra::{Matrix6, Vector6};

use super::{LegResponse, Response, none};
use crate::equations::body_factors::BodyFactors;
use crate::per_leg::PerLeg;
use crate::scalar::Real;

/// Factors of the equations of an implicit stage.
#[derive(Debug, Clone, Copy)]
pub struct Factors<S> {
    pub(super) tau: S,
    pub(super) body: BodyFactors<S>,
    pub(super) legs: PerLeg<Eliminated<S>>,
}

impl<S: Real> Factors<S> {
    /// Room for those of a vehicle with this many legs.
    pub fn none(legs: usize) -> Self {
        let zero = S::zero();
        Self {
            tau: zero,
            body: BodyFactors::none(),
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

    /// Factors the equations of weight τ (s).
    #[inline(always)]
    pub(super) fn set(&mut self, response: &Response<S>, tau: S) {
        let mut matrix = Matrix6::from([[S::zero(); 6]; 6]);
        for i in 0..3 {
            matrix[(i, i)] = response.mass;
            for k in 0..3 {
                matrix[(3 + i, 3 + k)] = response.inertia[(i, k)];
            }
        }
        let mut body = matrix;
        for (leg, eliminated) in response.legs.iter().zip(self.legs.iter_mut()) {
            eliminated.set(leg, tau, &mut body);
            for column in 0..6 {
                for row in 0..6 {
                    S::keep_rounds_apart();
                    matrix[(row, column)] += body[(row, column)];
                }
            }
        }
        self.tau = tau;
        self.body = BodyFactors::of(matrix);
    }
}

/// Rows and columns of link and pad, eliminated from the equations of an implicit stage.
#[derive(Debug, Clone, Copy)]
pub(super) struct Eliminated<S> {
    /// Forces on the body, times τ, per rate of link and of the pad against it.
    pub(super) columns: [Vector6<S>; 2],
    /// Inverse of the matrix of link and pad.
    pub(super) inverse: [[S; 2]; 2],
    /// Rates of link and pad per velocity of the body, negated.
    pub(super) rows: [Vector6<S>; 2],
}

impl<S: Real> Eliminated<S> {
    /// Eliminates a leg and writes its part of the equations of the body to `body`.
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
            let tilt = pad_way * displacement.pad;
            let pad_reach = velocity.pad + tilt;
            let link_reach = velocity.link + link_way * displacement.link + tilt;
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
