//! The account of a landing: energies, history, result.

use std::ops::Deref;

use super::Flight;
use super::rates::final_rates;
use crate::energy::{kinetic, released};
use crate::outcome::Outcome;
use crate::record::{Energies, Foot, Instant, Landing, LegWork};
use crate::stability::{Judge, calm_height};
use crate::state::State;
use crate::vehicle::Vehicle;

/// When to report to whom.
pub(super) struct History<O> {
    interval: f64,
    reported: u64,
    last: f64,
    observe: O,
}

impl<O> History<O> {
    pub(super) fn new(interval: f64, observe: O) -> Self {
        Self {
            interval,
            reported: 0,
            last: f64::NEG_INFINITY,
            observe,
        }
    }

    /// Next time to report at, s.
    fn next(&self) -> f64 {
        if self.reported == 0 {
            0.0
        } else {
            self.interval * self.reported as f64
        }
    }

    fn report<const LEGS: usize>(&mut self, instant: &Instant<LEGS>)
    where
        O: FnMut(&Instant<LEGS>),
    {
        (self.observe)(instant);
        self.last = instant.time;
        self.reported += 1;
    }
}

impl<V, O, const LEGS: usize> Flight<V, O, LEGS>
where
    V: Deref<Target = Vehicle<LEGS>>,
    O: FnMut(&Instant<LEGS>),
{
    /// Reports the instants that are due up to fraction `reach` of the step.
    pub(super) fn report(&mut self, reach: f64) {
        while self.history.interval.is_finite() && self.history.next() <= self.time_at(reach) {
            let time = self.history.next();
            let theta = ((time - self.time) / self.step.length).clamp(0.0, 1.0);
            let instant = self.instant(&self.state_at(theta), time);
            self.history.report(&instant);
        }
    }

    /// Reports the end of the landing.
    pub(super) fn report_end(&mut self) {
        if self.history.interval.is_finite() && self.time > self.history.last {
            let instant = self.instant(&self.step.before, self.time);
            self.history.report(&instant);
        }
    }

    fn instant(&self, state: &State<f64, LEGS>, time: f64) -> Instant<LEGS> {
        let mut judge = Judge::new(&self.scene, calm_height(&self.vehicle));
        let seen = judge
            .look(&self.motion, state)
            .unwrap_or_else(|_| judge.observe(&self.motion, state));
        let signals = self.motion.signals(state, &self.pieces, false);
        let loads = self.motion.loads(state, &self.pieces);
        let feet = std::array::from_fn(|j| Foot {
            pad_angle: self.modes[j].pad_angle(&self.laws[j], state.leg(j).pad_turn),
            sets: self.modes[j].sets(&self.laws[j], &signals.leg(j)),
        });
        let energies = [
            kinetic(&self.vehicle, state),
            released(&self.vehicle, &self.start, state),
        ];
        Instant::new(time, state, &seen, energies, &signals, &loads, feet)
    }

    pub(super) fn conclude(&self, outcome: Outcome) -> Landing<LEGS> {
        Landing {
            outcome,
            end_time: self.time,
            min_stability_angle: self.least_angle.0,
            min_stability_time: self.least_angle.1,
            min_clearance: self.least_clearance,
            energies: Energies {
                initial_kinetic: kinetic(&self.vehicle, &self.start),
                potential_change: released(&self.vehicle, &self.start, &self.step.before),
                legs: std::array::from_fn(|j| LegWork::from_state(self.step.before.leg(j).work)),
                final_kinetic: kinetic(&self.vehicle, &self.step.before),
            },
            max_strut_force: self.peaks.force,
            max_stroke: self.peaks.stroke,
            final_rates: final_rates(
                &self.vehicle,
                &self.scene,
                &self.motion,
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
