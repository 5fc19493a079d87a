//! Derivatives of the forces with respect to the motion, and the linear equations of an implicit step.
//!
//! Struts and ground act on feet, and the body feels a foot only through its struts. Eliminating each foot leaves six
//! equations of the body. They are written in vehicle axes: translation and rotation of the body, translation of each foot.

use nalgebra::{LU, Matrix3, Matrix3x6, Matrix6, U6, Vector3, Vector6};

use super::motion::{LegAction, Motion};
use super::state::{FootState, State};
use crate::integrator::rosenbrock::StageEquations;
use crate::laws::three_struts::{LegPieces, STRUTS};
use crate::per_leg::PerLeg;
use crate::response::turn;
use crate::state::{Body, quaternion_rate, rotation};

/// Displacement by which the push of the struts is differenced, ft.
const DIFFERENCE: f64 = 1e-5;

/// Derivatives of the forces at one state.
#[derive(Debug, Clone)]
pub struct Response {
    frame: Matrix3<f64>,
    quaternion: nalgebra::Vector4<f64>,
    mass: f64,
    inertia: Matrix3<f64>,
    legs: PerLeg<LegResponse>,
}

/// Derivatives of the forces on one foot, vehicle axes.
#[derive(Debug, Clone, Copy)]
struct LegResponse {
    mass: f64,
    /// Place of the foot in the body per displacement of the body: [−1 | p×].
    carried: Matrix3x6<f64>,
    /// Force of the struts per displacement and per velocity of the foot in the body.
    strut_stiffness: Matrix3<f64>,
    strut_damping: Matrix3<f64>,
    /// Force of the ground per displacement and per velocity of the foot.
    ground_stiffness: Matrix3<f64>,
    ground_damping: Matrix3<f64>,
}

/// Factors of the equations of an implicit stage.
#[derive(Debug, Clone)]
pub struct StageFactors<'a> {
    response: &'a Response,
    tau: f64,
    body: LU<f64, U6, U6>,
    legs: PerLeg<Eliminated>,
}

/// A foot, eliminated from the equations of a stage.
#[derive(Debug, Clone, Copy)]
struct Eliminated {
    /// Inverse of the foot's own matrix.
    inverse: Matrix3<f64>,
    /// Force of the struts on the foot, times τ, per velocity of the foot in the body.
    coupling: Matrix3<f64>,
}

impl Motion {
    /// The derivatives of the forces at a state.
    pub fn respond(&self, state: &State, pieces: &PerLeg<LegPieces>) -> Response {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        Response {
            quaternion: body.quaternion,
            mass: self.mass,
            inertia: self.inertia,
            legs: PerLeg::from_fn(self.leg_count(), |j| {
                let action = self.act(j, &body, &frame, &state.foot(j), &pieces[j]);
                self.leg_responds(j, &frame, &action, &pieces[j])
            }),
            frame,
        }
    }

    fn leg_responds(
        &self,
        leg: usize,
        frame: &Matrix3<f64>,
        action: &LegAction,
        pieces: &LegPieces,
    ) -> LegResponse {
        let of_leg = &self.legs[leg];
        let mut strut_damping = Matrix3::zeros();
        for k in 0..STRUTS {
            let [_, damping] = of_leg.damping(k, action.rates[k]);
            let push = action.reaches[k].push;
            strut_damping -= push * push.transpose() * damping;
        }
        // How the loads and the directions of the struts change with the place of the foot.
        let push_at = |place: &Vector3<f64>| {
            let reaches = of_leg.struts.at(place);
            (0..STRUTS).fold(Vector3::zeros(), |push, k| {
                let more = reaches[k].stroke - action.reaches[k].stroke;
                let load = action.loads[k] + pieces.struts[k].slope() * more;
                push + reaches[k].push * load
            })
        };
        let columns = [0, 1, 2].map(|axis| {
            let mut step = Vector3::zeros();
            step[axis] = DIFFERENCE;
            (push_at(&(action.place + step)) - push_at(&(action.place - step))) / (2.0 * DIFFERENCE)
        });
        let contact = &action.contact;
        let normal = frame.tr_mul(of_leg.ground.normal());
        let sliding = frame.tr_mul(&contact.sliding);
        let along_ground = Matrix3::identity() - normal * normal.transpose();
        let line = normal + sliding * contact.drag;
        let stiffness = of_leg.pad_strength * pieces.pad.slope();
        // Along its direction friction changes with the speed, across it only turns.
        let turning = contact.normal * contact.drag;
        let growing = contact.normal * self.friction_change(leg, pieces);
        let direction = match contact.sliding_squared > 0.0 {
            true => sliding / libm::sqrt(contact.sliding_squared),
            false => Vector3::zeros(),
        };
        LegResponse {
            mass: of_leg.mass,
            carried: carried(&action.place),
            strut_stiffness: Matrix3::from_columns(&columns),
            strut_damping,
            ground_stiffness: -(line * normal.transpose()) * stiffness,
            ground_damping: -(along_ground * turning)
                - direction * direction.transpose() * (growing - turning),
        }
    }
}

/// Place of a foot at `place` in the body per displacement of the body: translation, then rotation.
fn carried(place: &Vector3<f64>) -> Matrix3x6<f64> {
    let mut carried = Matrix3x6::zeros();
    carried
        .fixed_columns_mut::<3>(0)
        .copy_from(&-Matrix3::identity());
    (carried.fixed_columns_mut::<3>(3)).copy_from(&place.cross_matrix());
    carried
}

impl Response {
    /// The equations of an implicit stage of weight τ (s), factored.
    pub fn over(&self, tau: f64) -> StageFactors<'_> {
        let mut matrix = Matrix6::zeros();
        (matrix.fixed_view_mut::<3, 3>(0, 0)).copy_from(&(Matrix3::identity() * self.mass));
        (matrix.fixed_view_mut::<3, 3>(3, 3)).copy_from(&self.inertia);
        let legs = PerLeg::from_fn(self.legs.len(), |j| {
            let leg = &self.legs[j];
            let coupling = (leg.strut_damping + leg.strut_stiffness * tau) * tau;
            let ground = (leg.ground_damping + leg.ground_stiffness * tau) * tau;
            let own = Matrix3::identity() * leg.mass - coupling - ground;
            // Singular only where a number is not finite; the step is then refused.
            let inverse = own
                .try_inverse()
                .unwrap_or_else(|| Matrix3::repeat(f64::NAN));
            let reach = coupling * leg.carried;
            matrix -= leg.carried.tr_mul(&(reach + coupling * (inverse * reach)));
            Eliminated { inverse, coupling }
        });
        StageFactors {
            response: self,
            tau,
            body: matrix.lu(),
            legs,
        }
    }
}

impl StageFactors<'_> {
    /// Force on the foot that a given displacement makes, vehicle axes, lb: of the struts, and of struts and ground.
    fn pushes(&self, leg: usize, foot: &Vector3<f64>, body: &Vector6<f64>) -> [Vector3<f64>; 2] {
        let leg = &self.response.legs[leg];
        let struts = leg.strut_stiffness * (foot + leg.carried * body);
        [struts, struts + leg.ground_stiffness * foot]
    }
}

impl StageEquations<f64, State> for StageFactors<'_> {
    fn solve(&self, r: &State, u: &mut State) {
        let (tau, response) = (self.tau, self.response);
        let frame = &response.frame;
        let given = r.body();
        let turn = turn(&response.quaternion, &given.quaternion);
        let known = stacked(&frame.tr_mul(&given.position), &turn) * tau;
        let push = frame.tr_mul(&given.velocity) * response.mass;
        let mut right = stacked(&push, &(response.inertia * given.rate));
        let legs = response.legs.len();
        let rights = PerLeg::from_fn(legs, |j| {
            let (leg, foot, eliminated) = (&response.legs[j], r.foot(j), &self.legs[j]);
            let place = frame.tr_mul(&foot.position) * tau;
            let [struts, all] = self.pushes(j, &place, &known);
            let own = frame.tr_mul(&foot.velocity) * leg.mass + all;
            right += leg
                .carried
                .tr_mul(&(struts + eliminated.coupling * (eliminated.inverse * own)));
            own
        });
        right *= tau;
        let body = (self.body.solve(&right)).unwrap_or_else(|| Vector6::repeat(f64::NAN));
        let velocity = frame * body.fixed_rows::<3>(0);
        let rate = body.fixed_rows::<3>(3).into_owned();
        u.set_body(&Body {
            position: (given.position + velocity) * tau,
            velocity,
            quaternion: (given.quaternion + quaternion_rate(&response.quaternion, &rate)) * tau,
            rate,
        });
        for j in 0..legs {
            let (leg, eliminated) = (&response.legs[j], &self.legs[j]);
            let carried = eliminated.coupling * (leg.carried * body);
            let velocity = frame * (eliminated.inverse * (rights[j] * tau + carried));
            u.set_foot(
                j,
                &FootState {
                    position: (r.foot(j).position + velocity) * tau,
                    velocity,
                },
            );
        }
    }

    fn accumulate(
        &self,
        before: &State,
        h: f64,
        slopes: [&State; 3],
        after: &mut State,
        error: &mut State,
    ) {
        after.accumulate(before, h, slopes, error);
    }
}

fn stacked(first: &Vector3<f64>, second: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(first.x, first.y, first.z, second.x, second.y, second.z)
}
