//! `touchdown plot`: the pictures of result tables, anew.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use rayon::prelude::*;
use touchdown_figures::picture::{self, Picture};
use touchdown_figures::png;
use touchdown_sweep::file_writer::Folder;
use touchdown_sweep::input_error::{InputError, Place};

use crate::failure::Failure;
use crate::print::print;
use crate::worst_case;

const EXAMPLES: &str = "\
Examples:
  touchdown plot results/figure-4-09.csv
    writes results/figure-4-09.svg and .png

  touchdown plot results/surface-4-20.csv --out map.png
    writes map-contours.png and map-perspective.png, as two axes have two pictures

  touchdown plot results/trade.csv --least-over friction,roll_deg --out map.png
    draws the worst of everything else over two of many axes

  touchdown plot results/sensitivity/critical-touchdown-sensitivity.csv
    draws the tornado chart

The table of bands (figure-4-09-bands.csv) and the record (figure-4-09.json) are read where they
stand beside the table: without the one only first transitions are drawn, without the other there
is no title.";

/// Options of `plot`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Result tables of sweeps (CSV)
    #[arg(required = true, value_name = "FILE.csv")]
    tables: Vec<PathBuf>,
    /// Draw over these axes only (commas between them): of all points that agree in them, the one
    /// with the lowest first transition
    #[arg(long, value_name = "AXES", value_delimiter = ',')]
    least_over: Vec<String>,
    /// The picture, .svg or .png [default: both, beside the table]
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
    if let (Some(out), true) = (&options.out, options.tables.len() > 1) {
        let complaint = "--out names one picture: expected one table with it";
        return Err(InputError::other(complaint).at(Place::file(out)).into());
    }
    for table in &options.tables {
        let pictures = draw(table, &options.least_over)?;
        let place = options.out.as_deref().unwrap_or(table);
        let forms = match &options.out {
            Some(out) => vec![form_of(out)?],
            None => vec![Form::Svg, Form::Png],
        };
        let files = Folder::of(place)?.write_files(&files(&stem(place), &pictures, &forms)?)?;
        for file in files {
            print(&format!("{}\n", file.display()))?;
        }
    }
    Ok(())
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
        _ => Err(InputError::other(
            "is no name of a picture: expected one that ends in .svg or .png",
        )
        .at(Place::file(out))),
    }
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}

fn draw(table: &Path, least_over: &[String]) -> Result<Vec<Picture>, InputError> {
    let refuse = |complaint: String| InputError::other(complaint).at(Place::file(table));
    let text =
        fs::read_to_string(table).map_err(|error| refuse(format!("cannot be read: {error}")))?;
    let beside = |ending: &str| {
        let name = format!("{}{ending}", stem(table));
        fs::read_to_string(table.with_file_name(name)).ok()
    };
    // Tables beside that of the points have no record of their own.
    let of_sweep = ["-sensitivity", "-probabilities", "-distribution"]
        .iter()
        .find_map(|end| {
            let stem = stem(table).strip_suffix(end)?.to_owned();
            fs::read_to_string(table.with_file_name(format!("{stem}.json"))).ok()
        });
    let record = beside(".json").or(of_sweep);
    let (text, bands) = match least_over {
        [] => (text, beside("-bands.csv")),
        axes => (worst_case::over(&text, axes).map_err(refuse)?, None),
    };
    let pictures = picture::draw(&text, bands.as_deref(), record.as_deref())
        .map_err(|error| refuse(error.to_string()))?;
    if pictures.is_empty() {
        return Err(refuse(
            "has no picture: expected tables over one axis or a grid of two".to_owned(),
        ));
    }
    Ok(pictures)
}
