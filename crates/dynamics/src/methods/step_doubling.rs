//! The integrator of the report (3.2, 3.3): Runge-Kutta over an interval and over its halves.
//!
//! The difference of the two results removes the fifth-order error and gives, over 180, the error that remains. An
//! interval with too great an error is cut in half, where the result over its first half is known already. After an
//! accepted one the next is (2 − u) times as long, u being the greatest error as a share of the allowed one. Trial
//! stages change the laws' memory; it passes on into the next interval, and is reset only when an interval is tried
//! again from its start.

use super::fixed_interval::step;
use super::integration_summary::IntegrationSummary;
use super::{Evaluator, Start, Stepper, System, Taken, Vector};
use crate::method::Intervals;

/// The error of an interval as a share of the allowed error (3.3): greatest truncation errors of the variables per second
/// of simulated time; infinite where no limit is set.
#[derive(Debug, Clone)]
pub struct ErrorCheck {
    limits: Vec<f64>,
    /// Truncation errors of the interval last checked.
    pub errors: Vec<f64>,
}

/// The greatest error as a share of the allowed one, and its variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// The error over its limit; infinite if it is NaN.
    pub ratio: f64,
    /// Index of the variable; `None` while no error is greater than zero.
    pub variable: Option<usize>,
}

impl ErrorCheck {
    /// A check against these limits.
    pub fn new(limits: Vec<f64>) -> Self {
        Self {
            errors: Vec::with_capacity(limits.len()),
            limits,
        }
    }

    /// Checks errors that are a `fraction` of `differences`, over an interval of `length` seconds.
    pub fn worst(
        &mut self,
        length: f64,
        fraction: f64,
        differences: impl FnOnce(&mut Vec<f64>),
    ) -> Worst {
        differences(&mut self.errors);
        let mut worst = Worst {
            ratio: 0.0,
            variable: None,
        };
        for (variable, (error, limit)) in self.errors.iter_mut().zip(&self.limits).enumerate() {
            *error *= fraction;
            let ratio = error.abs() / (length * limit);
            if ratio > worst.ratio || ratio.is_nan() {
                worst = Worst {
                    ratio: if ratio.is_nan() { f64::INFINITY } else { ratio },
                    variable: Some(variable),
                };
            }
        }
        worst
    }
}

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
