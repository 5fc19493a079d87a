//! `touchdown merge`: results from the journals of all shards.

use std::path::PathBuf;

use clap::Args;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::journal::merge::{Shards, by_sweep};
use touchdown_sweep::journal::shard::journals_in;
use touchdown_sweep::journal::{Access, InOrder};
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::results::Circumstances;
use touchdown_sweep::output::{result_files, tables};

use crate::options::UnitsOption;
use crate::summary;
use crate::sweep_results::{self, Format};
use crate::terminal::{Failure, print};

const EXAMPLE: &str = "\
Example:
  touchdown sweep trade.toml --out night --shard 1/2      # on one machine
  touchdown sweep trade.toml --out night --shard 2/2      # on another
  touchdown merge night                                   # the journals together
  touchdown merge night --partial                         # what there is of them before

Shards stay where they are. Nothing but the journals is needed.";

/// Options of `merge`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// Folder with the journals of all shards of one or several sweeps
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Folder for the results [default: the one with the journals]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Make results of the points that are finished, of sweeps that are still running too: files
    /// named NAME-partial, marked as such
    #[arg(long)]
    partial: bool,
    /// Form of the tables
    #[arg(long, value_name = "FORMAT", default_value = "csv")]
    format: Format,
    #[command(flatten)]
    units: UnitsOption,
    /// Also replace results of other input, and files that are no results of a sweep
    #[arg(long)]
    overwrite: bool,
    /// Print nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// Runs `merge`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let refuse = |complaint| Failure::from(InputError::in_file(&options.folder, complaint));
    let journals = journals_in(&options.folder)
        .map_err(|error| InputError::unreadable(&options.folder, error))?;
    if journals.is_empty() {
        return Err(refuse(
            "has no journals: expected at least one file *.journal",
        ));
    }
    let access = match options.partial {
        true => Access::Shared,
        false => Access::Alone,
    };
    let sweeps = by_sweep(&journals, access)?;
    if sweeps.is_empty() {
        return Err(refuse("has no journals of sweeps"));
    }
    let folder = Folder::open(options.out.as_ref().unwrap_or(&options.folder))?;
    let mut told = String::new();
    for shards in sweeps {
        told += &merge(shards, &folder, options)?;
    }
    match options.quiet {
        true => Ok(()),
        false => print(&told),
    }
}

/// Writes the results of a sweep; in words.
fn merge(shards: Shards, folder: &Folder, options: &Options) -> Result<String, Failure> {
    let Shards {
        header,
        journals,
        absent,
    } = shards;
    // Journals of other runs are no shards.
    let Some(mut sweep) = header.sweep()? else {
        return Ok(String::new());
    };
    sweep.units = options.units.given.unwrap_or(sweep.units);
    let mut points = header.points;
    let mut results = InOrder::new(journals, points, &folder.path("."))?;
    let missing = match sweep.map() {
        Some(map) => {
            let (rounds, missing) = tables::rounds(map, &mut results)?;
            points = rounds.points().len() + missing.len();
            missing.len()
        }
        None => results.missing(),
    };
    if options.partial && missing > 0 {
        sweep = sweep.in_part(points - missing);
        if missing == points {
            return Err(Failure::running(format!(
                "{}: none of {points} points is finished",
                sweep.path.display()
            )));
        }
    } else if missing > 0 {
        return Err(incomplete(&sweep, &mut results, &absent, points));
    }
    result_files::check_places(&sweep, folder, options.overwrite)?;
    let circumstances = Circumstances {
        version: env!("CARGO_PKG_VERSION"),
        threads: None,
        wall_time: None,
    };
    let written =
        sweep_results::write(&sweep, &mut results, folder, circumstances, options.format)?;
    Ok(summary::sweep(
        &sweep,
        &written.counts,
        circumstances,
        &written.files,
        written.remark.as_deref(),
    ))
}

/// Which points are missing, and which shards.
fn incomplete(sweep: &Sweep, results: &mut InOrder, absent: &[usize], points: usize) -> Failure {
    const SHOWN: usize = 10;
    let first = match sweep.map() {
        Some(map) => match tables::rounds(map, results) {
            Ok((_, missing)) => missing.into_iter().take(SHOWN).collect(),
            Err(error) => return error.into(),
        },
        None => match results.first_missing(SHOWN) {
            Ok(first) => first,
            Err(error) => return Failure::running(error),
        },
    };
    let missing = match sweep.map() {
        // More points may follow from these.
        Some(_) => "points".to_owned(),
        None => format!("{} of {points} points", results.missing()),
    };
    let places: Vec<String> = first
        .iter()
        .map(|point| format!("point {point} ({})", sweep.place(*point)))
        .collect();
    let shards = match absent {
        [] => String::new(),
        absent => format!("there is no journal of shards {}, ", listed(absent, SHOWN)),
    };
    Failure::running(format!(
        "{}: {shards}{missing} are missing (--partial makes results of the others), the first:\n  {}",
        sweep.stem(),
        places.join("\n  ")
    ))
}

fn listed(numbers: &[usize], most: usize) -> String {
    let shown: Vec<String> = numbers.iter().take(most).map(usize::to_string).collect();
    let rest = if numbers.len() > most { ", …" } else { "" };
    shown.join(", ") + rest
}
