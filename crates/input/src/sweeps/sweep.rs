//! A sweep: the vehicle, the axes, and the job computed at every point.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::scene::{Settings, Stop};
use touchdown_search::search_range::Search;

use crate::documents::column::{Cell, Heading};
use crate::documents::document::Document;
use crate::documents::library::Source;
use crate::documents::output_units::{OutputUnits, UNITS};
use crate::points::design::Design;
use crate::points::parameter::Parameter;
use crate::points::refined_grid::RefinedGrid;
use crate::readers::scene_input::NamedConditions;
use crate::readers::vehicle_file::VehicleFile;

/// Keys of a sweep file.
pub(crate) const SWEEP: [&str; 12] = [
    "title",
    "statement",
    UNITS,
    "job",
    "vehicle",
    "scene",
    "axes",
    "sample",
    "map",
    "search",
    "sensitivity",
    "solver",
];

/// The job of a sweep at every point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Job {
    /// The horizontal velocity from which landings are no longer stable.
    Boundary(Search),
    /// The outcome of one landing.
    Outcome {
        /// Width of the probability intervals at which the sweep stops.
        enough: Option<f64>,
    },
}

impl Job {
    /// When its landings end, where the file does not say.
    pub(crate) fn stop(&self) -> Stop {
        match self {
            Self::Boundary(_) => Stop::Verdict,
            Self::Outcome { .. } => Stop::Rest,
        }
    }
}

/// Everything that determines the result of a sweep.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// The sweep file.
    pub path: PathBuf,
    /// Title, as in its file.
    pub title: String,
    /// An earlier statement, which pictures show for comparison.
    pub statement: Option<String>,
    /// Units of written and printed results.
    pub units: OutputUnits,
    /// The vehicle; varied parameters have their first values.
    pub vehicle: VehicleFile,
    /// Conditions that do not vary.
    pub fixed: NamedConditions,
    /// The varied parameters, one for each axis.
    pub axes: Vec<Parameter>,
    /// Their values.
    pub design: Design,
    /// The job; varied parameters have their first values.
    pub job: Job,
    /// Settings of landings; varied parameters have their first values.
    pub settings: Settings,
    /// Parameters whose effect on the first transition is computed.
    pub sensitivity: Vec<Parameter>,
    /// Set if the results cover only some of the points; they are then named and marked as partial.
    pub part: Option<Part>,
    /// The files read.
    pub(crate) sources: Vec<Source>,
    pub(crate) overrides: OverrideNames,
    pub(crate) document: Document,
}

/// Number of points of a sweep that have results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// Points with a result.
    pub points: usize,
    /// All points.
    pub of: usize,
}

/// Names of the files and words that override a sweep file.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct OverrideNames {
    pub(crate) vehicle: Option<PathBuf>,
    pub(crate) words: Vec<(String, String)>,
    #[serde(default)]
    pub(crate) set: Vec<(String, String)>,
    #[serde(default)]
    pub(crate) sensitivity: Vec<String>,
    #[serde(default)]
    pub(crate) units: Option<OutputUnits>,
}

/// Name of partial results of the sweep `stem`.
pub fn partial(stem: &str) -> String {
    format!("{stem}-partial")
}

impl Sweep {
    /// Name of the file without folder and extension, used to name results.
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        let stem = stem.to_string_lossy();
        match self.part {
            None => stem.into_owned(),
            Some(_) => partial(&stem),
        }
    }

    /// The files read, verbatim.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// Marks the sweep as partial: only `points` of its points have results.
    #[must_use]
    pub fn in_part(mut self, points: usize) -> Self {
        let of = self.design.count();
        self.title = format!("Partial, {points} of {of} points: {}", self.title);
        self.part = Some(Part { points, of });
        self
    }

    /// The places of a map; `None` for other designs.
    pub fn map(&self) -> Option<&RefinedGrid> {
        match &self.design {
            Design::Map(map) => Some(map),
            Design::Grid(_) | Design::Sample(_) => None,
        }
    }

    /// Number of legs of its vehicles.
    pub fn leg_count(&self) -> usize {
        self.vehicle.vehicle.leg_count()
    }

    /// The search, for a boundary sweep.
    pub fn search(&self) -> Option<&Search> {
        match &self.job {
            Job::Boundary(search) => Some(search),
            Job::Outcome { .. } => None,
        }
    }

    /// Headings of a table of results: the axes, then `columns`.
    pub fn headings(&self, columns: impl IntoIterator<Item = Heading>) -> Vec<Heading> {
        let axes = self.axes.iter().map(Parameter::heading);
        axes.chain(columns).collect()
    }

    /// Cells of coordinates, one for each axis, in the unit of its name.
    pub fn cells(&self, coordinates: &[f64]) -> Vec<Cell> {
        let varied = self.axes.iter().zip(coordinates);
        varied.map(|(axis, value)| axis.cell(*value)).collect()
    }

    /// Coordinates of a point as cells of its row.
    pub fn cells_of_point(&self, point: usize) -> Vec<Cell> {
        self.cells(&self.design.coordinates(point))
    }

    /// The coordinates of a point as text, in the units of results.
    pub fn place(&self, point: usize) -> String {
        let varied = self.axes.iter().zip(self.cells_of_point(point));
        let equation = |(axis, value): (&Parameter, Cell)| {
            let quantity = self.units.quantity(axis.name());
            format!("{} = {}", quantity.name(), quantity.cell(value))
        };
        varied.map(equation).collect::<Vec<_>>().join(", ")
    }
}
