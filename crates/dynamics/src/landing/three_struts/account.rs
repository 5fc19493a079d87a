//! The result of a landing, its energy account and its history.

use super::simulation::Simulation;
use crate::attitude::Attitude;
use crate::contact::Sinkages;
use crate::equations::three_struts::State;
use crate::integrator::step::StateVector;
use crate::landing::hull::Hull;
use crate::landing::record::{
    Energies, FinalRates, Instant, Landing, LegInstant, LegPosture, LegWork, ThreeStrutPosture,
};
use crate::landing::thrust::summed;
use crate::laws::three_struts::{STROKE_RATES, STROKES, STRUTS};
use crate::outcome::Outcome;
use crate::per_leg::PerLeg;
use crate::state::rotation;

/// Time between the states that are differenced, s.
const SPAN: f64 = 1e-5;

impl Simulation<'_> {
    /// Work of the thrust from first contact to fraction `reach` of the step, ft·lb.
    pub(super) fn thrust_work_at(&self, reach: f64) -> f64 {
        if self.thrust.is_none() {
            return self.thrust_work;
        }
        let power = summed(reach, |theta| {
            let mut state = self.step.before;
            self.step.motion_at(theta, &mut state);
            let thrust = self.thrust.at(self.time_at(theta));
            [thrust, self.motion.speed_along_thrust(&state)]
        });
        self.thrust_work + 0.5 * reach * self.step.length * power
    }

    /// Reports the instants up to fraction `reach` of the step that are due.
    pub(super) fn report(&mut self, reach: f64) {
        let until = self.time_at(reach);
        while let Some(due) = self.history.as_ref().map(|history| history.next()) {
            if due > until || due < self.time {
                return;
            }
            let theta = (due - self.time) / self.step.length;
            let mut state = self.step.before;
            self.step.at(theta, &mut state);
            let instant = self.instant(&state, due, self.thrust_work_at(theta));
            if let Some(history) = &mut self.history {
                history.report(&instant);
            }
        }
    }

    /// Reports the end of the landing, if that is not yet told.
    pub(super) fn report_last(&mut self) {
        let is_due = (self.history.as_ref()).is_some_and(|history| self.time > history.last);
        if is_due {
            let instant = self.instant(&self.step.before, self.time, self.thrust_work);
            if let Some(history) = &mut self.history {
                history.report(&instant);
            }
        }
    }

    fn instant(&self, state: &State, time: f64, thrust_work: f64) -> Instant {
        let body = state.body();
        let q = body.quaternion;
        let frame = rotation(&q);
        let seen = self.look(state);
        let signals = self.motion.signals(state, &self.pieces);
        let has_thrust = !self.scene.conditions().thrust.is_none();
        Instant {
            time,
            position: body.position,
            velocity: body.velocity,
            attitude: Attitude::from_quaternion([q.x, q.y, q.z, q.w]),
            angular_velocity: body.rate,
            stability_angle: seen.angle,
            clearance: seen.clearance,
            kinetic_energy: self.motion.kinetic(state),
            potential_change: self.motion.released(&self.start, state),
            thrust_work: has_thrust.then_some(thrust_work),
            legs: PerLeg::from_fn(self.leg_count(), |j| {
                let forces = self.motion.forces(j, &signals, &self.pieces);
                let (set, sinkage) = self.modes[j].pad_set(&self.laws[j], &signals.leg(j));
                let [_, left, right] = forces.struts;
                let foot = state.foot(j);
                LegInstant {
                    posture: LegPosture::ThreeStrut(ThreeStrutPosture {
                        foot: frame.tr_mul(&(foot.position - body.position)),
                        velocity: foot.velocity,
                        secondary_strokes: [1, 2].map(|k| signals.of(j, STROKES.start + k)),
                        secondary_forces: [left, right],
                    }),
                    stroke: signals.of(j, STROKES.start),
                    strut_force: forces.struts[0],
                    pad_normal: forces.normal,
                    pad_friction: forces.friction,
                    block_normal: 0.0,
                    block_friction: 0.0,
                    pad_sets: [set; 2],
                    block_set: 0.0,
                    sinkages: sinkage.map(|sinkage| Sinkages {
                        pad: [sinkage; 2],
                        block: 0.0,
                    }),
                    work: work(state, j),
                }
            }),
        }
    }

    /// The result of the landing with this outcome.
    pub(super) fn account(&self, outcome: Outcome) -> Landing {
        let state = &self.step.before;
        let legs = self.leg_count();
        let signals = &self.signals[0];
        let pads = PerLeg::from_fn(legs, |j| {
            self.modes[j].pad_depths(&self.laws[j], &signals.leg(j))
        });
        Landing {
            outcome,
            end_time: self.time,
            beyond: None,
            min_stability_angle: self.extremes.angle.0.max(0.0),
            min_stability_time: self.extremes.angle.1,
            min_clearance: self.extremes.clearance,
            tilt: state.body().tilt(),
            energies: Energies {
                initial_kinetic: self.motion.kinetic(&self.start),
                potential_change: self.motion.released(&self.start, state),
                thrust: self.thrust_work,
                legs: PerLeg::from_fn(legs, |j| work(state, j)),
                final_kinetic: self.motion.kinetic(state),
            },
            max_strut_force: PerLeg::from_fn(legs, |j| self.extremes.force(j)),
            max_stroke: PerLeg::from_fn(legs, |j| self.extremes.strokes(j, 0)[0]),
            max_stroke_share: PerLeg::from_fn(legs, |j| {
                (0..STRUTS).fold(0.0, |most: f64, k| {
                    let [shorter, longer] = self.extremes.strokes(j, k);
                    let share = |stroke| self.laws[j].stroke_share(k, stroke);
                    most.max(share(shorter)).max(share(-longer))
                })
            }),
            max_stroke_table_share: PerLeg::same(legs, 0.0),
            max_pad_crush: pads.map(|[crush, ..]| crush),
            max_pad_crush_share: pads.map(|[crush, height, _]| crush / height),
            max_sinkage: pads.map(|[.., sinkage]| sinkage),
            final_rates: self.final_rates(),
            pad_contact: self.pad_contact,
            block_contact: PerLeg::same(legs, None),
            steps: self.steps,
            evaluations: self.evaluations,
            events: self.events,
        }
    }

    /// Rates of σ and of the strokes of the primary struts now.
    fn final_rates(&self) -> FinalRates {
        let (state, slope) = (&self.step.before, &self.step.slopes[0]);
        let moved = |span: f64| {
            let mut moved = *state;
            state.advance_motion([span], [slope], &mut moved);
            moved
        };
        let angle = |state: &State| Hull::of(&self.motion.feet(state)).stability_angle();
        let rates = |state: &State| {
            let signals = self.motion.signals(state, &self.pieces);
            PerLeg::from_fn(self.leg_count(), |j| signals.of(j, STROKE_RATES.start))
        };
        let [before, after] = [-SPAN, SPAN].map(|span| rates(&moved(span)));
        FinalRates {
            stability_angle: Some((angle(&moved(SPAN)) - angle(&moved(-SPAN))) / (2.0 * SPAN)),
            strokes: rates(state),
            stroke_accelerations: PerLeg::from_fn(self.leg_count(), |j| {
                (after[j] - before[j]) / (2.0 * SPAN)
            }),
        }
    }
}

/// Work done on the elements of a leg.
fn work(state: &State, leg: usize) -> LegWork {
    let [strut, pad_crush, pad_friction] = state.works(leg);
    LegWork {
        strut,
        pad_crush,
        pad_friction,
        ..LegWork::default()
    }
}
