//! A landing followed from step to step until its outcome.

mod step_end;

use pulp::NullaryFnOnce;

use super::History;
use super::rest::Rest;
use super::steadiness::Steadiness;
use super::step_attempt::{StepKind, TakeStep, Workspace};
use super::trajectory::Trajectory;
use super::verdict::StabilityTrack;
use super::with_verdict;
use crate::integrator::step_control::{LONGEST, SHORTEST, StepControl};
use crate::outcome::{Failure, Outcome};
use crate::record::Landing;
use crate::registers::Registers;
use crate::rules::RestRule;
use crate::scene::{Scene, Settings};
use crate::vehicle::Vehicle;

/// First step after touchdown, s.
pub(super) const FIRST_STEP: f64 = 1e-4;
/// Steps, rejected ones included, before a landing is given up.
pub(super) const MOST_STEPS: u64 = 2_000_000;
/// Greatest turn of the body in a step of free flight, rad, over the fourth root of the tolerance. The cubics through
/// the depths of its feet at both ends are then accurate to about half of the tolerance.
const TURN: f64 = 2.0;

/// Start of the next step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NextStart {
    /// At the start of the step, which was rejected.
    StepStart,
    /// At the end of the step.
    StepEnd,
    /// At an event or kink within the step, or after free flight.
    Elsewhere,
}

/// A landing under way, with its next step.
pub(crate) struct Simulation<'o> {
    pub(crate) trajectory: Trajectory<'o>,
    stability: StabilityTrack,
    steadiness: Steadiness,
    /// Rest judged by supports, under [`RestRule::Energy`].
    rest: Option<Rest>,
    control: StepControl,
    /// Steps attempted, rejected ones included.
    attempts: u64,
    /// Number of events and time (s) from which a burst is counted.
    burst: (u64, f64),
    /// Verdict beyond which the landing goes on, and its time, s.
    noted: Option<(Outcome, f64)>,
    /// Step length that error control and the laws allow, s.
    whole: f64,
    /// Step length, s.
    length: f64,
    kind: StepKind,
    /// True if the kind of the step has been tested.
    is_kind_known: bool,
}

impl<'o> Simulation<'o> {
    /// A landing at first contact.
    pub(crate) fn new(
        vehicle: &Vehicle,
        scene: &Scene,
        settings: &Settings,
        history: Option<History<'o>>,
    ) -> Self {
        let trajectory = Trajectory::new(vehicle, scene, settings, history);
        let monitor = trajectory.monitor.clone();
        let rules = settings.rules(vehicle);
        Self {
            trajectory,
            stability: StabilityTrack::new(monitor, vehicle, scene),
            steadiness: Steadiness::new(vehicle, scene, settings, rules.rest),
            rest: (rules.rest == RestRule::Energy).then(|| Rest::new(vehicle, scene, settings)),
            control: StepControl::new(FIRST_STEP),
            attempts: 0,
            burst: (0, 0.0),
            noted: None,
            whole: 0.0,
            length: 0.0,
            kind: StepKind::Explicit,
            is_kind_known: false,
        }
    }

    /// Judges the touchdown and prepares the first step.
    ///
    /// # Errors
    /// The outcome, if there already is one.
    pub(crate) fn begin(&mut self) -> Result<(), Outcome> {
        self.trajectory.follow_thrust();
        let judged = self.stability.begin(&mut self.trajectory);
        self.trajectory.settle()?;
        self.trajectory.refuse_ground_in_body()?;
        if let Err(verdict) = judged {
            self.conclude(verdict.into())?;
        }
        self.burst = (self.trajectory.events, self.trajectory.time);
        self.plan_step()?;
        Ok(())
    }

    /// Sets the line of the thrust from now on. Returns whether it is a new one.
    ///
    /// # Errors
    /// The outcome, if the vehicle is at rest now that the thrust is over.
    fn follow_thrust(&mut self) -> Result<bool, Outcome> {
        let is_other = self.trajectory.follow_thrust();
        if is_other && let Some(verdict) = self.stability.follow_thrust(&self.trajectory) {
            self.conclude(verdict.into())?;
        }
        Ok(is_other)
    }

    /// Notes the first verdict of a landing that goes on beyond it.
    ///
    /// # Errors
    /// The verdict, if it ends the landing.
    fn conclude(&mut self, verdict: Outcome) -> Result<(), Outcome> {
        if !self.trajectory.settings.goes_on() {
            return Err(verdict);
        }
        let time = self.trajectory.time;
        self.noted.get_or_insert((verdict, time));
        Ok(())
    }

    /// Kind of the next step.
    pub(crate) fn kind(&self) -> StepKind {
        self.kind
    }

    /// Start of the next step, s after first contact.
    pub(crate) fn time(&self) -> f64 {
        self.trajectory.time
    }

    /// Length of the next step, s.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Takes the next step and prepares the one after it.
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    pub(crate) fn step(&mut self, workspace: &mut Workspace<f64>) -> Result<(), Outcome> {
        if !self.is_kind_known {
            self.find_kind();
        }
        let trajectory = &mut self.trajectory;
        let registers = trajectory.registers;
        let errors = registers.dispatch(TakeStep {
            registers,
            kind: self.kind,
            motion: &trajectory.motion,
            pieces: &trajectory.pieces,
            step: &mut trajectory.step,
            time: trajectory.time,
            length: self.length,
            workspace,
            middle: &mut trajectory.middle,
            signals: trajectory.signals.end_mut(),
        });
        self.end_step(errors)?;
        Ok(())
    }

    /// Continues after a step taken in a lane, and prepares the next. No velocity decayed faster than at `rate` (1/s)
    /// at its start; `errors` are its estimated errors ([`crate::integrator::step::Step::error`]).
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    pub(crate) fn end_lane_step(
        &mut self,
        rate: f64,
        errors: [f64; 2],
    ) -> Result<NextStart, Outcome> {
        let trajectory = &mut self.trajectory;
        // The step after an implicit one is taken as implicit too: only then its own rate shows whether that was right.
        if !self.is_kind_known && !trajectory.stiffness.exceeds_at(rate, self.length) {
            self.kind = StepKind::Explicit;
            self.is_kind_known = true;
            return Ok(NextStart::StepStart);
        }
        trajectory.step.length = self.length;
        trajectory.step.weights = self.kind.weights();
        self.end_step(errors)
    }

    /// Goes on to the end of the step, to an event before it, or back to its start; prepares the next.
    fn end_step(&mut self, errors: [f64; 2]) -> Result<NextStart, Outcome> {
        let registers = self.trajectory.registers;
        registers.dispatch(EndStep(self, errors))
    }

    /// Body of `end_step`, compiled for any registers.
    #[inline(always)]
    fn end_step_in_registers(&mut self, [motion, work]: [f64; 2]) -> Result<NextStart, Outcome> {
        let trajectory = &mut self.trajectory;
        trajectory.evaluations += self.kind.evaluations();
        trajectory.is_middle_seen = self.kind == StepKind::Implicit;
        if trajectory.is_middle_seen {
            trajectory.tell_pad_rates();
        }
        let tolerance = trajectory.settings.tolerance();
        let error = (motion / tolerance).max(work / trajectory.greatest_work_error());
        let error = if motion.is_nan() {
            f64::INFINITY
        } else {
            error
        };
        let next = if self.accept(error) {
            self.finish_step()?
        } else {
            NextStart::StepStart
        };
        let goes_elsewhere = self.plan_step()?;
        Ok(if goes_elsewhere {
            NextStart::Elsewhere
        } else {
            next
        })
    }

    /// Flies while all legs hang, then chooses the next step. Returns whether it starts elsewhere than the last one
    /// ended.
    ///
    /// # Errors
    /// The outcome, if no further step is to be taken.
    #[inline(always)]
    fn plan_step(&mut self) -> Result<bool, Outcome> {
        let mut goes_elsewhere = self.follow_thrust()?;
        while self.trajectory.flies_freely() {
            goes_elsewhere = true;
            self.fly()?;
            self.follow_thrust()?;
        }
        let left = self.time_left()?;
        let trajectory = &mut self.trajectory;
        self.whole = (self.control.proposed())
            .min(trajectory.longest_step())
            .min(trajectory.time_to_knot())
            .min(left);
        self.length = if trajectory.locates_kinks {
            trajectory.past_kink(self.whole)
        } else {
            self.whole
        };
        if self.length < SHORTEST {
            return Err(Outcome::Failure(Failure::StepCollapse));
        }
        // In a lane, the implicit step itself shows whether it had to be implicit.
        self.is_kind_known = false;
        if self.kind == StepKind::Explicit {
            self.find_kind();
        }
        Ok(goes_elsewhere)
    }

    /// Finds the kind of the next step.
    fn find_kind(&mut self) {
        self.is_kind_known = true;
        self.kind = if self.trajectory.is_stiff(self.length) {
            StepKind::Implicit
        } else {
            StepKind::Explicit
        };
    }

    /// Time left for another step, s.
    ///
    /// # Errors
    /// The outcome, if no further step is to be taken.
    #[inline(always)]
    fn time_left(&mut self) -> Result<f64, Outcome> {
        let limit = self.trajectory.settings.time_limit();
        if self.attempts == MOST_STEPS {
            return Err(Outcome::Failure(Failure::StepLimit));
        }
        self.attempts += 1;
        if self.trajectory.time > limit - SHORTEST {
            return Err(Outcome::TimeExpired);
        }
        Ok(limit - self.trajectory.time)
    }

    /// Returns whether a step with this error (in units of the tolerance) is accepted.
    #[inline(always)]
    fn accept(&mut self, error: f64) -> bool {
        let order = self.trajectory.step.weights.error_order;
        let is_good = self.control.accept(self.length, error, order);
        if is_good && self.length < self.whole {
            self.control.keep(self.whole);
        }
        is_good
    }

    /// Takes a step of free flight.
    #[cold]
    #[inline(never)]
    fn fly(&mut self) -> Result<(), Outcome> {
        let left = self.time_left()?;
        let trajectory = &mut self.trajectory;
        let flight = (trajectory.motion).free_flight(&trajectory.step.before, &trajectory.pieces);
        let turn = TURN * trajectory.settings.tolerance().sqrt().sqrt();
        let longest = LONGEST
            .min(turn / trajectory.step.before.body().rate.norm())
            .min(trajectory.longest_step());
        let length = flight
            .reach(longest)
            .min(left)
            .min(trajectory.time_to_knot());
        if length < SHORTEST {
            return Err(Outcome::Failure(Failure::StepCollapse));
        }
        trajectory.begin_flight(flight, length);
        let ended = self.finish_step();
        self.trajectory.free = None;
        ended.map(|_| ())
    }

    /// Result of the landing.
    pub(crate) fn result(&self, outcome: Outcome) -> Landing {
        let outcome = match &self.rest {
            Some(rest) => rest.ended(outcome, &self.trajectory),
            None => outcome,
        };
        let topples = (self.stability.is_beyond()).then_some(self.trajectory.time);
        let settings = &self.trajectory.settings;
        with_verdict(self.noted.clone(), topples, outcome, settings, |outcome| {
            self.trajectory.result(outcome)
        })
    }
}

/// Work after an attempted step, compiled for the registers of a single landing.
struct EndStep<'a, 'o>(&'a mut Simulation<'o>, [f64; 2]);

impl NullaryFnOnce for EndStep<'_, '_> {
    type Output = Result<NextStart, Outcome>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Self(simulation, errors) = self;
        simulation.end_step_in_registers(errors)
    }
}
