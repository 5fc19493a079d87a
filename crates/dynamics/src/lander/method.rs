//! Methods of integration to choose from.

use super::error_control::ErrorControl;
use crate::invalid::Invalid;
use crate::quantities::INTERVAL;

/// Method of integrating the equations of motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Method {
    /// Every change of a law is located in time: module `landing`.
    #[default]
    Located,
    /// The report's step doubling.
    Report(ErrorControl),
    /// Runge-Kutta of order 4 at a fixed interval.
    RungeKutta(FixedInterval),
    /// Trapezoidal at a fixed interval.
    Trapezoidal(FixedInterval),
    /// Milne's predictor and corrector.
    Milne(ErrorControl),
}

/// A checked fixed interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedInterval(f64);

impl FixedInterval {
    /// Checks an interval, s.
    ///
    /// # Errors
    /// It must lie in [1e-6, 1] s.
    pub fn new(seconds: f64) -> Result<Self, Invalid> {
        INTERVAL.check("", seconds)?;
        Ok(Self(seconds))
    }

    /// The interval, s.
    pub fn seconds(self) -> f64 {
        self.0
    }
}

impl Default for FixedInterval {
    /// That of section 4.1.2.
    fn default() -> Self {
        Self(const { INTERVAL.default_number().unwrap() })
    }
}
