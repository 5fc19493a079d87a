//! Derivatives of the forces with respect to the motion, and the linear equations of an implicit step.
//!
//! Struts and ground act on feet, and the body feels a foot only through its struts. Eliminating each foot leaves six
//! equations of the body. They are written in vehicle axes: translation and rotation of the body, translation of each foot.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use num_traits::{One, Zero};

use super::leg::{Leg, LegAction, SeenBody, push, secondary_push};
use super::motion::{Motion, Pieces};
use super::state::{FootState, State};
use super::struts::Reach;
use crate::equations::body_factors::BodyFactors;
use crate::integrator::rosenbrock::StageEquations;
use crate::laws::three_struts::{LegPieces, STRUTS};
use crate::products::{cross_matrix, inverse, outer, product, times, transposed_times};
use crate::quads::{Quad, Quads, legs_in, matrix_sum, vector_sum};
use crate::response::turn;
use crate::scalar::Real;
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
    legs: usize,
    quads: Quads<LegResponse>,
}

/// Derivatives of the forces on four feet, vehicle axes.
#[derive(Debug, Clone, Copy)]
struct LegResponse {
    mass: Quad,
    /// Place of the foot as the matrix of its cross product: how a rotation of the body moves it in the body.
    lever: Matrix3<Quad>,
    /// Velocity of the foot in ground axes relative to that of the CG, as the matrix of its cross product: seen from the body
    /// it turns as the body does.
    passing: Matrix3<Quad>,
    /// Force of the struts per displacement and per velocity of the foot in the body.
    strut_stiffness: Matrix3<Quad>,
    strut_damping: Matrix3<Quad>,
    /// Force of the struts on the foot as the matrix of its cross product: it turns with the body, and its lever moves.
    pull: Matrix3<Quad>,
    /// Force of the ground per displacement and per velocity of the foot.
    ground_stiffness: Matrix3<Quad>,
    ground_damping: Matrix3<Quad>,
}

/// Factors of the equations of an implicit stage.
#[derive(Debug, Clone)]
pub struct StageFactors<'a> {
    response: &'a Response,
    tau: f64,
    body: BodyFactors<f64>,
    quads: Quads<Eliminated>,
}

/// Four feet, eliminated from the equations of a stage.
#[derive(Debug, Clone, Copy)]
struct Eliminated {
    /// Inverse of the foot's own matrix.
    inverse: Matrix3<Quad>,
    /// Force and torque on the body, times τ, per velocity of the foot.
    on_body: [Matrix3<Quad>; 2],
    /// Force on the foot, times τ, per velocity and angular velocity of the body.
    on_foot: [Matrix3<Quad>; 2],
}

impl Motion {
    /// The derivatives of the forces at a state.
    #[inline(always)]
    pub fn respond(&self, state: &State, pieces: &Pieces) -> Response {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        let seen = SeenBody::new(&body, &frame);
        let mut quads = Quads::new();
        for (quad, leg) in self.quads.iter().enumerate() {
            let pieces = &pieces.quads[quad];
            let action = leg.act(&seen, &state.feet(quad), pieces);
            quads.push(leg.respond(&seen, &action, pieces));
        }
        Response {
            quaternion: body.quaternion,
            mass: self.mass,
            inertia: self.inertia,
            rate: body.rate,
            legs: self.leg_count(),
            quads,
            frame,
        }
    }
}

impl Leg<Quad> {
    #[inline(always)]
    fn respond(
        &self,
        body: &SeenBody<Quad>,
        action: &LegAction<Quad>,
        pieces: &LegPieces<Quad>,
    ) -> LegResponse {
        let mut damping = [Quad::zero(); STRUTS];
        let mut strut_damping = Matrix3::zeros();
        for (k, damping) in damping.iter_mut().enumerate() {
            *damping = self.damping(k, action.rates[k])[1];
            let push = &action.reaches[k].push;
            strut_damping -= outer(&(push * *damping), push);
        }
        // Friction of bearings changes with the rate of the stroke, and with the damping of the secondary struts.
        let bearing = &action.bearing;
        let along = &action.reaches[0].push;
        let mut change = along * -bearing.damping;
        for (Reach { push, .. }, damping) in action.reaches.iter().zip(damping).skip(1) {
            change -= push * (bearing.by_side_force.dot(push) * damping);
        }
        strut_damping += outer(along, &change);
        let mut strut_stiffness = Matrix3::zeros();
        for axis in 0..3 {
            let mut step = Vector3::zeros();
            step[axis] = Quad::constant(DIFFERENCE);
            let push = self.push_after(&step, body, action, pieces, &damping);
            let column = (push - action.pull) * (Quad::one() / Quad::constant(DIFFERENCE));
            strut_stiffness.set_column(axis, &column);
        }
        let contact = &action.contact;
        let normal = transposed_times(&body.frame, self.ground.normal());
        let sliding = transposed_times(&body.frame, &contact.sliding);
        let along_ground = Matrix3::identity() - outer(&normal, &normal);
        let line = normal + sliding * contact.drag;
        let stiffness = self.pad_strength * pieces.pad.slope();
        let drag = self.pad_strength * pieces.pad.drag_damping(contact.inward);
        // Along its direction friction changes with the speed, across it only turns.
        let turning = contact.normal * contact.drag;
        let growing = contact.normal * self.friction * pieces.friction.change();
        // The floor only keeps 0/0 out.
        let speed = contact.sliding_squared.max(Quad::constant(1e-30)).sqrt();
        let direction = sliding * (Quad::one() / speed);
        LegResponse {
            mass: self.mass,
            lever: cross_matrix(&action.place),
            passing: cross_matrix(&(action.velocity + body.rate.cross(&action.place))),
            strut_stiffness,
            strut_damping,
            pull: cross_matrix(&action.pull),
            ground_stiffness: outer(&(line * -stiffness), &normal),
            ground_damping: -(along_ground * turning)
                - outer(&(direction * (growing - turning)), &direction)
                - outer(&(line * drag), &normal),
        }
    }

    /// Force of the struts on the foot, displaced by a `step` in the body (ft): their loads and directions change with its place.
    #[inline(always)]
    fn push_after(
        &self,
        step: &Vector3<Quad>,
        body: &SeenBody<Quad>,
        action: &LegAction<Quad>,
        pieces: &LegPieces<Quad>,
        damping: &[Quad; STRUTS],
    ) -> Vector3<Quad> {
        let reaches = self.struts.at(&(action.place + step));
        let velocity = action.velocity - body.rate.cross(step);
        let mut loads = action.loads;
        loads[0] -= action.bearing.load;
        for k in 0..STRUTS {
            let [from, to] = [&action.reaches[k], &reaches[k]];
            let faster = -to.push.dot(&velocity) - action.rates[k];
            loads[k] += pieces.struts[k].slope() * (to.stroke - from.stroke) + damping[k] * faster;
        }
        let first = &reaches[0];
        let across = secondary_push(&reaches, &loads);
        let rate = -first.push.dot(&velocity);
        loads[0] += self.bearings.friction(first.stroke, rate, &across).load;
        push(&reaches, &loads)
    }
}

impl Response {
    /// The equations of an implicit stage of weight τ (s), factored.
    #[inline(always)]
    pub fn over(&self, tau: f64) -> StageFactors<'_> {
        // Gyroscopic torque changes with the angular velocity.
        let turning = cross_matrix(&times(&self.inertia, &self.rate))
            - product(&cross_matrix(&self.rate), &self.inertia);
        let mut blocks = [
            [Matrix3::identity() * self.mass, Matrix3::zeros()],
            [Matrix3::zeros(), self.inertia - turning * tau],
        ];
        let mut quads = Quads::new();
        for (quad, leg) in self.quads.iter().enumerate() {
            let (eliminated, changes) = leg.eliminate(Quad::constant(tau));
            let legs = legs_in(quad, self.legs);
            for row in 0..2 {
                for column in 0..2 {
                    blocks[row][column] -= matrix_sum(&changes[row][column], legs);
                }
            }
            quads.push(eliminated);
        }
        let matrix =
            Matrix6::from_fn(|row, column| blocks[row / 3][column / 3][(row % 3, column % 3)]);
        StageFactors {
            response: self,
            tau,
            body: BodyFactors::of(matrix),
            quads,
        }
    }
}

impl LegResponse {
    /// Eliminates the feet from the equations of a stage of weight τ. Also returns what that takes from the matrix of the
    /// body, in blocks of force and torque against velocity and angular velocity.
    #[inline(always)]
    fn eliminate(&self, tau: Quad) -> (Eliminated, [[Matrix3<Quad>; 2]; 2]) {
        let squared = tau * tau;
        let struts = (self.strut_damping + self.strut_stiffness * tau) * tau;
        let ground = (self.ground_damping + self.ground_stiffness * tau) * tau;
        let own = Matrix3::identity() * self.mass - struts - ground;
        let inverse = inverse(&own);
        let turn = self.pull * squared;
        let passing = product(&self.strut_damping, &self.passing) * squared;
        // A foot moves in the body by −1 per displacement and by the lever per rotation; the transpose of the lever is −lever.
        let on_foot = [-struts, product(&struts, &self.lever) + passing - turn];
        let on_body = [-struts, turn - product(&self.lever, &struts)];
        let moved = [
            product(&inverse, &on_foot[0]) - Matrix3::identity(),
            product(&inverse, &on_foot[1]) + self.lever,
        ];
        let on_force = [
            product(&on_body[0], &moved[0]),
            product(&on_body[0], &moved[1]) + turn - passing,
        ];
        let on_torque = [
            product(&on_body[1], &moved[0]),
            product(&on_body[1], &moved[1]) - product(&self.lever, &passing),
        ];
        let eliminated = Eliminated {
            inverse,
            on_body,
            on_foot,
        };
        (eliminated, [on_force, on_torque])
    }

    /// Force and torque on the body, and force on the foot, that given displacements of foot and body make, vehicle axes, lb and
    /// ft·lb.
    #[inline(always)]
    fn pushes(
        &self,
        foot: &Vector3<Quad>,
        shift: &Vector3<Quad>,
        turn: &Vector3<Quad>,
    ) -> ([Vector3<Quad>; 2], Vector3<Quad>) {
        let place = foot - shift + times(&self.lever, turn);
        let struts = times(&self.strut_stiffness, &place)
            + times(&self.strut_damping, &times(&self.passing, turn));
        let turned = times(&self.pull, turn);
        let torque = times(&self.pull, &place) - times(&self.lever, &struts);
        let on_foot = struts - turned + times(&self.ground_stiffness, foot);
        ([turned - struts, torque], on_foot)
    }
}

impl StageEquations<f64, State> for StageFactors<'_> {
    #[inline(always)]
    fn solve(&self, r: &State, u: &mut State) {
        let (tau, response) = (self.tau, self.response);
        let frame = &response.frame;
        let given = r.body();
        let in_quads = |v: &Vector3<f64>| v.map(Quad::constant);
        let wide_tau = Quad::constant(tau);
        let wide_frame = frame.map(Quad::constant);
        let shift = in_quads(&(transposed_times(frame, &given.position) * tau));
        let turn = in_quads(&(turn(&response.quaternion, &given.quaternion) * tau));
        let mut force = transposed_times(frame, &given.velocity) * response.mass;
        let mut torque = times(&response.inertia, &given.rate);
        let mut rights = Quads::<Vector3<Quad>>::new();
        for (quad, eliminated) in self.quads.iter().enumerate() {
            let (leg, feet) = (&response.quads[quad], r.feet(quad));
            let place = transposed_times(&wide_frame, &feet.position) * wide_tau;
            let ([push, twist], on_foot) = leg.pushes(&place, &shift, &turn);
            let own = transposed_times(&wide_frame, &feet.velocity) * leg.mass + on_foot;
            let moved = times(&eliminated.inverse, &own);
            let [on_force, on_torque] = &eliminated.on_body;
            let legs = legs_in(quad, response.legs);
            force += vector_sum(&(push + times(on_force, &moved)), legs);
            torque += vector_sum(&(twist + times(on_torque, &moved)), legs);
            rights.push(own);
        }
        let mut body = Vector6::new(force.x, force.y, force.z, torque.x, torque.y, torque.z) * tau;
        self.body.solve(&mut body);
        let local = Vector3::new(body[0], body[1], body[2]);
        let rate = Vector3::new(body[3], body[4], body[5]);
        let velocity = times(frame, &local);
        u.set_body(&Body {
            position: (given.position + velocity) * tau,
            velocity,
            quaternion: (given.quaternion + quaternion_rate(&response.quaternion, &rate)) * tau,
            rate,
        });
        let (local, rate) = (in_quads(&local), in_quads(&rate));
        for (quad, eliminated) in self.quads.iter().enumerate() {
            let [by_velocity, by_rate] = &eliminated.on_foot;
            let right =
                rights[quad] * wide_tau + times(by_velocity, &local) + times(by_rate, &rate);
            let velocity = times(&wide_frame, &times(&eliminated.inverse, &right));
            u.set_feet(
                quad,
                &FootState {
                    position: (r.feet(quad).position + velocity) * wide_tau,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crush_load::CrushLoad;
    use crate::integrator::event::Exit;
    use crate::integrator::step::StateVector;
    use crate::laws::three_struts::{INTERFERENCE, LegLaws, LegMode};
    use crate::parts::Inertia;
    use crate::per_leg::PerLeg;
    use crate::profile::Profile;
    use crate::scene::{Conditions, Scene};
    use crate::three_strut_leg::ThreeStrutLeg;
    use crate::three_struts::{
        Arrangement, BallFootpad, Foot, LegStrut, Telescope, ThreeStrutDesign,
    };
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
            static_friction_ratio: None,
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
        let cantilever = Telescope::without_friction(6.0);
        let with_friction = Telescope {
            bearing_friction: 0.1,
            bearing_overhang: 4.0,
            bearing_overlap: 3.0,
            ..cantilever
        };
        for arrangement in [
            Arrangement::Tripod,
            Arrangement::Cantilever(cantilever),
            Arrangement::Cantilever(with_friction),
        ] {
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
            let pieces_of = |modes: &PerLeg<LegMode>| {
                Pieces::new(PerLeg::from_fn(3, |j| modes[j].pieces(&laws[j])))
            };
            let mut modes = PerLeg::from_fn(3, |j| LegMode::untouched(&laws[j]));
            let untouched = pieces_of(&modes);
            let signals = motion.signals(&state, &untouched);
            for j in 0..3 {
                let mut foot = state.foot(j);
                let up = signals.of(j, INTERFERENCE) - 0.05;
                foot.position -= motion.ground_normal(j) * up;
                foot.velocity += Vector3::new(0.3, 0.1, -0.2);
                state.set_foot(j, &foot);
            }
            let signals = motion.signals(&state, &untouched);
            for (j, mode) in modes.iter_mut().enumerate() {
                let signals = signals.leg(j);
                (mode.cross(&laws[j], j, INTERFERENCE, Exit::Above, &signals)).unwrap();
            }
            let pieces = pieces_of(&modes);
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
