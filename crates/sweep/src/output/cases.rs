//! Tables of cases: one landing per row, each of which may change the vehicle and the solver.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::Arc;

use csv::StringRecord;
use serde_json::json;
use touchdown_dynamics::methods::Method;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use crate::document::{Document, Value};
use crate::findings::Finding;
use crate::fingerprint::fingerprint;
use crate::header::Header;
use crate::input_error::{InputError, Place};
use crate::landing_table::{self, Cell};
use crate::library::Library;
use crate::output_units::{OutputUnits, Quantity};
use crate::parameter::{Home, Parameter};
use crate::resolved_input;
use crate::scene_input::NamedConditions;
use crate::section::Section;
use crate::settings_input::{self, crush_rule_name, friction_profile_name};
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
const NAME_COLUMN: &str = OWN[0];
const VEHICLE_COLUMN: &str = OWN[1];

/// A row of a table of cases.
#[derive(Debug, Clone)]
pub struct CaseRow {
    /// Its name, from the column `case`, or else its number.
    pub name: String,
    /// What lands.
    pub vehicle: Arc<Vehicle>,
    /// How it touches down.
    pub scene: Scene,
    /// How that is computed.
    pub settings: Settings,
}

/// A table of cases.
#[derive(Debug, Clone)]
pub struct CaseTable {
    /// Its rows, at least one.
    pub rows: Vec<CaseRow>,
    /// What determines the results of all rows: the table and the vehicle files that it names by their fingerprints, the
    /// vehicle and the settings of rows that say nothing else.
    pub input: serde_json::Value,
}

impl CaseTable {
    /// The head of the journal of these cases.
    pub fn header(&self, program: &str) -> Header {
        let CaseRow {
            vehicle,
            scene,
            settings,
            ..
        } = &self.rows[0];
        let first = (&**vehicle, scene, settings);
        Header::of_cases(self.input.clone(), self.rows.len(), first, program)
    }
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
    let place = Place::file(path);
    let text = std::fs::read_to_string(path)
        .map_err(|error| InputError::other(format!("cannot be read: {error}")).at(place.clone()))?;
    parse(path, &text, vehicle, settings)
}

fn parse(
    path: &Path,
    text: &str,
    vehicle: &VehicleFile,
    settings: &Settings,
) -> Result<CaseTable, InputError> {
    let place = Place::file(path);
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
    let columns = Columns::of(&heading).map_err(|error| error.at(place.line(1)))?;

    let mut vehicles = Vehicles {
        table: path,
        own: vehicle,
        shared: Arc::new(vehicle.vehicle.clone()),
        files: HashMap::new(),
    };
    let mut cases = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(broken)?;
        let line = record.position().map_or(0, |position| position.line());
        let place = place.line(line as usize).row(index + 1);
        let case = columns
            .case(&heading, &record, &mut vehicles, settings)
            .map_err(|error| error.at(place))?;
        cases.push(CaseRow {
            name: match case.name.as_str() {
                "" => (index + 1).to_string(),
                name => name.to_owned(),
            },
            ..case
        });
    }
    if cases.is_empty() {
        return Err(InputError::other("has no rows: expected at least one case").at(place.clone()));
    }
    let files = vehicles.files.into_iter();
    let files: BTreeMap<String, String> = files
        .map(|(name, file)| (name, fingerprint(&file.document.source().text)))
        .collect();
    let input = json!({
        "table_of_cases": fingerprint(text),
        "vehicle_files": files,
        "vehicle": resolved_input::vehicle(&vehicle.document),
        "solver": resolved_input::solver(settings),
    });
    Ok(CaseTable { rows: cases, input })
}

/// The columns of a table that are parameters.
struct Columns {
    scene: Vec<(usize, Parameter)>,
    vehicle: Vec<(usize, Parameter)>,
    solver: Vec<(usize, Parameter)>,
}

impl Columns {
    fn of(heading: &StringRecord) -> Result<Self, InputError> {
        let mut columns = Self {
            scene: Vec::new(),
            vehicle: Vec::new(),
            solver: Vec::new(),
        };
        for (index, name) in heading.iter().enumerate() {
            if heading.iter().take(index).any(|before| before == name) {
                let said = format!("column {name} is there twice: expected once");
                return Err(InputError::other(said));
            }
            if OWN.contains(&name) {
                continue;
            }
            let parameter = Parameter::named(name, MOST_LEGS).filter(|known| known.name() == name);
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
            given.any(|(_, parameter)| parameter.program_name() == name)
        };
        match REQUIRED.iter().find(|name| !has(name)) {
            Some(absent) => Err(InputError::other(format!(
                "column {absent} is missing: expected {}",
                REQUIRED.join(", ")
            ))),
            None => Ok(columns),
        }
    }

    /// The case of a row; its name may be empty.
    fn case(
        &self,
        heading: &StringRecord,
        record: &StringRecord,
        vehicles: &mut Vehicles,
        settings: &Settings,
    ) -> Result<CaseRow, InputError> {
        let named = cell(heading, record, VEHICLE_COLUMN);
        let vehicle = vehicles.of_row(named, &self.vehicle, record)?;
        let settings = self.settings(settings, record)?;
        Ok(CaseRow {
            name: cell(heading, record, NAME_COLUMN).to_owned(),
            scene: self.scene(record, &vehicle, &settings.method())?,
            vehicle,
            settings,
        })
    }

    /// The scene of a row, for a vehicle and a method.
    fn scene(
        &self,
        record: &StringRecord,
        vehicle: &Vehicle,
        method: &Method,
    ) -> Result<Scene, InputError> {
        let mut conditions = NamedConditions::default();
        let given = values(&self.scene, record)?;
        for (parameter, _, value) in &given {
            if let Value::Number(number) = value {
                conditions.set(parameter.program_name(), *number);
            }
        }
        conditions.scene_for(vehicle, method).map_err(|fault| {
            let given = (given.iter()).find(|(known, ..)| known.program_name() == fault.name);
            match (fault.value, given) {
                (Some(value), Some((parameter, text, _))) => {
                    let allowed = parameter.explain(&fault.allowed, parameter.in_own_unit(value));
                    InputError::value(parameter.name(), text, &allowed)
                }
                (Some(value), None) => InputError::value(fault.name, value, &fault.allowed),
                (None, _) => InputError::missing(fault.name, &fault.allowed),
            }
        })
    }

    /// The settings of a row: those given, with the values of the row in place of their own.
    fn settings(&self, given: &Settings, record: &StringRecord) -> Result<Settings, InputError> {
        let values = values(&self.solver, record)?;
        if values.is_empty() {
            return Ok(*given);
        }
        if given.method() != Method::Located {
            let said = "solver.… columns and --method exclude each other: write solver.method here";
            return Err(InputError::other(said));
        }
        let is_located = |(parameter, text, _): &Given| {
            parameter.name() != "solver.method" || *text == "located"
        };
        let mut text = format!(
            "[solver]\ntime_limit_s = {}\ncrush_rule = \"{}\"\nfriction_profile = \"{}\"\n",
            given.time_limit(),
            crush_rule_name(given.crush_rule()),
            friction_profile_name(given.friction_profile())
        );
        if given.goes_on() {
            text += "stop = \"time\"\n";
        }
        if values.iter().all(is_located) {
            text += &format!("tolerance = {}\n", given.tolerance());
        }
        let mut document = Document::parse(Path::new("solver"), &text)?;
        for (parameter, _, value) in &values {
            document.write(parameter.path(), value.clone());
        }
        Section::root(&document, &["solver"])
            .and_then(|root| settings_input::settings_of_landing(&root))
            .map_err(|error| at(&values, &error.nowhere()))
    }
}

/// The complaint that no column may have this name.
fn unknown(name: &str) -> String {
    let mut alike = Parameter::nearest(name, MOST_LEGS);
    alike.retain(|name| !name.starts_with("search.") && !name.starts_with("scene."));
    let guess = match alike.as_slice() {
        [] => String::new(),
        names => format!("did you mean {}? ", names.join(" or ")),
    };
    format!(
        "column {name}: no such column; {guess}expected {}, keys of the scene, and dotted keys of the vehicle and the \
         solver, such as vehicle.strut.compression_damping; for remarks there is the column note",
        OWN.join(", ")
    )
}

/// The vehicles of the rows.
struct Vehicles<'v> {
    /// The table, from whose folder paths are.
    table: &'v Path,
    /// The one of rows that name no other.
    own: &'v VehicleFile,
    shared: Arc<Vehicle>,
    files: HashMap<String, VehicleFile>,
}

impl Vehicles<'_> {
    /// The vehicle of a row: that of its file, with the values of the row in place of its own.
    fn of_row(
        &mut self,
        name: &str,
        columns: &[(usize, Parameter)],
        record: &StringRecord,
    ) -> Result<Arc<Vehicle>, InputError> {
        if !name.is_empty() && !self.files.contains_key(name) {
            let path = self.table.parent().unwrap_or(Path::new("")).join(name);
            let file = VehicleFile::read_from(&path, Library::Disk)?;
            self.files.insert(name.to_owned(), file);
        }
        let values = values(columns, record)?;
        let file = self.files.get(name);
        if values.is_empty() && file.is_none() {
            return Ok(Arc::clone(&self.shared));
        }
        let mut document = file.unwrap_or(self.own).document.clone();
        for (parameter, _, value) in &values {
            vehicle_file::write(
                &mut document,
                parameter.name(),
                parameter.path(),
                value.clone(),
            )
            .map_err(|error| at(&values, &error))?;
        }
        VehicleFile::from_document(document)
            .map(|file| Arc::new(file.vehicle))
            .map_err(|error| at(&values, &error))
    }
}

/// A parameter with what a row says of it, as written and as a value.
type Given<'r> = (&'r Parameter, &'r str, Value);

/// What a row says of these parameters.
fn values<'r>(
    columns: &'r [(usize, Parameter)],
    record: &'r StringRecord,
) -> Result<Vec<Given<'r>>, InputError> {
    let said = columns.iter().filter_map(|(index, parameter)| {
        let text = record.get(*index).filter(|text| !text.is_empty())?;
        Some((parameter, text))
    });
    said.map(|(parameter, text)| Ok((parameter, text, parameter.value(text)?)))
        .collect()
}

/// A complaint that arose with these values.
fn at(values: &[Given], error: &InputError) -> InputError {
    let said: Vec<String> = (values.iter())
        .map(|(parameter, text, _)| format!("{} = {text}", parameter.name()))
        .collect();
    InputError::other(format!("at {}: {error}", said.join(", ")))
}

fn cell<'r>(heading: &StringRecord, record: &'r StringRecord, name: &str) -> &'r str {
    let position = heading.iter().position(|column| column == name);
    position.and_then(|index| record.get(index)).unwrap_or("")
}

/// The results of cases as CSV, in these units: `case`, then the columns of [`landing_table`] for as many legs as any
/// vehicle has.
///
/// # Errors
/// None but those of memory.
pub fn table<'r>(
    rows: impl Iterator<Item = (&'r str, &'r Finding)> + Clone,
    units: OutputUnits,
) -> Result<Vec<u8>, csv::Error> {
    let cells = |finding: &'r Finding| -> &'r [Cell] {
        match finding {
            Finding::Landing { cells, .. } => cells,
            _ => &[],
        }
    };
    let legs = rows
        .clone()
        .map(|(_, finding)| landing_table::leg_count(cells(finding)));
    let legs = legs.max().unwrap_or(0);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_field("case")?;
    let names = landing_table::names(legs);
    let quantities: Vec<Quantity> = names.iter().map(|name| units.quantity(name)).collect();
    writer.write_record(quantities.iter().map(Quantity::name))?;
    for (name, finding) in rows {
        writer.write_field(name)?;
        let row = landing_table::under_headings(cells(finding), legs);
        let row = quantities.iter().zip(&row);
        writer.write_record(row.map(|(quantity, cell)| quantity.cell(cell)))?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

#[cfg(test)]
#[path = "cases_tests.rs"]
mod tests;
