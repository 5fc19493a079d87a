//! Continuous output over a step, of order 4.
//!
//! The interpolant of Dormand and Prince's pair by L. F. Shampine, after E. Hairer, S. P. Nørsett
//! and G. Wanner, Solving Ordinary Differential Equations I, II.6, written as weights on the
//! stages: nothing is prepared that no one may ask for.

use crate::integrator::dormand_prince::{B, Step};
use crate::scalar::Real;
use crate::state::State;

/// Weights of the fourth-degree term on stages 1, 3, 4, 5, 6, 7.
const D: [f64; 6] = [
    -12715105075.0 / 11282082432.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

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

    #[inline(always)]
    fn stages(&self) -> [&State<S, LEGS>; 6] {
        self.slopes.each_ref()
    }

    /// Cubic Hermite interpolation between the ends plus a fourth-degree term that vanishes with
    /// its slope at both.
    #[inline(always)]
    fn weights(&self, theta: S) -> [S; 6] {
        let rest = S::one() - theta;
        let squared = theta * theta;
        let change = squared * (S::constant(3.0) - theta - theta);
        let bump = squared * rest * rest;
        let mut weights = D.map(|d| S::constant(d) * bump);
        for (weight, b) in weights.iter_mut().zip(B) {
            *weight += S::constant(b) * change;
        }
        weights[0] += theta * rest * rest;
        weights[5] -= squared * rest;
        weights.map(|w| w * self.length)
    }
}
