//! `touchdown stress`: what this program takes before it breaks, in numbers.

mod account;
mod case_table;
mod checks;
mod killed_run;
mod kills;
mod watchdog;
mod wild;

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use touchdown_dynamics::scene::{CrushRule, Settings};
use touchdown_sweep::file_writer::Folder;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::run::Workers;

use crate::failure::Failure;
use crate::interrupt;
use crate::print::print;
use crate::touchdown_options::finite;

const EXAMPLES: &str = "\
Examples:
  touchdown stress                                  # all of it, some hours
  touchdown stress --kills 20 --landings 1000       # a taste, a minute
  touchdown stress --kills 0 --seed 2               # a million other landings
  touchdown stress --kills 0 --tolerance 1e-6       # at the tolerance of single landings

Kills: a sweep of all bands is killed (SIGKILL) at random moments, from the first write to the
last rename, and started again with another number of threads. No kill may cost a point that is in
the journal, and whenever a run gets to its end its results are compared, byte for byte, with those
of a run in peace. Where something is wrong the folder is kept, and named.

Wild landings: vehicles and touchdowns drawn at random, see sweeps/stress/wild.toml: heavy and
light, stiff and soft, slippery, steep, spinning, tilted up to lying on the side. No landing may
panic, take forever, give a number that is none, or leave its account of energy open: by more than
four times the tolerance, of the energy in play, for every three seconds begun. At most 1 % may end
without a result where the model has a law (it has none for a loaded footpad inclined more than
65 deg).

Their journal is in the output folder: after an interruption run again to go on. Afterwards
stress-cases.csv holds all that went wrong, and the extremes, with the reason in the column `note`.
They land again, bit for bit at the same tolerance, with
  touchdown land --vehicle stress/stress-vehicle.toml --cases stress/stress-cases.csv \\
    --tolerance 3e-5 --out again.csv

Exit code 0 when all is well, 1 when anything of the above is not.";

/// Options of `stress`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// How often a sweep is killed
    #[arg(long, value_name = "N", default_value_t = 200)]
    kills: u32,
    /// How many wild landings are computed, at most 10^12
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    landings: u64,
    /// Seed of the random numbers: the same seed, the same landings
    #[arg(long, value_name = "N", default_value_t = 1966)]
    seed: u32,
    /// Relative error tolerance of the wild landings, from 1e-12 to 1e-2 [default: 3e-5, that of sweeps]
    #[arg(long, value_name = "TOL", value_parser = finite, allow_hyphen_values = true)]
    tolerance: Option<f64>,
    /// Folder for journals and for the cases of landings that went wrong, made if it is not there
    #[arg(long, value_name = "DIR", default_value = "stress")]
    out: PathBuf,
    /// Threads for the wild landings [default: one for each core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
}

/// Runs `stress`.
pub fn run(options: &Options) -> Result<(), Failure> {
    // Input that cannot be used is refused before anything is written or killed.
    let landings = match options.landings {
        0 => None,
        count => Some(wild::sweep(count, options.seed, settings(options)?)?),
    };
    let folder = Folder::open(&options.out)?;
    let workers = Workers::start(options.threads)?;
    let cancel = interrupt::flag()?;
    let bench = Bench {
        options,
        folder: &folder,
        workers: &workers,
        cancel: &cancel,
    };
    if options.kills > 0 {
        print(&kills::run(&bench)?)?;
    }
    if let Some(sweep) = landings {
        wild::run(&bench, &sweep)?;
    }
    Ok(())
}

/// How wild landings are computed.
fn settings(options: &Options) -> Result<Settings, InputError> {
    let tolerance = options.tolerance.unwrap_or(Settings::BOUNDARY_TOLERANCE);
    Settings::new(
        tolerance,
        Settings::DEFAULT_TIME_LIMIT,
        CrushRule::default(),
    )
    .map_err(|wrong| InputError::value("--tolerance", wrong.value, &wrong.allowed))
}

/// What all stress is done with.
struct Bench<'b> {
    options: &'b Options,
    folder: &'b Folder,
    workers: &'b Workers,
    cancel: &'b AtomicBool,
}

/// The vehicle of both sweeps, and where it stands from theirs.
const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
const SURVEYOR_FILE: &str = "vehicles/surveyor-table-4-1.toml";
