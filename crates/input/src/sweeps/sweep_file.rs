//! Reads sweep files: the vehicle, fixed and varied conditions, and the job.

use std::path::Path;

use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantity::Quantity;

use crate::points::axis_input::{self, AxisEntry};
use crate::readers::choice::choice;
pub use crate::sweeps::sweep::{Job, Sweep};

use crate::documents::document::Document;
use crate::documents::input_error::{InputError, short};
use crate::documents::library::Library;
use crate::documents::output_units::OutputUnits;
use crate::documents::section::{LocatedValue, Section};
use crate::points::design::Design;
use crate::points::grid::{Grid, GridFault, MOST_POINTS};
use crate::points::parameter::{Home, Parameter};
use crate::points::{map_input, sample_input, sensitivity_input};
use crate::readers::numbers::explanation;
use crate::readers::scene_input::{
    self, FaultyValue, HORIZONTAL_VELOCITY, NamedConditions, SceneFault,
};
use crate::readers::vehicle_file::{self, VehicleFile};
use crate::readers::{search_input, settings_input};
use crate::sweeps::case::{self, CaseFault};
use crate::sweeps::sweep::{OverrideNames, SWEEP};
use touchdown_dynamics::scene::Stop;

impl Sweep {
    /// Reads a sweep file and its vehicle file, and checks both completely.
    ///
    /// # Errors
    /// Names file, line, key and value of the first fault, and the allowed values.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::read_from(path, Library::Disk)
    }

    /// Reads a sweep file and the files that it names from a library.
    ///
    /// # Errors
    /// As [`Sweep::read`].
    pub fn read_from(path: &Path, library: Library) -> Result<Self, InputError> {
        let document = Document::read_from(path, library)?;
        let root = Section::root(&document, &SWEEP)?;
        let title = match root.optional("title") {
            Some(found) => found.text()?.to_owned(),
            None => path
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
        };
        let asked = asked(&root)?;
        check_complete(&root, asked)?;
        let statement = match root.optional("statement") {
            Some(found) => Some(found.text()?.to_owned()),
            None => None,
        };
        let units = OutputUnits::read(&root)?;
        let vehicle = vehicle_document(&root, path, library)?;
        let scene = root.section("scene", &scene_input::scene_keys())?;
        let entries = axis_input::entries(&root, vehicle_file::leg_count(&vehicle))?;
        check_names(&root, &scene, &entries, asked)?;
        let mut sources = vec![document.source(), vehicle.source()];
        let sampled = sample_input::sampled(&root, &entries, path, library, &mut sources)?;
        let enough = sampled.as_ref().and_then(|sampled| sampled.enough);
        if enough.is_some() && asked == JobWord::Boundary {
            let sample = root.section("sample", &sample_input::SAMPLE)?;
            let found = sample.value("stop_at_interval_width", "a number")?;
            return Err(found.complain_that("is used with job = \"outcome\" only"));
        }
        let design = match sampled {
            Some(sampled) => Design::Sample(sampled.sample),
            None => grid_or_map(&root, &entries)?,
        };
        let axes: Vec<Parameter> = entries
            .iter()
            .map(|entry| entry.parameter.clone())
            .collect();
        let first = design.coordinates(0);

        let varied = case::written(&document, &axes, Home::Sweep, &first);
        let varied = Section::root(&varied, &SWEEP)?;
        // Faults that occur without the first values of the axes are not attributed to the axes.
        let at_axes = |part, error, as_written: Option<InputError>| {
            let fault = CaseFault::Input { part, error };
            as_written.unwrap_or_else(|| locate(&fault, &first, &scene, &entries))
        };
        let job = match asked {
            JobWord::Boundary => {
                Job::Boundary(search_input::search(&varied).map_err(|error| {
                    at_axes(Home::Sweep, error, search_input::search(&root).err())
                })?)
            }
            JobWord::Outcome => Job::Outcome { enough },
        };
        let settings = settings_input::settings(&varied, job.stop()).map_err(|error| {
            let as_written = settings_input::settings(&root, job.stop()).err();
            at_axes(Home::Sweep, error, as_written)
        })?;
        if let Some(found) = settings_input::stop(&root)?
            && asked == JobWord::Boundary
            && settings.stop() != Stop::Verdict
        {
            return Err(found.complain("\"verdict\", at which the landings of a search end"));
        }
        let read_vehicle = VehicleFile::from_document;
        let varied = read_vehicle(case::written(&vehicle, &axes, Home::Vehicle, &first));
        let varied = varied
            .map_err(|error| at_axes(Home::Vehicle, error, read_vehicle(vehicle.clone()).err()))?;
        let vehicle = VehicleFile {
            document: vehicle,
            ..varied
        };
        let legs = vehicle.vehicle.leg_count();
        let fixed = NamedConditions::read(&scene)?;
        let sweep = Self {
            path: path.to_owned(),
            title,
            statement,
            units,
            vehicle,
            fixed,
            axes,
            design,
            job,
            settings,
            sensitivity: sensitivity_input::parameters(&root, legs)?,
            part: None,
            sources,
            overrides: OverrideNames::default(),
            document: document.clone(),
        };
        for coordinates in sweep.design.probes() {
            if let Err(fault) = sweep.case_at(&coordinates) {
                return Err(locate(&fault, &coordinates, &scene, &entries));
            }
        }
        sweep.check_sensitivity()?;
        Ok(sweep)
    }
}

fn vehicle_document(root: &Section, path: &Path, library: Library) -> Result<Document, InputError> {
    let found = root.value("vehicle", VEHICLE)?;
    named_vehicle(&found, path, library)
}

/// Reads the vehicle file that is named by a value in the file `path`.
pub(crate) fn named_vehicle(
    found: &LocatedValue,
    path: &Path,
    library: Library,
) -> Result<Document, InputError> {
    let file = path.parent().unwrap_or(Path::new("")).join(found.text()?);
    if let Some(refusal) = library.refusal(&file) {
        return Err(found.complain_that(&format!("{refusal}: expected {VEHICLE}")));
    }
    Document::read_from(&file, library)
}

/// Word of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum JobWord {
    #[default]
    Boundary,
    Outcome,
}

fn asked(root: &Section) -> Result<JobWord, InputError> {
    let jobs = [
        ("boundary", JobWord::Boundary),
        ("outcome", JobWord::Outcome),
    ];
    choice(root, "job", &jobs)
}

/// Keys without default that a sweep file lacks are named all at once; the first of them is named where it is read.
fn check_complete(root: &Section, asked: JobWord) -> Result<(), InputError> {
    let has_axes = root.optional("axes").is_some();
    let entries = match has_axes {
        true => axis_input::entries(root, MOST_LEGS),
        false => Ok(Vec::new()),
    };
    let Ok(entries) = entries else {
        return Ok(());
    };
    let varies = |name: &str| {
        let mut parameters = entries.iter().map(|entry| &entry.parameter);
        parameters.any(|parameter| parameter.program_name() == name)
    };
    let scene = root.optional_section("scene", &scene_input::scene_keys())?;
    let search = root.optional_section("search", &search_input::SEARCH)?;
    let searched = |name: &str| asked == JobWord::Boundary && name == HORIZONTAL_VELOCITY;
    let of_scene = scene_input::required().filter(|quantity| {
        let name = quantity.key;
        let given = (scene.as_ref()).and_then(|scene| scene_input::find(scene, name));
        given.is_none() && !varies(name) && !searched(name)
    });
    let of_search = search_input::required().filter(|quantity| {
        let key = quantity.key;
        let given = search.as_ref().and_then(|search| search.optional(key));
        asked == JobWord::Boundary && given.is_none() && !varies(&format!("search.{key}"))
    });
    let named = |table: &str, quantity: &Quantity| {
        (format!("{table}.{}", quantity.key), explanation(quantity))
    };
    let table = |key: &str, meaning: &str| (key.to_owned(), meaning.to_owned());
    let vehicle = root.optional("vehicle").is_none();
    let missing: Vec<(String, String)> = (vehicle.then(|| table("vehicle", VEHICLE)).into_iter())
        .chain(of_scene.map(|quantity| named("scene", quantity)))
        .chain((!has_axes).then(|| table("axes", axis_input::NEEDED)))
        .chain(of_search.map(|quantity| named("search", quantity)))
        .collect();
    if missing.len() < 2 {
        return Ok(());
    }
    let lines = missing
        .iter()
        .map(|(key, meaning)| format!("\n  {key}: {meaning}"));
    let lines: String = lines.collect();
    Err(root.lacks(&format!("{} keys are missing:{lines}", missing.len())))
}

/// Meaning of the key `vehicle`.
pub(crate) const VEHICLE: &str = "the path of a vehicle file, relative to this file";

/// Checks that nothing is given twice or without effect.
fn check_names(
    root: &Section,
    scene: &Section,
    entries: &[AxisEntry],
    asked: JobWord,
) -> Result<(), InputError> {
    if let Some(found) = root.optional("map") {
        if asked == JobWord::Outcome {
            return Err(found.complain_that("says nothing where job = \"outcome\""));
        }
        if root.optional("sample").is_some() {
            return Err(
                found.complain_that("says nothing beside [sample]: allowed is either of the two")
            );
        }
    }
    let varied = |name: &str| (entries.iter()).find(|entry| entry.parameter.program_name() == name);
    if asked == JobWord::Boundary {
        let fixed = scene.optional(HORIZONTAL_VELOCITY);
        let varied = varied(HORIZONTAL_VELOCITY).map(|entry| entry.found.clone());
        if let Some(found) = fixed.or(varied) {
            return Err(found.complain_that(SEARCHED));
        }
    } else if let Some(found) = root.optional("search") {
        return Err(found.complain_that("not used with job = \"outcome\""));
    }
    for name in scene_input::names(MOST_LEGS) {
        if let (Some(entry), Some(_)) = (varied(name), scene_input::find(scene, name)) {
            let both = "also in [scene]: expected only one of the two";
            return Err(entry.found.complain_that(both));
        }
    }
    let searched = entries
        .iter()
        .find(|entry| entry.parameter.name().starts_with("search."));
    match searched {
        Some(entry) if asked == JobWord::Outcome => {
            Err(entry.found.complain_that("not used with job = \"outcome\""))
        }
        _ => Ok(()),
    }
}

const SEARCHED: &str = "the horizontal velocity is what a sweep searches: \
     give from_fps and to_fps in [search] instead";

fn grid_or_map(root: &Section, entries: &[AxisEntry]) -> Result<Design, InputError> {
    let grid = grid(root, entries)?;
    let map = map_input::map(root, entries, &grid)?;
    Ok(map.map_or(Design::Grid(grid), Design::Map))
}

fn grid(root: &Section, entries: &[AxisEntry]) -> Result<Grid, InputError> {
    let axes = entries
        .iter()
        .map(AxisEntry::levels)
        .collect::<Result<_, _>>()?;
    Grid::new(axes).map_err(|fault| match fault {
        GridFault::Uneven([first, other]) => entries[other].found.complain_that(&format!(
            "moves together with {} but has another number of values: expected the same number of \
             values in one zip group",
            entries[first].parameter.name()
        )),
        GridFault::Empty | GridFault::TooMany => match root.optional("axes") {
            Some(found) => found.complain_that(&format!(
                "the grid has too many points: expected at most {MOST_POINTS}"
            )),
            None => root.missing("axes", "a table [axes]"),
        },
    })
}

/// Locates a fault of a point at the key responsible.
fn locate(
    fault: &CaseFault,
    coordinates: &[f64],
    scene: &Section,
    entries: &[AxisEntry],
) -> InputError {
    match fault {
        CaseFault::Scene(fault) => locate_condition(fault, scene, entries),
        CaseFault::Input { part, error } => {
            let varied = entries.iter().zip(coordinates);
            let of_part: Vec<(&AxisEntry, &f64)> = varied
                .filter(|(entry, _)| entry.parameter.home() == *part)
                .collect();
            let values = of_part.iter().map(|(entry, value)| {
                let parameter = &entry.parameter;
                format!("{} = {}", parameter.name(), parameter.cell(**value))
            });
            let values = values.collect::<Vec<_>>().join(", ");
            match of_part.first() {
                Some((entry, _)) => {
                    // Axis values appear nowhere else in the sweep file.
                    let error = match part {
                        Home::Sweep => error.clone().nowhere(),
                        _ => error.clone(),
                    };
                    entry.found.complain_that(&format!("at {values}: {error}"))
                }
                None => error.clone(),
            }
        }
    }
}

pub(crate) fn locate_condition(
    fault: &SceneFault,
    scene: &Section,
    entries: &[AxisEntry],
) -> InputError {
    // An invalid thrust is reported at its table if its scale is not given.
    let of_thrust = || {
        let is_of_thrust = fault.name.starts_with(scene_input::THRUST) && fault.value.is_some();
        scene.optional(scene_input::THRUST).filter(|_| is_of_thrust)
    };
    let varied = |entry: &AxisEntry| entry.parameter.program_name() == fault.name;
    let is_varied = entries.iter().any(varied);
    let found = scene_input::find(scene, fault.name);
    if let Some(found) = found.or_else(|| of_thrust().filter(|_| !is_varied)) {
        return found.complain(&fault.allowed);
    }
    let entry = entries
        .iter()
        .find(|entry| entry.parameter.program_name() == fault.name);
    match (entry, fault.value) {
        (Some(entry), Some(value)) => {
            let value = match value {
                FaultyValue::Number(number) => entry.parameter.in_own_unit(number).into(),
                word => word,
            };
            entry.found.complain_that(&format!(
                "includes {}: expected {}",
                short(value.to_string()),
                entry.parameter.allowed(fault)
            ))
        }
        // Of the vehicle, which the scene or the solver does not go with.
        (None, Some(value)) => scene.lacks(&format!(
            "{} = {value}: expected {}",
            fault.name, fault.allowed
        )),
        (_, None) => scene.missing(fault.name, &fault.allowed),
    }
}

#[cfg(test)]
#[path = "sweep_file_tests.rs"]
pub(crate) mod tests;
