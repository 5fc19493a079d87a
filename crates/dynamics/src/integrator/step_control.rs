//! Step size from error: a proportional-integral controller.
//!
//! K. Gustafsson, "Control-theoretic techniques for stepsize selection in explicit Runge-Kutta
//! methods", ACM Trans. Math. Softw. 17 (1991) 533-554; constants as in Hairer, Nørsett and
//! Wanner's DOPRI5.

use libm::{exp, log, pow};

const SAFETY: f64 = 0.9;
const INTEGRAL: f64 = 0.04;
const PROPORTIONAL: f64 = 0.2 - 0.75 * INTEGRAL;
const LEAST_FACTOR: f64 = 0.2;
const GREATEST_FACTOR: f64 = 5.0;
/// Natural logarithm of 1e-4: no smaller error of a step is remembered.
const SMALL_ERROR: f64 = -9.210_340_371_976_182;
/// No step is longer than this, s: a step cannot outgrow what its three looks at the signals see.
pub const LONGEST: f64 = 0.02;
/// Below this the time no longer advances, s.
pub const SHORTEST: f64 = 1e-14;

/// The controller's memory.
#[derive(Debug, Clone, Copy)]
pub struct StepControl {
    proposed: f64,
    /// Natural logarithm of the last good step's error in units of the tolerance.
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

    /// Takes note of a tried step with error `norm` in units of the tolerance; true when the step
    /// is good enough.
    pub fn accept(&mut self, length: f64, norm: f64) -> bool {
        if norm <= 1.0 {
            let error = log(norm.max(1e-8));
            let correction = INTEGRAL * self.last_error - PROPORTIONAL * error;
            let factor = (SAFETY * exp(correction)).clamp(
                LEAST_FACTOR,
                if self.rejected { 1.0 } else { GREATEST_FACTOR },
            );
            self.proposed = (length * factor).min(LONGEST);
            self.last_error = error.max(SMALL_ERROR);
            self.rejected = false;
            true
        } else {
            // A norm that is not a number shrinks the step as far as it goes.
            let factor = SAFETY * pow(norm, -PROPORTIONAL);
            let factor = if factor > LEAST_FACTOR {
                factor
            } else {
                LEAST_FACTOR
            };
            self.proposed = length * factor;
            self.rejected = true;
            false
        }
    }

    /// Takes note of an event after which the motion goes on under other laws.
    pub fn restart(&mut self) {
        self.last_error = SMALL_ERROR;
        self.rejected = false;
    }
}
