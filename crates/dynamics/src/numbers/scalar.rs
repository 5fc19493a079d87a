//! The number type of the equations of motion.
//!
//! The right-hand side is written once over [`Real`] and holds no branch, so the same code can be
//! instantiated for one landing (`f64`) or for several landings in the lanes of one register.

use std::ops::Neg;

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign};
use num_traits::{One, Zero};

/// Arithmetic of the equations of motion.
pub trait Real:
    nalgebra::Scalar
    + Copy
    + Zero
    + One
    + Neg<Output = Self>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
{
    /// Number of lanes, each with its own number.
    const LANES: usize;

    /// Call in every round of a loop over such numbers. Keeps the compiler from combining rounds in the lanes of a
    /// register where each number fills one by itself.
    #[inline(always)]
    fn keep_rounds_apart() {}

    /// Returns the same numbers. Keeps the compiler from splitting the lanes of one number to fit those of another: it
    /// forms registers by following sums back from their stores, but only about a dozen operations far.
    #[inline(always)]
    fn keep_lanes_together<T>(numbers: T) -> T {
        numbers
    }

    /// The same constant in every lane.
    fn constant(value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// The greater of two numbers; `self` if `other` is NaN.
    fn max(self, other: Self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// `magnitude` with the sign of `self` (of +1 where `self` is 0), for `magnitude` ≥ 0.
    fn signed_like(self, magnitude: Self) -> Self;
    /// `below` where `self` < 0, else `above`.
    fn where_negative(self, below: Self, above: Self) -> Self;
    /// `at_zero` where `self` is 0, else `elsewhere`.
    fn where_zero(self, at_zero: Self, elsewhere: Self) -> Self;
    /// Nearest whole number.
    fn round(self) -> Self;
    /// Returns whether no lane is farther from 0 than `limit`.
    fn is_within(self, limit: f64) -> bool;
    /// e to this power, number by number; for rare use.
    fn exp(self) -> Self;
    /// `even` where `self`, a whole number, is even, else `odd`.
    fn by_parity(self, even: Self, odd: Self) -> Self;

    /// Sine and cosine, to within 5e-16 for angles up to a thousand turns.
    ///
    /// Uses no platform library, so that a landing comes out the same, bit for bit, everywhere. Reduction to
    /// [-π/2, π/2] by three-part π after Cody and Waite, skipped where it changes no bit; then polynomials in the
    /// square, summed in pairs after Estrin, so that no term waits for the previous one.
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        if self.is_within(REDUCED) {
            return self.reduced_sin_cos();
        }
        let half_turns = (self * Self::constant(std::f64::consts::FRAC_1_PI)).round();
        let reduced = PI_PARTS
            .iter()
            .fold(self, |x, &part| x - half_turns * Self::constant(part));
        let (sine, cosine) = reduced.reduced_sin_cos();
        let sign = half_turns.by_parity(Self::one(), -Self::one());
        (sign * sine, sign * cosine)
    }

    /// Sine and cosine of an angle in [-π/2, π/2].
    #[inline(always)]
    fn reduced_sin_cos(self) -> (Self, Self) {
        let reduced = self;
        let square = reduced * reduced;
        let fourth = square * square;
        let eighth = fourth * fourth;
        let powers = [square, fourth, eighth];
        let sine = reduced + reduced * square * polynomial(&SINE, powers);
        let cosine = Self::one() + square * polynomial(&COSINE, powers);
        (sine, cosine)
    }
}

/// A polynomial, highest power first, from the first, second and fourth power of its variable.
#[inline(always)]
fn polynomial<S: Real>(c: &[f64; 8], [first, second, fourth]: [S; 3]) -> S {
    let pair = |k: usize| S::constant(c[k]) * first + S::constant(c[k + 1]);
    (pair(0) * second + pair(2)) * fourth + (pair(4) * second + pair(6))
}

/// Angle up to which no reduction is needed.
const REDUCED: f64 = 1.57;
/// π in parts, the first two short enough for exact products with whole numbers up to 2²².
const PI_PARTS: [f64; 3] = [
    3.141592651605606,
    1.9841871583270443e-9,
    1.034036596358821e-18,
];
/// (sin √z / √z − 1)/z and (cos √z − 1)/z on [0, π²/4], highest power first: Chebyshev fits with
/// errors of 4e-19 and 7e-18.
const SINE: [f64; 8] = [
    2.7311250130212627e-15,
    -7.643944600682418e-13,
    1.605897650599992e-10,
    -2.5052107604532307e-08,
    2.7557319219065165e-06,
    -0.0001984126984125461,
    0.008333333333333316,
    -0.16666666666666666,
];
const COSINE: [f64; 8] = [
    4.627070242373187e-14,
    -1.1464641206354425e-11,
    2.0876629339615696e-09,
    -2.755731774370793e-07,
    2.480158729226042e-05,
    -0.0013888888888860021,
    0.041666666666666324,
    -0.5,
];

impl Real for f64 {
    const LANES: usize = 1;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // A comparison instead of `f64::max`, of which LLVM 22.1 loses terms in some loops.
        if other > self { other } else { self }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline(always)]
    fn signed_like(self, magnitude: Self) -> Self {
        magnitude.copysign(self)
    }

    #[inline(always)]
    fn where_negative(self, below: Self, above: Self) -> Self {
        if self < 0.0 { below } else { above }
    }

    #[inline(always)]
    fn where_zero(self, at_zero: Self, elsewhere: Self) -> Self {
        if self == 0.0 { at_zero } else { elsewhere }
    }

    #[inline(always)]
    fn round(self) -> Self {
        // Adding and taking away 1.5·2⁵² rounds to nearest without a library call.
        const SHIFTER: f64 = 6_755_399_441_055_744.0;
        (self + SHIFTER) - SHIFTER
    }

    #[inline(always)]
    fn is_within(self, limit: f64) -> bool {
        self.abs() <= limit
    }

    fn exp(self) -> Self {
        libm::exp(self)
    }

    #[inline(always)]
    fn by_parity(self, even: Self, odd: Self) -> Self {
        let half = 0.5 * self;
        let odds = 2.0 * (half - Real::round(half)).abs();
        even + odds * (odd - even)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_and_cosine_agree_with_the_library() {
        let mut worst: f64 = 0.0;
        for k in -400_000..400_000 {
            let x = f64::from(k) * 0.0157 + 1e-7 * f64::from(k % 1000);
            let (sine, cosine) = Real::sin_cos(x);
            worst = worst
                .max((sine - x.sin()).abs())
                .max((cosine - x.cos()).abs());
        }
        assert!(worst < 5e-16, "{worst:e}");
    }
}
