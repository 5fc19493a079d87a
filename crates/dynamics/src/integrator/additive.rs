//! Additive Runge-Kutta steps: the damping implicit, all else explicit.
//!
//! C. A. Kennedy, M. H. Carpenter, "Additive Runge-Kutta schemes for convection-diffusion-reaction
//! equations", Appl. Numer. Math. 44 (2003) 139-181: `ARK4(3)6L[2]SA`, explicit and L-stable
//! diagonally implicit with common weights. The implicit part here is linear, −M⁻¹K v with the
//! damping matrix K of the start of the step, and the explicit part all that is left; whatever K
//! is, the order is four, and the better K, the longer the steps that stay stable.

use crate::damping::{DampedSolve, Velocities};
use crate::integrator::step::{Step, Weights};
use crate::scalar::Real;
use crate::state::State;

/// Diagonal of the implicit scheme.
pub const GAMMA: f64 = 0.25;
const EXPLICIT: [[f64; 5]; 5] = [
    [0.5, 0.0, 0.0, 0.0, 0.0],
    [13861.0 / 62500.0, 6889.0 / 62500.0, 0.0, 0.0, 0.0],
    [
        -116923316275.0 / 2393684061468.0,
        -2731218467317.0 / 15368042101831.0,
        9408046702089.0 / 11113171139209.0,
        0.0,
        0.0,
    ],
    [
        -451086348788.0 / 2902428689909.0,
        -2682348792572.0 / 7519795681897.0,
        12662868775082.0 / 11960479115383.0,
        3355817975965.0 / 11060851509271.0,
        0.0,
    ],
    [
        647845179188.0 / 3216320057751.0,
        73281519250.0 / 8382639484533.0,
        552539513391.0 / 3454668386233.0,
        3354512671639.0 / 8306763924573.0,
        4040.0 / 17871.0,
    ],
];
const IMPLICIT: [[f64; 5]; 5] = [
    [0.25, 0.0, 0.0, 0.0, 0.0],
    [8611.0 / 62500.0, -1743.0 / 31250.0, 0.0, 0.0, 0.0],
    [
        5012029.0 / 34652500.0,
        -654441.0 / 2922500.0,
        174375.0 / 388108.0,
        0.0,
        0.0,
    ],
    [
        15267082809.0 / 155376265600.0,
        -71443401.0 / 120774400.0,
        730878875.0 / 902184768.0,
        2285395.0 / 8070912.0,
        0.0,
    ],
    [
        82889.0 / 524892.0,
        0.0,
        15625.0 / 83664.0,
        69875.0 / 102672.0,
        -2260.0 / 8211.0,
    ],
];
/// Weights of the fourth-order result on stages 1, 3, 4, 5, 6.
const B: [f64; 5] = [
    82889.0 / 524892.0,
    15625.0 / 83664.0,
    69875.0 / 102672.0,
    -2260.0 / 8211.0,
    0.25,
];
/// Fourth- minus third-order weights on stages 1, 3, 4, 5, 6 and at the end.
const E: [f64; 6] = [
    82889.0 / 524892.0 - 4586570599.0 / 29645900160.0,
    15625.0 / 83664.0 - 178811875.0 / 945068544.0,
    69875.0 / 102672.0 - 814220225.0 / 1159782912.0,
    -2260.0 / 8211.0 + 3700637.0 / 11593932.0,
    0.25 - 61727.0 / 225920.0,
    0.0,
];

/// Where the slopes of the stages are kept: the second, which the result gives no weight, sits where
/// the one at the end will be.
const SLOTS: [usize; 6] = [0, 5, 1, 2, 3, 4];

impl<S: Real, const LEGS: usize> Step<S, LEGS> {
    /// Takes a step of length `h` with the damping implicit; `damped` is M + γhK factored.
    #[inline(always)]
    pub fn take_damped(
        &mut self,
        h: S,
        damped: &DampedSolve<S, LEGS>,
        derivative: impl Fn(&State<S, LEGS>, &mut State<S, LEGS>),
        last: impl FnOnce(&State<S, LEGS>, &mut State<S, LEGS>),
    ) {
        self.length = h;
        self.weights = Weights {
            result: B.map(S::constant),
            error: E.map(S::constant),
            // The continuous output is the cubic between the ends.
            bump: [S::zero(); 6],
        };
        // h A (Y_j − y) of the stages, A = −M⁻¹K.
        let mut decays = [Velocities::zero(); 6];
        self.take_stage::<1>(damped, &mut decays, &derivative);
        self.take_stage::<2>(damped, &mut decays, &derivative);
        self.take_stage::<3>(damped, &mut decays, &derivative);
        self.take_stage::<4>(damped, &mut decays, &derivative);
        self.take_stage::<5>(damped, &mut decays, &derivative);
        let [k1, k3, k4, k5, k6, k7] = &mut self.slopes;
        let weights = B.map(|b| S::constant(b) * h);
        self.before
            .advance(weights, [&*k1, &*k3, &*k4, &*k5, &*k6], &mut self.after);
        last(&self.after, k7);
    }

    /// Takes the stage that comes after `BEFORE` others.
    #[inline(always)]
    fn take_stage<const BEFORE: usize>(
        &mut self,
        damped: &DampedSolve<S, LEGS>,
        decays: &mut [Velocities<S, LEGS>; 6],
        derivative: &impl Fn(&State<S, LEGS>, &mut State<S, LEGS>),
    ) {
        let (explicit, implicit) = (&EXPLICIT[BEFORE - 1], &IMPLICIT[BEFORE - 1]);
        let weights: [S; BEFORE] = std::array::from_fn(|j| S::constant(explicit[j]) * self.length);
        let slopes = std::array::from_fn(|j| &self.slopes[SLOTS[j]]);
        let at = &mut self.stage;
        self.before.advance_motion(weights, slopes, at);
        let pushed = Velocities::of(at).plus(-S::one(), &Velocities::of(&self.before));
        let mut push = pushed;
        for j in 1..BEFORE {
            push = push.plus(S::constant(implicit[j] - explicit[j]), &decays[j]);
        }
        let moved = damped.solve(&push);
        decays[BEFORE] = moved.plus(-S::one(), &push).times(S::constant(1.0 / GAMMA));
        moved.plus(-S::one(), &pushed).add_to(at);
        derivative(at, &mut self.slopes[SLOTS[BEFORE]]);
    }
}
