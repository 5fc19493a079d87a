//! Vehicles, touchdowns and settings, each read from TOML text.

use std::path::Path;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyMapping, PySequence, PyString};
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantities::CONDITIONS;
use touchdown_dynamics::quantity::{IfMissing, Quantity};
use touchdown_dynamics::scene::Settings;
use touchdown_dynamics::vehicle;
use touchdown_input::documents::document::{Document, Entry, Node, Value};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::documents::{toml_text, unit};
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::points::parameter::Parameter;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::resolved_input;
use touchdown_input::sweeps::single_landing::{self, Touchdown};

use crate::errors::{Failure, guarded};

/// Vehicles shipped with the package.
const OWN_VEHICLES: [(&str, &str); 5] = [
    (
        "surveyor-table-4-1",
        include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml"),
    ),
    (
        "surveyor-si",
        include_str!("../../../sweeps/vehicles/surveyor-si.toml"),
    ),
    (
        "four-legs",
        include_str!("../../../sweeps/vehicles/four-legs.toml"),
    ),
    (
        "six-legs",
        include_str!("../../../sweeps/vehicles/six-legs.toml"),
    ),
    (
        "apollo-like",
        include_str!("../../../sweeps/vehicles/apollo-like.toml"),
    ),
];
/// Allowed values of a dictionary.
const VALUES: &str = "a number, a text, a list or a dictionary";
/// Longest value quoted in an error, bytes; of a longer one only the type is given.
const LONGEST_TOLD: usize = 80;
/// Greatest nesting of dictionaries and lists: more than any input has, and less than the stack holds. One may contain
/// itself.
const DEEPEST: usize = 32;

/// A document without a file.
fn document(text: &str) -> Result<Document, InputError> {
    Document::parse(Path::new(""), text)
}

/// A vehicle.
#[pyclass(frozen, module = "touchdown._engine")]
#[derive(Debug)]
pub struct Vehicle {
    /// The vehicle file.
    pub file: VehicleFile,
    /// The vehicle, shared.
    pub vehicle: Arc<vehicle::Vehicle>,
}

#[pymethods]
impl Vehicle {
    /// Parses TOML text. `path` is the file named in errors; if empty, none is.
    #[new]
    fn new(text: &str, path: &str) -> Result<Self, Failure> {
        guarded(|| {
            let file = VehicleFile::from_document(Document::parse(Path::new(path), text)?)?;
            let vehicle = Arc::new(file.vehicle.clone());
            Ok::<_, InputError>(Self { file, vehicle })
        })
    }

    /// Name.
    #[getter]
    fn name(&self) -> &str {
        &self.file.name
    }

    /// Number of legs.
    #[getter]
    fn legs(&self) -> usize {
        self.vehicle.leg_count()
    }

    /// The whole vehicle in program units, as JSON.
    fn resolved(&self) -> String {
        resolved_input::vehicle(&self.file.document).to_string()
    }
}

/// Conditions of a touchdown.
#[pyclass(frozen, module = "touchdown._engine")]
#[derive(Debug)]
pub struct Scene(pub Touchdown);

#[pymethods]
impl Scene {
    /// Parses TOML text with the keys of a table `[scene]`.
    #[new]
    fn new(text: &str) -> Result<Self, Failure> {
        guarded(|| Touchdown::from_document(document(text)?).map(Self))
    }

    /// All numbers in program units, with defaults.
    fn resolved(&self) -> Vec<(&'static str, f64)> {
        self.0.conditions().resolved()
    }
}

/// Settings of landings.
#[pyclass(frozen, module = "touchdown._engine")]
#[derive(Debug)]
pub struct Solver(pub Settings);

#[pymethods]
impl Solver {
    /// Parses TOML text with a table `[solver]`.
    #[new]
    fn new(text: &str) -> Result<Self, Failure> {
        guarded(|| single_landing::settings(&document(text)?).map(Self))
    }
}

/// Text of a vehicle shipped with the package.
#[pyfunction]
pub fn own_vehicle(name: &str) -> Option<&'static str> {
    let mut own = OWN_VEHICLES.iter();
    own.find_map(|(known, text)| (*known == name).then_some(*text))
}

/// The TOML text of a vehicle with values of parameters replaced; names start with `vehicle.`. Not yet checked.
#[pyfunction]
pub fn replaced(text: &str, values: Vec<(String, String)>) -> Result<String, Failure> {
    guarded(|| {
        let set = (values.iter()).map(|(name, text)| Assignment::new(name, text));
        let set: Vec<Assignment> = set.collect::<Result<_, _>>()?;
        let document = assignment::vehicle_document(document(text)?, &set)?;
        Ok::<_, InputError>(toml_text::text(document.root()))
    })
}

/// Writes a dictionary as TOML text.
#[pyfunction]
pub fn toml(values: &Bound<PyMapping>) -> PyResult<String> {
    Ok(toml_text::text(&entries(values, "", 0)?))
}

/// Name of a parameter in program units; `None` if there is no such parameter.
#[pyfunction]
pub fn program_name(name: &str) -> Option<String> {
    Parameter::named(name, MOST_LEGS).map(|parameter| parameter.program_name().to_owned())
}

/// Conditions of a touchdown: keys, and what the catalogue says of them.
#[pyfunction]
pub fn conditions() -> Vec<(&'static str, String)> {
    let said = |quantity: &Quantity| {
        let default = match quantity.if_missing {
            IfMissing::Required => String::new(),
            IfMissing::Number(number) => format!("; default {number}"),
            IfMissing::Words(words) => format!("; default {words}"),
        };
        format!("{}; {}{default}", quantity.meaning, quantity.range)
    };
    let conditions = CONDITIONS.iter();
    conditions
        .map(|quantity| (quantity.key, said(quantity)))
        .collect()
}

/// Splits a name into the name without unit, and the unit in words; "1" for pure numbers.
#[pyfunction]
pub fn bare_name_and_unit(name: &str) -> (&str, &'static str) {
    (unit::bare_name_and_unit(name).0, unit::unit(name))
}

/// Name and value of a result in other units.
#[pyfunction]
pub fn in_units(name: &str, value: f64, units: &str) -> PyResult<(String, f64)> {
    let quantity = output_units(units)?.quantity(name);
    Ok((quantity.name().to_owned(), quantity.number(value)))
}

/// Finds units of results by their word.
pub fn output_units(word: &str) -> Result<OutputUnits, Failure> {
    let refuse = || InputError::value("units", format!("{word:?}"), "\"US\" or \"SI\"").into();
    OutputUnits::named(word).ok_or_else(refuse)
}

fn entries(values: &Bound<PyMapping>, path: &str, depth: usize) -> PyResult<Vec<Entry>> {
    let items = values.items()?;
    let entry = |item: Bound<PyAny>| {
        let (key, value): (Bound<PyAny>, Bound<PyAny>) = item.extract()?;
        let Ok(key) = key.extract::<String>() else {
            let complaint = format!("{path}[{}]: expected a text as key", key.repr()?);
            return Err(Failure::from(InputError::other(complaint)).into());
        };
        let path = match path {
            "" => key.clone(),
            above => format!("{above}.{key}"),
        };
        Ok(Entry {
            node: node(&value, &path, depth + 1)?,
            key,
        })
    };
    items.iter().map(entry).collect()
}

fn node(value: &Bound<PyAny>, path: &str, depth: usize) -> PyResult<Node> {
    if depth > DEEPEST {
        let complaint =
            format!("{path}: expected at most {DEEPEST} lists and dictionaries within each other");
        return Err(Failure::from(InputError::other(complaint)).into());
    }
    let refuse = || -> PyResult<Node> {
        let mut said = value.repr()?.to_string();
        if said.contains('\n') || said.len() > LONGEST_TOLD {
            said = format!("a {}", value.get_type().name()?);
        }
        Err(Failure::from(InputError::value(path, said, VALUES)).into())
    };
    let read = if value.is_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>() {
        Value::Number(value.extract()?)
    } else if let Ok(text) = value.cast::<PyString>() {
        Value::Text(text.extract()?)
    } else if let Ok(table) = value.cast::<PyDict>() {
        Value::Table(entries(table.as_mapping(), path, depth)?)
    } else if let Ok(table) = value.cast::<PyMapping>() {
        Value::Table(entries(table, path, depth)?)
    } else if let Ok(list) = value.cast::<PySequence>() {
        let items = list.try_iter()?.enumerate();
        let item = |(index, item): (usize, PyResult<Bound<PyAny>>)| {
            node(&item?, &format!("{path}[{}]", index + 1), depth + 1)
        };
        Value::List(items.map(item).collect::<PyResult<_>>()?)
    } else if let Ok(plain) = value.call_method0("tolist") {
        // Arrays and scalars of NumPy, Series of pandas.
        if plain.is(value) {
            return refuse();
        }
        return node(&plain, path, depth + 1);
    } else if value.hasattr("dtype")? {
        // Arrays of xarray, Series of polars.
        return node(&value.call_method0("to_numpy")?, path, depth + 1);
    } else {
        return refuse();
    };
    Ok(Node {
        line: 1,
        written: String::new(),
        value: read,
    })
}
