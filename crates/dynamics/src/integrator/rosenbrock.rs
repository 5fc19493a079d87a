//! Linearly implicit steps of order four: Rodas4P2.
//!
//! G. Steinebach, "Improvement of Rosenbrock-Wanner method RODASP", in T. Reis, S. Grundel, S. Schöps (eds.),
//! Progress in Differential-Algebraic Equations II, Springer 2020, 165-184; written for transformed stages after
//! E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.7. L-stable and stiffly accurate, it does
//! not lose order where a foot is stuck, and it stays of order two with an inexact derivative.
//!
//! The accumulating part (work integrals, rates of pads at rest on a stop) is left out of the stages and summed by
//! Simpson's rule, which takes one more evaluation, in the middle.

use super::step::{StateVector, Step, Weights};
use crate::scalar::Real;

/// The equations (1/τ − J) u = r of the stages of a step, factored, with τ = [`GAMMA`] h. J is the derivative of the
/// motion, or near it; u and r are states.
pub trait StageEquations<S, Y> {
    /// Writes the moving part of u.
    fn solve(&self, r: &Y, u: &mut Y);

    /// Sums the accumulating part over a step of length `h` from `before` by Simpson's rule, from the slopes at its
    /// start, middle and end; writes its error over h.
    fn accumulate(&self, before: &Y, h: S, slopes: [&Y; 3], after: &mut Y, error: &mut Y);
}

/// Evaluations of the derivative in a step.
pub const EVALUATIONS: u64 = 7;

/// Diagonal of the implicit scheme: stages are solved with τ = γh.
pub const GAMMA: f64 = 0.25;
/// Weights of earlier stages on a stage's state; the last row, plus the last stage itself, gives the result.
const STATE: [[f64; 5]; 5] = [
    [3.0, 0.0, 0.0, 0.0, 0.0],
    [0.906377755268814, -0.189707390391685, 0.0, 0.0, 0.0],
    [
        3.758617027739064,
        1.161741776019525,
        -0.849258085312803,
        0.0,
        0.0,
    ],
    LAST,
    [LAST[0], LAST[1], LAST[2], LAST[3], 1.0],
];
const LAST: [f64; 5] = [
    7.089566927282776,
    4.573591406461604,
    -8.423496976860259,
    -0.959280113459775,
    0.0,
];
/// Fractions of a step at which a stage takes a derivative that depends on time. For a right-hand side linear in time
/// they combine α h and the γ h of the stage's own term of time.
pub const TIMES: [f64; 6] = [
    0.25,
    0.25,
    0.13191521565003017,
    0.6053578410704956,
    1.0,
    1.0,
];
/// Weights of earlier stages, over h, on the right-hand side of a stage.
const SLOPE: [[f64; 5]; 5] = [
    [-12.0, 0.0, 0.0, 0.0, 0.0],
    [-6.354581592719008, 0.338972550544623, 0.0, 0.0, 0.0],
    [
        -8.575016317114033,
        -7.606483992117508,
        12.22499765012482,
        0.0,
        0.0,
    ],
    [
        -5.888975457523102,
        -8.15739661784182,
        24.805546872612922,
        12.79040151279698,
        0.0,
    ],
    [
        -4.408651676063871,
        -6.692003137674639,
        24.625568527593117,
        16.627521966636085,
        -5.714285714285718,
    ],
];

impl<S: Real, Y: StateVector<S>> Step<S, Y> {
    /// Takes a step of length `h` from `before`, where the derivative is the first slope. `equations` are those of τ =
    /// [`GAMMA`] h, and `stages` are overwritten. `derivative` writes the derivative at a fraction of the step and a
    /// state into its last argument; `start` is that at the start at the first of [`TIMES`], if it depends on time.
    /// `middle` and `last` write it midway on the continuous output and at the end, where the accumulating part is
    /// still that of the start.
    #[inline(always)]
    #[allow(
        clippy::too_many_arguments,
        reason = "three functions and what they work on"
    )]
    pub fn take_implicit(
        &mut self,
        h: S,
        equations: &impl StageEquations<S, Y>,
        stages: &mut [Y; 6],
        start: Option<&Y>,
        derivative: impl Fn(f64, &Y, &mut Y),
        middle: impl FnOnce(&Y, &mut Y),
        last: impl FnOnce(&Y, &mut Y),
    ) {
        self.length = h;
        self.weights = weights();
        equations.solve(start.unwrap_or(&self.slopes[0]), &mut stages[0]);
        self.take_stage::<1>(equations, stages, &derivative);
        self.take_stage::<2>(equations, stages, &derivative);
        self.take_stage::<3>(equations, stages, &derivative);
        self.take_stage::<4>(equations, stages, &derivative);
        self.take_stage::<5>(equations, stages, &derivative);
        self.before.advance::<0>([], [], &mut self.after);
        let sixth = &stages[5];
        self.stage
            .advance_motion([S::one()], [sixth], &mut self.after);

        // In place of its stages' slopes a step keeps its mean slope, the slope in the middle, and its error over h.
        let [first, mean, midway, error, _, end] = &mut self.slopes;
        last(&self.after, end);
        self.before.midway(
            &self.after,
            S::constant(0.125) * h,
            [&*first, &*end],
            &mut self.stage,
        );
        middle(&self.stage, midway);
        error.set_motion_over(sixth, h);
        equations.accumulate(
            &self.before,
            h,
            [&*first, &*midway, &*end],
            &mut self.after,
            error,
        );
        mean.set_mean_rate(&self.before, &self.after, h);
    }

    /// Takes the stage after `BEFORE` others.
    #[inline(always)]
    fn take_stage<const BEFORE: usize>(
        &mut self,
        equations: &impl StageEquations<S, Y>,
        stages: &mut [Y; 6],
        derivative: &impl Fn(f64, &Y, &mut Y),
    ) {
        let before: [&Y; BEFORE] = std::array::from_fn(|j| &stages[j]);
        let weights: [S; BEFORE] = std::array::from_fn(|j| S::constant(STATE[BEFORE - 1][j]));
        self.before.advance_motion(weights, before, &mut self.stage);
        let [_, given, _, _, slope, _] = &mut self.slopes;
        derivative(TIMES[BEFORE], &self.stage, slope);
        let weights: [S; BEFORE] =
            std::array::from_fn(|j| S::constant(SLOPE[BEFORE - 1][j]) / self.length);
        slope.advance_motion(weights, before, given);
        equations.solve(given, &mut stages[BEFORE]);
    }
}

/// Weights of the slopes of an implicit step.
#[inline(always)]
pub fn weights<S: Real>() -> Weights<S> {
    Weights {
        result: [0.0, 1.0, 0.0, 0.0, 0.0].map(S::constant),
        error: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0].map(S::constant),
        error_order: 4.0,
        // The continuous output is the cubic between the ends.
        bump: [S::zero(); 6],
    }
}
