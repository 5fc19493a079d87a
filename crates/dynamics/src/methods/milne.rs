//! Milne's predictor and corrector at a variable interval, started and restarted by Runge-Kutta
//! (4.1.2, method 2).
//!
//! Three Runge-Kutta steps and a first step by Milne's formulas make a block, which is accepted or rejected by the
//! error of its last step: corrector minus predictor over 29. An interval is halved when that is too great. It is
//! doubled when the error is small enough for twice the interval and enough equal intervals lie behind. After every
//! halving the method starts again.

use std::collections::VecDeque;

use super::fixed_interval::step;
use super::integration_summary::IntegrationSummary;
use super::step_doubling::{ErrorCheck, Worst};
use super::{Evaluator, Start, Stepper, System, Taken, Vector};
use crate::method::Intervals;

/// Doubling multiplies the error by 32 and the allowed error by 2.
const SMALL_ENOUGH: f64 = 1.0 / 16.0;
/// Starts needed to leave out every other one.
const ENOUGH_TO_DOUBLE: usize = 6;

/// The method in progress.
#[derive(Debug, Clone)]
pub struct Milne<V, M> {
    interval: f64,
    least: f64,
    /// Equidistant past starts, the present one last.
    past: Vec<Start<V>>,
    /// Steps of an accepted block that have not been taken yet.
    pending: VecDeque<(Start<V>, M)>,
    cuts: usize,
    check: ErrorCheck,
    summary: IntegrationSummary,
}

impl<V: Vector, M: Copy> Milne<V, M> {
    /// The method before its first interval.
    pub fn new(check: ErrorCheck, intervals: Intervals) -> Self {
        Self {
            interval: intervals.first,
            least: intervals.least,
            past: Vec::new(),
            pending: VecDeque::new(),
            cuts: 0,
            check,
            summary: IntegrationSummary::default(),
        }
    }

    /// The account of the integration so far.
    pub fn into_summary(self) -> IntegrationSummary {
        self.summary
    }

    fn taken(&mut self, length: f64, state: V) -> Taken<V> {
        self.summary.enter(length, std::mem::take(&mut self.cuts));
        Taken { length, state }
    }

    /// A step by Milne's formulas from four equidistant starts, and its greatest error as a share of the allowed one.
    fn correct<S: System<State = V, Memory = M>>(
        &mut self,
        [oldest, older, old, now]: [&Start<V>; 4],
        evaluator: &mut Evaluator<S>,
    ) -> (V, Worst) {
        let third = self.interval / 3.0;
        let predicted = oldest.state.advanced(
            [8.0 * third, -4.0 * third, 8.0 * third],
            [&older.slope, &old.slope, &now.slope],
        );
        let slope = evaluator.slope(&predicted);
        let corrected = old.state.advanced(
            [third, 4.0 * third, third],
            [&old.slope, &now.slope, &slope],
        );
        let system = evaluator.system;
        let worst = self.check.worst(self.interval, 1.0 / 29.0, |differences| {
            system.difference(&corrected, &predicted, differences);
        });
        (corrected, worst)
    }

    /// Accepts a step with this error and returns true, or halves the interval.
    fn stands(&mut self, worst: Worst) -> bool {
        let passed = worst.ratio <= 1.0;
        if !passed && 0.5 * self.interval > self.least {
            self.interval *= 0.5;
            self.cuts += 1;
            return false;
        }
        self.summary.bypassed += u64::from(!passed);
        self.summary
            .enter_errors(&self.check.errors, worst.variable);
        true
    }

    /// Takes a block of three Runge-Kutta steps and one by Milne's formulas, at an interval at which it is accepted.
    fn begin<S: System<State = V, Memory = M>>(
        &mut self,
        start: &Start<V>,
        evaluator: &mut Evaluator<S>,
    ) {
        let kept = evaluator.memory;
        loop {
            evaluator.memory = kept;
            let mut block = vec![*start];
            let mut memories = Vec::new();
            for k in 0..3 {
                let state = step(&block[k], self.interval, |state| evaluator.slope(state));
                let slope = evaluator.slope(&state);
                block.push(Start { state, slope });
                memories.push(evaluator.memory);
            }
            let (state, worst) =
                self.correct([&block[0], &block[1], &block[2], &block[3]], evaluator);
            if self.stands(worst) {
                let slope = evaluator.slope(&state);
                block.push(Start { state, slope });
                memories.push(evaluator.memory);
                self.pending = block.into_iter().skip(1).zip(memories).collect();
                evaluator.memory = kept;
                return;
            }
        }
    }
}

impl<S: System> Stepper<S> for Milne<S::State, S::Memory> {
    fn advance(
        &mut self,
        start: &Start<S::State>,
        longest: f64,
        evaluator: &mut Evaluator<S>,
    ) -> Taken<S::State> {
        if longest < self.interval {
            self.pending.clear();
            self.past.clear();
            let state = step(start, longest, |state| evaluator.slope(state));
            return self.taken(longest, state);
        }
        self.past.push(*start);
        let past = std::mem::take(&mut self.past);
        if let (true, [.., a, b, c, d]) = (self.pending.is_empty(), &past[..]) {
            let kept = evaluator.memory;
            let (state, worst) = self.correct([a, b, c, d], evaluator);
            if self.stands(worst) {
                let length = self.interval;
                let behind = past.len().saturating_sub(ENOUGH_TO_DOUBLE);
                self.past = past[behind..].to_vec();
                if worst.ratio < SMALL_ENOUGH && self.past.len() >= ENOUGH_TO_DOUBLE {
                    // With the end of this step, every other one before it.
                    let others = self.past.iter().rev().skip(1).step_by(2).take(3);
                    self.past = others.rev().copied().collect();
                    self.interval *= 2.0;
                }
                return self.taken(length, state);
            }
            evaluator.memory = kept;
        } else {
            self.past = past;
        }
        if self.pending.is_empty() {
            self.past = vec![*start];
            self.begin(start, evaluator);
        }
        let length = self.interval;
        match self.pending.pop_front() {
            Some((next, memory)) => {
                evaluator.memory = memory;
                self.taken(length, next.state)
            }
            None => self.taken(0.0, start.state),
        }
    }
}
