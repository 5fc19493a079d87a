//! Reasons why a journal cannot be used.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Reasons why a journal cannot be used.
#[derive(Debug)]
#[non_exhaustive]
pub enum JournalError {
    /// Error of the file system.
    Io {
        /// The journal.
        path: PathBuf,
        /// The error.
        error: io::Error,
    },
    /// Another process is using it.
    Locked(PathBuf),
    /// It belongs to other input or another program.
    Different {
        /// The journal.
        path: PathBuf,
        /// The differences.
        differences: Vec<String>,
    },
    /// It, or its folder, was moved or removed.
    Gone(PathBuf),
    /// It has no readable header.
    NoHeader(PathBuf),
}

impl fmt::Display for JournalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io { path, error } => write!(
                f,
                "{}: {error}; what it holds stays good, run again to go on",
                path.display()
            ),
            Self::Locked(path) => write!(
                f,
                "{}: another process is at work on this journal",
                path.display()
            ),
            Self::Different { path, differences } => write!(
                f,
                "{}: a journal of other input cannot be resumed; remove it, or give another \
                 --out. What differs (here: now, there: in the journal):\n  {}",
                path.display(),
                differences.join("\n  ")
            ),
            Self::Gone(path) => write!(
                f,
                "{}: the journal was moved or removed while points were added to it",
                path.display()
            ),
            Self::NoHeader(path) => {
                write!(
                    f,
                    "{}: no journal of a sweep, or its head is damaged",
                    path.display()
                )
            }
        }
    }
}

impl std::error::Error for JournalError {}

impl JournalError {
    /// Error in reading the index of points.
    pub(crate) fn index(error: io::Error) -> Self {
        io_error(Path::new("index of points"), error)
    }
}

/// Error of the file system with a journal.
pub(super) fn io_error(path: &Path, error: io::Error) -> JournalError {
    JournalError::Io {
        path: path.to_owned(),
        error,
    }
}
