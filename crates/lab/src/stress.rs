//! `touchdown-lab stress`: sweeps killed at random moments, and random extreme landings.

mod account;
mod case_table;
mod checks;
mod killed_run;
mod kills;
mod watchdog;
mod wild;
mod wild_sweep;

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::{Args, value_parser};
use touchdown_dynamics::scene::Settings;
use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::threads::run::Workers;

use touchdown::finite;
use touchdown::terminal::{Failure, interrupt, print};

const EXAMPLES: &str = "\
Examples:
  touchdown-lab stress                                  # everything: some hours
  touchdown-lab stress --kills 20 --landings 500        # a short run: one minute
  touchdown-lab stress --kills 0 --seed 2               # a million other landings
  touchdown-lab stress --kills 0 --tolerance 1e-6       # at the tolerance of single landings

Kills: a sweep for all bands is killed (SIGKILL) at random moments, from the first write to the
last rename, and started again with another number of threads. No kill may lose a point that is in
the journal. The results of every completed run are compared byte for byte with those of an
undisturbed run. If something is wrong, the folder is kept and its name printed.

Wild landings: vehicles with three to eight legs, under the rules of 1966 and under physical rules, a
twelfth of the landings each, and touchdowns drawn at random (sweeps/stress/wild.toml): heavy and light, stiff and soft, slippery,
steep, spinning, tilted up to lying on the side. No landing may panic, run
without end, give a value that is not a number, or leave its energy account open by more than four
times the tolerance, relative to the energy involved, for every three seconds begun. At most 1 % may
end without a result where the model has a law (it has none for a loaded footpad inclined more than
65 deg).

The journals of the wild landings are in the output folder: run the same command again to continue
after an interruption. stress-cases.csv then lists everything that went wrong and the extreme
landings, with the reason in the column `note`. To compute them again, bit for bit at the same
tolerance:
  touchdown land --vehicle stress/stress-3-legs-1966.toml --cases stress/stress-cases.csv \\
    --tolerance 3e-5 --out again.csv

What is printed and listed is in feet and pounds.

Exit code 0 if all checks pass, 1 if not.";

/// Points that a sweep can have.
const MOST_LANDINGS: u64 = 10_000_000;

/// Options of `stress`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Number of times a sweep is killed
    #[arg(long, value_name = "N", default_value_t = 200)]
    kills: u32,
    /// Number of wild landings, at most 10^7, shared out among vehicles with 3 to 8 legs under either rules
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = value_parser!(u64).range(..=MOST_LANDINGS))]
    landings: u64,
    /// Seed of the random numbers; the same seed gives the same landings
    #[arg(long, value_name = "N", default_value_t = 1966)]
    seed: u32,
    /// Relative error tolerance of the wild landings, from 1e-12 to 1e-2 [default: 3e-5, that of sweeps]
    #[arg(long, value_name = "TOL", value_parser = finite, allow_hyphen_values = true)]
    tolerance: Option<f64>,
    /// Folder for journals and cases, created if missing
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
    let settings = settings(options)?;
    let folder = Folder::open(&options.out)?;
    let wild = wild_sweep::sweeps(options.landings, options.seed, settings)?;
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
    if !wild.is_empty() {
        wild::run(&bench, &wild)?;
    }
    Ok(())
}

/// How wild landings are computed.
fn settings(options: &Options) -> Result<Settings, InputError> {
    let tolerance = options.tolerance.unwrap_or(Settings::BOUNDARY_TOLERANCE);
    (Settings::default().with_tolerance(tolerance))
        .map_err(|wrong| InputError::value("--tolerance", wrong.value, &wrong.allowed))
}

/// What both tests need.
struct Bench<'b> {
    options: &'b Options,
    folder: &'b Folder,
    workers: &'b Workers,
    cancel: &'b AtomicBool,
}

/// The vehicle of both sweeps, and its path relative to them.
const SURVEYOR: &str = include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml");
const SURVEYOR_FILE: &str = "vehicles/surveyor-table-4-1.toml";
