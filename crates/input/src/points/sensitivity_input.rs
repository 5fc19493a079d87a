//! Reads the parameters of sensitivities: the table `[sensitivity]`, or the names that replace it.

use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::points::parameter::{Home, Parameter};
use crate::readers::scene_input::HORIZONTAL_VELOCITY;

pub(crate) const SENSITIVITY: [&str; 1] = ["parameters"];
const ALLOWED: &str = "a list of dotted names, such as \"vehicle.strut.compression_damping\"";

/// Reads `[sensitivity]`; returns no parameters without it.
pub(crate) fn parameters(root: &Section, legs: usize) -> Result<Vec<Parameter>, InputError> {
    let Some(section) = root.optional_section("sensitivity", &SENSITIVITY)? else {
        return Ok(Vec::new());
    };
    let list = section.value("parameters", ALLOWED)?;
    let mut parameters = Vec::new();
    for item in list.items(ALLOWED)? {
        add(&mut parameters, item.text()?, legs).map_err(|said| item.complain_that(&said))?;
    }
    match parameters.is_empty() {
        true => Err(list.complain("a list of at least one name")),
        false => Ok(parameters),
    }
}

/// Finds the parameters of names that override those of the file.
///
/// # Errors
/// Names the first unusable one.
pub(crate) fn named(names: &[String], legs: usize) -> Result<Vec<Parameter>, InputError> {
    let mut parameters = Vec::new();
    for name in names {
        add(&mut parameters, name, legs)
            .map_err(|said| InputError::other(format!("--sensitivity {name}: {said}")))?;
    }
    Ok(parameters)
}

fn add(parameters: &mut Vec<Parameter>, name: &str, legs: usize) -> Result<(), String> {
    let Some(parameter) = Parameter::named(name, legs) else {
        return Err(Parameter::unknown(name, legs));
    };
    if parameter.program_name() == HORIZONTAL_VELOCITY {
        return Err("the search varies it: expected another parameter".to_owned());
    }
    if parameter.home() == Home::Sweep {
        let complaint = "not a property of the vehicle or the touchdown: expected keys of the scene \
                         and dotted keys of the vehicle";
        return Err(complaint.to_owned());
    }
    if parameters.contains(&parameter) {
        return Err("listed twice: expected once".to_owned());
    }
    parameters.push(parameter);
    Ok(())
}
