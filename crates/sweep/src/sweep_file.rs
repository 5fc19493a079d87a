//! Sweep files: which vehicle, which conditions are fixed, which vary, and where to search.

use std::path::{Path, PathBuf};

use touchdown_dynamics::scene::{Scene, Settings};

use crate::axes::{Axis, Grid};
use crate::boundary::Search;
use crate::document::Document;
use crate::found::Found;
use crate::input_error::InputError;
use crate::scene_input::{HORIZONTAL_VELOCITY, NAMES, NamedConditions, SceneFault};
use crate::section::Section;
use crate::vehicle_file::VehicleFile;
use crate::{search_input, settings_input};

const SWEEP: [&str; 7] = [
    "title",
    "statement",
    "vehicle",
    "scene",
    "axes",
    "search",
    "solver",
];
const RANGE: [&str; 3] = ["from", "to", "step"];
/// Everything that determines the result of a sweep.
#[derive(Debug, Clone)]
pub struct Sweep<const LEGS: usize> {
    /// The sweep file.
    pub path: PathBuf,
    /// What the sweep is about, in the words of its file.
    pub title: String,
    /// What was said before of what the sweep shows, for its picture to stand against.
    pub statement: Option<String>,
    /// The vehicle.
    pub vehicle: VehicleFile<LEGS>,
    /// Conditions that do not vary.
    pub fixed: NamedConditions,
    /// Conditions that vary.
    pub grid: Grid,
    /// Where to search the transition.
    pub search: Search,
    /// How landings are computed.
    pub settings: Settings,
}

impl<const LEGS: usize> Sweep<LEGS> {
    /// Reads a sweep file and the vehicle file that it names, and checks all of both.
    ///
    /// # Errors
    /// Names file, line, key and value of the first thing wrong, and what is allowed.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let document = Document::read(path)?;
        let root = Section::root(&document, &SWEEP)?;
        let title = root.text("title")?.to_owned();
        let statement = match root.optional("statement") {
            Some(found) => Some(found.text()?.to_owned()),
            None => None,
        };
        let vehicle = vehicle(&root, path)?;
        let scene = scene(&root)?;
        let axes = axes(&root, &scene)?;
        let search = search_input::search(&root)?;
        let settings = settings_input::settings(&root)?;
        let fixed = check_scenes(&scene, &axes, search.from)?;
        let values = axes.into_iter().map(|(axis, _)| axis).collect();
        let grid = Grid::new(values).ok_or_else(|| match root.optional("axes") {
            Some(found) => found.complain_that("the grid has more points than can be counted"),
            None => root.missing("axes", "a table [axes]"),
        })?;
        Ok(Self {
            path: path.to_owned(),
            title,
            statement,
            vehicle,
            fixed,
            grid,
            search,
            settings,
        })
    }

    /// Name of the file without folder and ending: results are named after it.
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        stem.to_string_lossy().into_owned()
    }

    /// The scene of a grid point at the lowest speed of the search.
    ///
    /// # Errors
    /// None for a sweep that was read without error.
    pub fn scene(&self, point: usize) -> Result<Scene, SceneFault> {
        let mut conditions = self.fixed;
        let coordinates = self.grid.coordinates(point);
        for (axis, value) in self.grid.axes().iter().zip(coordinates) {
            conditions.set(axis.name(), value);
        }
        conditions.set(HORIZONTAL_VELOCITY, self.search.from);
        conditions.scene()
    }
}

fn vehicle<const LEGS: usize>(
    root: &Section,
    path: &Path,
) -> Result<VehicleFile<LEGS>, InputError> {
    let found = root.value(
        "vehicle",
        "the path of a vehicle file, relative to this file",
    )?;
    let file = path.parent().unwrap_or(Path::new("")).join(found.text()?);
    if !file.is_file() {
        return Err(found.complain_that(&format!(
            "there is no file {}: allowed is the path of a vehicle file, relative to this file",
            file.display()
        )));
    }
    VehicleFile::read(&file)
}

fn scene<'d>(root: &Section<'d>) -> Result<Section<'d>, InputError> {
    let scene = root.section("scene", &NAMES)?;
    match scene.optional(HORIZONTAL_VELOCITY) {
        Some(found) => Err(found.complain_that(SEARCHED)),
        None => Ok(scene),
    }
}

const SEARCHED: &str = "the horizontal velocity is what a sweep searches: \
     give from_fps and to_fps in [search] instead";

fn axes<'d>(root: &Section<'d>, scene: &Section<'d>) -> Result<Vec<(Axis, Found<'d>)>, InputError> {
    let allowed = "a table [axes] with at least one condition that varies";
    let found = root.value("axes", allowed)?;
    let known: Vec<&str> = NAMES
        .into_iter()
        .filter(|name| *name != HORIZONTAL_VELOCITY)
        .collect();
    if let Some((_, searched)) = root
        .section("axes", &NAMES)?
        .all_values()
        .find(|(name, _)| *name == HORIZONTAL_VELOCITY)
    {
        return Err(searched.complain_that(SEARCHED));
    }
    let axes = root
        .section("axes", &known)?
        .all_values()
        .map(|(name, found)| {
            if scene.optional(name).is_some() {
                let both = "also fixed in [scene]: allowed is either of the two";
                return Err(found.complain_that(both));
            }
            Ok((axis(name, &found)?, found))
        })
        .collect::<Result<Vec<_>, _>>()?;
    if axes.is_empty() {
        return Err(found.complain(allowed));
    }
    Ok(axes)
}

fn axis(name: &str, found: &Found) -> Result<Axis, InputError> {
    let allowed = "{ from = …, to = …, step = … } or a list of numbers";
    let Some(range) = found.table(&RANGE)? else {
        let values = found
            .items(allowed)?
            .iter()
            .map(Found::number)
            .collect::<Result<_, _>>()?;
        return Axis::list(name, values)
            .ok_or_else(|| found.complain("a list of at least one number"));
    };
    let [from, to, step] = [
        range.number("from")?,
        range.number("to")?,
        range.number("step")?,
    ];
    Axis::range(name, from, to, step).map_err(|(key, allowed)| match range.optional(key) {
        Some(found) => found.complain(&format!("{allowed} (from {from} to {to} by {step})")),
        None => range.missing(key, allowed),
    })
}

/// Checks the fixed conditions with every value of every axis, and returns the fixed ones.
///
/// Conditions are independent of each other but for the two forms of the attitude, so that it is
/// enough to vary one axis at a time.
fn check_scenes(
    scene: &Section,
    axes: &[(Axis, Found)],
    lowest_speed: f64,
) -> Result<NamedConditions, InputError> {
    let mut fixed = NamedConditions::default();
    for (name, found) in scene.all_values() {
        fixed.set(name, found.number()?);
    }
    let mut corner = fixed;
    corner.set(HORIZONTAL_VELOCITY, lowest_speed);
    for (axis, _) in axes {
        corner.set(axis.name(), axis.value(0));
    }
    for (axis, _) in axes {
        for value in axis.values() {
            let mut conditions = corner;
            conditions.set(axis.name(), value);
            conditions
                .scene()
                .map_err(|fault| locate(&fault, scene, axes))?;
        }
    }
    Ok(fixed)
}

fn locate(fault: &SceneFault, scene: &Section, axes: &[(Axis, Found)]) -> InputError {
    if let Some(found) = scene.optional(fault.name) {
        return found.complain(&fault.allowed);
    }
    match (
        axes.iter().find(|(axis, _)| axis.name() == fault.name),
        fault.value,
    ) {
        (Some((_, found)), Some(value)) => found.complain_that(&format!(
            "{value} is among them: allowed is {}",
            fault.allowed
        )),
        _ => scene.missing(fault.name, &fault.allowed),
    }
}

#[cfg(test)]
#[path = "sweep_file_tests.rs"]
mod tests;
