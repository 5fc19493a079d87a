//! Integration methods by name, with their numbers.

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::method::ERROR_LIMITS;
use touchdown_dynamics::methods::{ErrorControl, ErrorLimits, FixedInterval, Method};
use touchdown_dynamics::quantities::{
    ERROR_SCALE, FIRST_INTERVAL, INTERVAL, LEAST_INTERVAL, TOLERANCE,
};
use touchdown_dynamics::quantity::Quantity;

use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::readers::choice::chosen_by;
use crate::readers::numbers::{self, joined, keys, keys_of};

/// Names of the methods.
pub const METHODS: [&str; 5] = ["located", "report", "rk4", "trapezoidal", "milne"];

/// Methods with error control, and methods with a fixed interval.
const CHECKED: [&str; 2] = ["report", "milne"];
const FIXED: [&str; 2] = ["rk4", "trapezoidal"];

/// Keys of `[solver]` for the method.
pub(crate) const KEYS: [&str; 6] =
    joined(&[&["method", "error_per_second"], &keys_of::<4>(&NUMBERS)]);

/// Numbers of `[solver]` for the method.
pub(crate) const NUMBERS: [Quantity; 4] = [ERROR_SCALE, FIRST_INTERVAL, LEAST_INTERVAL, INTERVAL];

pub(crate) const LIMITS: [&str; 7] = keys(&ERROR_LIMITS);

/// Numbers of a method.
#[derive(Debug, Clone, Copy, Default)]
pub struct MethodNumbers {
    /// Relative tolerance per step: `located`.
    pub tolerance: Option<f64>,
    /// Factor on all error limits: `report`, `milne`.
    pub error_scale: Option<f64>,
    /// First interval, s: `report`, `milne`.
    pub first_interval: Option<f64>,
    /// Least interval, not cut further, s: `report`, `milne`.
    pub least_interval: Option<f64>,
    /// Fixed interval, s: `rk4`, `trapezoidal`.
    pub interval: Option<f64>,
    /// Error limits per second, before scaling: `report`, `milne`.
    pub limits: Option<ErrorLimits>,
}

/// Builds the method with a name, one of [`METHODS`], and numbers.
///
/// # Errors
/// Names the first number that is out of range or not used by the method.
pub fn method(name: &str, numbers: &MethodNumbers) -> Result<Method, Invalid> {
    let used = [
        (TOLERANCE, numbers.tolerance, &["located"][..]),
        (ERROR_SCALE, numbers.error_scale, &CHECKED),
        (FIRST_INTERVAL, numbers.first_interval, &CHECKED),
        (LEAST_INTERVAL, numbers.least_interval, &CHECKED),
        (INTERVAL, numbers.interval, &FIXED),
    ];
    for (quantity, value, users) in used {
        if let (Some(value), false) = (value, users.contains(&name)) {
            let users = users.join(" or ");
            let allowed = format!("only with method {users}; the method is {name}");
            return Err(Invalid::new(quantity.key, value, &allowed));
        }
    }
    let control = || -> Result<ErrorControl, Invalid> {
        let scale =
            (numbers.error_scale).unwrap_or(const { ERROR_SCALE.default_number().unwrap() });
        ERROR_SCALE.check("", scale)?;
        ErrorControl::new(
            numbers.limits.unwrap_or_default().scaled(scale),
            numbers
                .first_interval
                .unwrap_or(ErrorControl::FIRST_INTERVAL),
            numbers
                .least_interval
                .unwrap_or(ErrorControl::LEAST_INTERVAL),
        )
    };
    let fixed = || match numbers.interval {
        Some(seconds) => FixedInterval::new(seconds),
        None => Ok(FixedInterval::default()),
    };
    Ok(match name {
        "report" => Method::Report(control()?),
        "milne" => Method::Milne(control()?),
        "rk4" => Method::RungeKutta(fixed()?),
        "trapezoidal" => Method::Trapezoidal(fixed()?),
        _ => Method::Located,
    })
}

/// Name of a method.
pub fn method_name(method: &Method) -> &'static str {
    match method {
        Method::Located => "located",
        Method::Report(_) => "report",
        Method::RungeKutta(_) => "rk4",
        Method::Trapezoidal(_) => "trapezoidal",
        Method::Milne(_) => "milne",
    }
}

/// A method and its numbers as text.
pub fn method_words(method: &Method, tolerance: f64) -> String {
    let name = method_name(method);
    match method {
        Method::Located => format!("method {name}, tolerance {tolerance:e}"),
        Method::RungeKutta(fixed) | Method::Trapezoidal(fixed) => {
            format!("method {name}, interval {} s", fixed.seconds())
        }
        Method::Report(control) | Method::Milne(control) => {
            let (limits, intervals) = (control.limits(), control.intervals());
            format!(
                "method {name}, link rate error {} deg/s per s, first interval {} s, least {} s",
                rounded(limits.link_rate.to_degrees()),
                intervals.first,
                intervals.least
            )
        }
    }
}

/// Removes rounding errors of a unit conversion.
fn rounded(value: f64) -> f64 {
    let scale = libm::exp10(12.0 - libm::log10(value.abs()).floor());
    (value * scale).round() / scale
}

/// Reads the method of `[solver]`.
pub(crate) fn read(solver: &Section, tolerance: Option<f64>) -> Result<Method, InputError> {
    let name = match solver.optional("method") {
        None => "located",
        Some(found) => chosen_by(&found, &METHODS.map(|name| (name, name)))?,
    };
    let limits = match solver.optional_section("error_per_second", &LIMITS)? {
        None => None,
        Some(table) => Some(numbers::read(&table, &ERROR_LIMITS)?),
    };
    if let (Some(found), false) = (
        solver.optional("error_per_second"),
        matches!(name, "report" | "milne"),
    ) {
        let said = format!("expected to leave it out: method {name} does not use it");
        return Err(found.complain_that(&said));
    }
    let given = MethodNumbers {
        tolerance,
        error_scale: solver.optional_number(ERROR_SCALE.key)?,
        first_interval: solver.optional_number(FIRST_INTERVAL.key)?,
        least_interval: solver.optional_number(LEAST_INTERVAL.key)?,
        interval: solver.optional_number(INTERVAL.key)?,
        limits,
    };
    method(name, &given).map_err(|invalid| solver.complain(&invalid))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_its_method_and_back() {
        for name in METHODS {
            let found = method(name, &MethodNumbers::default()).unwrap();
            assert_eq!(method_name(&found), name);
        }
    }

    #[test]
    fn numbers_go_to_the_methods_that_use_them() {
        let numbers = MethodNumbers {
            error_scale: Some(0.5),
            first_interval: Some(0.0003),
            ..MethodNumbers::default()
        };
        let Ok(Method::Report(control)) = method("report", &numbers) else {
            panic!("no report");
        };
        assert_eq!(control.limits().velocity, 1.0 / 12.0);
        assert_eq!(control.intervals().first, 0.0003);
        let complaint = method("rk4", &numbers).unwrap_err();
        assert_eq!(complaint.quantity, "error_scale");
        assert!(complaint.allowed.contains("report or milne"));
        let numbers = MethodNumbers {
            interval: Some(2.0),
            ..MethodNumbers::default()
        };
        assert_eq!(method("rk4", &numbers).unwrap_err().quantity, "interval_s");
    }
}
