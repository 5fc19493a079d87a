//! Derivatives of the forces with respect to the motion, and the linear equations of an implicit step.
//!
//! Struts and ground act on feet, and the body feels a foot only through its struts. Eliminating each foot leaves six
//! equations of the body. They are written in vehicle axes: translation and rotation of the body, translation of each foot.

use nalgebra::{LU, Matrix3, Matrix3x6, Matrix6, SMatrix, U6, Vector3, Vector6};

use super::motion::{LegAction, Motion};
use super::state::{FootState, State};
use crate::integrator::rosenbrock::StageEquations;
use crate::laws::three_struts::{LegPieces, STRUTS};
use crate::per_leg::PerLeg;
use crate::response::turn;
use crate::state::{Body, quaternion_rate, rotation};

/// Displacement by which the push of the struts is differenced, ft.
const DIFFERENCE: f64 = 1e-6;

/// Derivatives of the forces at one state.
#[derive(Debug, Clone)]
pub struct Response {
    frame: Matrix3<f64>,
    quaternion: nalgebra::Vector4<f64>,
    mass: f64,
    inertia: Matrix3<f64>,
    /// Angular velocity, rad/s.
    rate: Vector3<f64>,
    legs: PerLeg<LegResponse>,
}

/// Derivatives of the forces on one foot, vehicle axes.
#[derive(Debug, Clone, Copy)]
struct LegResponse {
    mass: f64,
    /// Place of the foot in the body per displacement of the body: [−1 | p×].
    carried: Matrix3x6<f64>,
    /// Velocity of the foot in ground axes relative to that of the CG, as the matrix of its cross product: seen from the body
    /// it turns as the body does.
    passing: Matrix3<f64>,
    /// Force of the struts per displacement and per velocity of the foot in the body.
    strut_stiffness: Matrix3<f64>,
    strut_damping: Matrix3<f64>,
    /// Force of the struts on the foot as the matrix of its cross product: it turns with the body, and its lever moves.
    pull: Matrix3<f64>,
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
    /// Force on the body, times τ, per velocity of the foot.
    on_body: SMatrix<f64, 6, 3>,
    /// Force on the foot, times τ, per velocity of the body.
    on_foot: Matrix3x6<f64>,
}

impl Motion {
    /// The derivatives of the forces at a state.
    #[inline(always)]
    pub fn respond(&self, state: &State, pieces: &PerLeg<LegPieces>) -> Response {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        Response {
            quaternion: body.quaternion,
            mass: self.mass,
            inertia: self.inertia,
            rate: body.rate,
            legs: PerLeg::from_fn(self.leg_count(), |j| {
                let action = self.act(j, &body, &frame, &state.foot(j), &pieces[j]);
                self.leg_responds(j, &frame, &body.rate, &action, &pieces[j])
            }),
            frame,
        }
    }

    #[inline(always)]
    fn leg_responds(
        &self,
        leg: usize,
        frame: &Matrix3<f64>,
        rate: &Vector3<f64>,
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
            let turning = rate.cross(&(place - action.place));
            (0..STRUTS).fold(Vector3::zeros(), |push, k| {
                let [from, to] = [&action.reaches[k], &reaches[k]];
                let faster = -to.push.dot(&(action.velocity - turning)) - action.rates[k];
                let [_, damping] = of_leg.damping(k, action.rates[k]);
                let load = action.loads[k]
                    + pieces.struts[k].slope() * (to.stroke - from.stroke)
                    + damping * faster;
                push + to.push * load
            })
        };
        let columns = [0, 1, 2].map(|axis| {
            let mut step = Vector3::zeros();
            step[axis] = DIFFERENCE;
            (push_at(&(action.place + step)) - action.pull) / DIFFERENCE
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
            passing: (action.velocity + rate.cross(&action.place)).cross_matrix(),
            strut_stiffness: Matrix3::from_columns(&columns),
            strut_damping,
            pull: action.pull.cross_matrix(),
            ground_stiffness: -(line * normal.transpose()) * stiffness,
            ground_damping: -(along_ground * turning)
                - direction * direction.transpose() * (growing - turning),
        }
    }
}

/// Place of a foot at `place` in the body per displacement of the body: translation, then rotation.
#[inline(always)]
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
    #[inline(always)]
    pub fn over(&self, tau: f64) -> StageFactors<'_> {
        let mut matrix = Matrix6::zeros();
        (matrix.fixed_view_mut::<3, 3>(0, 0)).copy_from(&(Matrix3::identity() * self.mass));
        // Gyroscopic torque changes with the angular velocity.
        let turning =
            (self.inertia * self.rate).cross_matrix() - self.rate.cross_matrix() * self.inertia;
        (matrix.fixed_view_mut::<3, 3>(3, 3)).copy_from(&(self.inertia - turning * tau));
        let legs = PerLeg::from_fn(self.legs.len(), |j| {
            let leg = &self.legs[j];
            let struts = (leg.strut_damping + leg.strut_stiffness * tau) * tau;
            let ground = (leg.ground_damping + leg.ground_stiffness * tau) * tau;
            let own = Matrix3::identity() * leg.mass - struts - ground;
            // Singular only where a number is not finite; the step is then refused.
            let inverse = own
                .try_inverse()
                .unwrap_or_else(|| Matrix3::repeat(f64::NAN));
            let squared = tau * tau;
            let turn = leg.pull * squared;
            let passing = leg.strut_damping * leg.passing * squared;
            let mut on_foot = struts * leg.carried;
            let mut on_body = leg.carried.tr_mul(&struts);
            let mut turned = on_foot.fixed_columns_mut::<3>(3);
            turned += passing - turn;
            let mut moved = on_body.fixed_rows_mut::<3>(3);
            moved += turn;
            matrix -= on_body * (leg.carried + inverse * on_foot);
            let mut turned = matrix.fixed_columns_mut::<3>(3);
            turned -= leg.carried.tr_mul(&passing);
            let mut turned = matrix.fixed_view_mut::<3, 3>(0, 3);
            turned -= turn;
            Eliminated {
                inverse,
                on_body,
                on_foot,
            }
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
    /// Forces on the body and on a foot that given displacements of both make, vehicle axes, lb and ft·lb.
    #[inline(always)]
    fn pushes(
        &self,
        leg: usize,
        foot: &Vector3<f64>,
        body: &Vector6<f64>,
    ) -> (Vector6<f64>, Vector3<f64>) {
        let leg = &self.response.legs[leg];
        let place = foot + leg.carried * body;
        let turn = body.fixed_rows::<3>(3);
        let struts = leg.strut_stiffness * place + leg.strut_damping * (leg.passing * turn);
        let turned = leg.pull * turn;
        let on_body = leg.carried.tr_mul(&struts) + stacked(&turned, &(leg.pull * place));
        (on_body, struts - turned + leg.ground_stiffness * foot)
    }
}

impl StageEquations<f64, State> for StageFactors<'_> {
    #[inline(always)]
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
            let (on_body, on_foot) = self.pushes(j, &place, &known);
            let own = frame.tr_mul(&foot.velocity) * leg.mass + on_foot;
            right += on_body + eliminated.on_body * (eliminated.inverse * own);
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
            let eliminated = &self.legs[j];
            let right = rights[j] * tau + eliminated.on_foot * body;
            let velocity = frame * (eliminated.inverse * right);
            u.set_foot(
                j,
                &FootState {
                    position: (r.foot(j).position + velocity) * tau,
                    velocity,
                },
            );
        }
    }

    #[inline(always)]
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

#[inline(always)]
fn stacked(first: &Vector3<f64>, second: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(first.x, first.y, first.z, second.x, second.y, second.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crush_load::CrushLoad;
    use crate::integrator::event::Exit;
    use crate::integrator::step::StateVector;
    use crate::laws::three_struts::{INTERFERENCE, LegLaws, LegMode};
    use crate::parts::Inertia;
    use crate::profile::Profile;
    use crate::scene::{Conditions, Scene};
    use crate::three_strut_leg::ThreeStrutLeg;
    use crate::three_struts::{Arrangement, BallFootpad, Foot, LegStrut, ThreeStrutDesign};
    use crate::vehicle::Vehicle;

    fn strut(height: f64) -> LegStrut {
        LegStrut {
            hardpoint_radius: 7.0,
            hardpoint_height: height,
            stiffness: 3e5,
            damping: 150.0,
            square_damping: 20.0,
            compression_stroke: 2.0,
            tension_stroke: 1.0,
            compression_load: Some(CrushLoad::new(vec![[0.0, 5000.0]]).unwrap()),
            tension_load: None,
        }
    }

    fn legs(arrangement: Arrangement) -> Vec<ThreeStrutLeg> {
        let leg = |azimuth: f64| ThreeStrutDesign {
            azimuth,
            arrangement,
            foot: Foot {
                radius: 14.0,
                depth: 5.0,
                mass: 2.0,
            },
            primary: strut(6.0),
            secondary: strut(0.0),
            spread: 3.0,
            footpad: BallFootpad {
                diameter: 3.0,
                height: 0.6,
                crush_pressure: 3000.0,
                profile: Profile::new(vec![[0.0, 0.0], [0.1, 1.0], [0.6, 1.2]]).unwrap(),
            },
        };
        [0.3, 2.2, 4.1]
            .map(|azimuth| ThreeStrutLeg::new(leg(azimuth)).unwrap())
            .to_vec()
    }

    fn scene() -> Scene {
        Scene::new(Conditions {
            vertical_velocity: 0.0,
            horizontal_velocity: 0.0,
            cross_slope: 0.0,
            attitude: crate::attitude::Attitude::from_quaternion([1.0, 0.0, 0.0, 0.0]),
            angular_velocity: [0.0; 3],
            slope: 0.1,
            pad_friction: 0.4,
            block_friction: 0.4,
            soil: Default::default(),
            ground: Default::default(),
            gravity: None,
            thrust: Default::default(),
        })
        .unwrap()
    }

    /// The equations of a stage take the change of the derivative with the motion as differences of the derivative show it.
    #[test]
    fn the_equations_of_a_stage_are_those_of_the_derivative() {
        for arrangement in [Arrangement::Tripod, Arrangement::Cantilever { collar: 6.0 }] {
            let inertia = Inertia {
                xx: 900.0,
                yy: 1000.0,
                zz: 1100.0,
                xy: 30.0,
                xz: -20.0,
                yz: 15.0,
            };
            let legs = legs(arrangement);
            let vehicle = Vehicle::new(50.0, 5.31, 4.0, inertia, legs.clone()).unwrap();
            let scene = scene();
            let motion = Motion::new(&vehicle, &legs, &scene);
            let soil = Default::default();
            let laws: Vec<_> = (legs.iter())
                .map(|leg| LegLaws::of(leg.design(), &soil, Default::default()))
                .collect();
            let mut state = motion.at_first_contact(Body {
                position: Vector3::zeros(),
                velocity: Vector3::new(1.0, 3.0, 5.0),
                quaternion: nalgebra::Vector4::new(1.0, 0.001, -0.002, 0.5),
                rate: Vector3::new(0.02, -0.03, 0.01),
            });
            // Feet pressed into the ground, in the elastic range of their footpads, and sliding.
            let untouched = PerLeg::from_fn(3, |j| LegMode::untouched(&laws[j]).pieces(&laws[j]));
            let signals = motion.signals(&state, &untouched);
            for (j, signals) in signals.iter().take(3).enumerate() {
                let mut foot = state.foot(j);
                let up = signals[INTERFERENCE] - 0.05;
                foot.position -= motion.ground_normal(j) * up;
                foot.velocity += Vector3::new(0.3, 0.1, -0.2);
                state.set_foot(j, &foot);
            }
            let pieces = PerLeg::from_fn(3, |j| {
                let mut mode = LegMode::untouched(&laws[j]);
                let signals = &motion.signals(&state, &untouched)[j];
                (mode.cross(&laws[j], j, INTERFERENCE, Exit::Above, signals)).unwrap();
                mode.pieces(&laws[j])
            });
            let derive = |state: &State| {
                let mut slope = State::zero(3);
                motion.derive(0.0, state, &pieces, &mut slope);
                slope
            };
            let tau = 1e-3;
            let response = motion.respond(&state, &pieces);
            let equations = response.over(tau);
            for number in 0..13 + 6 * 3 {
                let mut u = State::unit(3, number);
                if (6..10).contains(&number) {
                    // Rotations alone, and nothing for the length of the quaternion.
                    let axis = Vector3::from_fn(|i, _| f64::from(u8::from(i + 6 == number)));
                    u.set_body(&Body {
                        quaternion: quaternion_rate(&state.body().quaternion, &axis),
                        ..State::zero(3).body()
                    });
                }
                let step = 1e-6;
                let mut ends = [state; 2];
                state.advance_motion([step], [&u], &mut ends[0]);
                state.advance_motion([-step], [&u], &mut ends[1]);
                let [after, before] = ends.map(|state| derive(&state));
                // r = u/τ − J u.
                let mut r = State::zero(3);
                State::zero(3).advance_motion(
                    [1.0 / tau, -0.5 / step, 0.5 / step],
                    [&u, &after, &before],
                    &mut r,
                );
                let mut found = State::zero(3);
                equations.solve(&r, &mut found);
                let mut off = State::zero(3);
                State::zero(3).advance_motion([1.0, -1.0], [&found, &u], &mut off);
                let off = off.greatest();
                // The rotation of the body turns with it, which the equations leave out; differences are one-sided.
                let allowed = if (6..10).contains(&number) {
                    0.03
                } else {
                    1e-4
                };
                assert!(off < allowed, "{arrangement:?}, number {number}: {off}");
            }
        }
    }
}
