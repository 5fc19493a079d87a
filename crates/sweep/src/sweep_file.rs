//! Sweep files: which vehicle, which conditions are fixed, which vary, and where to search.

use std::path::{Path, PathBuf};

use touchdown_dynamics::scene::Settings;

use crate::axis_input::{self, AxisEntry};
use crate::boundary::Search;
use crate::case::CaseFault;
use crate::design::Design;
use crate::document::Document;
use crate::found::Found;
use crate::grid::{Grid, GridFault};
use crate::input_error::InputError;
use crate::instead::Given;
use crate::library::{Library, Source};
use crate::parameter::{Home, Parameter};
use crate::scene_input::{HORIZONTAL_VELOCITY, NAMES, NamedConditions, SceneFault};
use crate::section::Section;
use crate::sensitivity::input;
use crate::vehicle_file::LEGS;
use crate::vehicle_file::VehicleFile;
use crate::{case, sample_input, search_input, settings_input};

/// Keys of a sweep file.
pub(crate) const SWEEP: [&str; 10] = [
    "title",
    "statement",
    "job",
    "vehicle",
    "scene",
    "axes",
    "sample",
    "search",
    "sensitivity",
    "solver",
];

/// What a sweep asks at every point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Job {
    /// From which horizontal velocity on landings are no longer stable.
    Boundary(Search),
    /// How one landing ends.
    Outcome {
        /// Width of the intervals of the probabilities at which enough is known.
        enough: Option<f64>,
    },
}

/// Everything that determines the result of a sweep.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// The sweep file.
    pub path: PathBuf,
    /// What the sweep is about, in the words of its file.
    pub title: String,
    /// What was said before of what the sweep shows, for its picture to stand against.
    pub statement: Option<String>,
    /// The vehicle; what varies of it has its first value.
    pub vehicle: VehicleFile,
    /// Conditions that do not vary.
    pub fixed: NamedConditions,
    /// What varies, one parameter for each axis.
    pub axes: Vec<Parameter>,
    /// The values over which it varies.
    pub design: Design,
    /// What is asked at every point; what varies of it has its first value.
    pub job: Job,
    /// How landings are computed; what varies of it has its first value.
    pub settings: Settings,
    /// Parameters on which the first transition's dependence is asked.
    pub sensitivity: Vec<Parameter>,
    /// The files that were read.
    pub(crate) sources: Vec<Source>,
    pub(crate) instead: Given,
    pub(crate) document: Document,
}

impl Sweep {
    /// Reads a sweep file and the vehicle file that it names, and checks all of both.
    ///
    /// # Errors
    /// Names file, line, key and value of the first thing wrong, and what is allowed.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::read_from(path, Library::Disk)
    }

    /// Reads a sweep file and what it names from a library.
    ///
    /// # Errors
    /// As [`Sweep::read`].
    pub fn read_from(path: &Path, library: Library) -> Result<Self, InputError> {
        let document = library.document(path)?;
        let root = Section::root(&document, &SWEEP)?;
        let title = root.text("title")?.to_owned();
        let statement = match root.optional("statement") {
            Some(found) => Some(found.text()?.to_owned()),
            None => None,
        };
        let vehicle = vehicle_document(&root, path, library)?;
        let asked = asked(&root)?;
        let scene = root.section("scene", &NAMES)?;
        let entries = axis_input::entries(&root, LEGS)?;
        check_names(&root, &scene, &entries, asked)?;
        let mut sources = vec![document.source(), vehicle.source()];
        let sampled = sample_input::sampled(&root, &entries, path, library, &mut sources)?;
        let enough = sampled.as_ref().and_then(|sampled| sampled.enough);
        let design = match sampled {
            Some(sampled) => Design::Sample(sampled.sample),
            None => Design::Grid(grid(&root, &entries)?),
        };
        let axes: Vec<Parameter> = entries
            .iter()
            .map(|entry| entry.parameter.clone())
            .collect();
        let first = design.coordinates(0);

        let varied = case::written(&document, &axes, Home::Sweep, &first);
        let varied = Section::root(&varied, &SWEEP)?;
        let job = match asked {
            Asked::Boundary => Job::Boundary(search_input::search(&varied)?),
            Asked::Outcome => Job::Outcome { enough },
        };
        let settings = settings_input::settings(&varied)?;
        let vehicle = VehicleFile {
            document: vehicle.clone(),
            ..VehicleFile::from_document(case::written(&vehicle, &axes, Home::Vehicle, &first))?
        };
        let mut fixed = NamedConditions::default();
        for (name, found) in scene.all_values() {
            fixed.set(name, found.number()?);
        }
        let sweep = Self {
            path: path.to_owned(),
            title,
            statement,
            vehicle,
            fixed,
            axes,
            design,
            job,
            settings,
            sensitivity: input::parameters(&root, LEGS)?,
            sources,
            instead: Given::default(),
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

    /// Name of the file without folder and ending: results are named after it.
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        stem.to_string_lossy().into_owned()
    }

    /// Whether the sensitivities that are asked for can be.
    pub(crate) fn check_sensitivity(&self) -> Result<(), InputError> {
        let refuse =
            |complaint: String| Err(InputError::other(complaint).at(self.document.place()));
        if !self.sensitivity.is_empty() && self.search().is_none() {
            return refuse("sensitivity: says nothing where job = \"outcome\"".to_owned());
        }
        let valueless = |parameter: &&Parameter| self.value(0, parameter).is_none();
        match self.sensitivity.iter().find(valueless) {
            Some(parameter) => refuse(format!(
                "sensitivity to {}: it has no value here: allowed are numbers that the sweep or the \
                 vehicle file gives",
                parameter.name()
            )),
            None => Ok(()),
        }
    }

    /// Where to search, if that is what the sweep asks.
    pub fn search(&self) -> Option<&Search> {
        match &self.job {
            Job::Boundary(search) => Some(search),
            Job::Outcome { .. } => None,
        }
    }

    /// Heading of a table of results: the axes, then `columns`.
    pub fn heading(&self, columns: impl IntoIterator<Item: Into<String>>) -> Vec<String> {
        let axes = self.axes.iter().map(|axis| axis.name().to_owned());
        axes.chain(columns.into_iter().map(Into::into)).collect()
    }

    /// The coordinates of a point as results write them.
    pub fn coordinates_written(&self, point: usize) -> Vec<String> {
        let coordinates = self.design.coordinates(point);
        let varied = self.axes.iter().zip(coordinates);
        varied.map(|(axis, value)| axis.written(value)).collect()
    }

    /// The coordinates of a point in words.
    pub fn place(&self, point: usize) -> String {
        let written = self.coordinates_written(point);
        let varied = self.axes.iter().zip(written);
        let equations: Vec<String> = varied
            .map(|(axis, value)| format!("{} = {value}", axis.name()))
            .collect();
        equations.join(", ")
    }
}

fn vehicle_document(root: &Section, path: &Path, library: Library) -> Result<Document, InputError> {
    let found = root.value(
        "vehicle",
        "the path of a vehicle file, relative to this file",
    )?;
    named_vehicle(&found, path, library)
}

/// The vehicle file that a value names, which stands in the file `path`.
pub(crate) fn named_vehicle(
    found: &Found,
    path: &Path,
    library: Library,
) -> Result<Document, InputError> {
    let file = path.parent().unwrap_or(Path::new("")).join(found.text()?);
    if !library.has(&file) {
        return Err(found.complain_that(&format!(
            "there is no file {}: allowed is the path of a vehicle file, relative to this file",
            file.display()
        )));
    }
    library.document(&file)
}

/// The job by its word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Asked {
    Boundary,
    Outcome,
}

fn asked(root: &Section) -> Result<Asked, InputError> {
    let Some(found) = root.optional("job") else {
        return Ok(Asked::Boundary);
    };
    match found.text()? {
        "boundary" => Ok(Asked::Boundary),
        "outcome" => Ok(Asked::Outcome),
        _ => Err(found.complain("\"boundary\" or \"outcome\"")),
    }
}

/// Checks that nothing is said twice or to no purpose.
fn check_names(
    root: &Section,
    scene: &Section,
    entries: &[AxisEntry],
    asked: Asked,
) -> Result<(), InputError> {
    let varied = |name: &str| entries.iter().find(|entry| entry.parameter.name() == name);
    if asked == Asked::Boundary {
        let fixed = scene.optional(HORIZONTAL_VELOCITY);
        let varied = varied(HORIZONTAL_VELOCITY).map(|entry| entry.found.clone());
        if let Some(found) = fixed.or(varied) {
            return Err(found.complain_that(SEARCHED));
        }
    } else if let Some(found) = root.optional("search") {
        return Err(found.complain_that("says nothing where job = \"outcome\""));
    }
    for (name, _) in scene.all_values() {
        if let Some(entry) = varied(name) {
            let both = "also fixed in [scene]: allowed is either of the two";
            return Err(entry.found.complain_that(both));
        }
    }
    let searched = entries
        .iter()
        .find(|entry| entry.parameter.name().starts_with("search."));
    match searched {
        Some(entry) if asked == Asked::Outcome => Err(entry
            .found
            .complain_that("says nothing where job = \"outcome\"")),
        _ => Ok(()),
    }
}

const SEARCHED: &str = "the horizontal velocity is what a sweep searches: \
     give from_fps and to_fps in [search] instead";

fn grid(root: &Section, entries: &[AxisEntry]) -> Result<Grid, InputError> {
    let axes = entries
        .iter()
        .map(AxisEntry::levels)
        .collect::<Result<_, _>>()?;
    Grid::new(axes).map_err(|fault| match fault {
        GridFault::Uneven([first, other]) => entries[other].found.complain_that(&format!(
            "moves together with {} but has not as many values: allowed is the same number of \
             values along one zip",
            entries[first].parameter.name()
        )),
        GridFault::Empty | GridFault::Uncountable => match root.optional("axes") {
            Some(found) => found.complain_that("the grid has more points than can be counted"),
            None => root.missing("axes", "a table [axes]"),
        },
    })
}

/// Brings what is wrong at a point to the key that says it.
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
                format!("{} = {}", parameter.name(), parameter.written(**value))
            });
            let values = values.collect::<Vec<_>>().join(", ");
            match of_part.first() {
                Some((entry, _)) => entry.found.complain_that(&format!("at {values}: {error}")),
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
    if let Some(found) = scene.optional(fault.name) {
        return found.complain(&fault.allowed);
    }
    let entry = entries
        .iter()
        .find(|entry| entry.parameter.name() == fault.name);
    match (entry, fault.value) {
        (Some(entry), Some(value)) => entry.found.complain_that(&format!(
            "{value} is among them: allowed is {}",
            fault.allowed
        )),
        _ => scene.missing(fault.name, &fault.allowed),
    }
}

#[cfg(test)]
#[path = "sweep_file_tests.rs"]
mod tests;
