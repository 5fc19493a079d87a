//! The columns of a table of cases, and the values of a row in them.

use touchdown_dynamics::methods::Method;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use super::OWN;
use super::cells::{CaseCell, CaseCells};
use crate::documents::document::Value;
use crate::documents::input_error::InputError;
use crate::documents::spelling::did_you_mean;
use crate::points::parameter::{Home, Parameter};
use crate::readers::scene_input::{NamedConditions, required};
use crate::readers::settings_input;

/// A row of a table.
#[derive(Clone, Copy)]
pub(super) struct Row<'r> {
    pub(super) cells: &'r dyn CaseCells,
    pub(super) number: usize,
}

impl<'r> Row<'r> {
    fn cell(self, column: usize) -> CaseCell<'r> {
        self.cells.cell(self.number, column)
    }

    /// Text of a row in a column that is not a parameter.
    pub(super) fn text(self, column: Option<usize>) -> Option<String> {
        match self.cell(column?) {
            CaseCell::Empty => None,
            said => Some(said.to_string()),
        }
    }
}

/// Meaning of the columns of a table.
#[derive(Debug, Clone)]
pub(super) struct Columns {
    pub(super) name: Option<usize>,
    pub(super) vehicle_file: Option<usize>,
    pub(super) vehicle: Vec<(usize, Parameter)>,
    scene: Vec<(usize, Parameter)>,
    /// Default conditions of the rows.
    shared: NamedConditions,
    solver: Vec<(usize, Parameter)>,
}

impl Columns {
    pub(super) fn of(heading: &[&str], shared: NamedConditions) -> Result<Self, InputError> {
        let place = |own: &str| heading.iter().position(|name| *name == own);
        let [name, vehicle_file, _] = OWN.map(place);
        let mut columns = Self {
            name,
            vehicle_file,
            vehicle: Vec::new(),
            scene: Vec::new(),
            shared,
            solver: Vec::new(),
        };
        for (index, name) in heading.iter().enumerate() {
            if heading[..index].contains(name) {
                let said = format!("column {name} is there twice: expected once");
                return Err(InputError::other(said));
            }
            if OWN.contains(name) {
                continue;
            }
            let parameter = Parameter::named(name, MOST_LEGS).filter(|known| known.name() == *name);
            let Some(parameter) = parameter else {
                return Err(InputError::other(unknown(name)));
            };
            let same_kind = match parameter.home() {
                Home::Scene => &mut columns.scene,
                Home::Vehicle => &mut columns.vehicle,
                Home::Sweep if name.starts_with("solver.") => &mut columns.solver,
                Home::Sweep => return Err(InputError::other(unknown(name))),
            };
            if let Some((_, before)) = same_kind.iter().find(|(_, before)| *before == parameter) {
                let before = before.name();
                let said =
                    format!("columns {before} and {name}: expected one spelling of a quantity");
                return Err(InputError::other(said));
            }
            same_kind.push((index, parameter));
        }
        let has = |name: &str| {
            let mut given = columns.scene.iter();
            shared.get(name).is_some() || given.any(|(_, one)| one.program_name() == name)
        };
        let required: Vec<&str> = required().map(|quantity| quantity.key).collect();
        match required.iter().find(|name| !has(name)) {
            Some(absent) => Err(InputError::other(format!(
                "column {absent} is missing: expected {}",
                required.join(", ")
            ))),
            None => Ok(columns),
        }
    }

    /// Builds the scene of a row, for a vehicle and settings.
    pub(super) fn scene(
        &self,
        row: Row,
        vehicle: &Vehicle,
        settings: &Settings,
    ) -> Result<Scene, InputError> {
        let mut conditions = self.shared;
        let given = values(&self.scene, row)?;
        for Given {
            parameter, value, ..
        } in &given
        {
            if let Value::Number(number) = value {
                conditions.set(parameter.program_name(), *number);
            }
        }
        conditions.scene_for(vehicle, settings).map_err(|fault| {
            let said = |one: &&Given| one.parameter.program_name() == fault.name;
            match (fault.value, given.iter().find(said)) {
                (
                    Some(_),
                    Some(Given {
                        parameter, cell, ..
                    }),
                ) => InputError::value(parameter.name(), cell, &parameter.allowed(&fault)),
                _ => fault.error(),
            }
        })
    }

    /// Settings of a row: those given, replaced by the row's values.
    pub(super) fn settings(&self, given: &Settings, row: Row) -> Result<Settings, InputError> {
        let values = values(&self.solver, row)?;
        if values.is_empty() {
            return Ok(*given);
        }
        if given.method() != Method::Located {
            let said = "solver.… columns and --method exclude each other: write solver.method here";
            return Err(InputError::other(said));
        }
        let replaced = values.iter().map(|one| (one.parameter.path(), &one.value));
        settings_input::settings_with(given, replaced).map_err(|error| at(&values, &error))
    }
}

/// Error for an unknown column name.
fn unknown(name: &str) -> String {
    let mut alike = Parameter::nearest(name, MOST_LEGS);
    alike.retain(|name| !name.starts_with("search.") && !name.starts_with("scene."));
    let guess = did_you_mean(&alike);
    format!(
        "column {name}: no such column; {guess}expected {}, keys of the scene, and dotted keys of the vehicle and the \
         solver, such as vehicle.strut.compression_damping; for remarks there is the column note",
        OWN.join(", ")
    )
}

/// A parameter with its cell in a row, as written and as a value.
pub(super) struct Given<'r> {
    pub(super) parameter: &'r Parameter,
    cell: CaseCell<'r>,
    pub(super) value: Value,
}

/// Values of a row for these parameters.
pub(super) fn values<'r>(
    columns: &'r [(usize, Parameter)],
    row: Row<'r>,
) -> Result<Vec<Given<'r>>, InputError> {
    let said = columns.iter().filter_map(|(column, parameter)| {
        let cell = row.cell(*column);
        let value = match cell {
            CaseCell::Empty => return None,
            CaseCell::Number(number) => parameter.number(number),
            CaseCell::Text(text) => parameter.value(text),
        };
        Some(value.map(|value| Given {
            parameter,
            cell,
            value,
        }))
    });
    said.collect()
}

/// Adds these values to the error that they caused.
pub(super) fn at(values: &[Given], error: &InputError) -> InputError {
    let said: Vec<String> = (values.iter())
        .map(|one| format!("{} = {}", one.parameter.name(), one.cell))
        .collect();
    InputError::other(format!("at {}: {error}", said.join(", ")))
}
