//! The integrator of the report (3.2, 3.3): Runge-Kutta over an interval and over its halves.
//!
//! The difference of the two results removes the fifth-order error and gives, over 180, the error that remains. An
//! interval with too great an error is cut in half, where the result over its first half is known already. After an
//! accepted one the next is (2 − u) times as long, u being the greatest error as a share of the allowed one. Trial
//! stages change the laws' memory; it passes on into the next interval, and is reset only when an interval is tried
//! again from its start.

use super::error_check::ErrorCheck;
use super::integration_summary::IntegrationSummary;
use super::runge_kutta::step;
use super::system::{Evaluator, Start, Stepper, System, Taken, Vector};
use crate::error_control::Intervals;

/// The method in progress.
#[derive(Debug, Clone)]
pub struct StepDoubling {
    next: f64,
    least: f64,
    check: ErrorCheck,
    summary: IntegrationSummary,
}

impl StepDoubling {
    /// The method before its first interval.
    pub fn new(check: ErrorCheck, intervals: Intervals) -> Self {
        Self {
            next: intervals.first,
            least: intervals.least,
            check,
            summary: IntegrationSummary::default(),
        }
    }

    /// The account of the integration so far.
    pub fn into_summary(self) -> IntegrationSummary {
        self.summary
    }
}

impl<S: System> Stepper<S> for StepDoubling {
    fn advance(
        &mut self,
        start: &Start<S::State>,
        longest: f64,
        evaluator: &mut Evaluator<S>,
    ) -> Taken<S::State> {
        let system = evaluator.system;
        let kept = evaluator.memory;
        let mut length = self.next.min(longest);
        let mut cuts = 0;
        let look = |evaluator: &mut Evaluator<S>, state: &S::State| {
            let mut slope = evaluator.slope(state);
            system.hold(&start.slope, &mut slope);
            slope
        };
        let mut whole = step(start, length, |state| look(evaluator, state));
        loop {
            evaluator.memory = kept;
            let half = 0.5 * length;
            let middle = step(start, half, |state| look(evaluator, state));
            let from_middle = Start {
                state: middle,
                slope: look(evaluator, &middle),
            };
            let end = step(&from_middle, half, |state| look(evaluator, state));
            let end = end.advanced([1.0 / 15.0, -1.0 / 15.0], [&end, &whole]);
            let worst = self.check.worst(length, 1.0 / 180.0, |differences| {
                system.difference(&whole, &end, differences);
            });
            let passed = worst.ratio <= 1.0;
            if passed || half <= self.least {
                self.summary.enter(length, cuts);
                self.summary
                    .enter_errors(&self.check.errors, worst.variable);
                self.summary.bypassed += u64::from(!passed);
                self.next = (2.0 - worst.ratio.min(1.0)) * length;
                return Taken { length, state: end };
            }
            whole = middle;
            length = half;
            cuts += 1;
        }
    }
}
