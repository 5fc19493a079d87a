//! Tables of cases: one landing per row, of one vehicle or of one that differs from row to row.

use std::path::Path;
use std::sync::Arc;

use csv::StringRecord;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::vehicle::Vehicle;

use crate::document::Value;
use crate::input_error::{InputError, Place};
use crate::landing_table;
use crate::parameter::Parameter;
use crate::scene_input::{NAMES, NamedConditions};
use crate::vehicle_file::LEGS;
use crate::vehicle_file::VehicleFile;

/// Columns that every table of cases must have.
pub(crate) const REQUIRED: [&str; 6] = [
    "case",
    "vertical_velocity_fps",
    "horizontal_velocity_fps",
    "cross_slope_deg",
    "slope_deg",
    "friction",
];
/// Columns of the attitude, unless it is given in tip form.
pub(crate) const EULER: [&str; 3] = ["pitch_deg", "yaw_deg", "roll_deg"];

/// The cases of a table, in its order.
#[derive(Debug, Clone)]
pub struct Cases {
    /// Their names, from the column `case`.
    pub names: Vec<String>,
    /// Their scenes.
    pub scenes: Vec<Scene>,
    /// Their vehicles: one for all, or one for each.
    vehicles: Vec<Arc<Vehicle>>,
}

impl Cases {
    /// The vehicle of a case.
    pub fn vehicle(&self, case: usize) -> Arc<Vehicle> {
        Arc::clone(&self.vehicles[if self.vehicles.len() == 1 { 0 } else { case }])
    }
}

/// Reads and checks a whole table. Columns named `vehicle.` and a key of the vehicle file hold instead
/// of what it says; other columns that are no touchdown condition are ignored. An empty cell leaves
/// its condition to the default, and a number of the vehicle to its file.
///
/// # Errors
/// Names file, line, row, column and value of the first thing wrong, and what is allowed.
pub fn read(path: &Path, vehicle: &VehicleFile) -> Result<Cases, InputError> {
    let place = Place::file(path);
    let text = std::fs::read_to_string(path)
        .map_err(|error| InputError::other(format!("cannot be read: {error}")).at(place.clone()))?;
    parse(&place, &text, vehicle)
}

fn parse(place: &Place, text: &str, vehicle: &VehicleFile) -> Result<Cases, InputError> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let broken = |error: csv::Error| {
        let place = match error.position() {
            Some(position) => place.line(position.line() as usize),
            None => place.clone(),
        };
        InputError::other(format!("not a table of comma-separated values: {error}")).at(place)
    };
    let heading = reader.headers().map_err(broken)?.clone();
    let on_heading = |error: InputError| error.at(place.line(1));
    check_heading(&heading).map_err(on_heading)?;
    let varied = vehicle_columns(&heading, LEGS).map_err(on_heading)?;

    let mut cases = Cases {
        names: Vec::new(),
        scenes: Vec::new(),
        vehicles: Vec::new(),
    };
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(broken)?;
        let line = record.position().map_or(0, |position| position.line());
        let place = place.line(line as usize).row(index + 1);
        let scene = scene(&heading, &record).map_err(|error| error.at(place.clone()))?;
        cases.scenes.push(scene);
        if !varied.is_empty() {
            let vehicle = vehicle_of(vehicle, &varied, &record);
            cases
                .vehicles
                .push(Arc::new(vehicle.map_err(|error| error.at(place))?));
        }
        cases.names.push(cell(&heading, &record, "case").to_owned());
    }
    if cases.names.is_empty() {
        return Err(
            InputError::other("has no rows: required is at least one case").at(place.clone()),
        );
    }
    if varied.is_empty() {
        cases.vehicles.push(Arc::new(vehicle.vehicle.clone()));
    }
    Ok(cases)
}

/// Columns that hold numbers of the vehicle.
fn vehicle_columns(
    heading: &StringRecord,
    legs: usize,
) -> Result<Vec<(usize, Parameter)>, InputError> {
    let mut varied: Vec<(usize, Parameter)> = Vec::new();
    for (index, name) in heading.iter().enumerate() {
        if !name.starts_with("vehicle.") {
            continue;
        }
        let refuse = |said: &str| Err(InputError::other(format!("column {name}: {said}")));
        let Some(parameter) = Parameter::named(name, legs) else {
            return refuse(&Parameter::unknown(name, legs));
        };
        if varied.iter().any(|(_, known)| *known == parameter) {
            return refuse("is there twice: allowed is once");
        }
        varied.push((index, parameter));
    }
    Ok(varied)
}

/// The vehicle of a row: that of the file, with the values of the row in place of its own.
fn vehicle_of(
    file: &VehicleFile,
    varied: &[(usize, Parameter)],
    record: &StringRecord,
) -> Result<Vehicle, InputError> {
    let mut document = file.document.clone();
    let mut said = Vec::new();
    for (index, parameter) in varied {
        let text = record.get(*index).unwrap_or("");
        if text.is_empty() {
            continue;
        }
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => {
                document.write(parameter.path(), Value::Number(value));
            }
            _ => return Err(InputError::value(parameter.name(), text, "a finite number")),
        }
        said.push(format!("{} = {text}", parameter.name()));
    }
    VehicleFile::from_document(document)
        .map(|file| file.vehicle)
        .map_err(|error| InputError::other(format!("at {}: {error}", said.join(", "))))
}

fn check_heading(heading: &StringRecord) -> Result<(), InputError> {
    let has = |name: &str| heading.iter().any(|column| column == name);
    let attitude: &[&str] = if has("tip_deg") { &[] } else { &EULER };
    if let Some(absent) = REQUIRED.iter().chain(attitude).find(|name| !has(name)) {
        let alike = crate::input_error::nearest(absent, &heading.iter().collect::<Vec<_>>());
        let hint = alike.map_or(String::new(), |name| format!(" (there is a column {name})"));
        let needed = [&REQUIRED[..], attitude].concat().join(", ");
        return Err(InputError::other(format!(
            "column {absent} is missing{hint}: required are {needed}"
        )));
    }
    let twice = NAMES
        .iter()
        .find(|name| heading.iter().filter(|column| column == *name).count() > 1);
    match twice {
        Some(name) => Err(InputError::other(format!(
            "column {name} is there twice: allowed is once"
        ))),
        None => Ok(()),
    }
}

fn cell<'r>(heading: &StringRecord, record: &'r StringRecord, name: &str) -> &'r str {
    let position = heading.iter().position(|column| column == name);
    position.and_then(|index| record.get(index)).unwrap_or("")
}

fn scene(heading: &StringRecord, record: &StringRecord) -> Result<Scene, InputError> {
    let mut conditions = NamedConditions::default();
    for name in NAMES {
        let text = cell(heading, record, name);
        if text.is_empty() {
            continue;
        }
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => conditions.set(name, value),
            _ => return Err(InputError::value(name, text, "a finite number")),
        }
    }
    conditions.scene().map_err(|fault| match fault.value {
        Some(value) => InputError::value(fault.name, value, &fault.allowed),
        None => InputError::missing(fault.name, &fault.allowed),
    })
}

/// The results of all cases as CSV: `case`, then the columns of [`landing_table`].
///
/// # Errors
/// None but those of memory.
pub fn table(names: &[String], landings: &[Landing]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (index, (name, landing)) in names.iter().zip(landings).enumerate() {
        let (columns, values): (Vec<_>, Vec<_>) =
            landing_table::columns(landing).into_iter().unzip();
        if index == 0 {
            writer.write_field("case")?;
            writer.write_record(columns)?;
        }
        writer.write_field(name)?;
        writer.write_record(values.iter().map(landing_table::Cell::to_string))?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

#[cfg(test)]
#[path = "cases_tests.rs"]
mod tests;
