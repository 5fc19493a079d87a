//! The equations of motion for methods that locate no events: every evaluation chooses the active piece of each law
//! from the state.
//!
//! This is the only place where these methods touch laws and motion.

use crate::contact::{self, Choice, LegLaws, LegMode, PadDepths};
use crate::motion::{LegLoads, LegPieces, Motion, Pieces, Signal, Signals};
use crate::outcome::Outcome;
use crate::per_leg::PerLeg;
use crate::record::Foot;
use crate::scene::{Scene, Settings};
use crate::state::State;
use crate::vehicle::Vehicle;

use super::System;
use super::variables;

/// Plastic sets of the elements of each leg.
pub type Sets = PerLeg<contact::Sets>;

/// A vehicle in a scene.
#[derive(Debug, Clone)]
pub struct ForceModel {
    motion: Motion<f64>,
    laws: Vec<LegLaws>,
    /// Pieces for evaluating signals that depend on no piece.
    untouched: Pieces<f64>,
    /// Initial pieces of each leg, to be overwritten.
    untouched_legs: PerLeg<LegPieces<f64>>,
}

/// Results of the laws at one state.
#[derive(Debug, Clone)]
pub struct Look {
    /// Derivative of the state.
    pub slope: State<f64>,
    /// Signals of the legs.
    pub signals: Signals<f64>,
    /// Coefficients of the chosen pieces.
    pub pieces: PerLeg<LegPieces<f64>>,
    /// Other choices.
    pub choices: PerLeg<Choice>,
}

impl ForceModel {
    /// The model of a vehicle in a scene under the crush rule and friction profile of `settings`.
    pub fn new(vehicle: &Vehicle, scene: &Scene, settings: &Settings) -> Self {
        let laws: Vec<LegLaws> = (vehicle.hinged_legs().iter())
            .enumerate()
            .map(|(index, leg)| {
                leg.laws()
                    .clone()
                    .on_soil(&scene.conditions().soil_under(index), leg.design())
                    .with_crush_rule(settings.rules(vehicle).crush)
                    .with_friction(scene.friction_law(settings))
            })
            .collect();
        let untouched = PerLeg::from_fn(laws.len(), |j| {
            LegMode::untouched(&laws[j]).pieces(&laws[j])
        });
        Self {
            motion: Motion::new(vehicle, scene),
            untouched: Pieces::new(&untouched),
            untouched_legs: untouched,
            laws,
        }
    }

    /// Stroke at which the strut of leg `leg` bottoms, ft.
    pub fn bottoming_stroke(&self, leg: usize) -> f64 {
        self.laws[leg].bottoming_stroke()
    }

    /// As [`LegLaws::table_end`], of leg `leg`.
    pub fn table_end(&self, leg: usize) -> f64 {
        self.laws[leg].table_end()
    }

    /// The equations of motion.
    pub fn motion(&self) -> &Motion<f64> {
        &self.motion
    }

    /// Greatest crush and sinkage of each pad with these sets.
    pub fn pad_depths(&self, sets: &Sets) -> PerLeg<PadDepths> {
        PerLeg::from_fn(self.laws.len(), |j| self.laws[j].pad_depths(&sets[j]))
    }

    /// The feet at a state with these sets.
    pub(super) fn feet(&self, state: &State<f64>, sets: &Sets) -> PerLeg<Foot> {
        PerLeg::from_fn(self.laws.len(), |j| {
            Foot::new(&self.laws[j], state.leg(j).pad_turn, &sets[j])
        })
    }

    /// Chooses the pieces at a state and evaluates. The sets grow by the laws.
    pub fn look(&self, state: &State<f64>, sets: &mut Sets) -> Look {
        let mut signals = self.motion.signals(state, &self.untouched, false);
        let mut pieces = self.untouched_legs;
        let mut choices = self.choose(&signals, sets, &mut pieces);
        let mut slope = State::zero(state.leg_count());
        let evaluate = |pieces: &[LegPieces<f64>], slope: &mut _, signals: &mut _| {
            let pieces = Pieces::new(pieces);
            self.motion
                .evaluate::<true, false>(0.0, state, &pieces, slope, signals);
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
        signals: &Signals<f64>,
        sets: &mut Sets,
        pieces: &mut PerLeg<LegPieces<f64>>,
    ) -> PerLeg<Choice> {
        PerLeg::from_fn(self.laws.len(), |j| {
            let choice = self.laws[j].choose(sets[j], signals.leg(j), &mut pieces[j]);
            sets[j] = choice.sets;
            choice
        })
    }

    /// Outcome by which the laws end the landing, if any.
    pub fn end(&self, look: &Look) -> Option<Outcome> {
        (self.laws.iter().enumerate())
            .find_map(|(j, laws)| laws.end(j, &look.pieces[j], look.signals.leg(j)))
    }

    /// Loads at a state.
    pub fn loads(&self, state: &State<f64>, look: &Look) -> PerLeg<LegLoads<f64>> {
        self.motion.loads(state, &Pieces::new(&look.pieces))
    }
}

impl System for ForceModel {
    type State = State<f64>;
    type Memory = Sets;

    fn derivative(&self, state: &Self::State, sets: &mut Sets) -> Self::State {
        let signals = self.motion.signals(state, &self.untouched, false);
        let mut pieces = self.untouched_legs;
        let kept = *sets;
        let choices = self.choose(&signals, sets, &mut pieces);
        if choices.iter().any(Choice::awaits_torque) {
            *sets = kept;
            return self.look(state, sets).slope;
        }
        let mut slope = State::zero(state.leg_count());
        self.motion
            .derivative::<true, false>(0.0, state, &Pieces::new(&pieces), &mut slope);
        slope
    }

    fn hold(&self, start: &Self::State, derivative: &mut Self::State) {
        for j in 0..start.leg_count() {
            let mut leg = derivative.leg(j);
            leg.pad_rate = start.leg(j).pad_rate;
            derivative.set_leg(j, &leg);
        }
    }

    fn difference(&self, a: &Self::State, b: &Self::State, difference: &mut Vec<f64>) {
        variables::difference(a, b, difference);
    }
}
