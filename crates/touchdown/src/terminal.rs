//! Files, messages and the terminal, as all commands use them; failures of commands and their exit codes.

pub mod interrupt;
pub mod progress;
pub mod summary;

use std::fmt;
use std::io::{ErrorKind, Write, stdout};
use std::path::PathBuf;
use std::process::ExitCode;

use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::journal::JournalError;
use touchdown_sweep::journal::merge::MergeError;
use touchdown_sweep::output::file_writer::WriteError;
use touchdown_sweep::output::tables::TablesError;
use touchdown_sweep::threads::run::RunError;

/// Prints a text to standard output. A reader who has seen enough and closed the pipe, as `head` does, is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let what = format!("standard output cannot be written: {error}");
            Err(Failure::Running(what))
        }
        _ => Ok(()),
    }
}

/// Prints the paths of files, one a line.
pub fn print_paths(files: &[PathBuf]) -> Result<(), Failure> {
    let lines = files.iter().map(|file| format!("{}\n", file.display()));
    print(&lines.collect::<String>())
}

/// Exit code after an interruption: 128 + SIGINT, as shells report it.
pub const INTERRUPTED: u8 = 130;

/// Exit code of a program that has done its work; writes a failure to the terminal.
pub fn exit(program: &str, done: Result<(), Failure>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{program}: {failure}");
            failure.exit_code()
        }
    }
}

/// An end other than success.
#[derive(Debug)]
pub enum Failure {
    /// The input cannot be used.
    Input(InputError),
    /// Something went wrong while running.
    Running(String),
    /// The user interrupted; what became of the work.
    Interrupted(String),
}

impl Failure {
    /// The exit code of the program.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Running(_) => 1,
            Self::Input(_) => 2,
            Self::Interrupted(_) => INTERRUPTED,
        })
    }

    /// Anything that went wrong while running.
    pub fn running(error: impl fmt::Display) -> Self {
        Self::Running(error.to_string())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) => error.fmt(f),
            Self::Running(what) => f.write_str(what),
            Self::Interrupted(work) => write!(f, "interrupted; {work}"),
        }
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        Self::running(error)
    }
}

impl From<JournalError> for Failure {
    fn from(error: JournalError) -> Self {
        match error {
            JournalError::Different { .. } => Self::Input(InputError::other(error.to_string())),
            other => Self::running(other),
        }
    }
}

impl From<MergeError> for Failure {
    fn from(error: MergeError) -> Self {
        match error {
            MergeError::Journal(error) => error.into(),
            strangers => Self::Input(InputError::other(strangers.to_string())),
        }
    }
}

impl From<TablesError> for Failure {
    fn from(error: TablesError) -> Self {
        Self::running(error)
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        match error {
            RunError::Kept(journal) => Self::Interrupted(format!(
                "what is finished is kept in {}: run again to go on",
                journal.display()
            )),
            RunError::Cancelled => Self::Interrupted("no unfinished result was written".to_owned()),
            RunError::Journal(error) => error.into(),
            RunError::TooManyThreads { .. } => Self::Input(InputError::other(error.to_string())),
            other => Self::running(other),
        }
    }
}
