//! The equations of motion and one Runge-Kutta step without the landing around them.

use nalgebra::{Vector3, Vector4};
use touchdown_dynamics::contact::{LegLaws, LegMode};
use touchdown_dynamics::integrator::event::Exit;
use touchdown_dynamics::integrator::rosenbrock::GAMMA;
use touchdown_dynamics::integrator::step::StateVector;
use touchdown_dynamics::integrator::step::Step;
use touchdown_dynamics::lanes::Lanes;
use touchdown_dynamics::motion::{FreeFlight, LegLoads, Motion, Pieces, Signal, Signals};
use touchdown_dynamics::per_leg::PerLeg;
use touchdown_dynamics::response::{Factors, Response};
use touchdown_dynamics::rules::ContactRule;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene};
use touchdown_dynamics::soil::Soil;
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;
use touchdown_dynamics::vehicle::Vehicle;

use super::level;
use super::scenes::pressed_in;

/// A vehicle in a scene with fixed pieces of all laws.
#[derive(Clone)]
pub struct Bare {
    /// Its equations of motion.
    pub motion: Motion<f64>,
    laws: Vec<LegLaws>,
    pieces: Pieces<f64>,
}

impl Bare {
    /// A vehicle that touches nothing.
    pub fn new(vehicle: &Vehicle, scene: &Scene) -> Self {
        Self::by_rules(vehicle, scene, CrushRule::PivotRate, ContactRule::Pivot)
    }

    /// The same under any rules.
    pub fn by_rules(
        vehicle: &Vehicle,
        scene: &Scene,
        crush: CrushRule,
        contact: ContactRule,
    ) -> Self {
        let laws: Vec<LegLaws> = (vehicle.hinged_legs().iter().enumerate())
            .map(|(j, leg)| {
                let laws = leg.laws().clone().with_crush_rule(crush);
                let soil = scene.conditions().soil_under(j);
                laws.with_contact_rule(contact).on_soil(&soil, leg.design())
            })
            .collect();
        let untouched: Vec<_> = (laws.iter())
            .map(|laws| LegMode::untouched(laws).pieces(laws))
            .collect();
        let pieces = Pieces::new(&untouched);
        Self {
            motion: Motion::new(vehicle, scene).with_contact_rule(contact),
            laws,
            pieces,
        }
    }

    /// Puts in place the pieces that hold at a state.
    pub fn settle(&mut self, state: &State<f64>) {
        let mut state = *state;
        let mut modes: Vec<LegMode> = self.laws.iter().map(LegMode::untouched).collect();
        for _ in 0..32 {
            let mut derivative = State::zero(3);
            let mut signals = Signals::blank(3);
            self.motion.evaluate::<true, false>(
                0.0,
                &state,
                &self.pieces,
                &mut derivative,
                &mut signals,
            );
            let mut changed = false;
            for (j, mode) in modes.iter_mut().enumerate() {
                let ranges = mode.ranges(&self.laws[j]);
                let left = ranges
                    .iter()
                    .zip(Signal::ALL)
                    .find_map(|(range, signal)| Some((signal, range.exit(signals.of(j, signal))?)));
                if let Some((signal, exit)) = left {
                    changed = true;
                    let (laws, before) = (&self.laws[j], *mode);
                    mode.cross(laws, j, signal, exit, signals.leg(j)).unwrap();
                    let mut leg = state.leg(j);
                    leg.pad_turn = mode.pad_turn(laws, before.pad_angle(laws, leg.pad_turn));
                    state.set_leg(j, &leg);
                }
            }
            let pieces: Vec<_> = (modes.iter().zip(&self.laws))
                .map(|(mode, laws)| mode.pieces(laws))
                .collect();
            self.pieces = Pieces::new(&pieces);
            if !changed {
                return;
            }
        }
        panic!("laws do not settle");
    }

    /// Lets all pads touch and lift off again at a state in the air: links that move outward run down from then on.
    pub fn lift_off(&mut self, state: &State<f64>) {
        let signals = self.signals(state);
        let lifted = self.laws.iter().enumerate().map(|(j, laws)| {
            let mut mode = LegMode::untouched(laws);
            for exit in [Exit::Above, Exit::Below] {
                mode.cross(laws, j, Signal::OuterInterference, exit, signals.leg(j))
                    .unwrap();
            }
            mode.pieces(laws)
        });
        self.pieces = Pieces::new(&lifted.collect::<Vec<_>>());
    }

    /// Writes the time derivative of a state.
    pub fn derivative(&self, state: &State<f64>, slope: &mut State<f64>) {
        if self.motion.acts_at_face() {
            (self.motion).derivative::<true, true>(0.0, state, &self.pieces, slope);
        } else {
            (self.motion).derivative::<true, false>(0.0, state, &self.pieces, slope);
        }
    }

    /// The equations of motion in lanes, this vehicle in each, and the coefficients in force.
    pub fn in_lanes<const N: usize>(&self) -> (Motion<Lanes<N>>, Pieces<Lanes<N>>) {
        let legs = self.motion.leg_count();
        let mut pieces = Pieces::absent(legs);
        for lane in 0..N {
            for leg in 0..legs {
                pieces.set_lane(lane, leg, &self.pieces);
            }
        }
        (self.motion.in_all_lanes(), pieces)
    }

    /// The signals of all legs, torques included.
    pub fn signals(&self, state: &State<f64>) -> Signals<f64> {
        self.motion.signals(state, &self.pieces, true)
    }

    /// Loads of all legs.
    pub fn loads(&self, state: &State<f64>) -> PerLeg<LegLoads<f64>> {
        self.motion.loads(state, &self.pieces)
    }

    /// How the forces answer at a state.
    pub fn response(&self, state: &State<f64>) -> Response<f64> {
        let mut response = self.motion.response();
        if self.motion.acts_at_face() {
            (self.motion).respond::<true>(state, &self.pieces, &mut response);
        } else {
            (self.motion).respond::<false>(state, &self.pieces, &mut response);
        }
        response
    }

    /// Rate (1/s) that no decay of a velocity exceeds at a state.
    pub fn greatest_decay(&self, state: &State<f64>) -> f64 {
        if self.motion.acts_at_face() {
            self.motion.greatest_decay::<true>(state, &self.pieces)
        } else {
            self.motion.greatest_decay::<false>(state, &self.pieces)
        }
    }

    /// The flight from a state on, all legs hanging.
    pub fn free_flight(&self, state: &State<f64>) -> FreeFlight {
        self.motion.free_flight(state, &self.pieces)
    }

    /// One step of `length` seconds.
    pub fn step(&self, state: &State<f64>, length: f64) -> Step<f64, State<f64>> {
        let mut step = self.standing_at(state);
        let derivative = |state: &_, slope: &mut _| self.derivative(state, slope);
        let stage = |_, state: &_, slope: &mut _| derivative(state, slope);
        step.take_explicit(length, stage, derivative);
        step
    }

    /// One implicit step of `length` seconds.
    pub fn implicit_step(&self, state: &State<f64>, length: f64) -> Step<f64, State<f64>> {
        self.implicit_step_and_middle(state, length).0
    }

    /// One implicit step of `length` seconds, and the state at which it evaluates its middle.
    pub fn implicit_step_and_middle(
        &self,
        state: &State<f64>,
        length: f64,
    ) -> (Step<f64, State<f64>>, State<f64>) {
        let mut step = self.standing_at(state);
        let mut midway = *state;
        let response = self.response(state);
        let derivative = |state: &_, slope: &mut _| self.derivative(state, slope);
        let middle = |state: &State<f64>, slope: &mut _| {
            midway = *state;
            derivative(state, slope);
        };
        let mut factors = Factors::none(state.leg_count());
        let system = response.over(GAMMA * length, &mut factors);
        let mut stages = [State::zero(3); 6];
        let stage = |_, state: &_, slope: &mut _| derivative(state, slope);
        step.take_implicit(
            length,
            &system,
            &mut stages,
            None,
            stage,
            middle,
            derivative,
        );
        (step, midway)
    }

    fn standing_at(&self, state: &State<f64>) -> Step<f64, State<f64>> {
        let mut slope = State::zero(3);
        self.derivative(state, &mut slope);
        Step::from(*state, slope)
    }

    /// `count` implicit steps through `time` seconds.
    pub fn march_implicit(&self, state: &State<f64>, time: f64, count: u32) -> State<f64> {
        let length = time / f64::from(count);
        (0..count).fold(*state, |state, _| self.implicit_step(&state, length).after)
    }

    /// `count` steps through `time` seconds.
    pub fn march(&self, state: &State<f64>, time: f64, count: u32) -> State<f64> {
        let length = time / f64::from(count);
        (0..count).fold(*state, |state, _| self.step(&state, length).after)
    }
}

/// A vehicle that stands along the slope with all its feet `depth` ft deep, sliding and turning, its struts stroking
/// and returning.
pub fn pressed(vehicle: &Vehicle, depth: f64, sliding: f64) -> (Bare, State<f64>) {
    pressed_by(vehicle, depth, sliding, ContactRule::Pivot)
}

/// The same under a contact rule.
pub fn pressed_by(
    vehicle: &Vehicle,
    depth: f64,
    sliding: f64,
    rule: ContactRule,
) -> (Bare, State<f64>) {
    pressed_on(vehicle, [depth, sliding, 0.0], rule, Soil::Rock)
}

/// A vehicle as in [`pressed_by`] on this soil, into which it also sinks: depth (ft), sliding and sinking (ft/s).
pub fn pressed_on(
    vehicle: &Vehicle,
    [depth, sliding, sinking]: [f64; 3],
    rule: ContactRule,
    soil: Soil,
) -> (Bare, State<f64>) {
    let scene = Scene::new(Conditions {
        soil,
        ..level(170.0, -10.0, 11.0)
    });
    let scene = scene.unwrap();
    let mut bare = Bare::by_rules(vehicle, &scene, CrushRule::PivotRate, rule);
    let first = touchdown(vehicle, &scene, &bare.motion);
    let mut state = pressed_in(first, [-0.8, 0.3, -0.1], Vector3::new(0.2, -0.3, 0.1));
    let mut body = state.body();
    let slope = scene.conditions().slope;
    let (sine, cosine) = (0.5 * slope).sin_cos();
    body.quaternion = Vector4::new(cosine, -sine, 0.0, 0.0);
    body.velocity = Vector3::new(sliding, 0.3 * sliding, sinking);
    state.set_body(&body);
    let deep = bare.signals(&state).of(0, Signal::OuterInterference);
    body.position.z += (depth - deep) / slope.cos();
    state.set_body(&body);
    bare.settle(&state);
    (bare, state)
}

/// Greatest difference of what moves in two states, relative above 1 and absolute below.
pub fn distance(one: &State<f64>, other: &State<f64>) -> f64 {
    State::greatest_error([1.0, -1.0], [one, other], one, other)[0]
}
