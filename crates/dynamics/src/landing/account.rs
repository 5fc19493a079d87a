//! The account of a landing: instants of its history, energies, result, rates at its end.

use super::trajectory::Trajectory;
use crate::energy::{kinetic, released};
use crate::motion::{Motion, Pieces, Signal};
use crate::outcome::Outcome;
use crate::per_leg::PerLeg;
use crate::record::{Energies, EnergiesAt, FinalRates, Foot, Instant, Landing, LegWork};
use crate::stability::StabilityMonitor;
use crate::state::State;

/// Time between the states that are differenced, s: long enough for second differences.
const SPAN: f64 = 1e-5;

impl Trajectory<'_> {
    /// Reports the instants that are due up to fraction `reach` of the step.
    pub(super) fn report(&mut self, reach: f64) {
        while let Some(history) = &self.history
            && history.next() <= self.time_at(reach)
        {
            let time = history.next();
            let theta = ((time - self.time) / self.step.length).clamp(0.0, 1.0);
            let thrust_work = self.thrust_work_at(theta);
            let instant = self.instant(&self.state_at(theta), time, thrust_work);
            if let Some(history) = &mut self.history {
                history.report(&instant);
            }
        }
    }

    /// Reports the end of the landing.
    pub(super) fn report_end(&mut self) {
        let is_due = (self.history.as_ref()).is_some_and(|history| self.time > history.last);
        if is_due {
            let instant = self.instant(&self.step.before, self.time, self.thrust_work);
            if let Some(history) = &mut self.history {
                history.report(&instant);
            }
        }
    }

    fn instant(&self, state: &State<f64>, time: f64, thrust_work: f64) -> Instant {
        let mut monitor = self.monitor.clone();
        let seen = monitor
            .choose_plane(&self.motion, state)
            .unwrap_or_else(|_| monitor.observe(&self.motion, state));
        let signals = self.motion.signals(state, &self.pieces, false);
        let loads = self.motion.loads(state, &self.pieces);
        let feet = PerLeg::from_fn(self.leg_count(), |j| {
            let (mode, laws) = (&self.modes[j], &self.laws[j]);
            let pad_angle = mode.pad_angle(laws, state.leg(j).pad_turn);
            Foot::new(laws, pad_angle, &mode.sets(laws, signals.leg(j)))
        });
        let has_thrust = !self.scene.conditions().thrust.is_none();
        let energies = EnergiesAt {
            kinetic: kinetic(&self.motion, state),
            potential_change: released(&self.motion, &self.start, state),
            thrust_work: has_thrust.then_some(thrust_work),
        };
        Instant::new(time, state, &seen, energies, &signals, &loads, feet)
    }

    pub(super) fn result(&self, outcome: Outcome) -> Landing {
        let signals = (self.motion).signals(&self.step.before, &self.pieces, false);
        let pads = PerLeg::from_fn(self.leg_count(), |j| {
            self.modes[j].pad_depths(&self.laws[j], signals.leg(j))
        });
        Landing {
            outcome,
            end_time: self.time,
            beyond: None,
            // A CG beyond its critical feet has no stability left, however far beyond.
            min_stability_angle: self.least_angle.0.max(0.0),
            min_stability_time: self.least_angle.1,
            min_clearance: self.least_clearance,
            tilt: self.step.before.body().tilt(),
            energies: Energies {
                initial_kinetic: kinetic(&self.motion, &self.start),
                potential_change: released(&self.motion, &self.start, &self.step.before),
                thrust: self.thrust_work,
                legs: PerLeg::from_fn(self.leg_count(), |j| {
                    LegWork::from_state(self.step.before.leg(j).work)
                }),
                final_kinetic: kinetic(&self.motion, &self.step.before),
            },
            max_strut_force: (self.hidden_forces).greatest(&self.motion, &self.peaks.force),
            max_stroke: self.peaks.stroke,
            max_stroke_share: PerLeg::from_fn(self.leg_count(), |j| {
                self.peaks.stroke[j] / self.laws[j].bottoming_stroke()
            }),
            max_stroke_table_share: PerLeg::from_fn(self.leg_count(), |j| {
                self.peaks.stroke[j] / self.laws[j].table_end()
            }),
            max_pad_crush: pads.map(|pad| pad.crush),
            max_pad_crush_share: pads.map(|pad| pad.crush / pad.height),
            max_sinkage: pads.map(|pad| pad.sinkage),
            final_rates: final_rates(
                self.monitor.clone(),
                &self.motion,
                self.time,
                &self.step.before,
                &self.pieces,
            ),
            pad_contact: self.pad_contact,
            block_contact: self.block_contact,
            steps: self.steps,
            evaluations: self.evaluations,
            events: self.events,
        }
    }
}

/// Rates of σ and of the strokes at a time (s) and a state, by central differences along the motion under the present
/// accelerations. σ is measured over the critical feet that the monitor chooses at the state. A search estimates from the
/// rates at the end of a landing how far beyond toppling or bottoming it would have gone.
pub(crate) fn final_rates(
    mut monitor: StabilityMonitor,
    motion: &Motion<f64>,
    time: f64,
    state: &State<f64>,
    pieces: &Pieces<f64>,
) -> FinalRates {
    let mut derivative = State::zero(state.leg_count());
    if motion.acts_at_face() {
        motion.derivative::<true, true>(time, state, pieces, &mut derivative);
    } else {
        motion.derivative::<true, false>(time, state, pieces, &mut derivative);
    }
    let [earlier, later] = [-SPAN, SPAN].map(|time| {
        let mut moved = state.advanced_motion([time], [&derivative]);
        for j in 0..state.leg_count() {
            let mut leg = moved.leg(j);
            leg.link_angle += 0.5 * time * time * derivative.leg(j).link_rate;
            moved.set_leg(j, &leg);
        }
        moved
    });

    let is_defined = monitor.choose_plane(motion, state).is_ok();
    let angle = |state| monitor.observe(motion, state).angle;
    let strokes = |state| {
        let signals = motion.signals(state, pieces, false);
        PerLeg::from_fn(motion.leg_count(), |j| signals.of(j, Signal::Stroke))
    };
    let [before, now, after] = [strokes(&earlier), strokes(state), strokes(&later)];
    FinalRates {
        stability_angle: is_defined.then(|| (angle(&later) - angle(&earlier)) / (2.0 * SPAN)),
        strokes: PerLeg::from_fn(motion.leg_count(), |j| {
            (after[j] - before[j]) / (2.0 * SPAN)
        }),
        stroke_accelerations: PerLeg::from_fn(motion.leg_count(), |j| {
            (after[j] - 2.0 * now[j] + before[j]) / (SPAN * SPAN)
        }),
    }
}
