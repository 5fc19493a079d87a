//! `touchdown merge`: results from the journals of all shards.

use std::path::PathBuf;

use clap::Args;
use touchdown_sweep::file_writer::Folder;
use touchdown_sweep::input_error::{InputError, Place};
use touchdown_sweep::journal::InOrder;
use touchdown_sweep::merge::{Shards, by_sweep};
use touchdown_sweep::results::Circumstances;
use touchdown_sweep::sweep_file::Sweep;
use touchdown_sweep::tables;

use crate::failure::Failure;
use crate::print::print;
use crate::sweep_results::Format;
use crate::{journal_files, summary, sweep_results};

const EXAMPLE: &str = "\
Example:
  touchdown sweep trade.toml --out night --shard 1/2      # on one machine
  touchdown sweep trade.toml --out night --shard 2/2      # on another
  touchdown merge night                                   # the journals together

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
    /// Form of the tables
    #[arg(long, value_name = "FORMAT", default_value = "csv")]
    format: Format,
    /// Print nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// Runs `merge`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let refuse = |complaint: String| {
        Failure::from(InputError::other(complaint).at(Place::file(&options.folder)))
    };
    let journals = journal_files::in_folder(&options.folder)
        .map_err(|error| refuse(format!("cannot be read: {error}")))?;
    if journals.is_empty() {
        return Err(refuse(
            "has no journals: required is at least one file *.journal".to_owned(),
        ));
    }
    let sweeps = by_sweep(&journals)?;
    let folder = Folder::open(options.out.as_ref().unwrap_or(&options.folder))?;
    let mut told = String::new();
    for shards in sweeps {
        told += &merge(shards, &folder, options.format)?;
    }
    match options.quiet {
        true => Ok(()),
        false => print(&told),
    }
}

/// Writes the results of a sweep; in words.
fn merge(shards: Shards, folder: &Folder, format: Format) -> Result<String, Failure> {
    const SHOWN: usize = 10;
    let Shards {
        header,
        journals,
        absent,
    } = shards;
    let sweep: Sweep = header.sweep()?;
    let points = header.points;
    let mut results = InOrder::new(journals, points, &folder.path("."))?;
    let (missing, first) = tables::missing(&sweep, &mut results, SHOWN)?;
    if missing > 0 {
        let places: Vec<String> = first
            .iter()
            .map(|point| format!("point {point} ({})", sweep.place(*point)))
            .collect();
        let shards = match absent.as_slice() {
            [] => String::new(),
            absent => format!("there is no journal of shards {}, ", listed(absent, SHOWN)),
        };
        let of_all = match sweep.map() {
            // More may follow from them.
            Some(_) => " or more".to_owned(),
            None => format!(" of {points}"),
        };
        return Err(Failure::running(format!(
            "{}: {shards}{missing}{of_all} points are missing, the first:\n  {}",
            sweep.stem(),
            places.join("\n  ")
        )));
    }
    let circumstances = Circumstances {
        version: env!("CARGO_PKG_VERSION"),
        threads: None,
        wall_time: None,
    };
    let written = sweep_results::write(&sweep, &mut results, folder, circumstances, format)?;
    Ok(summary::sweep(
        &sweep,
        &written.counts,
        circumstances,
        &written.files,
        written.remark.as_deref(),
    ))
}

fn listed(numbers: &[usize], most: usize) -> String {
    let shown: Vec<String> = numbers.iter().take(most).map(usize::to_string).collect();
    let rest = if numbers.len() > most { ", …" } else { "" };
    shown.join(", ") + rest
}
