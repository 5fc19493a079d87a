//! Why a journal cannot be used.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a journal cannot be used.
#[derive(Debug)]
pub enum JournalError {
    /// The file system says no.
    Io {
        /// The journal.
        path: PathBuf,
        /// What it says.
        error: io::Error,
    },
    /// Another process is at work on it.
    Locked(PathBuf),
    /// It belongs to another input or program.
    Different {
        /// The journal.
        path: PathBuf,
        /// What differs.
        differences: Vec<String>,
    },
    /// It was moved or removed, or its folder was.
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
    /// The index of points cannot be read.
    pub(crate) fn index(error: io::Error) -> Self {
        io_error(Path::new("index of points"), error)
    }
}

/// The file system says no to a journal.
pub(super) fn io_error(path: &Path, error: io::Error) -> JournalError {
    JournalError::Io {
        path: path.to_owned(),
        error,
    }
}
