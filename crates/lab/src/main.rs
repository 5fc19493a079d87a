//! The laboratory of `touchdown`: what the program says, against the report of 1966, against itself beyond a verdict, and under
//! stress.

mod stress;
mod study;
mod verdicts;
mod work_precision;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use touchdown::terminal::{self, interrupt};
use touchdown::{EXIT_CODES, LONG_VERSION};
use touchdown_figures::picture::Picture;

/// Compare results with the report of 1966, and test the program
#[derive(Debug, Parser)]
#[command(version, long_version = LONG_VERSION.as_str(), propagate_version = true, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Compare results with the report of 1966
    Study(study::Options),
    /// Measure error and run time against the tolerance
    WorkPrecision(work_precision::Options),
    /// Test the program on this machine: kill sweeps again and again, compute random extreme landings
    Stress(stress::Options),
    /// Follow random landings beyond their verdicts: whether anything contradicts them
    Verdicts(verdicts::Options),
    /// Run a command of touchdown: `stress` kills sweeps of this very program
    #[command(flatten)]
    Program(touchdown::Command),
}

/// Pictures as files.
fn as_files(stem: &str, pictures: Vec<Picture>) -> Vec<(String, Vec<u8>)> {
    let file = move |Picture { suffix, svg }| (format!("{stem}{suffix}.svg"), svg.into_bytes());
    pictures.into_iter().map(file).collect()
}

fn main() -> ExitCode {
    interrupt::report_file_limits();
    let done = match Cli::parse().command {
        Command::Study(options) => study::run(&options),
        Command::WorkPrecision(options) => work_precision::run(&options),
        Command::Stress(options) => stress::run(&options),
        Command::Verdicts(options) => verdicts::run(&options),
        Command::Program(command) => command.run(),
    };
    terminal::exit("touchdown-lab", done)
}
