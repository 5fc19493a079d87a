//! A step: its start, its end, the slopes and the continuous output between.

use crate::scalar::Real;

/// Vectors for steps: sums of states and slopes, lane by lane.
///
/// Part of a state may only accumulate, so that nothing depends on it. The rest is called the motion.
pub trait StateVector<S: Real>: Copy {
    /// Writes self + Σ weight · slope into `result`.
    fn advance<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    );

    /// Writes self + Σ weight · slope of the motion into `result`.
    fn advance_motion<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    );

    /// Writes the motion midway between self and `end` on the cubic between them, from the slopes at both and an eighth
    /// of the time between.
    fn midway(&self, end: &Self, eighth: S, slopes: [&Self; 2], middle: &mut Self);

    /// Writes (end − start)/length into self.
    fn set_mean_rate(&mut self, start: &Self, end: &Self, length: S);

    /// Writes change/length of the motion into self.
    fn set_motion_over(&mut self, change: &Self, length: S);

    /// Greatest weighted sum of `slopes` in the motion, in units of the weights of its numbers from `before` to
    /// `after`, and the greatest in the accumulating part. NaN if a sum is NaN.
    fn greatest_error<const TERMS: usize>(
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        before: &Self,
        after: &Self,
    ) -> [S; 2];
}

/// Differences between the kinds of steps once taken: weights on the slopes of a [`Step`].
#[derive(Debug, Clone, Copy)]
pub struct Weights<S> {
    /// Weights of the first five, for the change over the step.
    pub result: [S; 5],
    /// Weights for the local error estimate.
    pub error: [S; 6],
    /// Power of the step's length with which that estimate falls.
    pub error_order: f64,
    /// Weights for the fourth-degree term of the continuous output.
    pub bump: [S; 6],
}

/// A step from one state to the next.
#[derive(Debug, Clone, Copy)]
pub struct Step<S, Y> {
    /// State at the start.
    pub before: Y,
    /// State at the end.
    pub after: Y,
    /// Motion at a stage between.
    pub(super) stage: Y,
    /// Derivatives at stages 1, 3, 4, 5, 6 and at the end of an explicit step, whose second stage has no weight. For an
    /// implicit step the terms that its weights combine, with the derivatives at its ends first and last.
    pub slopes: [Y; 6],
    /// Length, s.
    pub length: S,
    /// Weights of the slopes.
    pub weights: Weights<S>,
}

impl<S: Real, Y: StateVector<S>> Step<S, Y> {
    /// A step to be taken from `state`, where the derivative is `slope`.
    pub fn from(state: Y, slope: Y) -> Self {
        let zero = S::zero();
        Self {
            before: state,
            after: state,
            stage: state,
            slopes: [slope; 6],
            length: zero,
            weights: Weights {
                result: [zero; 5],
                error: [zero; 6],
                error_order: 1.0,
                bump: [zero; 6],
            },
        }
    }

    /// Local error estimate ([`StateVector::greatest_error`]).
    #[inline(always)]
    pub fn error(&self) -> [S; 2] {
        let weights = self.weights.error.map(|w| w * self.length);
        Y::greatest_error(weights, self.slopes.each_ref(), &self.before, &self.after)
    }

    /// Writes the state at fraction θ of the step.
    #[inline(always)]
    pub fn at(&self, theta: S, state: &mut Y) {
        let (weights, slopes) = self.change(theta);
        self.before.advance(weights, slopes, state);
    }

    /// Writes the motion at fraction θ of the step.
    #[inline(always)]
    pub fn motion_at(&self, theta: S, state: &mut Y) {
        let (weights, slopes) = self.change(theta);
        self.before.advance_motion(weights, slopes, state);
    }

    /// The change from the start to fraction θ of the step: weights and slopes to be summed.
    ///
    /// Cubic Hermite interpolation between the ends, plus, for methods that have one, a fourth-degree term that vanishes
    /// with its slope at both. It is written as weights on the stages, so that nothing has to be prepared in advance.
    #[inline(always)]
    pub fn change(&self, theta: S) -> ([S; 6], [&Y; 6]) {
        let rest = S::one() - theta;
        let squared = theta * theta;
        let change = squared * (S::constant(3.0) - theta - theta);
        let bump = squared * rest * rest;
        let mut weights = self.weights.bump.map(|w| w * bump);
        for (weight, b) in weights.iter_mut().zip(self.weights.result) {
            *weight += b * change;
        }
        weights[0] += theta * rest * rest;
        weights[5] -= squared * rest;
        (weights.map(|w| w * self.length), self.slopes.each_ref())
    }
}
