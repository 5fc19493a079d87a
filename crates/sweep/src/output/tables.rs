//! The result tables of a sweep, written row by row from its journals.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;
use touchdown_input::documents::column::{Cell, Column, Heading, Kind, described, headings};
use touchdown_input::documents::history_columns::{OF_BODY, OF_LEG};
use touchdown_input::documents::output_units::Quantity;
use touchdown_input::points::refined_grid::RefinedGrid;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::Extent;

use crate::journal::{InOrder, JournalError};
use crate::maps::rounds::Rounds;
use crate::output::file_writer::{Draft, Folder, WriteError};
use crate::output::map_tables::{self, EDGE_COLUMNS, GRID_COLUMNS, SURFACE_COLUMNS};
use crate::output::parquet_table::{self, ParquetTable};
use crate::output::{bands_table, landing_table, results, sensitivity_table};
use crate::summary::findings::Finding;
use crate::summary::probabilities;
use crate::summary::sweep_counts::SweepCounts;
use crate::summary::transition_statistics::{
    DISTRIBUTION_COLUMNS, QUANTILE_COLUMNS, TransitionStatistics,
};

/// Tables that are written but not yet in place.
#[derive(Debug)]
pub struct Tables {
    /// Results of the points.
    pub points: Draft,
    /// Bands, if all were searched.
    pub bands: Option<Draft>,
    /// Probabilities of outcomes, for a sample of single landings.
    pub probabilities: Option<Draft>,
    /// Quantiles of the transition velocity, for a sample.
    pub quantiles: Option<Draft>,
    /// Their distribution.
    pub distribution: Option<Draft>,
    /// Sensitivities, if any.
    pub sensitivity: Option<Draft>,
    /// Edges of a map, and over two axes also its regular table and triangles.
    pub of_map: Vec<Draft>,
    /// The same tables as Parquet files, if requested.
    pub parquet: Vec<Draft>,
    /// Counts over the points.
    pub counts: SweepCounts,
}

/// Reason why tables could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TablesError {
    /// A journal cannot be read.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// A table cannot be written.
    #[error(transparent)]
    Deposit(#[from] WriteError),
    /// No journal has a readable result for this point.
    #[error("there is no result of point {0}")]
    Point(usize),
}

impl Tables {
    /// Writes the tables of a sweep beside their places in `folder`, points in grid order; for a partial sweep, only
    /// points with a result.
    ///
    /// # Errors
    /// If a result is missing, or something cannot be read or written.
    pub fn write(
        sweep: &Sweep,
        results: &mut InOrder,
        folder: &Folder,
        has_parquet: bool,
    ) -> Result<Self, TablesError> {
        let stem = sweep.stem();
        let begin = |end: &str, heading: &[Heading]| {
            Table::begin(folder, &format!("{stem}{end}"), heading, sweep, has_parquet)
        };
        let mut points = begin("", &results::heading(sweep))?;
        let has_bands = sweep
            .search()
            .is_some_and(|search| search.extent == Extent::All);
        let mut bands = match has_bands {
            true => Some(begin("-bands", &bands_table::heading(sweep))?),
            false => None,
        };
        let mut sensitivities = match sweep.sensitivity.is_empty() {
            false => Some(begin("-sensitivity", &sensitivity_table::heading(sweep))?),
            true => None,
        };
        let mut counts = SweepCounts::of(sweep);
        let rounds = sweep.map().map(|map| rounds(map, results)).transpose()?;
        let all: Box<dyn Iterator<Item = usize>> = match &rounds {
            Some((_, missing)) if !missing.is_empty() && sweep.part.is_none() => {
                return Err(TablesError::Point(missing[0]));
            }
            Some((rounds, _)) => Box::new(rounds.points().into_iter()),
            None => Box::new(0..sweep.design.count()),
        };
        for point in all {
            let bytes = results.result(point)?;
            if bytes.is_none() && sweep.part.is_some() {
                continue;
            }
            let finding = bytes.as_deref().and_then(Finding::decode);
            let finding = finding.ok_or(TablesError::Point(point))?;
            points.add(results::row(sweep, point, &finding))?;
            if let (Some(bands), Some(boundary)) = (&mut bands, finding.boundary()) {
                for row in bands_table::rows(sweep, point, boundary) {
                    bands.add(row)?;
                }
            }
            if let (
                Some(table),
                Finding::Sensitive {
                    boundary,
                    sensitivity,
                },
            ) = (&mut sensitivities, &finding)
            {
                for row in sensitivity_table::rows(sweep, point, boundary, sensitivity) {
                    table.add(row)?;
                }
            }
            counts.add(sweep, point, &finding);
            if counts.is_enough(sweep) {
                break;
            }
        }
        let whole = |end: &str, heading: Vec<Heading>, rows: Option<Vec<Vec<Cell>>>| {
            let Some(rows) = rows else {
                return Ok::<_, WriteError>(None);
            };
            let mut table = begin(end, &heading)?;
            for row in rows {
                table.add(row)?;
            }
            Ok(Some(table))
        };
        let overall = counts.outcomes.unwrap_or_default();
        let probabilities = counts.probabilities.as_ref();
        let probabilities = probabilities.map(|known| known.rows(sweep, &overall));
        let heading = probabilities::heading(sweep);
        let probabilities = whole("-probabilities", heading, probabilities)?;
        let transitions = counts.transitions.as_ref();
        let quantiles = transitions.map(TransitionStatistics::quantile_rows);
        let heading = headings(&QUANTILE_COLUMNS, 0).collect();
        let quantiles = whole("-quantiles", heading, quantiles)?;
        let distribution = transitions.map(TransitionStatistics::distribution_rows);
        let heading = headings(&DISTRIBUTION_COLUMNS, 0).collect();
        let distribution = whole("-distribution", heading, distribution)?;
        let (points, mut parquet) = points.end()?;
        let mut end = |table: Option<Table>| -> Result<Option<Draft>, WriteError> {
            let Some(table) = table else {
                return Ok(None);
            };
            let (csv, more) = table.end()?;
            parquet.extend(more);
            Ok(Some(csv))
        };
        if let Some((rounds, _)) = &rounds {
            counts.coarse_cells = rounds.coarse_cells();
        }
        let mut of_map = Vec::new();
        let of_rounds = rounds.iter();
        for written in of_rounds.flat_map(|(rounds, _)| map_tables::all(sweep, rounds)) {
            let mut table = begin(written.end, &written.heading)?;
            for row in written.rows {
                table.add(row)?;
            }
            of_map.extend(end(Some(table))?);
        }
        Ok(Self {
            points,
            bands: end(bands)?,
            probabilities: end(probabilities)?,
            quantiles: end(quantiles)?,
            distribution: end(distribution)?,
            sensitivity: end(sensitivities)?,
            of_map,
            parquet,
            counts,
        })
    }
}

/// Collects the points of a map that have results, and the missing ones.
///
/// # Errors
/// If a journal cannot be read.
pub fn rounds<'m>(
    map: &'m RefinedGrid,
    results: &mut InOrder,
) -> Result<(Rounds<'m>, Vec<usize>), JournalError> {
    Rounds::of_results(map, |point| {
        let bytes = results.result(point)?;
        Ok(bytes.as_deref().and_then(Finding::decode))
    })
}

/// A table being written. Rows are given in program units and written in those of results.
struct Table {
    quantities: Vec<Quantity>,
    writer: csv::Writer<Draft>,
    path: PathBuf,
    parquet: Option<(ParquetTable<Draft>, PathBuf)>,
}

impl Table {
    fn begin(
        folder: &Folder,
        stem: &str,
        heading: &[Heading],
        sweep: &Sweep,
        has_parquet: bool,
    ) -> Result<Self, WriteError> {
        let name = |ending: &str| format!("{stem}.{ending}");
        let quantities = heading.iter().map(|one| sweep.units.quantity(&one.name));
        let quantities: Vec<Quantity> = quantities.collect();
        let parquet = match has_parquet {
            false => None,
            true => {
                let path = folder.path(&name("parquet"));
                let names = quantities.iter().map(Quantity::name);
                let columns: Vec<(&str, Kind)> =
                    names.zip(heading.iter().map(|one| one.kind)).collect();
                let draft = folder.draft(&name("parquet"))?;
                let table = ParquetTable::begin(draft, parquet_table::of_sweep(sweep), &columns);
                Some((table.map_err(|error| refuse(&path, error))?, path))
            }
        };
        let path = folder.path(&name("csv"));
        let mut writer = csv::Writer::from_writer(folder.draft(&name("csv"))?);
        let written = writer.write_record(quantities.iter().map(Quantity::name));
        written.map_err(|error| refuse(&path, error.into()))?;
        Ok(Self {
            quantities,
            writer,
            path,
            parquet,
        })
    }

    fn add(&mut self, row: Vec<Cell>) -> Result<(), WriteError> {
        let row = self.quantities.iter().zip(row);
        let row: Vec<Cell> = row.map(|(quantity, cell)| quantity.cell(cell)).collect();
        let written = self.writer.write_record(row.iter().map(Cell::to_string));
        written.map_err(|error| refuse(&self.path, error.into()))?;
        if let Some((table, path)) = &mut self.parquet {
            table.add(row).map_err(|error| refuse(path, error))?;
        }
        Ok(())
    }

    /// Ends the table; its CSV and Parquet files.
    fn end(self) -> Result<(Draft, Vec<Draft>), WriteError> {
        let csv = self.writer.into_inner();
        let csv = csv.map_err(|error| refuse(&self.path, error.into_error()))?;
        let parquet = self
            .parquet
            .map(|(table, path)| table.end().map_err(|error| refuse(&path, error)));
        Ok((csv, parquet.transpose()?.into_iter().collect()))
    }
}

fn refuse(path: &Path, error: io::Error) -> WriteError {
    let path = path.to_owned();
    WriteError { path, error }
}

/// Widths of edges, one for each refined axis.
const WITHIN: [Column<()>; 1] = [Column::number(
    "within_AXIS",
    |()| None,
    "for each refined axis: half the distance of these two points; the edge passes between them",
)
.in_unit("of the axis")];

/// Columns of all tables as `docs/output.md` lists them: tables by their name there, each as its rows in Markdown.
pub fn documented() -> Vec<(&'static str, String)> {
    vec![
        ("transitions", described(&results::COLUMNS)),
        ("bands", described(&bands_table::COLUMNS)),
        ("map points", described(&results::OF_MAP_POINTS)),
        ("map edges", described(&EDGE_COLUMNS) + &described(&WITHIN)),
        ("map grid", described(&GRID_COLUMNS)),
        ("map surface", described(&SURFACE_COLUMNS)),
        ("landings", described(&landing_table::COLUMNS)),
        ("reports", described(&landing_table::OF_REPORTS)),
        ("history", described(&OF_BODY) + &described(&OF_LEG)),
        ("sensitivities", described(&sensitivity_table::COLUMNS)),
        ("probabilities", described(&probabilities::columns())),
        ("quantiles", described(&QUANTILE_COLUMNS)),
        ("distribution", described(&DISTRIBUTION_COLUMNS)),
    ]
}
