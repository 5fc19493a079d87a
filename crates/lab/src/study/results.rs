//! Result tables that a study draws upon.

use std::fs;
use std::path::{Path, PathBuf};

use touchdown_figures::FigureError;
use touchdown_figures::bands_table::BandsTable;
use touchdown_figures::boundary_table::{BoundaryTable, Kind, Transition};
use touchdown_input::documents::input_error::InputError;

/// A folder with the results of sweeps.
pub struct Results {
    folder: PathBuf,
}

/// The first transitions of a sweep.
pub struct Transitions {
    file: PathBuf,
    table: BoundaryTable,
}

impl Results {
    pub fn new(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
        }
    }

    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The results of a variant of the study, in a folder of their own.
    pub fn variant(&self, name: &str) -> Self {
        Self::new(&self.folder.join(name))
    }

    /// First transitions of the sweep `stem`.
    pub fn transitions(&self, stem: &str) -> Result<Transitions, InputError> {
        let file = self.folder.join(format!("{stem}.csv"));
        let table = read(&file, BoundaryTable::parse)?;
        Ok(Transitions { file, table })
    }

    /// Bands of the sweep `stem`.
    pub fn bands(&self, stem: &str) -> Result<BandsTable, InputError> {
        read(
            &self.folder.join(format!("{stem}-bands.csv")),
            BandsTable::parse,
        )
    }
}

fn read<T>(file: &Path, parse: impl Fn(&str) -> Result<T, FigureError>) -> Result<T, InputError> {
    let text = fs::read_to_string(file).map_err(|error| {
        let expected = "expected results of the sweeps that `touchdown-lab study --help` names";
        InputError::unreadable(file, format!("{error}; {expected}"))
    })?;
    parse(&text).map_err(|error| InputError::in_file(file, error.to_string()))
}

impl Transitions {
    /// All points: coordinates, and the transition if there is one.
    pub fn points(&self) -> impl Iterator<Item = (&[f64], Option<Transition>)> {
        let points = self.table.points.iter();
        points.map(|point| (point.coordinates.as_slice(), point.transition))
    }

    /// The transition at a point of the grid, if there is one.
    ///
    /// # Errors
    /// When the grid has no such point.
    pub fn at(&self, place: &[f64]) -> Result<Option<Transition>, InputError> {
        let point = self.points().find(|(coordinates, _)| *coordinates == place);
        point
            .map(|(_, transition)| transition)
            .ok_or_else(|| InputError::in_file(&self.file, format!("has no point {place:?}")))
    }

    /// The point with the lowest transition.
    ///
    /// # Errors
    /// When no point has one.
    pub fn lowest(&self) -> Result<(&[f64], f64), InputError> {
        self.points()
            .filter_map(|(place, transition)| Some((place, transition?.speed)))
            .min_by(|(_, a), (_, b)| a.total_cmp(b))
            .ok_or_else(|| InputError::in_file(&self.file, "has no transition"))
    }
}

/// Points of a table of bands in which landings of a kind occur at any speed.
pub fn with_kind(bands: &BandsTable, kind: Kind) -> Vec<&[f64]> {
    let has = |bands: &[touchdown_figures::bands_table::Band]| {
        bands.iter().any(|band| band.kind == Some(kind))
    };
    let points = bands.points.iter();
    points
        .filter(|(_, bands)| has(bands))
        .map(|(place, _)| place.as_slice())
        .collect()
}
