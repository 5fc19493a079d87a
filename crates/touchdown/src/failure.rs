//! Why the program ends without having done what was asked, and with which exit code.

use std::fmt;
use std::process::ExitCode;

use touchdown_sweep::deposit::DepositError;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::run::RunError;

/// An end other than success.
#[derive(Debug)]
pub enum Failure {
    /// The input cannot be used.
    Input(InputError),
    /// Something went wrong while running.
    Running(String),
    /// The user interrupted.
    Interrupted,
}

impl Failure {
    /// The exit code of the program.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Running(_) => 1,
            Self::Input(_) => 2,
            // 128 + SIGINT, as shells report it.
            Self::Interrupted => 130,
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
            Self::Interrupted => f.write_str("interrupted; no unfinished result was written"),
        }
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl From<DepositError> for Failure {
    fn from(error: DepositError) -> Self {
        Self::running(error)
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        match error {
            RunError::Cancelled => Self::Interrupted,
            other => Self::running(other),
        }
    }
}
