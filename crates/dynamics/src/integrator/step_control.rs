//! Step size from error: a proportional-integral controller.
//!
//! K. Gustafsson, "Control-theoretic techniques for stepsize selection in explicit Runge-Kutta
//! methods", ACM Trans. Math. Softw. 17 (1991) 533-554; constants as in Hairer, Nørsett and
//! Wanner's DOPRI5, with a little more safety.

const SAFETY: f64 = 0.88;
const INTEGRAL: f64 = 0.04;
const LEAST_FACTOR: f64 = 0.2;
const GREATEST_FACTOR: f64 = 5.0;
/// Binary logarithm of 1e-4, the smallest error of a step that is remembered.
const SMALL_ERROR: f64 = -13.287_712_379_549_45;
/// Longest step, s: a step must not outgrow what three samples of the signals show.
pub const LONGEST: f64 = 0.02;
/// Step below which time no longer advances, s.
pub const SHORTEST: f64 = 1e-14;

/// The controller's memory.
#[derive(Debug, Clone, Copy)]
pub struct StepControl {
    proposed: f64,
    /// Binary logarithm of the last good step's error in units of the tolerance.
    last_error: f64,
    rejected: bool,
}

impl StepControl {
    /// A controller that proposes `first` seconds.
    pub fn new(first: f64) -> Self {
        Self {
            proposed: first.min(LONGEST),
            last_error: SMALL_ERROR,
            rejected: false,
        }
    }

    /// Length of the next step to try, s.
    pub fn proposed(&self) -> f64 {
        self.proposed
    }

    /// Notes a tried step with error `norm` in units of the tolerance, which falls as the step to the power `order`.
    /// Returns true if the step is good enough.
    #[inline(always)]
    pub fn accept(&mut self, length: f64, norm: f64, order: f64) -> bool {
        let proportional = 1.0 / order - 0.75 * INTEGRAL;
        if norm <= 1.0 {
            let error = log2(norm.max(1e-8));
            let correction = INTEGRAL * self.last_error - proportional * error;
            let factor = (SAFETY * exp2(correction)).clamp(
                LEAST_FACTOR,
                if self.rejected { 1.0 } else { GREATEST_FACTOR },
            );
            self.proposed = (length * factor).min(LONGEST);
            self.last_error = error.max(SMALL_ERROR);
            self.rejected = false;
            true
        } else {
            // A norm that is not finite shrinks the step as far as it goes.
            let factor = if norm.is_finite() {
                SAFETY * exp2(-proportional * log2(norm))
            } else {
                LEAST_FACTOR
            };
            self.proposed = length * factor.max(LEAST_FACTOR);
            self.rejected = true;
            false
        }
    }

    /// Notes that a good step ended before the `whole` length (s) that its error would have allowed, so the next one
    /// need not be shorter.
    pub fn keep(&mut self, whole: f64) {
        self.proposed = self.proposed.max(whole);
    }

    /// Notes an event after which other laws hold.
    pub fn restart(&mut self) {
        self.last_error = SMALL_ERROR;
        self.rejected = false;
    }
}

// A step size needs no exact logarithm, and the whole next step waits for it. A number's own exponent and mantissa are
// its logarithm but for a bow over each octave (J. N. Mitchell, IRE Trans. EC-11 (1962) 512-517), which a parabola
// straightens.

const MANTISSA: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
const OCTAVE: f64 = (MANTISSA + 1) as f64;
const ONE: u64 = 1.0_f64.to_bits();
/// Height of the bow over its ends, times four.
const BOW: f64 = 0.336;

/// Fraction of its octave at which a positive number with these bits lies, 0 to 1.
#[inline(always)]
fn fraction(bits: u64) -> f64 {
    f64::from_bits((bits & MANTISSA) | ONE) - 1.0
}

/// Binary logarithm of a positive finite number, to within 0.01.
#[inline(always)]
fn log2(x: f64) -> f64 {
    let f = fraction(x.to_bits());
    let chord = (x.to_bits() as i64 - ONE as i64) as f64 / OCTAVE;
    chord + BOW * f * (1.0 - f)
}

/// 2^x to within 0.4 %, for exponents between -1022 and 1023.
#[inline(always)]
fn exp2(x: f64) -> f64 {
    let bits = (x * OCTAVE) as i64 + ONE as i64;
    let f = fraction(bits as u64);
    f64::from_bits(bits as u64 & !MANTISSA) * (1.0 + f - BOW * f * (1.0 - f))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithm_and_power_are_as_near_as_stated() {
        for k in -40_000..40_000 {
            let x = f64::from(k) / 1000.0;
            let exact = libm::exp2(x);
            assert!((log2(exact) - x).abs() < 0.01, "log2 {exact}");
            assert!((exp2(x) / exact - 1.0).abs() < 0.004, "2^{x}");
        }
    }

    #[test]
    fn a_norm_that_is_no_number_shrinks_the_step_as_far_as_it_goes() {
        for norm in [f64::NAN, f64::INFINITY, f64::MAX] {
            let mut control = StepControl::new(1e-3);
            assert!(!control.accept(1e-3, norm, 5.0));
            assert_eq!(control.proposed(), 1e-3 * LEAST_FACTOR);
        }
    }
}
