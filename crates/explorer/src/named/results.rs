//! Tables of results, with their accompanying files.

use std::path::Path;

use touchdown_input::documents::column_units::units_of_names;
use touchdown_input::documents::input_error::InputError;

use super::Reading;
use super::record;
use super::source::{Source, stem};

/// Column after the axes in tables of transitions, and in tables of landings.
const TRANSITIONS: &str = "first_transition_to";
const LANDINGS: &str = "outcome";

/// Kind of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResultsKind {
    /// Transitions over two or more axes.
    Map,
    /// Transitions over one axis.
    Profile,
    /// One landing per row.
    Sample,
}

impl ResultsKind {
    /// Word in answers.
    pub fn word(self) -> &'static str {
        match self {
            Self::Map => "map",
            Self::Profile => "profile",
            Self::Sample => "sample",
        }
    }
}

/// A table of results.
#[derive(Debug, Clone)]
pub struct Results {
    /// Name in requests.
    pub name: String,
    /// File.
    pub file: String,
    /// Kind.
    pub kind: ResultsKind,
    /// Names of the axes.
    pub axes: Vec<String>,
    /// Number of rows.
    pub points: usize,
    /// Name of the source of its landings, if there is a record of its input.
    pub source: Option<String>,
    /// The table.
    pub table: String,
    /// The table of bands beside it.
    pub bands: Option<String>,
    /// The triangles of a refined map.
    pub surface: Option<String>,
    /// Its edges.
    pub edges: Option<String>,
    /// The record.
    pub record: Option<String>,
}

impl Results {
    /// Reads a table, and the touchdown in the record beside it; `None` if it has neither transitions nor landings.
    pub(crate) fn read(
        reading: &mut Reading,
        file: &Path,
    ) -> Result<Option<(Self, Option<Source>)>, InputError> {
        let table = reading.library.text(file)?;
        let heading = table.lines().next().unwrap_or_default();
        let names: Vec<&str> = heading.split(',').collect();
        let place = |name: &str| names.iter().position(|known| *known == name);
        let (kind, axes) = match (place(TRANSITIONS), place(LANDINGS)) {
            (Some(1), _) => (ResultsKind::Profile, 1),
            (Some(axes @ 2..), _) => (ResultsKind::Map, axes),
            (None, Some(axes @ 1..)) if names[0] != "case" => (ResultsKind::Sample, axes),
            _ => return Ok(None),
        };
        reading.text(file)?;
        let name = stem(file);
        let mut beside = |ending: &str| {
            let path = file.with_file_name(format!("{name}{ending}"));
            reading.optional_text(&path)
        };
        let bands = beside("-bands.csv")?;
        let surface = beside("-surface.csv")?;
        let edges = beside("-edges.csv")?;
        let record = beside(".json")?;
        let row = table.lines().nth(1).unwrap_or_default();
        let first = names[..axes].iter().copied().zip(row.split(','));
        let source = match &record {
            Some(record) => {
                let source = record::source(record, &file.with_extension("json"))?;
                let units = units_of_names(names.iter().copied()).unwrap_or_default();
                Some(Source {
                    units,
                    ..source.with(first)?
                })
            }
            None => None,
        };
        let results = Self {
            name,
            file: file.display().to_string(),
            kind,
            axes: names[..axes].iter().map(|&name| name.to_owned()).collect(),
            points: table.lines().count().saturating_sub(1),
            source: None,
            bands,
            surface,
            edges,
            record,
            table,
        };
        Ok(Some((results, source)))
    }
}
