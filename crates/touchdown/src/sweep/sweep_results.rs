//! The files that a sweep leaves: tables, record and pictures.

use std::path::PathBuf;

use clap::ValueEnum;
use touchdown_figures::FigureError;
use touchdown_figures::picture::{self, Choices, Source};
use touchdown_input::points::design::Design;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::journal::InOrder;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::result_files::{self, NamedFiles};
use touchdown_sweep::output::results::Circumstances;
use touchdown_sweep::output::tables::Tables;
use touchdown_sweep::summary::sweep_counts::SweepCounts;

use crate::plot;
use crate::terminal::Failure;

/// Longest table that is drawn, bytes: beyond it nothing could be made out. Of a table over more axes than
/// pictures can show, the worst case over the others is drawn, so that it may be longer.
const LONGEST_DRAWN: u64 = 4 << 20;
const LONGEST_REDUCED: u64 = 64 << 20;
/// Axes that pictures can show.
const MOST_DRAWN_AXES: usize = 2;

/// Forms of the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Comma-separated values
    Csv,
    /// Parquet beside the CSV files, with units and the whole input in the metadata
    Parquet,
}

/// What was written of a sweep.
pub struct Written {
    /// Its points in numbers.
    pub counts: SweepCounts,
    /// How it was run.
    pub circumstances: Circumstances<'static>,
    /// The files.
    pub files: Vec<PathBuf>,
    /// Which pictures there are not, and how they can be drawn.
    pub remark: Option<String>,
}

/// Writes all results of a sweep into a folder.
pub fn write(
    sweep: &Sweep,
    results: &mut InOrder,
    folder: &Folder,
    circumstances: Circumstances<'static>,
    format: Format,
) -> Result<Written, Failure> {
    let mut remark = None;
    let draw = |tables: &Tables, record: &str| {
        let (mut files, said) = pictures(sweep, tables, record, folder)?;
        remark = said;
        files.extend(charts(sweep, tables, record)?);
        Ok::<_, Failure>(files)
    };
    let has_parquet = format == Format::Parquet;
    let version = circumstances.version;
    let (counts, files) = result_files::write(sweep, results, folder, version, has_parquet, draw)?;
    Ok(Written {
        counts,
        circumstances,
        files,
        remark,
    })
}

/// Charts of the tables beside that of the points: the tornado chart where anything has a derivative, probabilities by
/// bin, the distribution of transition velocities.
fn charts(sweep: &Sweep, tables: &Tables, record: &str) -> Result<NamedFiles, Failure> {
    let [_, smooth] = tables.counts.slopes;
    let sensitivity = tables.sensitivity.as_ref().filter(|_| smooth > 0);
    let mut files = Vec::new();
    for (end, table) in [
        ("-sensitivity", sensitivity),
        ("-probabilities", tables.probabilities.as_ref()),
        ("-distribution", tables.distribution.as_ref()),
    ] {
        let text = table.map(|table| table.text(LONGEST_DRAWN)).transpose()?;
        if let Some(text) = text.flatten() {
            let source = Source {
                table: &text,
                record: Some(record),
                ..Source::default()
            };
            let pictures = picture::draw(&source, &Choices::default()).map_err(Failure::running)?;
            files.extend(plot::both(&format!("{}{end}", sweep.stem()), &pictures)?);
        }
    }
    Ok(files)
}

/// The pictures of a boundary over a grid, and what is to be said of those that there are not.
fn pictures(
    sweep: &Sweep,
    tables: &Tables,
    record: &str,
    folder: &Folder,
) -> Result<(NamedFiles, Option<String>), Failure> {
    // Samples have a picture of their distribution.
    if matches!(sweep.design, Design::Sample(_)) {
        return Ok((Vec::new(), None));
    }
    let none = |reason: &str| Ok((Vec::new(), Some(format!("no picture: {reason}"))));
    if let [edges, grid, surface] = tables.of_map.as_slice() {
        let [edges, grid, surface, points] =
            [edges, grid, surface, &tables.points].map(|table| table.text(LONGEST_REDUCED));
        let (edges, grid, surface, points) = (edges?, grid?, surface?, points?);
        let source = Source {
            name: &sweep.stem(),
            table: surface.as_deref().unwrap_or_default(),
            edges: edges.as_deref(),
            points: points.as_deref(),
            grid: grid.as_deref(),
            record: Some(record),
            ..Source::default()
        };
        if source.table.lines().nth(1).is_none() {
            return none("there is no surface, or one of too many triangles");
        }
        return match picture::draw(&source, &Choices::default()) {
            Ok(pictures) => Ok((plot::both(&sweep.stem(), &pictures)?, None)),
            Err(FigureError::NoPicture(reason)) => none(&reason),
            Err(error) => Err(Failure::running(error)),
        };
    }
    let is_reduced = sweep.axes.len() > MOST_DRAWN_AXES;
    let longest = if is_reduced {
        LONGEST_REDUCED
    } else {
        LONGEST_DRAWN
    };
    let stem = sweep.stem();
    let table = folder.path(&format!("{stem}.csv"));
    let Some(points) = tables.points.text(longest)? else {
        let table = table.display();
        return none(&format!(
            "the table has more than {} MB: `touchdown plot {table}` draws it",
            longest >> 20
        ));
    };
    let bands = match &tables.bands {
        Some(bands) => bands.text(LONGEST_DRAWN)?,
        None => None,
    };
    let points = drawable(sweep, points);
    if points.lines().nth(1).is_none() {
        return none("no row is complete");
    }
    let bands = bands.filter(|_| sweep.part.is_none() || sweep.axes.len() == 1);
    let source = Source {
        name: &stem,
        table: &points,
        bands: bands.as_deref(),
        record: Some(record),
        ..Source::default()
    };
    let pictures = match picture::draw(&source, &Choices::default()) {
        Ok(pictures) => pictures,
        Err(FigureError::NoPicture(reason)) => return none(&reason),
        Err(error) => return Err(Failure::running(error)),
    };
    let remark = is_reduced.then(|| {
        let [.., slow, fast] = sweep.axes.as_slice() else {
            return String::new();
        };
        let [slow, fast] = [slow, fast].map(|axis| sweep.units.quantity(axis.name()));
        format!(
            "{stem}-contours and {stem}-perspective show V_H at worst over all axes but two: \
             `touchdown plot {} --worst-by {},{}` and the like draw others",
            table.display(),
            slow.name(),
            fast.name()
        )
    });
    Ok((plot::both(&stem, &pictures)?, remark))
}

/// The part of a table of points that pictures can show: of a sweep in part over two axes, the values of the first axis
/// at which all points are there.
fn drawable(sweep: &Sweep, points: String) -> String {
    let Design::Grid(grid) = &sweep.design else {
        return points;
    };
    let [_, fast] = grid.dimensions() else {
        return points;
    };
    if sweep.part.is_none() {
        return points;
    }
    let whole = grid.axes()[fast[0]].count();
    let slow = |row: &str| row.split(',').next().map(str::to_owned);
    let rows: Vec<&str> = points.lines().collect();
    let is_whole = |group: &&[&str]| group.len() == whole;
    let (heading, rows) = rows.split_at(1.min(rows.len()));
    let groups = rows.chunk_by(|a, b| slow(a) == slow(b)).filter(is_whole);
    let drawn = heading.iter().chain(groups.flatten());
    drawn.map(|row| format!("{row}\n")).collect()
}
