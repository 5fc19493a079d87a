//! Values set on the command line: `vehicle.strut.preload_lb=200`, with the names that axes have.

use crate::documents::document::{Document, Value};
use crate::documents::input_error::InputError;
use crate::documents::key_path::KeyPath;
use crate::points::parameter::{Home, Parameter};
use crate::readers::scene_input::NamedConditions;
use crate::readers::vehicle_file::{self, VehicleFile};
use touchdown_dynamics::per_leg::MOST_LEGS;

/// A parameter and the value that replaces the one in the input files.
#[derive(Debug, Clone)]
pub struct Assignment {
    parameter: Parameter,
    text: String,
    value: Value,
}

impl Assignment {
    /// Parses `KEY=VALUE`.
    ///
    /// # Errors
    /// Names an unknown key with similar ones, or a value that is neither a finite number nor one of the parameter's
    /// words.
    pub fn parse(text: &str) -> Result<Self, InputError> {
        let Some((name, value)) = text.split_once('=') else {
            return Err(InputError::other("expected KEY=VALUE"));
        };
        Self::new(name.trim(), value.trim())
    }

    /// Sets the parameter `name` to the value in `text`.
    ///
    /// # Errors
    /// See [`Assignment::parse`].
    pub fn new(name: &str, text: &str) -> Result<Self, InputError> {
        let Some(parameter) = Parameter::named(name, MOST_LEGS) else {
            let complaint = Parameter::unknown(name, MOST_LEGS);
            return Err(InputError::other(format!("{name} = {text}: {complaint}")));
        };
        let value = parameter.value(text)?;
        Ok(Self {
            parameter,
            text: text.to_owned(),
            value,
        })
    }

    /// The parameter set.
    pub fn parameter(&self) -> &Parameter {
        &self.parameter
    }

    /// True for a key of `[solver]`.
    pub fn is_of_solver(&self) -> bool {
        self.parameter.program_name().starts_with("solver.")
    }

    /// The value as typed.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Error that this assignment is not possible.
    pub fn refuse(&self, complaint: &str) -> InputError {
        let name = self.parameter.name();
        InputError::other(format!("--set {name}={}: {complaint}", self.text))
    }

    /// Error that the value is not `allowed`, which is in program units.
    pub fn refuse_value(&self, allowed: &str) -> InputError {
        let allowed = match self.text.parse() {
            Ok(number) => self.parameter.explain(allowed, number),
            Err(_) => allowed.to_owned(),
        };
        self.refuse(&format!("expected {allowed}"))
    }

    /// Key within the parameter's part of the input.
    pub fn path(&self) -> &KeyPath {
        self.parameter.path()
    }

    /// The value in program units.
    pub fn value(&self) -> Value {
        self.value.clone()
    }
}

/// Checks that no parameter is set twice.
///
/// # Errors
/// Names the second assignment.
pub fn check_once(set: &[Assignment]) -> Result<(), InputError> {
    for (index, one) in set.iter().enumerate() {
        let before = &set[..index];
        if before.iter().any(|other| other.parameter == one.parameter) {
            return Err(one.refuse("set twice: expected once"));
        }
    }
    Ok(())
}

/// Sets the conditions of a touchdown.
pub fn set_conditions(conditions: &mut NamedConditions, set: &[Assignment]) {
    for one in set {
        if let (Home::Scene, Value::Number(number)) = (one.parameter.home(), &one.value) {
            conditions.set(one.parameter.program_name(), *number);
        }
    }
}

/// The document of a vehicle with set values in place of its own, not yet read.
///
/// # Errors
/// If the vehicle has no such leg.
pub fn vehicle_document(
    mut document: Document,
    set: &[Assignment],
) -> Result<Document, InputError> {
    let of_vehicle = (set.iter()).filter(|one| one.parameter.home() == Home::Vehicle);
    for one in of_vehicle {
        vehicle_file::write(
            &mut document,
            one.parameter().name(),
            one.path(),
            one.value(),
        )?;
    }
    Ok(document)
}

/// The vehicle with set values in place of those in its file.
///
/// # Errors
/// If the result is not a valid vehicle.
pub fn set_vehicle(file: &VehicleFile, set: &[Assignment]) -> Result<VehicleFile, InputError> {
    let of_vehicle = || (set.iter()).filter(|one| one.parameter.home() == Home::Vehicle);
    let said = || {
        let said = of_vehicle().map(|one| format!("{}={}", one.parameter.name(), one.text));
        said.collect::<Vec<_>>().join(" --set ")
    };
    vehicle_document(file.document.clone(), set)
        .and_then(VehicleFile::from_document)
        .map_err(|error| InputError::other(format!("--set {}: {error}", said())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_words_are_set_by_the_names_of_axes() {
        let preload = Assignment::parse("vehicle.strut.preload_lb=200").unwrap();
        assert_eq!(preload.parameter().name(), "vehicle.strut.preload_lb");
        assert!(matches!(preload.value(), Value::Number(200.0)));
        let preload = Assignment::parse("vehicle.strut.preload_n=444.82216152605").unwrap();
        assert_eq!(preload.parameter().name(), "vehicle.strut.preload_n");
        assert!(matches!(preload.value(), Value::Number(100.0)));
        let slope = Assignment::parse("scene.slope_deg = -5").unwrap();
        assert_eq!(slope.parameter().name(), "slope_deg");
        let rule = Assignment::parse("solver.crush_rule=section").unwrap();
        assert!(matches!(rule.value(), Value::Text(word) if word == "section"));
    }

    #[test]
    fn what_cannot_be_set_is_named() {
        for (text, fragment) in [
            ("slope_deg", "KEY=VALUE"),
            ("slop_deg=5", "did you mean slope_deg?"),
            ("vehicle.strut.preload=5", "vehicle.strut.preload_lb"),
            (
                "slope_deg=steep",
                "slope_deg = steep: expected a finite number",
            ),
            ("slope_deg=nan", "a finite number"),
            ("solver.crush_rule=soft", "one of pivot-rate, section"),
        ] {
            let complaint = Assignment::parse(text).unwrap_err().to_string();
            assert!(complaint.contains(fragment), "{complaint}");
        }
    }
}
