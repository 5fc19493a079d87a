//! A landing followed from step to step until its outcome.

use arrayvec::ArrayVec;

use super::extremes::{Extremes, Seen};
use crate::equations::three_struts::{Motion, Pieces, Signals, State};
use crate::integrator::event::{Guard, Sample, first_exit};
use crate::integrator::step::Step;
use crate::integrator::step_control::{LONGEST, SHORTEST, StepControl};
use crate::landing::events::MOST_CHANGES;
use crate::landing::record::Landing;
use crate::landing::rest::Rest;
use crate::landing::simulation::{FIRST_STEP, MOST_STEPS};
use crate::landing::steadiness::Steadiness;
use crate::landing::toppling::Toppling;
use crate::landing::touchdown::body_at_touchdown;
use crate::landing::trajectory::{event_resolution, work_error};
use crate::landing::{History, UnderWay, with_verdict};
use crate::laws::three_struts::{LegLaws, LegMode, SIGNALS};
use crate::outcome::{Failure, Outcome};
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::registers::Single;
use crate::rules::RestRule;
use crate::scene::{Scene, Settings};
use crate::three_strut_leg::ThreeStrutLeg;
use crate::thrust::ThrustLine;
use crate::vehicle::Vehicle;

/// Most signals with ranges.
const MOST_SIGNALS: usize = SIGNALS * MOST_LEGS;

/// A landing under way.
pub(in crate::landing) struct Simulation<'o> {
    pub(super) registers: Single,
    pub(super) scene: Scene,
    pub(super) settings: Settings,
    pub(super) motion: Motion,
    pub(super) laws: ArrayVec<LegLaws, MOST_LEGS>,
    pub(super) modes: PerLeg<LegMode>,
    pub(super) pieces: Pieces,
    guards: ArrayVec<Guard, MOST_SIGNALS>,
    /// Time resolution of events, s.
    resolution: f64,
    /// Work error allowed per step, ft·lb.
    pub(super) work_error: f64,
    pub(super) time: f64,
    /// The start of this step is the present state and its derivative.
    pub(super) step: Step<f64, State>,
    pub(super) stages: [State; 6],
    /// Signals at the start, in the middle and at the end of the step.
    pub(super) signals: [Signals; 3],
    /// Signals at the points of the step between which an event was located.
    buffers: [Signals; 3],
    pub(super) thrust: ThrustLine<f64>,
    /// Time of the thrust's next change of line, s, and its work so far, ft·lb.
    pub(super) next_knot: f64,
    pub(super) thrust_work: f64,
    pub(super) start: State,
    control: StepControl,
    steadiness: Steadiness,
    rest: Rest,
    /// Present look at stability.
    pub(super) seen: Seen,
    pub(super) extremes: Extremes,
    toppling: Toppling,
    /// Verdict beyond which the landing goes on, and its time, s.
    pub(super) noted: Option<(Outcome, f64)>,
    pub(super) pad_contact: PerLeg<Option<f64>>,
    pub(super) steps: u64,
    attempts: u64,
    pub(super) evaluations: u64,
    pub(super) events: u64,
    pub(super) history: Option<History<'o>>,
}

impl<'o> Simulation<'o> {
    /// A landing at first contact.
    pub(in crate::landing) fn new(
        vehicle: &Vehicle,
        legs: &[ThreeStrutLeg],
        scene: &Scene,
        settings: &Settings,
        history: Option<History<'o>>,
    ) -> Self {
        let conditions = scene.conditions();
        let motion = Motion::new(vehicle, legs, scene);
        let laws: ArrayVec<LegLaws, MOST_LEGS> = (legs.iter())
            .enumerate()
            .map(|(index, leg)| {
                let soil = conditions.soil_under(index);
                LegLaws::of(leg.design(), &soil, scene.friction_law(settings))
            })
            .collect();
        let modes = PerLeg::from_fn(legs.len(), |j| LegMode::untouched(&laws[j]));
        let state = motion.at_first_contact(body_at_touchdown(conditions));
        let height = vehicle.standing_height();
        let gravity = scene.gravity(vehicle);
        let energy = motion.kinetic(&state) + motion.total_mass() * gravity * height;
        Self {
            registers: Single::fastest(),
            scene: *scene,
            settings: *settings,
            pieces: pieces_of(&modes, &laws),
            guards: ArrayVec::new(),
            resolution: event_resolution(settings),
            work_error: work_error(settings, energy),
            time: 0.0,
            step: Step::from(state, State::zero(legs.len())),
            stages: [State::zero(legs.len()); 6],
            signals: [Signals::NONE; 3],
            buffers: [Signals::NONE; 3],
            thrust: ThrustLine::none(),
            next_knot: if conditions.thrust.is_none() {
                f64::INFINITY
            } else {
                0.0
            },
            thrust_work: 0.0,
            start: state,
            control: StepControl::new(FIRST_STEP),
            steadiness: Steadiness::new(vehicle, scene, settings, RestRule::Energy),
            rest: Rest::new(vehicle, scene, settings),
            seen: Seen::NOTHING,
            extremes: Extremes::none(),
            toppling: Toppling::new(vehicle, scene),
            noted: None,
            pad_contact: PerLeg::same(legs.len(), None),
            steps: 0,
            attempts: 0,
            evaluations: 0,
            events: 0,
            history,
            motion,
            laws,
            modes,
        }
    }

    /// Number of legs.
    pub(super) fn leg_count(&self) -> usize {
        self.motion.leg_count()
    }

    /// Sets the line of the thrust from now on. Returns whether it is a new one.
    fn follow_thrust(&mut self) -> bool {
        if self.next_knot - self.time > SHORTEST {
            return false;
        }
        (self.thrust, self.next_knot) = self.scene.conditions().thrust.line_from(self.next_knot);
        true
    }

    /// Evaluates derivative and signals at the present state.
    fn evaluate(&mut self) {
        let thrust = self.thrust.at(self.time);
        let Step { before, slopes, .. } = &mut self.step;
        let [first, ..] = slopes;
        (self.motion).evaluate(thrust, before, &self.pieces, first, &mut self.signals[0]);
        self.evaluations += 1;
    }

    /// Sets the laws that hold from the present state on. One change can bring another, so this repeats until every
    /// signal lies in its range.
    fn settle(&mut self) -> Result<(), Outcome> {
        for _ in 0..MOST_CHANGES {
            self.choose_guards();
            self.evaluate();
            for (contact, mode) in self.pad_contact.iter_mut().zip(&self.modes) {
                if mode.in_contact() {
                    contact.get_or_insert(self.time);
                }
            }
            if !self.cross()? {
                return Ok(());
            }
        }
        Err(Outcome::Failure(Failure::Chattering))
    }

    fn choose_guards(&mut self) {
        self.guards.clear();
        for (leg, (mode, laws)) in self.modes.iter().zip(&self.laws).enumerate() {
            for (index, range) in mode.ranges(laws).into_iter().enumerate() {
                if !range.is_free() {
                    let signal = leg * SIGNALS + index;
                    self.guards.push(Guard { signal, range });
                }
            }
        }
    }

    /// Takes each leg past the first of its signals that is out of range. Returns whether any was.
    fn cross(&mut self) -> Result<bool, Outcome> {
        let mut crossed = false;
        let mut last = None;
        for guard in &self.guards {
            let leg = guard.signal / SIGNALS;
            let signals = &self.signals[0].leg(leg);
            let index = guard.signal % SIGNALS;
            // The ranges of a leg's other signals change with it.
            let Some(exit) = guard
                .range
                .exit(signals[index])
                .filter(|_| last != Some(leg))
            else {
                continue;
            };
            (last, crossed) = (Some(leg), true);
            self.events += 1;
            self.modes[leg].cross(&self.laws[leg], leg, index, exit, signals)?;
        }
        if crossed {
            self.pieces = pieces_of(&self.modes, &self.laws);
        }
        Ok(crossed)
    }

    /// Finds the first fraction of the step at which a law changes its active piece, and the one of the `buffers` with the
    /// signals there.
    fn find_event(&mut self) -> Option<(f64, usize)> {
        let Self {
            motion,
            pieces,
            step,
            stages: [state, ..],
            signals: [start, middle, end],
            ..
        } = self;
        let sample = |theta, signals| Sample { theta, signals };
        let mut looks = 0;
        let found = first_exit(
            [
                sample(0.0, &*start),
                sample(0.5, &*middle),
                sample(1.0, &*end),
            ],
            &self.guards,
            self.resolution / step.length,
            &mut self.buffers,
            |theta, signals| {
                looks += 1;
                step.motion_at(theta, state);
                *signals = motion.signals(state, pieces);
            },
        );
        self.evaluations += looks;
        found
    }

    /// Notes the first verdict of a landing that goes on beyond it.
    ///
    /// # Errors
    /// The verdict, if it ends the landing.
    fn conclude(&mut self, verdict: Outcome) -> Result<(), Outcome> {
        if !self.settings.goes_on() {
            return Err(verdict);
        }
        self.noted.get_or_insert((verdict, self.time));
        Ok(())
    }

    /// Time at fraction θ of the step, s.
    pub(super) fn time_at(&self, theta: f64) -> f64 {
        self.time + theta * self.step.length
    }

    /// Goes on to the end of the step, or to an event within it.
    fn finish_step(&mut self) -> Result<(), Outcome> {
        if !self.step.after.is_finite() {
            return Err(Outcome::Failure(Failure::NonFinite));
        }
        self.steps += 1;
        let event = self.find_event();
        let reach = event.map_or(1.0, |(theta, _)| theta);
        let at_end = match event {
            Some((_, buffer)) => self.buffers[buffer],
            None => self.signals[2],
        };
        self.seen = self.note_extremes(reach, &at_end);
        self.report(reach);
        self.thrust_work = self.thrust_work_at(reach);
        let time = self.time_at(reach);
        let has_toppled = self.note_beyond(time - self.time);
        self.signals[0] = at_end;
        if event.is_some() {
            let mut state = self.step.before;
            self.step.at(reach, &mut state);
            (self.step.before, self.time) = (state, time);
            self.control.restart();
            self.cross()?;
            self.settle()?;
        } else {
            self.time = time;
            self.step.before = self.step.after;
            self.step.slopes[0] = self.step.slopes[5];
        }
        self.judge(has_toppled)
    }

    /// Notes whether the CG is beyond the hull of the feet, a time (s) after that was last noted. Returns whether the vehicle has
    /// toppled.
    fn note_beyond(&mut self, passed: f64) -> bool {
        let Seen { angle, clearance } = self.seen;
        let body = || self.step.after.body();
        (self.toppling).note(angle <= 0.0, passed, clearance, body, || {
            self.modes.iter().any(LegMode::is_pressed)
        })
    }

    /// Judges the present state.
    fn judge(&mut self, has_toppled: bool) -> Result<(), Outcome> {
        if self.noted.is_some() {
            return Ok(());
        }
        if has_toppled {
            return self.conclude(Outcome::UnstableToppled);
        }
        let angle = self.seen.angle;
        self.steadiness.note(self.time, angle);
        let mut rest = self.rest.clone();
        let at_rest = rest.note(self);
        self.rest = rest;
        if at_rest {
            return self.conclude(Outcome::StableSubsided);
        }
        if !self.thrust.is_none() {
            return Ok(());
        }
        let ends_early = self.settings.ends_early();
        let body = self.step.before.body();
        match self.steadiness.end(self.time, &body, ends_early) {
            Some(outcome) => self.conclude(outcome),
            None => Ok(()),
        }
    }
}

impl UnderWay for Simulation<'_> {
    fn begin(&mut self) -> Result<(), Outcome> {
        self.follow_thrust();
        self.settle()?;
        self.seen = self.look(&self.step.before);
        self.extremes.note_angle(self.seen, 0.0);
        self.note_beyond(0.0);
        self.judge(false)
    }

    fn step(&mut self) -> Result<(), Outcome> {
        if self.follow_thrust() {
            self.evaluate();
        }
        let left = self.settings.time_limit() - self.time;
        if self.attempts == MOST_STEPS {
            return Err(Outcome::Failure(Failure::StepLimit));
        }
        if left < SHORTEST {
            return Err(Outcome::TimeExpired);
        }
        self.attempts += 1;
        let whole = self.control.proposed().min(LONGEST);
        let length = whole.min(left).min(self.next_knot - self.time);
        if length < SHORTEST {
            return Err(Outcome::Failure(Failure::StepCollapse));
        }
        let error = self.attempt(length);
        let order = self.step.weights.error_order;
        if !self.control.accept(length, error, order) {
            return Ok(());
        }
        if length < whole {
            self.control.keep(whole);
        }
        self.finish_step()
    }

    fn stands_on_all_feet(&self) -> bool {
        self.pad_contact.iter().all(Option::is_some)
    }

    fn report_end(&mut self) {
        self.report_last();
    }

    fn result(&self, outcome: Outcome) -> Landing {
        let outcome = self.rest.ended(outcome, self);
        let topples = self.toppling.is_beyond().then_some(self.time);
        with_verdict(
            self.noted.clone(),
            topples,
            outcome,
            &self.settings,
            |outcome| self.account(outcome),
        )
    }
}

/// The active pieces in these modes.
fn pieces_of(modes: &PerLeg<LegMode>, laws: &[LegLaws]) -> Pieces {
    Pieces::new(PerLeg::from_fn(modes.len(), |j| modes[j].pieces(&laws[j])))
}
