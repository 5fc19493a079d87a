//! Starting touchdowns, from vehicle, scene and sweep files.

use std::path::Path;

use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Class;
use touchdown_input::documents::column_units::units_of_names;
use touchdown_input::documents::document::{Document, Entry, Value};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::documents::toml_text;
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::readers::scene_input::{HORIZONTAL_VELOCITY, NamedConditions};
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::scene_file::{self, SceneCase};
use touchdown_input::sweeps::single_landing;
use touchdown_input::sweeps::sweep_file::Sweep;

use super::Reading;

/// The table of solver settings in an input file.
const SOLVER: &str = "solver";
/// Default range of V_H, ft/s.
pub const SEARCHED: [f64; 2] = [0.0, 25.0];
/// Baseline of the report.
const BASELINE: [(&str, f64); 5] = [
    (VERTICAL_VELOCITY, 14.0),
    (HORIZONTAL_VELOCITY, 8.0),
    ("cross_slope_deg", 180.0),
    ("slope_deg", 15.0),
    ("friction", 1.0),
];
const VERTICAL_VELOCITY: &str = "vertical_velocity_fps";
/// Parts of the velocities of the baseline that are tried on a vehicle, until it lands.
const PARTS: [f64; 7] = [1.0, 0.75, 0.5, 0.375, 0.25, 0.125, 0.0625];

/// Origin of a source.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SourceKind {
    /// A vehicle file.
    Vehicle,
    /// A case of a scene file.
    Scene,
    /// A sweep file, at its first point.
    Sweep,
    /// The record beside a table of results, without the values of its axes.
    Results,
}

impl SourceKind {
    /// Word in answers.
    pub fn word(self) -> &'static str {
        match self {
            Self::Vehicle => "vehicle",
            Self::Scene => "scene",
            Self::Sweep => "sweep",
            Self::Results => "results",
        }
    }
}

/// A starting touchdown.
#[derive(Debug, Clone)]
pub struct Source {
    /// Name in requests.
    pub name: String,
    /// Title for display.
    pub title: String,
    /// File.
    pub file: String,
    /// Origin.
    pub kind: SourceKind,
    /// Vehicle.
    pub vehicle: VehicleFile,
    /// Touchdown conditions.
    pub conditions: NamedConditions,
    /// The table `[solver]` alone.
    pub solver: Document,
    /// Range of V_H, ft/s.
    pub search: [f64; 2],
    /// Units that its file asks for, or in which it has its numbers.
    pub units: OutputUnits,
}

impl Source {
    /// Reads a file of any kind.
    pub(crate) fn read(reading: &mut Reading, file: &Path) -> Result<Vec<Self>, InputError> {
        let document = reading.document(file)?;
        let has = |key: &str| document.root().iter().any(|entry| entry.key == key);
        if has("axes") || has("search") {
            return Ok(vec![Self::of_sweep(reading, file, &document)?]);
        }
        if has("scene") || has("case") {
            return Self::of_scene_file(reading, file, units_of(&document));
        }
        Ok(vec![Self::of_vehicle(reading, file)?])
    }

    /// A vehicle at the baseline of the report, or at the part of its velocities at which it lands.
    pub(crate) fn of_vehicle(reading: &mut Reading, file: &Path) -> Result<Self, InputError> {
        let document = reading.document(file)?;
        let units = units_of(&document);
        let vehicle = VehicleFile::from_document(document)?;
        let solver = nothing()?;
        let settings = single_landing::settings(&solver)?;
        let at = |part: f64| {
            let velocities = [VERTICAL_VELOCITY, HORIZONTAL_VELOCITY];
            NamedConditions::of(BASELINE.map(|(name, value)| {
                let of_part = velocities.contains(&name).then_some(part * value);
                (name, of_part.unwrap_or(value))
            }))
        };
        let lands = |part: &f64| {
            let scene = at(*part).scene_for(&vehicle.vehicle, &settings);
            let landing = scene.map(|scene| land(&vehicle.vehicle, &scene, &settings));
            landing.is_ok_and(|landing| landing.outcome.class() == Class::Stable)
        };
        let part = PARTS.into_iter().find(lands).unwrap_or(1.0);
        Ok(Self {
            name: stem(file),
            title: vehicle.name.clone(),
            file: file.display().to_string(),
            kind: SourceKind::Vehicle,
            vehicle,
            conditions: at(part),
            solver,
            search: SEARCHED.map(|end| part * end),
            units,
        })
    }

    fn of_scene_file(
        reading: &mut Reading,
        file: &Path,
        units: OutputUnits,
    ) -> Result<Vec<Self>, InputError> {
        let read = scene_file::read_from(file, reading.library)?;
        let is_single = read.cases.len() == 1;
        let source = |case: SceneCase| -> Result<Self, InputError> {
            let name = match is_single {
                true => stem(file),
                false => format!("{}-{}", stem(file), case.name),
            };
            reading.keep(case.vehicle.document.source());
            Ok(Self {
                title: format!("{}: {}", case.vehicle.name, name),
                name,
                file: file.display().to_string(),
                kind: SourceKind::Scene,
                conditions: case.conditions,
                solver: solver_of(&case.document)?,
                vehicle: case.vehicle,
                search: SEARCHED,
                units,
            })
        };
        read.cases.into_iter().map(source).collect()
    }

    fn of_sweep(
        reading: &mut Reading,
        file: &Path,
        document: &Document,
    ) -> Result<Self, InputError> {
        let sweep = Sweep::read_from(file, reading.library)?;
        for source in sweep.sources() {
            reading.keep(source.clone());
        }
        let first = sweep.cells_of_point(0).into_iter();
        let first: Vec<String> = first.map(|cell| cell.to_string()).collect();
        let mut conditions = sweep.fixed;
        let search = sweep.search().map(|search| [search.from, search.to]);
        if let Some([from, to]) = search {
            conditions.set(HORIZONTAL_VELOCITY, 0.5 * (from + to));
        }
        let source = Self {
            name: stem(file),
            title: sweep.title.clone(),
            file: file.display().to_string(),
            kind: SourceKind::Sweep,
            vehicle: sweep.vehicle.clone(),
            conditions,
            solver: solver_of(document)?,
            search: search.unwrap_or(SEARCHED),
            units: units_of(document),
        };
        let first = sweep.axes.iter().zip(&first);
        source.with(first.map(|(axis, text)| (axis.name(), text.as_str())))
    }

    /// Replaces values of parameters, given as written in tables.
    pub(super) fn with<'t>(
        mut self,
        values: impl Iterator<Item = (&'t str, &'t str)>,
    ) -> Result<Self, InputError> {
        let set = values.map(|(name, text)| Assignment::new(name, text));
        let set: Vec<Assignment> = set.collect::<Result<_, _>>()?;
        assignment::set_conditions(&mut self.conditions, &set);
        self.vehicle = assignment::set_vehicle(&self.vehicle, &set)?;
        for one in set.iter().filter(|one| one.is_of_solver()) {
            self.solver.write(one.path(), one.value());
        }
        Ok(self)
    }
}

/// An empty document.
pub(super) fn nothing() -> Result<Document, InputError> {
    Document::parse(Path::new(""), "")
}

/// Units that a file asks for, else those in which it has its numbers.
fn units_of(document: &Document) -> OutputUnits {
    fn keys<'d>(entries: &'d [Entry], into: &mut Vec<&'d str>) {
        for entry in entries {
            into.push(&entry.key);
            if let Value::Table(inner) = &entry.node.value {
                keys(inner, into);
            }
        }
    }
    let asked = document.root().iter().find(|entry| entry.key == "units");
    if let Some(Value::Text(word)) = asked.map(|entry| &entry.node.value) {
        return OutputUnits::named(word).unwrap_or_default();
    }
    let mut all = Vec::new();
    keys(document.root(), &mut all);
    units_of_names(all).unwrap_or_default()
}

/// Extracts the table `[solver]` of a document.
fn solver_of(document: &Document) -> Result<Document, InputError> {
    let is_solver =
        |entry: &&Entry| entry.key == SOLVER && matches!(entry.node.value, Value::Table(_));
    let solver: Vec<_> = document.root().iter().filter(is_solver).cloned().collect();
    Document::parse(document.path(), &toml_text::text(&solver))
}

/// Name of a file without folder and extension.
pub(super) fn stem(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    stem.to_string_lossy().into_owned()
}
