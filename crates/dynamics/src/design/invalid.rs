//! The one error of this crate: a value that is not valid for any lander or landing.

use std::fmt;

/// A quantity outside its allowed range.
#[derive(Debug, Clone, PartialEq)]
pub struct Invalid {
    /// The quantity, in the words of the input files, with its unit: `mass_slug`.
    pub quantity: String,
    /// The offending value.
    pub value: f64,
    /// The allowed range.
    pub allowed: String,
}

impl Invalid {
    /// States that `quantity` may not be `value`, with the range `allowed`.
    pub fn new(quantity: impl Into<String>, value: f64, allowed: impl Into<String>) -> Self {
        Self {
            quantity: quantity.into(),
            value,
            allowed: allowed.into(),
        }
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} = {}: expected {}",
            self.quantity, self.value, self.allowed
        )
    }
}

impl std::error::Error for Invalid {}

/// Returns `Ok(value)` if it is finite and `test` holds for it.
pub(crate) fn require(
    quantity: &str,
    value: f64,
    allowed: &str,
    test: impl Fn(f64) -> bool,
) -> Result<f64, Invalid> {
    if value.is_finite() && test(value) {
        Ok(value)
    } else {
        Err(Invalid::new(quantity, value, allowed))
    }
}
