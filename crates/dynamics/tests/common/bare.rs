//! The equations of motion and one Runge-Kutta step without the landing around them.

use touchdown_dynamics::contact::{LegLaws, LegMode};
use touchdown_dynamics::formation::LegsAbreast;
use touchdown_dynamics::integrator::event::Exit;
use touchdown_dynamics::integrator::rosenbrock::GAMMA;
use touchdown_dynamics::integrator::step::Step;
use touchdown_dynamics::motion::{FreeFlight, Glance, Motion, MotionsAbreast, Pieces, Signal};
use touchdown_dynamics::response::Response;
use touchdown_dynamics::scene::{CrushRule, Scene};
use touchdown_dynamics::state::State;
use touchdown_dynamics::vehicle::Vehicle;

/// A vehicle in a scene with fixed pieces of all laws.
#[derive(Clone)]
pub struct Bare<const LEGS: usize> {
    /// Its equations of motion.
    pub motion: Motion<LEGS>,
    laws: [LegLaws; LEGS],
    pieces: Pieces<LEGS>,
}

impl<const LEGS: usize> Bare<LEGS> {
    /// A vehicle that touches nothing.
    pub fn new(vehicle: &Vehicle<LEGS>, scene: &Scene) -> Self {
        let rule = CrushRule::PivotRate;
        let laws = std::array::from_fn(|j| LegLaws::new(&vehicle.legs()[j], rule));
        let pieces = Pieces::new(&std::array::from_fn(|j: usize| {
            LegMode::untouched(&laws[j]).pieces(&laws[j])
        }));
        Self {
            motion: Motion::new(vehicle, scene),
            laws,
            pieces,
        }
    }

    /// Puts in place the pieces that hold at a state.
    pub fn settle(&mut self, state: &State<f64, LEGS>) {
        let mut state = *state;
        let mut modes: [LegMode; LEGS] = std::array::from_fn(|j| LegMode::untouched(&self.laws[j]));
        for _ in 0..32 {
            let mut derivative = State::zero();
            let mut signals = Glance::blank();
            self.motion
                .evaluate(&state, &self.pieces, &mut derivative, &mut signals);
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
                    mode.cross(laws, j, signal, exit, &signals.leg(j)).unwrap();
                    let mut leg = state.leg(j);
                    leg.pad_turn = mode.pad_turn(laws, before.pad_angle(laws, leg.pad_turn));
                    state.set_leg(j, &leg);
                }
            }
            self.pieces = Pieces::new(&std::array::from_fn(|j| modes[j].pieces(&self.laws[j])));
            if !changed {
                return;
            }
        }
        panic!("laws do not settle");
    }

    /// Lets all pads touch and lift off again at a state in the air: links that move outward run down from then on.
    pub fn lift_off(&mut self, state: &State<f64, LEGS>) {
        let signals = self.signals(state);
        self.pieces = Pieces::new(&std::array::from_fn(|j| {
            let (laws, mut mode) = (&self.laws[j], LegMode::untouched(&self.laws[j]));
            for exit in [Exit::Above, Exit::Below] {
                mode.cross(laws, j, Signal::OuterInterference, exit, &signals.leg(j))
                    .unwrap();
            }
            mode.pieces(laws)
        }));
    }

    /// Writes the time derivative of a state.
    pub fn derivative(&self, state: &State<f64, LEGS>, slope: &mut State<f64, LEGS>) {
        self.motion.derivative(state, &self.pieces, slope);
    }

    /// The equations of motion in lanes, this vehicle in each.
    pub fn abreast<const N: usize>(&self) -> MotionsAbreast<N, LEGS> {
        let mut motions = MotionsAbreast::new(&self.motion);
        for lane in 0..N {
            for leg in 0..LEGS {
                motions.set_pieces(lane, leg, &self.pieces);
            }
        }
        motions
    }

    /// The same in registers of one or two numbers.
    pub fn in_narrow_registers(self) -> Self {
        Self {
            motion: self.motion.in_narrow_registers(),
            ..self
        }
    }

    /// The signals of all legs, torques included.
    pub fn signals(&self, state: &State<f64, LEGS>) -> Glance<LEGS> {
        self.motion.signals(state, &self.pieces, true)
    }

    /// How the forces answer at a state.
    pub fn response(&self, state: &State<f64, LEGS>) -> Response<LegsAbreast, LEGS> {
        let mut response = self.motion.response();
        self.motion.respond(state, &self.pieces, &mut response);
        response
    }

    /// The flight from a state on, all legs hanging.
    pub fn free_flight(&self, state: &State<f64, LEGS>) -> FreeFlight<LEGS> {
        self.motion.free_flight(state, &self.pieces)
    }

    /// One step of `length` seconds.
    pub fn step(&self, state: &State<f64, LEGS>, length: f64) -> Step<f64, LEGS> {
        let mut step = self.standing_at(state);
        let derivative = |state: &_, slope: &mut _| self.derivative(state, slope);
        step.take_explicit(length, derivative, derivative);
        step
    }

    /// One implicit step of `length` seconds.
    pub fn implicit_step(&self, state: &State<f64, LEGS>, length: f64) -> Step<f64, LEGS> {
        self.implicit_step_and_middle(state, length).0
    }

    /// One implicit step of `length` seconds, and the state at which it evaluates its middle.
    pub fn implicit_step_and_middle(
        &self,
        state: &State<f64, LEGS>,
        length: f64,
    ) -> (Step<f64, LEGS>, State<f64, LEGS>) {
        let mut step = self.standing_at(state);
        let mut midway = *state;
        let response = self.response(state);
        let derivative = |state: &_, slope: &mut _| self.derivative(state, slope);
        let middle = |state: &State<f64, LEGS>, slope: &mut _| {
            midway = *state;
            derivative(state, slope);
        };
        let system = response.over(GAMMA * length);
        let mut stages = [State::zero(); 6];
        step.take_implicit(length, &system, &mut stages, derivative, middle, derivative);
        (step, midway)
    }

    fn standing_at(&self, state: &State<f64, LEGS>) -> Step<f64, LEGS> {
        let mut slope = State::zero();
        self.derivative(state, &mut slope);
        Step::from(*state, slope)
    }

    /// `count` implicit steps through `time` seconds.
    pub fn march_implicit(
        &self,
        state: &State<f64, LEGS>,
        time: f64,
        count: u32,
    ) -> State<f64, LEGS> {
        let length = time / f64::from(count);
        (0..count).fold(*state, |state, _| self.implicit_step(&state, length).after)
    }

    /// `count` steps through `time` seconds.
    pub fn march(&self, state: &State<f64, LEGS>, time: f64, count: u32) -> State<f64, LEGS> {
        let length = time / f64::from(count);
        (0..count).fold(*state, |state, _| self.step(&state, length).after)
    }
}

/// Greatest difference of what moves in two states, relative above 1 and absolute below.
pub fn distance<const LEGS: usize>(one: &State<f64, LEGS>, other: &State<f64, LEGS>) -> f64 {
    one.advanced([-1.0], [other]).error_norm(one, other, 1.0)
}
