//! Continuous output over a step, of order 4.
//!
//! The interpolant of Dormand and Prince's pair given by L. F. Shampine and written in this form
//! by E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary Differential Equations I, II.6.

use crate::integrator::dormand_prince::Step;
use crate::scalar::Real;
use crate::state::State;

const D: [f64; 6] = [
    -12715105075.0 / 11282082432.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

/// The state at any fraction of a step.
#[derive(Debug, Clone, Copy)]
pub struct Interpolant<S, const LEGS: usize> {
    before: State<S, LEGS>,
    coefficients: [State<S, LEGS>; 4],
}

impl<S: Real, const LEGS: usize> Interpolant<S, LEGS> {
    /// The interpolant of a step.
    #[inline(always)]
    pub fn new(step: &Step<S, LEGS>) -> Self {
        let one = S::one();
        let [k1, k3, k4, k5, k6, k7] = &step.slopes;
        let h = step.length;
        let change = step.after.advanced([-one], [&step.before]);
        let bend = change.scaled(-one).advanced([h], [k1]);
        let turn = change.advanced([-h, -one], [k7, &bend]);
        let quartic =
            State::zero().advanced(D.map(|d| S::constant(d) * h), [k1, k3, k4, k5, k6, k7]);
        Self {
            before: step.before,
            coefficients: [change, bend, turn, quartic],
        }
    }

    /// The state at fraction θ of the step.
    #[inline(always)]
    pub fn at(&self, theta: S) -> State<S, LEGS> {
        let [change, bend, turn, quartic] = &self.coefficients;
        self.before
            .advanced(Self::weights(theta), [change, bend, turn, quartic])
    }

    /// What moves of the state at fraction θ of the step; the work integrals are those before it.
    #[inline(always)]
    pub fn motion_at(&self, theta: S) -> State<S, LEGS> {
        let [change, bend, turn, quartic] = &self.coefficients;
        self.before
            .advanced_motion(Self::weights(theta), [change, bend, turn, quartic])
    }

    #[inline(always)]
    fn weights(theta: S) -> [S; 4] {
        let rest = S::one() - theta;
        let both = theta * rest;
        [theta, both, theta * both, both * both]
    }
}
