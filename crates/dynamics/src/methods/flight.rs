//! A landing by one of these methods: outcomes are looked for at the starts of intervals only.

use crate::energy::{kinetic, released};
use crate::landing::final_rates;
use crate::motion::{Pieces, Signal};
use crate::outcome::{Failure, Outcome};
use crate::record::{Energies, Foot, Instant, Landing, LegWork};
use crate::scene::{Scene, Settings};
use crate::stability::{Judge, calm_height};
use crate::state::State;
use crate::touchdown::touchdown;
use crate::vehicle::Vehicle;

use super::force_model::{ForceModel, Look};
use super::system::{Evaluator, Start, Stepper};

/// Intervals before a landing is given up.
const MOST_INTERVALS: u64 = 4_000_000;
/// What is left of the time limit when it counts as reached, s.
const END_OF_TIME: f64 = 1e-9;

/// A landing under way.
pub(super) struct Flight<'a, O, const LEGS: usize> {
    vehicle: &'a Vehicle<LEGS>,
    scene: &'a Scene,
    settings: &'a Settings,
    model: &'a ForceModel<LEGS>,
    judge: Judge<LEGS>,
    time: f64,
    first: State<f64, LEGS>,
    interval: f64,
    reported: u64,
    last_report: f64,
    observe: O,
}

/// The extremes of a landing.
struct Extremes<const LEGS: usize> {
    angle: (f64, f64),
    clearance: f64,
    strut_force: [f64; LEGS],
    stroke: [f64; LEGS],
    pad_contact: [Option<f64>; LEGS],
    block_contact: [Option<f64>; LEGS],
}

impl<'a, O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'a, O, LEGS> {
    pub(super) fn new(
        vehicle: &'a Vehicle<LEGS>,
        scene: &'a Scene,
        settings: &'a Settings,
        model: &'a ForceModel<LEGS>,
        interval: f64,
        observe: O,
    ) -> Self {
        Self {
            vehicle,
            scene,
            settings,
            model,
            judge: Judge::new(scene, calm_height(vehicle)),
            time: 0.0,
            first: touchdown(vehicle, scene, model.motion()),
            interval,
            reported: 0,
            last_report: f64::NEG_INFINITY,
            observe,
        }
    }

    pub(super) fn run(mut self, stepper: &mut impl Stepper<ForceModel<LEGS>>) -> Landing<LEGS> {
        let mut evaluator = Evaluator {
            system: self.model,
            memory: [[0.0; 3]; LEGS],
            evaluations: 0,
        };
        let mut state = self.first;
        let mut extremes = Extremes::new();
        let mut before: Option<(Start<State<f64, LEGS>>, f64)> = None;
        let mut intervals = 0;
        let outcome = loop {
            evaluator.evaluations += 1;
            let look = self.model.look(&state, &mut evaluator.memory);
            let start = Start {
                state,
                slope: look.slope,
            };
            if let Some((from, length)) = &before {
                self.report(from, &start, *length, evaluator.memory);
            }
            if let Some(outcome) = self.end(&start, &look, &mut extremes) {
                self.report_end(&state, evaluator.memory);
                break outcome;
            }
            let left = self.settings.time_limit() - self.time;
            if left < END_OF_TIME {
                self.report_end(&state, evaluator.memory);
                break Outcome::TimeExpired;
            }
            if intervals == MOST_INTERVALS {
                break Outcome::Failure(Failure::StepLimit);
            }
            let taken = stepper.advance(&start, left, &mut evaluator);
            intervals += 1;
            if !taken.state.is_finite() {
                break Outcome::Failure(Failure::NonFinite);
            }
            self.time += taken.length;
            state = taken.state;
            before = Some((start, taken.length));
        };
        let least = extremes.angle;
        Landing {
            outcome,
            end_time: self.time,
            min_stability_angle: least.0.max(0.0),
            min_stability_time: least.1,
            min_clearance: extremes.clearance,
            max_strut_force: extremes.strut_force,
            max_stroke: extremes.stroke,
            final_rates: final_rates(
                self.vehicle,
                self.scene,
                self.model.motion(),
                &state,
                &Pieces::new(&self.model.look(&state, &mut evaluator.memory).pieces),
            ),
            pad_contact: extremes.pad_contact,
            block_contact: extremes.block_contact,
            energies: Energies {
                initial_kinetic: kinetic(self.vehicle, &self.first),
                potential_change: released(self.vehicle, &self.first, &state),
                legs: std::array::from_fn(|j| LegWork::from_state(state.leg(j).work)),
                final_kinetic: kinetic(self.vehicle, &state),
            },
            steps: intervals,
            evaluations: evaluator.evaluations,
            events: 0,
        }
    }

    /// Judges the start of an interval.
    fn end(
        &mut self,
        start: &Start<State<f64, LEGS>>,
        look: &Look<LEGS>,
        extremes: &mut Extremes<LEGS>,
    ) -> Option<Outcome> {
        extremes.note_legs(self.time, look);
        let motion = self.model.motion();
        let seen = match self.judge.look(motion, &start.state) {
            Ok(seen) => seen,
            Err(verdict) => {
                let seen = self.judge.observe(motion, &start.state);
                extremes.clearance = extremes.clearance.min(seen.clearance);
                // With all feet on one side from the first instant no angle is defined.
                extremes.angle.0 = extremes.angle.0.min(std::f64::consts::PI);
                return Some(verdict.into());
            }
        };
        extremes.clearance = extremes.clearance.min(seen.clearance);
        if seen.angle < extremes.angle.0 {
            extremes.angle = (seen.angle, self.time);
        }
        match self.judge.verdict(&seen, extremes.angle.0) {
            Some(verdict) => Some(verdict.into()),
            None => self.model.end(look),
        }
    }

    /// Reports the instants that are due within an interval, by Hermite's cubic between its ends.
    fn report(
        &mut self,
        from: &Start<State<f64, LEGS>>,
        to: &Start<State<f64, LEGS>>,
        length: f64,
        sets: [[f64; 3]; LEGS],
    ) {
        while self.interval.is_finite() {
            let due = self.interval * self.reported as f64;
            if due > self.time {
                return;
            }
            let t = (1.0 - (self.time - due) / length).clamp(0.0, 1.0);
            let rise = t * t * (3.0 - 2.0 * t);
            let state = from.state.advanced(
                [
                    rise,
                    -rise,
                    length * t * (1.0 - t) * (1.0 - t),
                    length * t * t * (t - 1.0),
                ],
                [&to.state, &from.state, &from.slope, &to.slope],
            );
            self.report_instant(due, &state, sets);
            self.reported += 1;
        }
    }

    fn report_end(&mut self, state: &State<f64, LEGS>, sets: [[f64; 3]; LEGS]) {
        if self.interval.is_finite() && self.time > self.last_report {
            self.report_instant(self.time, state, sets);
        }
    }

    fn report_instant(&mut self, time: f64, state: &State<f64, LEGS>, mut sets: [[f64; 3]; LEGS]) {
        let mut judge = Judge::new(self.scene, calm_height(self.vehicle));
        let motion = self.model.motion();
        let seen = judge
            .look(motion, state)
            .unwrap_or_else(|_| judge.observe(motion, state));
        let kept = sets;
        let look = self.model.look(state, &mut sets);
        let loads = self.model.loads(state, &look);
        let energies = [
            kinetic(self.vehicle, state),
            released(self.vehicle, &self.first, state),
        ];
        let feet = std::array::from_fn(|j| Foot {
            pad_angle: state.leg(j).pad_turn,
            sets: kept[j],
        });
        let instant = Instant::new(time, state, &seen, energies, &look.signals, &loads, feet);
        (self.observe)(&instant);
        self.last_report = time;
    }
}

impl<const LEGS: usize> Extremes<LEGS> {
    fn new() -> Self {
        Self {
            angle: (f64::INFINITY, 0.0),
            clearance: f64::INFINITY,
            strut_force: [0.0; LEGS],
            stroke: [0.0; LEGS],
            pad_contact: [None; LEGS],
            block_contact: [None; LEGS],
        }
    }

    fn note_legs(&mut self, time: f64, look: &Look<LEGS>) {
        for j in 0..LEGS {
            let force = look.signals.of(j, Signal::StrutForce).abs();
            self.strut_force[j] = self.strut_force[j].max(force);
            let stroke = look.signals.of(j, Signal::Stroke);
            self.stroke[j] = self.stroke[j].max(stroke);
            if look.choices[j].pad_in_contact {
                self.pad_contact[j].get_or_insert(time);
            }
            if look.choices[j].block_in_contact {
                self.block_contact[j].get_or_insert(time);
            }
        }
    }
}
