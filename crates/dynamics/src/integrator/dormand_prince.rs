//! The Runge-Kutta pair of order 5(4) of Dormand and Prince.
//!
//! J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl.
//! Math. 6 (1980) 19-26. The last stage is the first of the next step.

use super::step::{StateVector, Step, Weights};
use crate::scalar::Real;

/// Evaluations of the derivative in a step.
pub const EVALUATIONS: u64 = 6;

const A2: [f64; 1] = [1.0 / 5.0];
const A3: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];
const A4: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
const A5: [f64; 4] = [
    19372.0 / 6561.0,
    -25360.0 / 2187.0,
    64448.0 / 6561.0,
    -212.0 / 729.0,
];
const A6: [f64; 5] = [
    9017.0 / 3168.0,
    -355.0 / 33.0,
    46732.0 / 5247.0,
    49.0 / 176.0,
    -5103.0 / 18656.0,
];
/// Weights of the fifth-order result on stages 1, 3, 4, 5, 6.
const B: [f64; 5] = [
    35.0 / 384.0,
    500.0 / 1113.0,
    125.0 / 192.0,
    -2187.0 / 6784.0,
    11.0 / 84.0,
];
/// Fifth- minus fourth-order weights on stages 1, 3, 4, 5, 6, 7.
const E: [f64; 6] = [
    71.0 / 57600.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Weights of the fourth-degree term of the continuous output on stages 1, 3, 4, 5, 6, 7, by
/// L. F. Shampine, after E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary Differential
/// Equations I, II.6.
const D: [f64; 6] = [
    -12715105075.0 / 11282082432.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

impl<S: Real, Y: StateVector<S>> Step<S, Y> {
    /// Takes an explicit step of length `h` from `before`, where the derivative is the first slope. `derivative` writes
    /// the derivative at a fraction of the step and a state into its last argument; `last` does so at the end of the
    /// step.
    #[inline(always)]
    pub fn take_explicit(
        &mut self,
        h: S,
        derivative: impl Fn(f64, &Y, &mut Y),
        last: impl FnOnce(&Y, &mut Y),
    ) {
        self.length = h;
        self.weights = weights();
        let (y, stage) = (&self.before, &mut self.stage);
        let [k1, k3, k4, k5, k6, k7] = &mut self.slopes;
        // Stage 2 is needed for the next four only; it sits where the last one will be.
        y.advance_motion(times(h, A2), [&*k1], stage);
        derivative(0.2, stage, k7);
        y.advance_motion(times(h, A3), [&*k1, &*k7], stage);
        derivative(0.3, stage, k3);
        y.advance_motion(times(h, A4), [&*k1, &*k7, &*k3], stage);
        derivative(0.8, stage, k4);
        y.advance_motion(times(h, A5), [&*k1, &*k7, &*k3, &*k4], stage);
        derivative(8.0 / 9.0, stage, k5);
        y.advance_motion(times(h, A6), [&*k1, &*k7, &*k3, &*k4, &*k5], stage);
        derivative(1.0, stage, k6);
        y.advance(times(h, B), [&*k1, &*k3, &*k4, &*k5, &*k6], &mut self.after);
        last(&self.after, k7);
    }
}

/// Weights of the slopes of an explicit step.
#[inline(always)]
pub fn weights<S: Real>() -> Weights<S> {
    Weights {
        result: B.map(S::constant),
        error: E.map(S::constant),
        error_order: 5.0,
        bump: D.map(S::constant),
    }
}

#[inline(always)]
fn times<S: Real, const TERMS: usize>(h: S, weights: [f64; TERMS]) -> [S; TERMS] {
    weights.map(|w| S::constant(w) * h)
}
