//! How fast sideways may a legged lander touch down before it topples?
//!
//! The program `touchdown`: one landing, a table of landings, or a sweep for the speed at which
//! the lander begins to topple.

mod explore;
mod import_deck;
mod landings;
mod new;
mod options;
mod pictures;
mod shell;
mod stress;
mod study;
mod surface;
mod sweeps;
mod terminal;
mod verdicts;
mod work_precision;

use std::process::ExitCode;
use std::sync::LazyLock;

use clap::{CommandFactory, Parser, Subcommand};
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_sweep::results::COMMIT;

use landings::{cases, integration_report, land, land_files, report, scene_cases};
use options::{overrides, solver_options, touchdown_options, units};
use pictures::plot;
use sweeps::{axis_words, dry_run, estimate, merge, overview, sweep, sweep_files, sweep_results};
use terminal::{failure, interrupt, print, progress, summary};

/// How fast sideways may a legged lander touch down before it topples?
///
/// Units throughout: foot, second, pound, slug; angles in degrees.
#[derive(Debug, Parser)]
#[command(version, long_version = LONG_VERSION.as_str(), propagate_version = true, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// The version of the program, of the model, and the commit if it is known.
static LONG_VERSION: LazyLock<String> = LazyLock::new(|| {
    let commit = COMMIT.map_or(String::new(), |commit| format!(", commit {commit}"));
    format!(
        "{} (model version {MODEL_VERSION}{commit})",
        env!("CARGO_PKG_VERSION")
    )
});

const EXIT_CODES: &str = "\
Exit codes: 0 done, 1 failed while running, 2 unusable input, 130 interrupted.";

#[derive(Debug, Subcommand)]
enum Command {
    /// Compute one landing, the cases of a scene file, or one landing for each row of a table
    Land(Box<land::Options>),
    /// Find the horizontal velocity at which landings cease to be stable, at every point of a grid or a sample
    Sweep(sweep::Options),
    /// Write the results of sweeps that were computed in shards
    Merge(merge::Options),
    /// Draw the pictures of result tables
    Plot(plot::Options),
    /// Open a page in the browser in which a landing answers as sliders move
    Explore(explore::Options),
    /// Write a commented vehicle, sweep or scene file as a starting point
    New(new::Options),
    /// Find slope and cross-slope from the times at which the footpads touched the surface
    Surface(surface::Options),
    /// Convert a card deck of the 1966 program to vehicle files, a scene file and tables of cases
    ImportDeck(import_deck::Options),
    /// Compare results with the report of 1966
    Study(study::Options),
    /// Measure error and run time against the tolerance
    WorkPrecision(work_precision::Options),
    /// Test the program on this machine: kill sweeps again and again, compute random extreme landings
    Stress(stress::Options),
    /// Follow random landings beyond their verdicts: whether anything contradicts them
    Verdicts(verdicts::Options),
    /// Print completions for a shell
    Completions(shell::Completions),
    /// Print a manual page (roff)
    Man(shell::Manual),
}

fn main() -> ExitCode {
    interrupt::report_file_limits();
    let done = match Cli::parse().command {
        Command::Land(options) => land::run(&options),
        Command::Sweep(options) => sweep::run(&options),
        Command::Merge(options) => merge::run(&options),
        Command::Plot(options) => plot::run(&options),
        Command::Explore(options) => explore::run(&options),
        Command::New(options) => new::run(&options),
        Command::Surface(options) => surface::run(&options),
        Command::ImportDeck(options) => import_deck::run(&options),
        Command::Study(options) => study::run(&options),
        Command::WorkPrecision(options) => work_precision::run(&options),
        Command::Stress(options) => stress::run(&options),
        Command::Verdicts(options) => verdicts::run(&options),
        Command::Completions(options) => shell::completions(&options, Cli::command()),
        Command::Man(options) => shell::manual(&options, Cli::command()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("touchdown: {failure}");
            failure.exit_code()
        }
    }
}
