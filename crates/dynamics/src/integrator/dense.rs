//! Continuous output over a step.
//!
//! Cubic Hermite interpolation between the ends, plus a fourth-degree term that vanishes with its
//! slope at both where the method has one; written as weights on the stages, so that nothing is
//! prepared that no one may ask for.

use crate::integrator::step::Step;
use crate::scalar::Real;
use crate::state::State;

impl<S: Real, const LEGS: usize> Step<S, LEGS> {
    /// The state at fraction θ of the step.
    #[inline(always)]
    pub fn at(&self, theta: S) -> State<S, LEGS> {
        self.before.advanced(self.weights(theta), self.stages())
    }

    /// What moves of the state at fraction θ of the step; the work integrals are those before it.
    #[inline(always)]
    pub fn motion_at(&self, theta: S) -> State<S, LEGS> {
        self.before
            .advanced_motion(self.weights(theta), self.stages())
    }

    /// Angles γ (rad) and rates γ̇ (rad/s) of the links at fraction θ of the step.
    #[inline(always)]
    pub fn links_at(&self, theta: S) -> [[S; LEGS]; 2] {
        self.before
            .links_advanced(self.weights(theta), self.stages())
    }

    /// Rates α̇ of the pads at fraction θ of the step, rad/s.
    #[inline(always)]
    pub fn pad_rates_at(&self, theta: S) -> [S; LEGS] {
        self.before
            .pad_rates_advanced(self.weights(theta), self.stages())
    }

    #[inline(always)]
    fn stages(&self) -> [&State<S, LEGS>; 6] {
        self.slopes.each_ref()
    }

    #[inline(always)]
    fn weights(&self, theta: S) -> [S; 6] {
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
        weights.map(|w| w * self.length)
    }
}
