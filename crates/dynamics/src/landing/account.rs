//! The account of a landing: energies, history, result.

use super::Flight;
use crate::attitude::Attitude;
use crate::motion::Signal;
use crate::outcome::Outcome;
use crate::record::{Energies, Instant, Landing, LegInstant, LegWork};
use crate::stability::Judge;
use crate::state::State;

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

impl<O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'_, O, LEGS> {
    /// Kinetic energy of body and lower links, ft·lb.
    fn kinetic_energy(&self, state: &State<f64, LEGS>) -> f64 {
        let body = state.body();
        let translation = self.vehicle.mass() * body.velocity.norm_squared();
        let rotation = body.rate.dot(&(self.vehicle.inertia() * body.rate));
        let links: f64 = (0..LEGS)
            .map(|j| {
                let rate = state.leg(j).link_rate;
                self.vehicle.legs()[j].design().linkage.inertia * rate * rate
            })
            .sum();
        0.5 * (translation + rotation + links)
    }

    /// Potential energy released since first contact, ft·lb.
    fn potential_change(&self, state: &State<f64, LEGS>) -> f64 {
        let descent = state.body().position.z - self.start.body().position.z;
        self.vehicle.mass() * self.vehicle.gravity() * descent
    }

    /// Reports the instants that are due up to fraction `reach` of the step.
    pub(super) fn report(&mut self, reach: f64) {
        while self.history.interval.is_finite() && self.history.next() <= self.time_at(reach) {
            let time = self.history.next();
            let theta = ((time - self.time) / self.step.length).clamp(0.0, 1.0);
            let instant = self.instant(&self.step.at(theta), time);
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
        let body = state.body();
        let mut judge = Judge::new(self.scene, self.calm_height());
        let seen = judge
            .look(&self.motion, state)
            .unwrap_or_else(|_| judge.observe(&self.motion, state));
        let signals = self.motion.signals(state, &self.pieces, false);
        let loads = self.motion.loads(state, &self.pieces);
        let q = body.quaternion;
        Instant {
            time,
            position: body.position,
            velocity: body.velocity,
            attitude: Attitude::from_quaternion([q.x, q.y, q.z, q.w]),
            angular_velocity: body.rate,
            stability_angle: seen.angle,
            clearance: seen.clearance,
            kinetic_energy: self.kinetic_energy(state),
            potential_change: self.potential_change(state),
            legs: std::array::from_fn(|j| {
                let leg = state.leg(j);
                let [outer, inner, block] = self.modes[j].sets(&self.laws[j], &signals[j]);
                LegInstant {
                    link_angle: leg.link_angle,
                    link_rate: leg.link_rate,
                    pad_angle: leg.pad_angle,
                    pad_rate: leg.pad_rate,
                    stroke: signals[j][Signal::Stroke as usize],
                    strut_force: loads[j].strut,
                    pad_normal: loads[j].pad_normal,
                    pad_friction: loads[j].pad_friction,
                    block_normal: loads[j].block_normal,
                    block_friction: loads[j].block_friction,
                    pad_sets: [outer, inner],
                    block_set: block,
                    work: LegWork::from_state(leg.work),
                }
            }),
        }
    }

    pub(super) fn conclude(self, outcome: Outcome) -> Landing<LEGS> {
        Landing {
            outcome,
            end_time: self.time,
            min_stability_angle: self.least_angle.0,
            min_stability_time: self.least_angle.1,
            min_clearance: self.least_clearance,
            energies: Energies {
                initial_kinetic: self.kinetic_energy(&self.start),
                potential_change: self.potential_change(&self.step.before),
                legs: std::array::from_fn(|j| LegWork::from_state(self.step.before.leg(j).work)),
                final_kinetic: self.kinetic_energy(&self.step.before),
            },
            max_strut_force: self.greatest_strut_force,
            max_stroke: self.greatest_stroke,
            final_rates: self.final_rates(),
            pad_contact: self.pad_contact,
            block_contact: self.block_contact,
            steps: self.steps,
            evaluations: self.evaluations,
            events: self.events,
        }
    }
}
