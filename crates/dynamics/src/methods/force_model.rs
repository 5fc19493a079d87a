//! The equations of motion for methods that locate no events: at every evaluation each law's
//! active piece is chosen from the state.
//!
//! This is the only place where these methods touch laws and motion.

use crate::contact::{Choice, LegLaws, LegMode};
use crate::motion::{Glance, LegLoads, LegPieces, Motion, Pieces, Signal};
use crate::outcome::Outcome;
use crate::scene::{Scene, Settings};
use crate::state::State;
use crate::vehicle::Vehicle;

use super::system::System;
use super::variables;

/// Plastic sets of outboard section, inboard section and block of each leg, ft.
pub type Sets<const LEGS: usize> = [[f64; 3]; LEGS];

/// A vehicle in a scene.
#[derive(Debug, Clone)]
pub struct ForceModel<const LEGS: usize = 3> {
    motion: Motion<LEGS>,
    laws: [LegLaws; LEGS],
    /// Pieces for a look at signals that no piece has a say in.
    untouched: Pieces<LEGS>,
    /// A place to start from for the pieces of each leg.
    untouched_legs: [LegPieces<f64>; LEGS],
}

/// What the laws say at one state.
#[derive(Debug, Clone)]
pub struct Look<const LEGS: usize = 3> {
    /// Derivative of the state.
    pub slope: State<f64, LEGS>,
    /// Signals of the legs.
    pub signals: Glance<LEGS>,
    /// Coefficients of the pieces chosen.
    pub pieces: [LegPieces<f64>; LEGS],
    /// What else was chosen.
    pub choices: [Choice; LEGS],
}

impl<const LEGS: usize> ForceModel<LEGS> {
    /// The model of a vehicle in a scene under the crush rule and friction profile of `settings`.
    pub fn new(vehicle: &Vehicle<LEGS>, scene: &Scene, settings: &Settings) -> Self {
        let laws: [LegLaws; LEGS] = std::array::from_fn(|j| {
            LegLaws::new(&vehicle.legs()[j], settings.crush_rule())
                .with_friction(settings.friction_profile())
        });
        let untouched = std::array::from_fn(|j| LegMode::untouched(&laws[j]).pieces(&laws[j]));
        Self {
            motion: Motion::new(vehicle, scene),
            untouched: Pieces::new(&untouched),
            untouched_legs: untouched,
            laws,
        }
    }

    /// The equations of motion.
    pub fn motion(&self) -> &Motion<LEGS> {
        &self.motion
    }

    /// Chooses the pieces at a state and evaluates; the sets grow as the laws say.
    pub fn look(&self, state: &State<f64, LEGS>, sets: &mut Sets<LEGS>) -> Look<LEGS> {
        let mut signals = self.motion.signals(state, &self.untouched, false);
        let mut pieces = self.untouched_legs;
        let mut choices = self.choose(&signals, sets, &mut pieces);
        let mut slope = State::zero();
        let evaluate = |pieces: &_, slope: &mut _, signals: &mut _| {
            let pieces = Pieces::new(pieces);
            self.motion.evaluate(state, &pieces, slope, signals);
        };
        evaluate(&pieces, &mut slope, &mut signals);
        let mut pushed = false;
        for (j, choice) in choices.iter_mut().enumerate() {
            if choice.awaits_torque() && signals.of(j, Signal::LinkTorque) < 0.0 {
                choice.push(&self.laws[j], &mut pieces[j]);
                pushed = true;
            }
        }
        if pushed {
            evaluate(&pieces, &mut slope, &mut signals);
        }
        Look {
            slope,
            signals,
            pieces,
            choices,
        }
    }

    fn choose(
        &self,
        signals: &Glance<LEGS>,
        sets: &mut Sets<LEGS>,
        pieces: &mut [LegPieces<f64>; LEGS],
    ) -> [Choice; LEGS] {
        std::array::from_fn(|j| {
            let choice = self.laws[j].choose(sets[j], &signals.leg(j), &mut pieces[j]);
            sets[j] = choice.sets;
            choice
        })
    }

    /// How the laws end the landing, if they do.
    pub fn end(&self, look: &Look<LEGS>) -> Option<Outcome> {
        (0..LEGS).find_map(|j| self.laws[j].end(j, &look.pieces[j], &look.signals.leg(j)))
    }

    /// Loads at a state.
    pub fn loads(&self, state: &State<f64, LEGS>, look: &Look<LEGS>) -> [LegLoads<f64>; LEGS] {
        self.motion.loads(state, &Pieces::new(&look.pieces))
    }
}

impl<const LEGS: usize> System for ForceModel<LEGS> {
    type State = State<f64, LEGS>;
    type Memory = Sets<LEGS>;

    fn derivative(&self, state: &Self::State, sets: &mut Sets<LEGS>) -> Self::State {
        let signals = self.motion.signals(state, &self.untouched, false);
        let mut pieces = self.untouched_legs;
        let kept = *sets;
        let choices = self.choose(&signals, sets, &mut pieces);
        if choices.iter().any(Choice::awaits_torque) {
            *sets = kept;
            return self.look(state, sets).slope;
        }
        let mut slope = State::zero();
        self.motion
            .derivative(state, &Pieces::new(&pieces), &mut slope);
        slope
    }

    fn hold(&self, start: &Self::State, derivative: &mut Self::State) {
        for j in 0..LEGS {
            let mut leg = derivative.leg(j);
            leg.pad_rate = start.leg(j).pad_rate;
            derivative.set_leg(j, &leg);
        }
    }

    fn difference(&self, a: &Self::State, b: &Self::State, difference: &mut Vec<f64>) {
        variables::difference(a, b, difference);
    }
}
