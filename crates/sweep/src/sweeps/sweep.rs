//! A sweep: the vehicle, what varies, and what is computed at every point.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::scene::Settings;

use crate::design::Design;
use crate::document::Document;
use crate::output_units::{OutputUnits, UNITS};
use crate::parameter::Parameter;
use crate::refined_grid::RefinedGrid;
use crate::scene_input::NamedConditions;
use crate::search_range::Search;
use crate::source::Source;
use crate::vehicle_file::VehicleFile;

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

/// What a sweep computes at every point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Job {
    /// The horizontal velocity from which landings are no longer stable.
    Boundary(Search),
    /// How one landing ends.
    Outcome {
        /// Width of the intervals of the probabilities at which the sweep stops.
        enough: Option<f64>,
    },
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
    /// The units of what is written and printed of it.
    pub units: OutputUnits,
    /// The vehicle; what varies of it has its first value.
    pub vehicle: VehicleFile,
    /// Conditions that do not vary.
    pub fixed: NamedConditions,
    /// The parameters that vary, one for each axis.
    pub axes: Vec<Parameter>,
    /// Their values.
    pub design: Design,
    /// What is computed at every point; what varies of it has its first value.
    pub job: Job,
    /// How landings are computed; what varies of it has its first value.
    pub settings: Settings,
    /// Parameters whose effect on the first transition is computed.
    pub sensitivity: Vec<Parameter>,
    /// Set where results are those of some of the points: they are named and marked as such.
    pub part: Option<Part>,
    /// The files that were read.
    pub(crate) sources: Vec<Source>,
    pub(crate) overrides: OverrideNames,
    pub(crate) document: Document,
}

/// How many points of a sweep there are results of.
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

/// Name of the results of a part of the points of the sweep `stem`.
pub fn partial(stem: &str) -> String {
    format!("{stem}-partial")
}

impl Sweep {
    /// Name of the file without folder and ending, which results are named after.
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        let stem = stem.to_string_lossy();
        match self.part {
            None => stem.into_owned(),
            Some(_) => partial(&stem),
        }
    }

    /// The files that were read, word for word.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// The same sweep, of whose points there are results of some only.
    #[must_use]
    pub fn in_part(mut self, points: usize) -> Self {
        let of = self.design.count();
        self.title = format!("Partial, {points} of {of} points: {}", self.title);
        self.part = Some(Part { points, of });
        self
    }

    /// The places of its points, if it is a map.
    pub fn map(&self) -> Option<&RefinedGrid> {
        match &self.design {
            Design::Map(map) => Some(map),
            Design::Grid(_) | Design::Sample(_) => None,
        }
    }

    /// Number of legs of its vehicles.
    pub fn leg_count(&self) -> usize {
        self.vehicle.vehicle.legs().len()
    }

    /// Where to search, if the sweep searches.
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

    /// The coordinates of a point as text, in the units of results.
    pub fn place(&self, point: usize) -> String {
        let written = self.coordinates_written(point);
        let varied = self.axes.iter().zip(written);
        let equation = |(axis, value): (&Parameter, String)| {
            let quantity = self.units.quantity(axis.name());
            format!("{} = {}", quantity.name(), quantity.cell(&value))
        };
        varied.map(equation).collect::<Vec<_>>().join(", ")
    }
}
