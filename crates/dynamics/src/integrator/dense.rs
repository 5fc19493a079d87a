//! Continuous output over a step.
//!
//! Cubic Hermite interpolation between the ends, plus, for methods that have one, a fourth-degree term that vanishes
//! with its slope at both. It is written as weights on the stages, so that nothing has to be prepared in advance.

use super::step::{StateVector, Step};
use crate::scalar::Real;

impl<S: Real, Y: StateVector<S>> Step<S, Y> {
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
