//! `touchdown plot`: the pictures of result tables, anew.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use rayon::prelude::*;
use touchdown_figures::levels::Levels;
use touchdown_figures::picture::{self, Choices, Picture, Source};
use touchdown_figures::png;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::library::Library;
use touchdown_sweep::output::file_writer::Folder;

use crate::terminal::{Failure, print_paths};

const EXAMPLES: &str = "\
Examples:
  touchdown plot results/figure-4-09.csv
    writes results/figure-4-09.svg and .png

  touchdown plot results/surface-4-20.csv --levels 11,12,13,14,16,20 --out map.png
    writes map-contours.png and map-perspective.png, as two axes have two pictures

  touchdown plot results/trade.csv --worst-by friction,roll_deg --out map.png
    draws V_H over two of many axes, at worst over all others; without --worst-by a table over three
    axes has a contour map for each value of the third, too

  touchdown plot landing.csv --columns stroke_#_ft,clearance_ft --out strokes.svg
    draws these columns of a history, # for every leg

  touchdown plot soft.csv stiff.csv --out both.png
    draws several histories over each other

  touchdown plot results/sensitivity/critical-touchdown-sensitivity.csv
    draws the tornado chart

The table of bands (figure-4-09-bands.csv) and the record (figure-4-09.json) are read where they
stand beside the table: without the one only first transitions are drawn, without the other there
are no conditions. The record of a history is what `land --json` prints (landing.json).";

/// Options of `plot`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Result tables of sweeps, or histories of landings (CSV)
    #[arg(required = true, value_name = "FILE.csv")]
    tables: Vec<PathBuf>,
    /// Draw the transitions of a sweep over these one or two axes (commas between them), at worst over
    /// all others: of the points that agree in them, the one with the lowest first transition
    #[arg(long, alias = "least-over", value_name = "AXES", value_delimiter = ',')]
    worst_by: Vec<String>,
    /// Levels of the contour map, in the unit of the table (commas between them) [default: round ones from the data]
    #[arg(long, value_name = "LEVELS", value_delimiter = ',')]
    levels: Vec<f64>,
    /// Columns of a history (commas between them; # stands for every leg), those of one unit in one
    /// panel [default: velocity, attitude, stability, forces of struts and footpads, energies]
    #[arg(long, value_name = "COLUMNS", value_delimiter = ',')]
    columns: Vec<String>,
    /// The picture, .svg or .png; several histories are drawn over each other in it [default: both,
    /// beside each table]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Forms of picture files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Svg,
    Png,
}

/// Runs `plot`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let choices = Choices {
        levels: match options.levels.as_slice() {
            [] => None,
            levels => Some(
                Levels::listed(levels)
                    .map_err(|error| InputError::other(format!("--levels: {error}")))?,
            ),
        },
        worst_by: options.worst_by.clone(),
        columns: options.columns.clone(),
    };
    let tables = options.tables.iter().map(|path| Files::read(path));
    let tables = tables.collect::<Result<Vec<Files>, _>>()?;
    if let (Some(out), [_, _, ..]) = (&options.out, tables.as_slice()) {
        let picture = overlay(&tables, out, &choices)?;
        return write(out, &[picture], &[form_of(out)?]);
    }
    for files in &tables {
        let pictures = picture::draw(&files.source(), &choices);
        let pictures = pictures.map_err(|error| files.refuse(&error))?;
        match &options.out {
            Some(out) => write(out, &pictures, &[form_of(out)?])?,
            None => write(&files.path, &pictures, &[Form::Svg, Form::Png])?,
        }
    }
    Ok(())
}

/// A table, and what stands beside it.
struct Files {
    path: PathBuf,
    name: String,
    table: String,
    bands: Option<String>,
    edges: Option<String>,
    points: Option<String>,
    grid: Option<String>,
    record: Option<String>,
}

impl Files {
    fn read(path: &Path) -> Result<Self, InputError> {
        let table = Library::Disk.text(path)?;
        let name = stem(path);
        let beside = |name: String| fs::read_to_string(path.with_file_name(name)).ok();
        // Tables beside that of the points have the record of their sweep.
        let of_map = name.strip_suffix("-surface");
        let of_sweep = ["-sensitivity", "-probabilities", "-distribution"]
            .iter()
            .find_map(|end| name.strip_suffix(end))
            .or(of_map)
            .unwrap_or(&name);
        let record = beside(format!("{name}.json")).or_else(|| beside(format!("{of_sweep}.json")));
        Ok(Self {
            path: path.to_owned(),
            table,
            bands: beside(format!("{name}-bands.csv")),
            edges: of_map.and_then(|stem| beside(format!("{stem}-edges.csv"))),
            points: of_map.and_then(|stem| beside(format!("{stem}.csv"))),
            grid: of_map.and_then(|stem| beside(format!("{stem}-grid.csv"))),
            record,
            name,
        })
    }

    fn source(&self) -> Source<'_> {
        Source {
            name: &self.name,
            table: &self.table,
            bands: self.bands.as_deref(),
            edges: self.edges.as_deref(),
            points: self.points.as_deref(),
            grid: self.grid.as_deref(),
            record: self.record.as_deref(),
        }
    }

    fn refuse(&self, complaint: &impl ToString) -> InputError {
        InputError::in_file(&self.path, complaint.to_string())
    }
}

/// Histories drawn over each other.
fn overlay(tables: &[Files], out: &Path, choices: &Choices) -> Result<Picture, InputError> {
    if !tables.iter().all(|files| picture::is_history(&files.table)) {
        let complaint = "--out names one picture: expected one table or several histories with it";
        return Err(InputError::in_file(out, complaint));
    }
    let mut sources: Vec<Source> = tables.iter().map(Files::source).collect();
    // Files of one name are told apart by their folders.
    let paths: Vec<String> = tables
        .iter()
        .map(|files| files.path.display().to_string())
        .collect();
    let is_shared = |name: &str| tables.iter().filter(|files| files.name == name).count() > 1;
    for (source, path) in sources.iter_mut().zip(&paths) {
        if is_shared(source.name) {
            source.name = path;
        }
    }
    for files in tables {
        // A table that cannot be drawn is refused with its name.
        picture::overlay(&[files.source()], &Choices::default())
            .map_err(|error| files.refuse(&error))?;
    }
    let svg = picture::overlay(&sources, choices)
        .map_err(|error| InputError::in_file(out, error.to_string()))?;
    Ok(Picture {
        suffix: String::new(),
        svg,
    })
}

fn write(place: &Path, pictures: &[Picture], forms: &[Form]) -> Result<(), Failure> {
    let files = files(&stem(place), pictures, forms)?;
    print_paths(&Folder::of(place)?.write_files(&files)?)
}

/// Pictures of a table as SVG and PNG, by name.
pub fn both(stem: &str, pictures: &[Picture]) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    files(stem, pictures, &[Form::Svg, Form::Png])
}

fn files(
    stem: &str,
    pictures: &[Picture],
    forms: &[Form],
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let draw = |Picture { suffix, svg }: &Picture, form: &Form| {
        Ok(match form {
            Form::Svg => (format!("{stem}{suffix}.svg"), svg.clone().into_bytes()),
            Form::Png => (
                format!("{stem}{suffix}.png"),
                png::render(svg).map_err(Failure::running)?,
            ),
        })
    };
    pictures
        .par_iter()
        .flat_map_iter(|picture| forms.iter().map(move |form| draw(picture, form)))
        .collect()
}

fn form_of(out: &Path) -> Result<Form, InputError> {
    match out.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => Ok(Form::Svg),
        Some("png") => Ok(Form::Png),
        _ => Err(InputError::in_file(
            out,
            "is not the name of a picture: expected one that ends in .svg or .png",
        )),
    }
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
