//! The Runge-Kutta pair of order 5(4) of Dormand and Prince.
//!
//! J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comput. Appl.
//! Math. 6 (1980) 19-26. The last stage is the first of the next step.

use crate::scalar::Real;
use crate::state::State;

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
pub(super) const B: [f64; 5] = [
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

/// Evaluations of the derivative in a step.
pub const EVALUATIONS: u64 = 6;

/// A step from one state to the next.
#[derive(Debug, Clone, Copy)]
pub struct Step<S, const LEGS: usize> {
    /// State at the start.
    pub before: State<S, LEGS>,
    /// State at the end.
    pub after: State<S, LEGS>,
    /// Derivatives at stages 1, 3, 4, 5, 6 and at the end.
    pub slopes: [State<S, LEGS>; 6],
    /// Length, s.
    pub length: S,
}

impl<S: Real, const LEGS: usize> Step<S, LEGS> {
    /// A step yet to be taken from `state`, where the derivative is `slope`.
    pub fn from(state: State<S, LEGS>, slope: State<S, LEGS>) -> Self {
        Self {
            before: state,
            after: state,
            slopes: [slope; 6],
            length: S::zero(),
        }
    }

    /// Takes a step of length `h` from `before`, where the derivative is the first slope.
    /// `derivative` writes the derivative at a state into its second argument; `last` does so at
    /// the end of the step.
    #[inline(always)]
    pub fn take(
        &mut self,
        h: S,
        derivative: impl Fn(&State<S, LEGS>, &mut State<S, LEGS>),
        last: impl FnOnce(&State<S, LEGS>, &mut State<S, LEGS>),
    ) {
        self.length = h;
        let y = &self.before;
        let [k1, k3, k4, k5, k6, k7] = &mut self.slopes;
        // Stage 2 is needed for the next four only; it sits where the last one will be.
        derivative(&y.advanced_motion(times(h, A2), [&*k1]), k7);
        derivative(&y.advanced_motion(times(h, A3), [&*k1, &*k7]), k3);
        derivative(&y.advanced_motion(times(h, A4), [&*k1, &*k7, &*k3]), k4);
        derivative(
            &y.advanced_motion(times(h, A5), [&*k1, &*k7, &*k3, &*k4]),
            k5,
        );
        derivative(
            &y.advanced_motion(times(h, A6), [&*k1, &*k7, &*k3, &*k4, &*k5]),
            k6,
        );
        self.after = y.advanced(times(h, B), [&*k1, &*k3, &*k4, &*k5, &*k6]);
        last(&self.after, k7);
    }

    /// Local error estimate.
    #[inline(always)]
    pub fn error(&self) -> State<S, LEGS> {
        State::zero().advanced_motion(times(self.length, E), self.slopes.each_ref())
    }
}

#[inline(always)]
fn times<S: Real, const TERMS: usize>(h: S, weights: [f64; TERMS]) -> [S; TERMS] {
    weights.map(|w| S::constant(w) * h)
}
