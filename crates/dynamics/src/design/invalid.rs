//! The one error of this crate: a value that no lander or landing can have.

use std::fmt;

/// A quantity outside its allowed range.
#[derive(Debug, Clone, PartialEq)]
pub struct Invalid {
    /// The quantity, in the words of the input files, with its unit: `mass_slug`.
    pub quantity: String,
    /// The offending value.
    pub value: f64,
    /// What is allowed.
    pub allowed: String,
}

impl Invalid {
    /// States that `quantity` may not be `value`, only what `allowed` says.
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

/// `Ok(value)` when it is finite and `test` holds for it.
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

/// No number of a lander is greater than this, whatever its unit: what follows from such numbers stays finite.
const GREATEST: f64 = 1e9;

/// `Ok(value)` when it is greater than zero and no greater than any number of a lander.
pub(crate) fn positive(quantity: &str, value: f64) -> Result<f64, Invalid> {
    require(quantity, value, "0 < value ≤ 1e9", |v| {
        v > 0.0 && v <= GREATEST
    })
}

/// `Ok(value)` when it is not below zero and no greater than any number of a lander.
pub(crate) fn non_negative(quantity: &str, value: f64) -> Result<f64, Invalid> {
    require(quantity, value, "0 ≤ value ≤ 1e9", |v| {
        (0.0..=GREATEST).contains(&v)
    })
}

/// `Ok(value)` when its magnitude is no greater than that of any number of a lander.
pub(crate) fn bounded(quantity: &str, value: f64) -> Result<f64, Invalid> {
    require(quantity, value, "-1e9 ≤ value ≤ 1e9", |v| {
        v.abs() <= GREATEST
    })
}
