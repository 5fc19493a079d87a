//! How fast sideways may a legged lander touch down before it topples?
//!
//! The program `touchdown`: one landing, a table of landings, or a sweep for the speed at which
//! the lander begins to topple. The laboratory (`crates/lab`) uses what is public here: the commands, and how they speak
//! to the terminal.
//!
//! The floors, from the top:
//!
//! | floor | what |
//! |---|---|
//! | `main`, `lib` | the commands |
//! | `explore` | the explorer |
//! | `landings`, `sweeps`, `ask`, `surface` | `land`; `sweep` and `merge`; V_H at one place; the surface from impact times |
//! | `plot` | pictures of result tables |
//! | `import_deck`, `new`, `shell` | card decks, starting files, completions and manual page |
//! | `options` | options that several commands share |
//! | `terminal` | messages, failures, progress, interruption |

mod ask;
mod explore;
mod import_deck;
mod landings;
mod new;
mod options;
mod plot;
mod shell;
mod surface;
mod sweeps;
pub mod terminal;

use std::process::ExitCode;
use std::sync::LazyLock;

use clap::{CommandFactory, Parser, Subcommand};
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_sweep::output::results::COMMIT;

pub use options::touchdown_options::finite;

use landings::{cases, land, observed, report, scene_cases};
use options::{overrides, solver_options, touchdown_options};
use sweeps::{axis_words, dry_run, estimate, merge, overview, sweep, sweep_results};
use terminal::{Failure, interrupt, progress, summary};

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
pub static LONG_VERSION: LazyLock<String> = LazyLock::new(|| {
    let commit = COMMIT.map_or(String::new(), |commit| format!(", commit {commit}"));
    format!(
        "{} (model version {MODEL_VERSION}{commit})",
        env!("CARGO_PKG_VERSION")
    )
});

/// Exit codes in words.
pub const EXIT_CODES: &str = "\
Exit codes: 0 done, 1 failed while running, 2 unusable input, 130 interrupted.";

/// Commands with their options.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Compute one landing, the cases of a scene file, or one landing for each row of a table
    Land(Box<land::Options>),
    /// Find the horizontal velocity at which landings cease to be stable, at every point of a grid or a sample
    Sweep(sweep::Options),
    /// Find V_H at any place of a sweep, or of its stored results
    Ask(ask::Options),
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
    /// Print completions for a shell
    Completions(shell::Completions),
    /// Print a manual page (roff)
    Man(shell::Manual),
}

impl Command {
    /// Runs the command.
    ///
    /// # Errors
    /// When input cannot be used, when something fails on the way, or when the user interrupts.
    pub fn run(self) -> Result<(), Failure> {
        match self {
            Self::Land(options) => land::run(&options),
            Self::Sweep(options) => sweep::run(&options),
            Self::Ask(options) => ask::run(&options),
            Self::Merge(options) => merge::run(&options),
            Self::Plot(options) => plot::run(&options),
            Self::Explore(options) => explore::run(&options),
            Self::New(options) => new::run(&options),
            Self::Surface(options) => surface::run(&options),
            Self::ImportDeck(options) => import_deck::run(&options),
            Self::Completions(options) => shell::completions(&options, Cli::command()),
            Self::Man(options) => shell::manual(&options, Cli::command()),
        }
    }
}

/// Runs the program with the arguments that it was started with.
pub fn main() -> ExitCode {
    interrupt::report_file_limits();
    terminal::exit("touchdown", Cli::parse().command.run())
}
