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
//! | `main`, `lib` | the commands; completions and manual page |
//! | `explore` | the explorer |
//! | `land`, `sweep`, `merge`, `ask`, `surface` | one landing, scene files, tables of cases; sweeps and their shards; V_H at one place; the surface from impact times |
//! | `plot` | pictures of result tables |
//! | `import_deck`, `new` | card decks, starting files |
//! | `options` | options that several commands share |
//! | `terminal` | messages, failures, progress, interruption |

mod ask;
mod explore;
mod import_deck;
mod land;
mod merge;
mod new;
mod options;
mod plot;
mod surface;
mod sweep;
pub mod terminal;

use std::process::ExitCode;
use std::sync::LazyLock;

use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::output::results::COMMIT;

pub use options::touchdown_options::finite;

use land::{observed, report};
use options::{solver_options, touchdown_options};
use sweep::{axis_words, estimate, sweep_results};
use terminal::{Failure, interrupt, print, progress, summary};

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
    Completions(Completions),
    /// Print a manual page (roff)
    Man(Manual),
}

/// Options of `completions`.
#[derive(Debug, Args)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

/// Options of `man`.
#[derive(Debug, Args)]
pub struct Manual {
    /// Print the page of this command instead of that of the program
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
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
            Self::Completions(options) => completions(&options),
            Self::Man(options) => manual(&options),
        }
    }
}

/// Prints the completions of the program.
fn completions(options: &Completions) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut Cli::command(), "touchdown", &mut script);
    print(&String::from_utf8_lossy(&script))
}

/// Prints the manual page of the program, or of one of its commands.
fn manual(options: &Manual) -> Result<(), Failure> {
    let mut program = Cli::command();
    program.build();
    let page = match &options.command {
        None => program,
        Some(name) => {
            let command = program.find_subcommand(name).cloned();
            let names = program.get_subcommands().map(clap::Command::get_name);
            let names = names.collect::<Vec<_>>().join(", ");
            command.ok_or_else(|| {
                InputError::other(format!("there is no command {name}: expected {names}"))
            })?
        }
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page)
        .render(&mut text)
        .map_err(Failure::running)?;
    print(&String::from_utf8_lossy(&text))
}

/// Runs the program with the arguments that it was started with.
pub fn main() -> ExitCode {
    interrupt::report_file_limits();
    terminal::exit("touchdown", Cli::parse().command.run())
}
