//! A landing by one of these methods, judged at the starts of intervals only.

use crate::contact;
use crate::energy::{kinetic, released};
use crate::landing::final_rates;
use crate::motion::{Pieces, Signal};
use crate::outcome::{Failure, Outcome};
use crate::per_leg::PerLeg;
use crate::record::{Energies, EnergiesAt, Instant, Landing, LegWork};
use crate::rules::Rules;
use crate::scene::{Scene, Settings};
use crate::stability::StabilityMonitor;
use crate::state::State;
use crate::touchdown::touchdown;
use crate::vehicle::Vehicle;

use super::force_model::{ForceModel, Look, Sets};
use super::{Evaluator, Start, Stepper};

/// Intervals before a landing is given up.
const MOST_INTERVALS: u64 = 4_000_000;
/// Time left at which the time limit counts as reached, s.
const END_OF_TIME: f64 = 1e-9;

/// A landing under way.
pub(super) struct Flight<'a> {
    settings: &'a Settings,
    model: &'a ForceModel,
    /// A monitor that has observed nothing yet, and the one that follows the landing.
    fresh: StabilityMonitor,
    monitor: StabilityMonitor,
    time: f64,
    first: State<f64>,
    interval: f64,
    reported: u64,
    last_report: f64,
    observe: &'a mut dyn FnMut(&Instant),
}

/// The extremes of a landing.
struct Extremes {
    angle: (f64, f64),
    clearance: f64,
    strut_force: PerLeg<f64>,
    stroke: PerLeg<f64>,
    pad_contact: PerLeg<Option<f64>>,
    block_contact: PerLeg<Option<f64>>,
}

impl<'a> Flight<'a> {
    pub(super) fn new(
        vehicle: &'a Vehicle,
        scene: &'a Scene,
        settings: &'a Settings,
        model: &'a ForceModel,
        interval: f64,
        observe: &'a mut dyn FnMut(&Instant),
    ) -> Self {
        // These methods judge as the program of 1966 did.
        let fresh = StabilityMonitor::new(Rules::REPORT, vehicle, scene);
        Self {
            settings,
            model,
            monitor: fresh.clone(),
            fresh,
            time: 0.0,
            first: touchdown(vehicle, scene, model.motion()),
            interval,
            reported: 0,
            last_report: f64::NEG_INFINITY,
            observe,
        }
    }

    pub(super) fn run(mut self, stepper: &mut impl Stepper<ForceModel>) -> Landing {
        let mut evaluator = Evaluator {
            system: self.model,
            memory: PerLeg::same(self.first.leg_count(), contact::Sets::default()),
            evaluations: 0,
        };
        let mut state = self.first;
        let mut extremes = Extremes::new(state.leg_count());
        let mut before: Option<(Start<State<f64>>, f64)> = None;
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
        let pads = self.model.pad_depths(&evaluator.memory);
        Landing {
            beyond: None,
            outcome,
            end_time: self.time,
            min_stability_angle: least.0.max(0.0),
            min_stability_time: least.1,
            min_clearance: extremes.clearance,
            tilt: state.body().tilt(),
            max_strut_force: extremes.strut_force,
            max_stroke: extremes.stroke,
            max_stroke_share: PerLeg::from_fn(state.leg_count(), |j| {
                extremes.stroke[j] / self.model.bottoming_stroke(j)
            }),
            max_stroke_table_share: PerLeg::from_fn(state.leg_count(), |j| {
                extremes.stroke[j] / self.model.table_end(j)
            }),
            max_pad_crush: pads.map(|pad| pad.crush),
            max_pad_crush_share: pads.map(|pad| pad.crush / pad.height),
            max_sinkage: pads.map(|pad| pad.sinkage),
            final_rates: final_rates(
                self.fresh,
                self.model.motion(),
                self.time,
                &state,
                &Pieces::new(&self.model.look(&state, &mut evaluator.memory).pieces),
            ),
            pad_contact: extremes.pad_contact,
            block_contact: extremes.block_contact,
            energies: Energies {
                initial_kinetic: kinetic(self.model.motion(), &self.first),
                potential_change: released(self.model.motion(), &self.first, &state),
                thrust: 0.0,
                legs: PerLeg::from_fn(state.leg_count(), |j| {
                    LegWork::from_state(state.leg(j).work)
                }),
                final_kinetic: kinetic(self.model.motion(), &state),
            },
            steps: intervals,
            evaluations: evaluator.evaluations,
            events: 0,
        }
    }

    /// Judges the start of an interval.
    fn end(
        &mut self,
        start: &Start<State<f64>>,
        look: &Look,
        extremes: &mut Extremes,
    ) -> Option<Outcome> {
        extremes.note_legs(self.time, look);
        let motion = self.model.motion();
        let seen = match self.monitor.choose_plane(motion, &start.state) {
            Ok(seen) => seen,
            Err(verdict) => {
                let seen = self.monitor.observe(motion, &start.state);
                extremes.clearance = extremes.clearance.min(seen.clearance);
                // With all feet on one side from the first instant, no angle is defined.
                extremes.angle.0 = extremes.angle.0.min(std::f64::consts::PI);
                return Some(verdict.into());
            }
        };
        extremes.clearance = extremes.clearance.min(seen.clearance);
        if seen.angle < extremes.angle.0 {
            extremes.angle = (seen.angle, self.time);
        }
        if let Some(verdict) = self.monitor.verdict(&seen, extremes.angle.0) {
            return Some(verdict.into());
        }
        self.model.end(look)
    }

    /// Reports the instants due within an interval, by Hermite's cubic between its ends.
    fn report(
        &mut self,
        from: &Start<State<f64>>,
        to: &Start<State<f64>>,
        length: f64,
        sets: Sets,
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

    fn report_end(&mut self, state: &State<f64>, sets: Sets) {
        if self.interval.is_finite() && self.time > self.last_report {
            self.report_instant(self.time, state, sets);
        }
    }

    fn report_instant(&mut self, time: f64, state: &State<f64>, mut sets: Sets) {
        let mut monitor = self.fresh.clone();
        let motion = self.model.motion();
        let seen = monitor
            .choose_plane(motion, state)
            .unwrap_or_else(|_| monitor.observe(motion, state));
        let kept = sets;
        let look = self.model.look(state, &mut sets);
        let loads = self.model.loads(state, &look);
        let energies = EnergiesAt {
            kinetic: kinetic(self.model.motion(), state),
            potential_change: released(self.model.motion(), &self.first, state),
            thrust_work: None,
        };
        let feet = self.model.feet(state, &kept);
        let instant = Instant::new(time, state, &seen, energies, &look.signals, &loads, feet);
        (self.observe)(&instant);
        self.last_report = time;
    }
}

impl Extremes {
    fn new(legs: usize) -> Self {
        Self {
            angle: (f64::INFINITY, 0.0),
            clearance: f64::INFINITY,
            strut_force: PerLeg::same(legs, 0.0),
            stroke: PerLeg::same(legs, 0.0),
            pad_contact: PerLeg::same(legs, None),
            block_contact: PerLeg::same(legs, None),
        }
    }

    fn note_legs(&mut self, time: f64, look: &Look) {
        for (j, choice) in look.choices.iter().enumerate() {
            let force = look.signals.of(j, Signal::StrutForce).abs();
            self.strut_force[j] = self.strut_force[j].max(force);
            let stroke = look.signals.of(j, Signal::Stroke);
            self.stroke[j] = self.stroke[j].max(stroke);
            if choice.pad_in_contact {
                self.pad_contact[j].get_or_insert(time);
            }
            if choice.block_in_contact {
                self.block_contact[j].get_or_insert(time);
            }
        }
    }
}
