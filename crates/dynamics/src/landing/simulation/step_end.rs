//! The end of an accepted step, in order: what ends it first, what is noted up to there, where the landing goes on, and
//! whether it is over.

use pulp::NullaryFnOnce;

use super::{NextStart, Simulation};
use crate::integrator::step::Step;
use crate::outcome::{Failure, Outcome};
use crate::registers::Registers;
use crate::stability::Verdict;

/// Events within `BURST_TIME` (s) that count as chattering too: the laws switch to and fro while time creeps.
const BURST: u64 = 4000;
const BURST_TIME: f64 = 1e-5;

/// Reason for which a step ends.
enum StepEnd {
    /// Nothing before its end.
    Whole,
    /// A change of a law; the signals there are in one of the `buffers`.
    Law { buffer: usize },
    /// A gentle kink of a law.
    Kink,
    /// A verdict that ends the landing.
    Verdict(Verdict),
}

impl StepEnd {
    /// The buffer with the signals of a change of a law.
    #[inline(always)]
    fn buffer(&self) -> Option<usize> {
        match *self {
            Self::Law { buffer } => Some(buffer),
            Self::Whole | Self::Kink | Self::Verdict(_) => None,
        }
    }
}

impl Simulation<'_> {
    /// Goes on to the end of a step, or to the first event or verdict within it.
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    pub(super) fn finish_step(&mut self) -> Result<NextStart, Outcome> {
        let registers = self.trajectory.registers;
        registers.dispatch(FinishStep(self))
    }

    /// Body of `finish_step`, compiled for any registers.
    #[inline(always)]
    fn finish_step_in_registers(&mut self) -> Result<NextStart, Outcome> {
        if !self.trajectory.step.after.is_finite() {
            return Err(Outcome::Failure(Failure::NonFinite));
        }
        self.trajectory.steps += 1;
        let (reach, end) = self.first_end();
        self.note_until(reach, &end);
        let next = match end {
            StepEnd::Verdict(verdict) => {
                self.trajectory.move_to(reach);
                return Err(verdict.into());
            }
            StepEnd::Law { buffer } => self.change_laws(reach, buffer)?,
            StepEnd::Kink => self.start_at_kink(reach),
            StepEnd::Whole => self.start_at_end(),
        };
        self.judge_rest()?;
        Ok(next)
    }

    /// The earliest of what ends the step, and its fraction. A verdict beyond which the landing goes on is noted instead.
    #[inline(always)]
    fn first_end(&mut self) -> (f64, StepEnd) {
        let (trajectory, stability) = (&mut self.trajectory, &mut self.stability);
        let (mut reach, mut end) = match trajectory.find_event() {
            Some((theta, buffer)) => (theta, StepEnd::Law { buffer }),
            None => (1.0, StepEnd::Whole),
        };
        if trajectory.locates_kinks
            && let Some(theta) = trajectory.kink_before(reach)
        {
            (reach, end) = (theta, StepEnd::Kink);
        }
        if self.noted.is_some() {
            trajectory.follow_clearance(stability, reach);
        } else if let Some((theta, verdict)) = trajectory.judge_step(stability, reach, end.buffer())
        {
            if trajectory.settings.goes_on() {
                self.noted = Some((verdict.into(), trajectory.time_at(theta)));
            } else {
                (reach, end) = (theta, StepEnd::Verdict(verdict));
            }
        }
        (reach, end)
    }

    /// Notes history, work and strut peaks up to fraction `reach`, where the step ends, and goes on to that time.
    #[inline(always)]
    fn note_until(&mut self, reach: f64, end: &StepEnd) {
        let trajectory = &mut self.trajectory;
        trajectory.report(reach);
        trajectory.thrust_work = trajectory.thrust_work_at(reach);
        let buffer = match end {
            StepEnd::Verdict(_) | StepEnd::Kink => {
                trajectory.buffers[0] = trajectory.signals_at(reach);
                Some(0)
            }
            StepEnd::Law { .. } | StepEnd::Whole => end.buffer(),
        };
        trajectory.note_struts(buffer, reach);
        trajectory.time = trajectory.time_at(reach);
    }

    /// Goes to fraction `reach`, where a law changes, and sets the laws that hold from there on.
    ///
    /// # Errors
    /// The outcome, if the change of laws ends the landing.
    #[inline(always)]
    fn change_laws(&mut self, reach: f64, buffer: usize) -> Result<NextStart, Outcome> {
        let trajectory = &mut self.trajectory;
        trajectory.move_to(reach);
        (trajectory.signals.start_mut()).assign(&trajectory.buffers[buffer]);
        trajectory.earlier = None;
        self.control.restart();
        trajectory.cross()?;
        trajectory.settle()?;
        let (events, since) = self.burst;
        if trajectory.events - events > BURST {
            if trajectory.time - since < BURST_TIME {
                return Err(Outcome::Failure(Failure::Chattering));
            }
            self.burst = (trajectory.events, trajectory.time);
        }
        Ok(NextStart::Elsewhere)
    }

    /// Goes to fraction `reach`, where a law bends.
    #[inline(always)]
    fn start_at_kink(&mut self, reach: f64) -> NextStart {
        let trajectory = &mut self.trajectory;
        trajectory.remember_step(reach);
        trajectory.move_to(reach);
        trajectory.events += 1;
        trajectory.evaluate();
        NextStart::Elsewhere
    }

    /// Goes to the end of the step.
    #[inline(always)]
    fn start_at_end(&mut self) -> NextStart {
        let trajectory = &mut self.trajectory;
        trajectory.remember_step(1.0);
        let Step {
            before,
            after,
            slopes: [first, .., last],
            ..
        } = &mut trajectory.step;
        before.assign(after);
        first.assign(last);
        NextStart::StepEnd
    }

    /// Judges whether the motion is over, and recentres laws that bend gently.
    ///
    /// # Errors
    /// The outcome, if it is over and the landing does not go on beyond that.
    #[inline(always)]
    fn judge_rest(&mut self) -> Result<(), Outcome> {
        let Self {
            trajectory,
            steadiness,
            rest,
            ..
        } = self;
        steadiness.note(trajectory.time, self.stability.angle());
        let at_rest = match rest {
            Some(rest) if self.noted.is_none() => rest.note(trajectory),
            _ => false,
        };
        let end = if at_rest {
            Some(Outcome::StableSubsided)
        } else if trajectory.pieces.thrust().is_none() {
            let ends_early = trajectory.settings.ends_early();
            steadiness.end(trajectory.time, &trajectory.step.before.body(), ends_early)
        } else {
            None
        };
        trajectory.follow();
        match end {
            Some(outcome) => self.conclude(outcome),
            None => Ok(()),
        }
    }
}

/// Work after an accepted step, compiled for the registers of a single landing.
struct FinishStep<'a, 'o>(&'a mut Simulation<'o>);

impl NullaryFnOnce for FinishStep<'_, '_> {
    type Output = Result<NextStart, Outcome>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        self.0.finish_step_in_registers()
    }
}
