//! Tables of cases: one landing per row; each row may change the vehicle and the solver.

mod cells;
mod columns;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;
use serde_json::json;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

pub use cells::{CaseCell, CaseCells};
use columns::{Columns, Given, Row, at, values};

use crate::documents::fingerprint::fingerprint;
use crate::documents::input_error::{InputError, Place};
use crate::documents::library::Library;
use crate::readers::scene_input::NamedConditions;
use crate::readers::settings_input::solver_in_record;
use crate::readers::vehicle_file::{self, VehicleFile};
use crate::sweeps::resolved_input;
use crate::sweeps::sweep_file::VEHICLE;

/// Columns that are not parameters: the name of the case, its vehicle file, and a remark without effect.
pub(crate) const OWN: [&str; 3] = ["case", "vehicle", "note"];

/// A row of a table of cases.
#[derive(Debug, Clone)]
pub struct CaseRow {
    /// The vehicle.
    pub vehicle: Arc<Vehicle>,
    /// The touchdown.
    pub scene: Scene,
    /// Settings of the landing.
    pub settings: Settings,
}

/// A table of cases. Only the cells of its rows are kept.
#[derive(Debug)]
pub struct CaseTable {
    cells: Box<dyn CaseCells>,
    columns: Columns,
    vehicles: Vehicles,
    settings: Settings,
    first: CaseRow,
    most_legs: usize,
    /// Everything that determines the results: fingerprints of the table and of its vehicle files, and the default
    /// vehicle and settings.
    pub input: serde_json::Value,
}

/// Reads and checks a whole table. Columns may be all keys of a case of a scene file, dotted for the vehicle and the
/// solver. Empty cells take their values from `vehicle`, from `settings` or the defaults.
///
/// # Errors
/// Names file, line, row, column and value of the first fault, and the allowed values.
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
    let never = AtomicBool::new(false);
    CaseTable::new(Box::new(rows), columns, folder, vehicle, settings, &never)
}

/// Rows that are checked together: between these the check can be cancelled.
const CHECKED_TOGETHER: usize = 1024;

const NO_ROWS: &str = "has no rows: expected at least one case";

impl CaseTable {
    /// Checks the heading of a table without rows; `shared` are the default conditions.
    ///
    /// # Errors
    /// Names the first column that is unknown, there twice or missing.
    pub fn check_heading(heading: &[&str], shared: &NamedConditions) -> Result<(), InputError> {
        Columns::of(heading, *shared).map(drop)
    }

    /// Checks a whole table with this heading; `shared` are the default conditions of its rows. Rows are checked on the
    /// threads of the caller's pool.
    ///
    /// # Errors
    /// As [`read`], or that `cancel` became true.
    pub fn of_cells(
        heading: &[&str],
        cells: Box<dyn CaseCells>,
        shared: &NamedConditions,
        vehicle: &VehicleFile,
        settings: &Settings,
        cancel: &AtomicBool,
    ) -> Result<Self, InputError> {
        let columns = Columns::of(heading, *shared)?;
        if cells.is_empty() {
            return Err(InputError::other(NO_ROWS).within("the table of cases"));
        }
        let mut table = Self::new(cells, columns, Path::new(""), vehicle, settings, cancel)?;
        table.input["scene"] = resolved_input::scene(shared).into();
        Ok(table)
    }

    fn new(
        cells: Box<dyn CaseCells>,
        columns: Columns,
        folder: &Path,
        vehicle: &VehicleFile,
        settings: &Settings,
        cancel: &AtomicBool,
    ) -> Result<Self, InputError> {
        let mut vehicles = Vehicles {
            own: vehicle.clone(),
            shared: Arc::new(vehicle.vehicle.clone()),
            files: BTreeMap::new(),
        };
        let row = |number| Row {
            cells: &*cells,
            number,
        };
        for number in 0..cells.len() {
            vehicles
                .read(row(number).text(columns.vehicle_file), folder)
                .map_err(|error| cells.at_row(number, error))?;
        }
        let checked = |number| {
            case(row(number), &columns, &vehicles, settings)
                .map_err(|error| cells.at_row(number, error))
        };
        let first = checked(0)?;
        let mut most_legs = 0;
        for begin in (0..cells.len()).step_by(CHECKED_TOGETHER) {
            if cancel.load(Ordering::Relaxed) {
                return Err(InputError::other("cancelled"));
            }
            let end = cells.len().min(begin + CHECKED_TOGETHER);
            let legs = |number| checked(number).map(|case| case.vehicle.leg_count());
            let all: Vec<Result<usize, InputError>> =
                (begin..end).into_par_iter().map(legs).collect();
            for legs in all {
                most_legs = most_legs.max(legs?);
            }
        }
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

    /// Greatest number of legs among the vehicles.
    pub fn most_legs(&self) -> usize {
        self.most_legs
    }

    /// Name of a row from the column `case`, else its number.
    pub fn name(&self, row: usize) -> String {
        let name = self.row(row).text(self.columns.name);
        name.unwrap_or_else(|| (row + 1).to_string())
    }

    /// Builds the input of a row.
    ///
    /// # Errors
    /// None: all rows have been checked.
    pub fn case(&self, row: usize) -> Result<CaseRow, InputError> {
        let case = case(self.row(row), &self.columns, &self.vehicles, &self.settings);
        case.map_err(|error| self.cells.at_row(row, error))
    }

    /// Input of the first row.
    pub fn first(&self) -> &CaseRow {
        &self.first
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

/// Vehicles of the rows.
#[derive(Debug)]
struct Vehicles {
    /// Vehicle of rows without a vehicle file.
    own: VehicleFile,
    shared: Arc<Vehicle>,
    files: BTreeMap<String, VehicleFile>,
}

impl Vehicles {
    /// Reads the vehicle file of a row, unless read already.
    fn read(&mut self, name: Option<String>, folder: &Path) -> Result<(), InputError> {
        if let Some(name) = name.filter(|name| !self.files.contains_key(name)) {
            let path = folder.join(&name);
            if let Some(refusal) = Library::Disk.refusal(&path) {
                let said = format!("vehicle = {name}: {refusal}: expected {VEHICLE}");
                return Err(InputError::unreadable(&path, said));
            }
            let file = VehicleFile::read_from(&path, Library::Disk)?;
            self.files.insert(name, file);
        }
        Ok(())
    }

    /// The vehicle of this file, or the default one, with these values replaced.
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
