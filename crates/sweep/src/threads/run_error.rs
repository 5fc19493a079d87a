//! What a run reports: its progress, and why it has no result.

use std::fmt;

use crate::case::CaseFault;
use crate::journal::JournalError;

/// Receives the progress of a run, from all threads.
pub trait Observer: Sync {
    /// The point with this number is about to be computed; others are too.
    fn begin(&self, _point: usize) {}
    /// A landing has been computed.
    fn landing(&self) {}
    /// The point or the case with this number is done.
    fn point(&self, _point: usize) {}
}

/// Ignores all progress.
impl Observer for () {}

/// Why a run has no result.
#[derive(Debug)]
pub enum RunError {
    /// It was cancelled.
    Cancelled,
    /// A point has no valid input.
    Point {
        /// Its coordinates in words.
        place: String,
        /// What is wrong.
        fault: CaseFault,
    },
    /// A result could not be written to the journal.
    Journal(JournalError),
    /// More threads were requested than are allowed on this machine.
    TooManyThreads {
        /// Threads requested.
        asked: usize,
        /// The most that are allowed.
        most: usize,
    },
    /// The threads could not be started.
    Threads(rayon::ThreadPoolBuildError),
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("cancelled"),
            Self::Point { place, fault } => {
                write!(f, "the point {place} has no valid input: {fault}")
            }
            Self::Journal(error) => error.fmt(f),
            Self::TooManyThreads { asked, most } => write!(
                f,
                "threads = {asked}: expected 1 to {most} on this machine; results do not depend on them"
            ),
            Self::Threads(error) => write!(f, "threads cannot be started: {error}"),
        }
    }
}

impl std::error::Error for RunError {}
