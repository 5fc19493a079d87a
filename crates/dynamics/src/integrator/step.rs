//! A step: where it starts and ends, and the slopes between.

use crate::scalar::Real;
use crate::state::State;

/// What the kinds of steps differ in once they are taken: weights on the slopes of a [`Step`].
#[derive(Debug, Clone, Copy)]
pub struct Weights<S> {
    /// Of the first five, for the change over the step.
    pub result: [S; 5],
    /// For the local error estimate.
    pub error: [S; 6],
    /// Power of the step's length with which that estimate falls.
    pub error_order: f64,
    /// For the fourth-degree term of the continuous output.
    pub bump: [S; 6],
}

/// A step from one state to the next.
#[derive(Debug, Clone, Copy)]
pub struct Step<S, const LEGS: usize> {
    /// State at the start.
    pub before: State<S, LEGS>,
    /// State at the end.
    pub after: State<S, LEGS>,
    /// State at a stage between, but for the work integrals.
    pub(super) stage: State<S, LEGS>,
    /// Derivatives at stages 1, 3, 4, 5, 6 and at the end of an explicit step, which gives its second stage
    /// no weight; of an implicit step what its weights say, first and last the derivatives at its ends.
    pub slopes: [State<S, LEGS>; 6],
    /// Length, s.
    pub length: S,
    /// Weights of the slopes.
    pub weights: Weights<S>,
}

impl<S: Real, const LEGS: usize> Step<S, LEGS> {
    /// A step yet to be taken from `state`, where the derivative is `slope`.
    pub fn from(state: State<S, LEGS>, slope: State<S, LEGS>) -> Self {
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

    /// Local error estimate.
    #[inline(always)]
    pub fn error(&self) -> State<S, LEGS> {
        let weights = self.weights.error.map(|w| w * self.length);
        State::zero().advanced(weights, self.slopes.each_ref())
    }
}
