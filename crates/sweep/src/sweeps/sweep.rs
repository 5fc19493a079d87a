//! A sweep: what lands, what varies, and what is asked at every point.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::scene::Settings;

use crate::design::Design;
use crate::document::Document;
use crate::parameter::Parameter;
use crate::refined_grid::RefinedGrid;
use crate::scene_input::NamedConditions;
use crate::search_range::Search;
use crate::source::Source;
use crate::vehicle_file::VehicleFile;

/// Keys of a sweep file.
pub(crate) const SWEEP: [&str; 11] = [
    "title",
    "statement",
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
    pub(crate) overrides: OverrideNames,
    pub(crate) document: Document,
}

/// Names of the files and words that override a sweep file.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct OverrideNames {
    pub(crate) vehicle: Option<PathBuf>,
    pub(crate) words: Vec<(String, String)>,
    #[serde(default)]
    pub(crate) sensitivity: Vec<String>,
}

impl Sweep {
    /// Name of the file without folder and ending: results are named after it.
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        stem.to_string_lossy().into_owned()
    }

    /// The places of its points, if it is a map.
    pub fn map(&self) -> Option<&RefinedGrid> {
        match &self.design {
            Design::Map(map) => Some(map),
            Design::Grid(_) | Design::Sample(_) => None,
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
