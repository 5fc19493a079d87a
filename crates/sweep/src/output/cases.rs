//! Tables of cases: one landing per row, each of which may change the vehicle and the solver.

mod cells;
mod columns;
mod results;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use serde_json::json;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

pub use cells::{CaseCell, CaseCells};
use columns::{Columns, Given, Row, at, values};
pub use results::{is_table, table};

use crate::fingerprint::fingerprint;
use crate::header::Header;
use crate::input_error::{InputError, Place};
use crate::library::Library;
use crate::resolved_input;
use crate::scene_input::NamedConditions;
use crate::settings_input::solver_in_record;
use crate::vehicle_file::{self, VehicleFile};

/// Columns that every table of cases must have.
pub(crate) const REQUIRED: [&str; 5] = [
    "vertical_velocity_fps",
    "horizontal_velocity_fps",
    "cross_slope_deg",
    "slope_deg",
    "friction",
];
/// Columns that are no parameters: the name of the case, its vehicle file, and a remark that nothing depends on.
pub(crate) const OWN: [&str; 3] = ["case", "vehicle", "note"];

/// A row of a table of cases.
#[derive(Debug, Clone)]
pub struct CaseRow {
    /// What lands.
    pub vehicle: Arc<Vehicle>,
    /// How it touches down.
    pub scene: Scene,
    /// How that is computed.
    pub settings: Settings,
}

/// A table of cases. Of its rows nothing is kept but the cells.
#[derive(Debug)]
pub struct CaseTable {
    cells: Box<dyn CaseCells>,
    columns: Columns,
    vehicles: Vehicles,
    settings: Settings,
    first: CaseRow,
    most_legs: usize,
    /// What determines the results of all rows: the table and the vehicle files that it names by their fingerprints, the
    /// vehicle and the settings of rows that say nothing else.
    pub input: serde_json::Value,
}

/// Reads and checks a whole table. Every key of a case of a scene file may be a column, dotted where it is one of the
/// vehicle or the solver; what a cell leaves empty is that of `vehicle`, of `settings` or the default.
///
/// # Errors
/// Names file, line, row, column and value of the first thing wrong, and what is allowed.
pub fn read(
    path: &Path,
    vehicle: &VehicleFile,
    settings: &Settings,
) -> Result<CaseTable, InputError> {
    parse(path, &Library::Disk.text(path)?, vehicle, settings)
}

fn parse(
    path: &Path,
    text: &str,
    vehicle: &VehicleFile,
    settings: &Settings,
) -> Result<CaseTable, InputError> {
    let place = Place::file(path);
    let (heading, rows) = cells::CsvRows::parse(path, text)?;
    let heading: Vec<&str> = heading.iter().collect();
    let columns = Columns::of(&heading, NamedConditions::default())
        .map_err(|error| error.at(place.line(1)))?;
    if rows.is_empty() {
        return Err(InputError::other(NO_ROWS).at(place));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    CaseTable::new(Box::new(rows), columns, folder, vehicle, settings)
}

const NO_ROWS: &str = "has no rows: expected at least one case";

impl CaseTable {
    /// Checks a whole table with this heading, where `shared` are the conditions of rows that say nothing else.
    ///
    /// # Errors
    /// As [`read`].
    pub fn of_cells(
        heading: &[&str],
        cells: Box<dyn CaseCells>,
        shared: &NamedConditions,
        vehicle: &VehicleFile,
        settings: &Settings,
    ) -> Result<Self, InputError> {
        let columns = Columns::of(heading, *shared)?;
        if cells.is_empty() {
            return Err(InputError::other(NO_ROWS).within("the table of cases"));
        }
        let mut table = Self::new(cells, columns, Path::new(""), vehicle, settings)?;
        table.input["scene"] = resolved_input::scene(shared).into();
        Ok(table)
    }

    fn new(
        cells: Box<dyn CaseCells>,
        columns: Columns,
        folder: &Path,
        vehicle: &VehicleFile,
        settings: &Settings,
    ) -> Result<Self, InputError> {
        let mut vehicles = Vehicles {
            own: vehicle.clone(),
            shared: Arc::new(vehicle.vehicle.clone()),
            files: BTreeMap::new(),
        };
        let (mut first, mut most_legs) = (None, 0);
        for number in 0..cells.len() {
            let row = Row {
                cells: &*cells,
                number,
            };
            let case = vehicles
                .read(row.text(columns.vehicle_file), folder)
                .and_then(|()| case(row, &columns, &vehicles, settings))
                .map_err(|error| cells.at_row(number, error))?;
            most_legs = most_legs.max(case.vehicle.legs().len());
            first.get_or_insert(case);
        }
        let Some(first) = first else {
            return Err(InputError::other(NO_ROWS));
        };
        let files = vehicles.files.iter();
        let files: BTreeMap<&String, String> = files
            .map(|(name, file)| (name, fingerprint(&file.document.source().text)))
            .collect();
        let input = json!({
            "table_of_cases": cells.fingerprint(),
            "vehicle_files": files,
            "vehicle": resolved_input::vehicle(&vehicle.document),
            "solver": solver_in_record(settings, &vehicle.vehicle),
        });
        Ok(Self {
            cells,
            columns,
            vehicles,
            settings: *settings,
            first,
            most_legs,
            input,
        })
    }

    /// Number of rows, at least one.
    #[expect(clippy::len_without_is_empty, reason = "no table is")]
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Number of legs of the vehicle that has the most.
    pub fn most_legs(&self) -> usize {
        self.most_legs
    }

    /// The name of a row, from the column `case`, or else its number.
    pub fn name(&self, row: usize) -> String {
        let name = self.row(row).text(self.columns.name);
        name.unwrap_or_else(|| (row + 1).to_string())
    }

    /// What a row describes.
    ///
    /// # Errors
    /// None: all rows have been checked.
    pub fn case(&self, row: usize) -> Result<CaseRow, InputError> {
        let case = case(self.row(row), &self.columns, &self.vehicles, &self.settings);
        case.map_err(|error| self.cells.at_row(row, error))
    }

    /// The head of the journal of these cases.
    pub fn header(&self, program: &str) -> Header {
        let CaseRow {
            vehicle,
            scene,
            settings,
        } = &self.first;
        let first = (&**vehicle, scene, settings);
        Header::of_cases(self.input.clone(), self.len(), first, program)
    }

    fn row(&self, number: usize) -> Row<'_> {
        Row {
            cells: &*self.cells,
            number,
        }
    }
}

fn case(
    row: Row,
    columns: &Columns,
    vehicles: &Vehicles,
    settings: &Settings,
) -> Result<CaseRow, InputError> {
    let file = row.text(columns.vehicle_file);
    let vehicle = vehicles.with(file.as_deref(), &values(&columns.vehicle, row)?)?;
    let settings = columns.settings(settings, row)?;
    Ok(CaseRow {
        scene: columns.scene(row, &vehicle, &settings)?,
        vehicle,
        settings,
    })
}

/// The vehicles of the rows.
#[derive(Debug)]
struct Vehicles {
    /// The one of rows that name no other.
    own: VehicleFile,
    shared: Arc<Vehicle>,
    files: BTreeMap<String, VehicleFile>,
}

impl Vehicles {
    /// Reads the vehicle file that a row names, unless one before it did.
    fn read(&mut self, name: Option<String>, folder: &Path) -> Result<(), InputError> {
        if let Some(name) = name.filter(|name| !self.files.contains_key(name)) {
            let file = VehicleFile::read_from(&folder.join(&name), Library::Disk)?;
            self.files.insert(name, file);
        }
        Ok(())
    }

    /// The vehicle of this file, or of rows that name none, with these values in place of its own.
    fn with(&self, file: Option<&str>, values: &[Given]) -> Result<Arc<Vehicle>, InputError> {
        let file = file.and_then(|name| self.files.get(name));
        if values.is_empty() && file.is_none() {
            return Ok(Arc::clone(&self.shared));
        }
        let mut document = file.unwrap_or(&self.own).document.clone();
        for one in values {
            let (name, path) = (one.parameter.name(), one.parameter.path());
            vehicle_file::write(&mut document, name, path, one.value.clone())
                .map_err(|error| at(values, &error))?;
        }
        VehicleFile::from_document(document)
            .map(|file| Arc::new(file.vehicle))
            .map_err(|error| at(values, &error))
    }
}

#[cfg(test)]
#[path = "cases_tests.rs"]
mod tests;
