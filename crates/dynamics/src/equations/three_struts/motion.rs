//! Forces on body and feet, and the signals by which laws change.

use nalgebra::{Matrix3, Vector3};
use num_traits::One;

use super::leg::{Leg, LegAction, SeenBody};
use super::state::{FootState, State};
use crate::integrator::event::SignalValues;
use crate::kinematics::Surface;
use crate::lanes::Lanes;
use crate::laws::three_struts::{
    INTERFERENCE, INTERFERENCE_RATE, LOAD, LegPieces, LegSignals, SIGNALS, SLIDING, STROKE_RATES,
    STROKES, STRUTS,
};
use crate::per_leg::PerLeg;
use crate::products::times;
use crate::quads::{LANES, QUADS, Quad, Quads, legs_in, side_by_side, vector_sum};
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::{Body, quaternion_rate, rotation};
use crate::three_strut_leg::ThreeStrutLeg;
use crate::vehicle::Vehicle;

/// The equations of motion of a vehicle on legs of three struts in a scene.
#[derive(Debug, Clone)]
pub struct Motion {
    surface: Surface<f64>,
    /// A point of the line of action of the thrust, vehicle axes from the CG, ft.
    thrust_place: Vector3<f64>,
    pub(super) mass: f64,
    pub(super) inertia: Matrix3<f64>,
    inverse_inertia: Matrix3<f64>,
    gravity: f64,
    legs: PerLeg<Leg<f64>>,
    /// The same, four legs at a time.
    pub(super) quads: Quads<Leg<Quad>>,
}

/// The active pieces of the laws of all legs.
#[derive(Debug, Clone)]
pub struct Pieces {
    legs: PerLeg<LegPieces<f64>>,
    pub(super) quads: Quads<LegPieces<Quad>>,
}

impl Pieces {
    /// The active pieces of these legs.
    pub fn new(legs: PerLeg<LegPieces<f64>>) -> Self {
        Self {
            quads: side_by_side(&legs),
            legs,
        }
    }
}

/// Signals of all legs at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Signals([LegSignals<Quad>; QUADS]);

impl Signals {
    /// No signals yet.
    pub const NONE: Self = Self([[Lanes([0.0; LANES]); SIGNALS]; QUADS]);

    /// A signal of a leg.
    #[inline(always)]
    pub fn of(&self, leg: usize, signal: usize) -> f64 {
        self.0[leg / LANES][signal].0[leg % LANES]
    }

    /// The signals of a group of legs.
    #[inline(always)]
    pub fn quad(&self, quad: usize) -> &LegSignals<Quad> {
        &self.0[quad]
    }

    /// The signals of a leg.
    pub fn leg(&self, leg: usize) -> LegSignals<f64> {
        std::array::from_fn(|signal| self.of(leg, signal))
    }
}

impl SignalValues for Signals {
    /// Signals are counted leg by leg.
    #[inline(always)]
    fn get(&self, index: usize) -> f64 {
        self.of(index / SIGNALS, index % SIGNALS)
    }
}

/// Forces on one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegForces {
    /// Load of each strut, lb; compression is positive.
    pub struts: [f64; STRUTS],
    /// Normal force of the ground on the footpad, lb.
    pub normal: f64,
    /// Friction force on it, lb.
    pub friction: f64,
}

impl Motion {
    /// The equations of motion of a vehicle on these legs in a scene.
    pub fn new(vehicle: &Vehicle, legs: &[ThreeStrutLeg], scene: &Scene) -> Self {
        let inertia = *vehicle.inertia();
        let depth = vehicle.center_of_gravity_height();
        let center = vehicle.center_of_gravity_offset().map(|offset| -offset);
        let [x, y] = scene.conditions().thrust.offset();
        let of_legs = PerLeg::from_fn(legs.len(), |j| Leg::new(j, &legs[j], depth, center, scene));
        Self {
            surface: Surface::new(scene),
            thrust_place: Vector3::new(center[0] + x, center[1] + y, 0.0),
            mass: vehicle.mass(),
            // A positive definite matrix has an inverse; the vehicle was checked.
            inverse_inertia: inertia.try_inverse().unwrap_or_else(Matrix3::zeros),
            inertia,
            gravity: scene.gravity(vehicle),
            quads: side_by_side(&of_legs),
            legs: of_legs,
        }
    }

    /// Number of legs.
    pub fn leg_count(&self) -> usize {
        self.legs.len()
    }

    /// Acceleration of gravity, ft/s².
    pub fn gravity(&self) -> f64 {
        self.gravity
    }

    /// Mass of body and feet, slug.
    pub fn total_mass(&self) -> f64 {
        self.mass + self.legs.iter().map(|leg| leg.mass).sum::<f64>()
    }

    /// The state at first contact: feet at rest in the moving body, with the lowest footpad on its ground.
    pub fn at_first_contact(&self, mut body: Body<f64>) -> State {
        let frame = rotation(&body.quaternion);
        let rise = |leg: &Leg<f64>| {
            let depth = leg
                .ground
                .depth_of(&(body.position + frame * leg.struts.foot));
            leg.ground.rise(depth + leg.pad_height)
        };
        body.position.z -= crate::extremes::greatest(self.legs.iter().map(rise));
        let mut state = State::zero(self.leg_count());
        state.set_body(&body);
        for (j, leg) in self.legs.iter().enumerate() {
            let place = &leg.struts.foot;
            state.set_foot(
                j,
                &FootState {
                    position: body.position + frame * place,
                    velocity: body.velocity + frame * body.rate.cross(place),
                },
            );
        }
        state
    }

    /// Rate at which the fastest motion of a foot decays, 1/s, and the angular frequency of the fastest oscillation, rad/s, where
    /// the signals are these: upper limits of both.
    #[inline(always)]
    pub fn fastest(&self, signals: &Signals, pieces: &Pieces) -> [f64; 2] {
        let mut fastest = [Quad::constant(0.0); 2];
        for (quad, leg) in self.quads.iter().enumerate() {
            let (signals, pieces) = (&signals.0[quad], &pieces.quads[quad]);
            let rate = signals[INTERFERENCE_RATE];
            let normal = leg.normal(pieces, signals[INTERFERENCE], rate);
            let mut damping = normal * leg.friction * pieces.friction.per_speed(signals[SLIDING])
                + leg.pad_strength * pieces.pad.drag_damping(rate);
            let mut springs = leg.pad_strength * pieces.pad.slope();
            let mut across = Quad::constant(0.0);
            for k in 0..STRUTS {
                damping += leg.damping(k, signals[STROKE_RATES.start + k])[1];
                springs += pieces.struts[k].slope();
            }
            for k in 1..STRUTS {
                let (stroke, rate) = (signals[STROKES.start + k], signals[STROKE_RATES.start + k]);
                across += leg.load(k, pieces, stroke, rate).abs();
            }
            damping += leg.bearings.greatest_damping(
                signals[STROKES.start],
                signals[STROKE_RATES.start],
                across,
            );
            let [decay, stiffness] = &mut fastest;
            *decay = decay.max(damping / leg.mass);
            *stiffness = stiffness.max(springs / leg.mass);
        }
        let [decay, stiffness] =
            fastest.map(|of_legs| crate::extremes::greatest(of_legs.0.into_iter()));
        [decay, libm::sqrt(stiffness)]
    }

    /// Writes the time derivative of the state under this thrust (lb), and tells of each group of legs in turn.
    #[inline(always)]
    fn derive_and_tell(
        &self,
        thrust: f64,
        state: &State,
        pieces: &Pieces,
        derivative: &mut State,
        mut tell: impl FnMut(usize, &LegAction<Quad>),
    ) {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        let seen = SeenBody::new(&body, &frame);
        let gravity = Quad::constant(self.gravity);
        // Force and torque about the CG, vehicle axes.
        let mut force = Vector3::new(0.0, 0.0, -thrust);
        let mut torque = self.thrust_place.cross(&force);
        for (quad, leg) in self.quads.iter().enumerate() {
            let foot = state.feet(quad);
            let action = leg.act(&seen, &foot, &pieces.quads[quad]);
            let legs = legs_in(quad, self.leg_count());
            force -= vector_sum(&action.pull, legs);
            torque -= vector_sum(&action.place.cross(&action.pull), legs);
            let contact = &action.contact;
            let ground = (leg.ground.normal() + contact.sliding * contact.drag) * -contact.normal;
            let mut acceleration =
                (times(&seen.frame, &action.pull) + ground) * (Quad::one() / leg.mass);
            acceleration.z += gravity;
            derivative.set_feet(
                quad,
                &FootState {
                    position: foot.velocity,
                    velocity: acceleration,
                },
            );
            let [first, second, third] = &action.loads;
            let rates = &action.rates;
            derivative.set_works(
                quad,
                [
                    *first * rates[0] + *second * rates[1] + *third * rates[2],
                    contact.normal * contact.inward,
                    contact.normal * contact.drag * contact.sliding_squared,
                ],
            );
            tell(quad, &action);
        }
        let mut acceleration = times(&frame, &force) / self.mass;
        acceleration.z += self.gravity;
        let twist = torque - body.rate.cross(&times(&self.inertia, &body.rate));
        derivative.set_body(&Body {
            position: body.velocity,
            velocity: acceleration,
            quaternion: quaternion_rate(&body.quaternion, &body.rate),
            rate: times(&self.inverse_inertia, &twist),
        });
    }

    /// Writes the time derivative of the state under this thrust (lb).
    #[inline(always)]
    pub fn derive(&self, thrust: f64, state: &State, pieces: &Pieces, derivative: &mut State) {
        self.derive_and_tell(thrust, state, pieces, derivative, |_, _| {});
    }

    /// Writes the time derivative of the state and the signals of all legs, under this thrust (lb).
    #[inline(always)]
    pub fn evaluate(
        &self,
        thrust: f64,
        state: &State,
        pieces: &Pieces,
        derivative: &mut State,
        signals: &mut Signals,
    ) {
        self.derive_and_tell(thrust, state, pieces, derivative, |quad, action| {
            signals.0[quad] = action.signals();
        });
    }

    /// Signals of all legs at a state.
    #[inline(always)]
    pub fn signals(&self, state: &State, pieces: &Pieces) -> Signals {
        let mut signals = Signals::NONE;
        let body = state.body();
        let seen = SeenBody::new(&body, &rotation(&body.quaternion));
        for (quad, leg) in self.quads.iter().enumerate() {
            let action = leg.act(&seen, &state.feet(quad), &pieces.quads[quad]);
            signals.0[quad] = action.signals();
        }
        signals
    }

    /// Forces on a leg whose signals are these.
    pub fn forces(&self, leg: usize, signals: &Signals, pieces: &Pieces) -> LegForces {
        let (of_leg, signals, pieces) = (&self.legs[leg], signals.leg(leg), &pieces.legs[leg]);
        let [interference, rate] = [INTERFERENCE, INTERFERENCE_RATE].map(|k| signals[k]);
        let normal = of_leg.normal(pieces, interference, rate);
        let sliding_squared = signals[SLIDING];
        let drag = of_leg.friction * pieces.friction.per_speed(sliding_squared);
        let secondary = |k: usize| {
            let (stroke, rate) = (signals[STROKES.start + k], signals[STROKE_RATES.start + k]);
            of_leg.load(k, pieces, stroke, rate)
        };
        LegForces {
            struts: [signals[LOAD], secondary(1), secondary(2)],
            normal,
            friction: normal * drag * libm::sqrt(sliding_squared),
        }
    }

    /// Loads of the struts of a leg, lb, that together push its foot with this force (ground axes, lb).
    pub fn loads_for(&self, leg: usize, state: &State, force: &Vector3<f64>) -> [f64; STRUTS] {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        let place = frame.tr_mul(&(state.foot(leg).position - body.position));
        let pushes = self.legs[leg].struts.at(&place).map(|reach| reach.push);
        let loads = Matrix3::from_columns(&pushes)
            .try_inverse()
            .map(|inverse| inverse * frame.tr_mul(force));
        // Struts in one plane bear no force across it.
        loads.map_or([f64::INFINITY; STRUTS], Into::into)
    }

    /// Positions of the feet relative to the CG, ground axes, ft.
    pub fn feet(&self, state: &State) -> PerLeg<Vector3<f64>> {
        let center = state.body().position;
        PerLeg::from_fn(self.leg_count(), |j| state.foot(j).position - center)
    }

    /// Inward normal of the ground under a footpad, ground axes.
    pub fn ground_normal(&self, leg: usize) -> &Vector3<f64> {
        self.legs[leg].ground.normal()
    }

    /// Least height of the hardpoints over the surface, ft.
    pub fn clearance(&self, state: &State) -> f64 {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        let hardpoints = self.legs.iter().flat_map(|leg| leg.struts.hardpoints);
        let heights =
            hardpoints.map(|hardpoint| -self.surface.depth(&(body.position + frame * hardpoint)));
        crate::extremes::least(heights)
    }

    /// Kinetic energy of body and feet, ft·lb.
    pub fn kinetic(&self, state: &State) -> f64 {
        let body = state.body();
        let turning = body.rate.dot(&(self.inertia * body.rate));
        let feet = (self.legs.iter().enumerate())
            .map(|(j, leg)| leg.mass * state.foot(j).velocity.norm_squared());
        0.5 * (self.mass * body.velocity.norm_squared() + turning + feet.sum::<f64>())
    }

    /// Potential energy released between two states, ft·lb.
    pub fn released(&self, from: &State, to: &State) -> f64 {
        let descent = to.body().position.z - from.body().position.z;
        let feet = self
            .legs
            .iter()
            .enumerate()
            .map(|(j, leg)| leg.mass * (to.foot(j).position.z - from.foot(j).position.z));
        self.gravity * (self.mass * descent + feet.sum::<f64>())
    }

    /// Moment of the thrust about the CG per force, ground axes, ft; with the direction in which it pushes.
    pub fn thrust_line(&self, state: &State) -> (Vector3<f64>, Vector3<f64>) {
        let frame = rotation(&state.body().quaternion);
        let along = -frame.column(2).into_owned();
        ((frame * self.thrust_place).cross(&along), along)
    }

    /// Speed of the body along the line of action of the thrust, ft/s.
    pub fn speed_along_thrust(&self, state: &State) -> f64 {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        let velocity = frame.tr_mul(&body.velocity) + body.rate.cross(&self.thrust_place);
        -velocity.z
    }
}
