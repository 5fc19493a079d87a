//! Forces on body and feet, and the signals by which laws change.

use nalgebra::{Matrix3, Vector3};

use super::state::{FootState, State};
use super::struts::{Reach, Struts};
use crate::ground::Patch;
use crate::integrator::event::SignalValues;
use crate::kinematics::{LocalPlane, Surface};
use crate::laws::three_struts::{
    INTERFERENCE, INTERFERENCE_RATE, LOAD, LegPieces, LegSignals, SIGNALS, SLIDING, STROKE_RATES,
    STROKES, STRUTS,
};
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::scene::Scene;
use crate::state::{Body, quaternion_rate, rotation};
use crate::three_strut_leg::ThreeStrutLeg;
use crate::three_struts::LegStrut;
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
    pub(super) legs: PerLeg<Leg>,
}

/// Constants of one leg.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    pub(super) struts: Struts,
    /// Damping of each strut: lb·s/ft, and lb·s²/ft².
    damping: [[f64; 2]; STRUTS],
    pub(super) mass: f64,
    pub(super) ground: LocalPlane<f64>,
    pad_height: f64,
    /// π d_f²/4 C_f: the force on the footpad per relative pressure, lb.
    pub(super) pad_strength: f64,
    friction: f64,
}

/// Signals of all legs at one instant.
pub type Signals = [LegSignals; MOST_LEGS];

impl SignalValues for Signals {
    #[inline(always)]
    fn get(&self, index: usize) -> f64 {
        self.as_flattened()[index]
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

/// One leg at one instant.
pub(super) struct LegAction {
    /// Foot from the CG in vehicle axes, ft.
    pub(super) place: Vector3<f64>,
    /// Its velocity in the body, ft/s.
    pub(super) velocity: Vector3<f64>,
    pub(super) reaches: [Reach; STRUTS],
    pub(super) rates: [f64; STRUTS],
    pub(super) loads: [f64; STRUTS],
    /// Force of the struts on the foot in vehicle axes, lb.
    pub(super) pull: Vector3<f64>,
    pub(super) contact: Contact,
    pub(super) interference: f64,
}

/// Action of the ground on a foot.
pub(super) struct Contact {
    /// Velocity into the ground, ft/s, and along it in ground axes.
    pub(super) inward: f64,
    pub(super) sliding: Vector3<f64>,
    pub(super) sliding_squared: f64,
    /// Normal force, lb.
    pub(super) normal: f64,
    /// μ/S, s/ft.
    pub(super) drag: f64,
}

impl Leg {
    fn new(index: usize, leg: &ThreeStrutLeg, depth: f64, center: [f64; 2], scene: &Scene) -> Self {
        let design = leg.design();
        let conditions = scene.conditions();
        let struts = Struts::new(design, depth, center);
        let patch: &Patch = &conditions.ground.leg(index).pad;
        let place = conditions.attitude.matrix() * struts.foot;
        let pad = &design.footpad;
        Self {
            struts,
            damping: design
                .struts()
                .map(|strut: &LegStrut| [strut.damping, strut.square_damping]),
            mass: design.foot.mass,
            ground: LocalPlane::new(patch, conditions.slope, place),
            pad_height: pad.height,
            pad_strength: std::f64::consts::FRAC_PI_4
                * pad.diameter
                * pad.diameter
                * pad.crush_pressure,
            friction: conditions.pad_friction,
        }
    }

    /// Damping of strut `k` at a rate of its stroke (ft/s): force per speed, and its derivative, lb·s/ft.
    #[inline(always)]
    pub(super) fn damping(&self, k: usize, rate: f64) -> [f64; 2] {
        let [linear, square] = self.damping[k];
        let grown = square * rate.abs();
        [linear + grown, linear + 2.0 * grown]
    }
}

impl Motion {
    /// The equations of motion of a vehicle on these legs in a scene.
    pub fn new(vehicle: &Vehicle, legs: &[ThreeStrutLeg], scene: &Scene) -> Self {
        let inertia = *vehicle.inertia();
        let depth = vehicle.center_of_gravity_height();
        let center = vehicle.center_of_gravity_offset().map(|offset| -offset);
        let [x, y] = scene.conditions().thrust.offset();
        Self {
            surface: Surface::new(scene),
            thrust_place: Vector3::new(center[0] + x, center[1] + y, 0.0),
            mass: vehicle.mass(),
            // A positive definite matrix has an inverse; the vehicle was checked.
            inverse_inertia: inertia.try_inverse().unwrap_or_else(Matrix3::zeros),
            inertia,
            gravity: scene.gravity(vehicle),
            legs: PerLeg::from_fn(legs.len(), |j| Leg::new(j, &legs[j], depth, center, scene)),
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
        let rise = |leg: &Leg| {
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

    /// One leg at a state.
    #[inline(always)]
    pub(super) fn act(
        &self,
        leg: usize,
        body: &Body<f64>,
        frame: &Matrix3<f64>,
        foot: &FootState,
        pieces: &LegPieces,
    ) -> LegAction {
        let of_leg = &self.legs[leg];
        let place = frame.tr_mul(&(foot.position - body.position));
        let velocity = frame.tr_mul(&(foot.velocity - body.velocity)) - body.rate.cross(&place);
        let reaches = of_leg.struts.at(&place);
        let rates: [f64; STRUTS] = std::array::from_fn(|k| -reaches[k].push.dot(&velocity));
        let loads: [f64; STRUTS] = std::array::from_fn(|k| {
            let [damping, _] = of_leg.damping(k, rates[k]);
            pieces.struts[k].at(reaches[k].stroke) + damping * rates[k]
        });
        let pull = (0..STRUTS).fold(Vector3::zeros(), |pull, k| {
            pull + reaches[k].push * loads[k]
        });
        let normal = of_leg.ground.normal();
        let interference = of_leg.ground.depth_of(&foot.position) + of_leg.pad_height;
        let inward = normal.dot(&foot.velocity);
        let sliding = foot.velocity - normal * inward;
        let sliding_squared = sliding.norm_squared();
        LegAction {
            place,
            velocity,
            reaches,
            rates,
            loads,
            pull,
            contact: Contact {
                inward,
                sliding,
                sliding_squared,
                normal: of_leg.pad_strength * pieces.pad.at(interference),
                drag: of_leg.friction * pieces.friction.per_speed(sliding_squared),
            },
            interference,
        }
    }

    /// Rate at which the fastest motion of a foot decays, 1/s, and the angular frequency of the fastest oscillation, rad/s, where
    /// the signals are these: upper limits of both.
    #[inline(always)]
    pub fn fastest(&self, signals: &Signals, pieces: &PerLeg<LegPieces>) -> [f64; 2] {
        let (mut decay, mut stiffness): (f64, f64) = (0.0, 0.0);
        for (j, leg) in self.legs.iter().enumerate() {
            let (signals, pieces) = (&signals[j], &pieces[j]);
            let normal = leg.pad_strength * pieces.pad.at(signals[INTERFERENCE]);
            let friction = normal * leg.friction * pieces.friction.per_speed(signals[SLIDING]);
            let pad = leg.pad_strength * pieces.pad.slope();
            let (mut damping, mut springs) = (friction, pad);
            for k in 0..STRUTS {
                damping += leg.damping(k, signals[STROKE_RATES.start + k])[1];
                springs += pieces.struts[k].slope();
            }
            decay = decay.max(damping / leg.mass);
            stiffness = stiffness.max(springs / leg.mass);
        }
        [decay, libm::sqrt(stiffness)]
    }

    /// Change of the friction on a footpad with its sliding speed, per normal force, s/ft.
    pub(super) fn friction_change(&self, leg: usize, pieces: &LegPieces) -> f64 {
        self.legs[leg].friction * pieces.friction.change()
    }

    /// Writes the time derivative of the state and the signals of all legs, under this thrust (lb).
    #[inline(always)]
    pub fn evaluate(
        &self,
        thrust: f64,
        state: &State,
        pieces: &PerLeg<LegPieces>,
        derivative: &mut State,
        signals: &mut Signals,
    ) {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        // Force and torque about the CG, vehicle axes.
        let mut force = Vector3::new(0.0, 0.0, -thrust);
        let mut torque = self.thrust_place.cross(&force);
        for (j, leg) in self.legs.iter().enumerate() {
            let foot = state.foot(j);
            let action = self.act(j, &body, &frame, &foot, &pieces[j]);
            force -= action.pull;
            torque -= action.place.cross(&action.pull);
            let contact = &action.contact;
            let ground = (leg.ground.normal() + contact.sliding * contact.drag) * -contact.normal;
            let mut acceleration = (frame * action.pull + ground) / leg.mass;
            acceleration.z += self.gravity;
            derivative.set_foot(
                j,
                &FootState {
                    position: foot.velocity,
                    velocity: acceleration,
                },
            );
            let power: f64 = (0..STRUTS).map(|k| action.loads[k] * action.rates[k]).sum();
            derivative.set_works(
                j,
                [
                    power,
                    contact.normal * contact.inward,
                    contact.normal * contact.drag * contact.sliding_squared,
                ],
            );
            signals[j] = action.signals();
        }
        let mut acceleration = frame * force / self.mass;
        acceleration.z += self.gravity;
        let twist = torque - body.rate.cross(&(self.inertia * body.rate));
        derivative.set_body(&Body {
            position: body.velocity,
            velocity: acceleration,
            quaternion: quaternion_rate(&body.quaternion, &body.rate),
            rate: self.inverse_inertia * twist,
        });
    }

    /// Writes the time derivative of the state under this thrust (lb).
    #[inline(always)]
    pub fn derive(
        &self,
        thrust: f64,
        state: &State,
        pieces: &PerLeg<LegPieces>,
        derivative: &mut State,
    ) {
        let mut signals = [[0.0; SIGNALS]; MOST_LEGS];
        self.evaluate(thrust, state, pieces, derivative, &mut signals);
    }

    /// Signals of all legs at a state.
    pub fn signals(&self, state: &State, pieces: &PerLeg<LegPieces>) -> Signals {
        let mut signals = [[0.0; SIGNALS]; MOST_LEGS];
        let body = state.body();
        let frame = rotation(&body.quaternion);
        for j in 0..self.leg_count() {
            let action = self.act(j, &body, &frame, &state.foot(j), &pieces[j]);
            signals[j] = action.signals();
        }
        signals
    }

    /// Forces on a leg at a state.
    pub fn forces(&self, leg: usize, state: &State, pieces: &PerLeg<LegPieces>) -> LegForces {
        let body = state.body();
        let frame = rotation(&body.quaternion);
        let action = self.act(leg, &body, &frame, &state.foot(leg), &pieces[leg]);
        let contact = &action.contact;
        LegForces {
            struts: action.loads,
            normal: contact.normal,
            friction: contact.normal * contact.drag * libm::sqrt(contact.sliding_squared),
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

impl LegAction {
    #[inline(always)]
    fn signals(&self) -> LegSignals {
        let mut signals = [0.0; SIGNALS];
        signals[INTERFERENCE] = self.interference;
        signals[INTERFERENCE_RATE] = self.contact.inward;
        signals[SLIDING] = self.contact.sliding_squared;
        for k in 0..STRUTS {
            signals[STROKES.start + k] = self.reaches[k].stroke;
            signals[STROKE_RATES.start + k] = self.rates[k];
        }
        signals[LOAD] = self.loads[0];
        signals
    }
}
