//! Runs that lose nothing: what is finished goes to a journal beside the results, from which an interrupted run goes on.
//!
//! A sweep from its file to the table of its points:
//!
//! ```
//! use std::path::Path;
//! use std::sync::atomic::AtomicBool;
//!
//! use touchdown_sweep::input::sweeps::sweep_file::Sweep;
//! use touchdown_sweep::journal::shard::Shard;
//! use touchdown_sweep::output::file_writer::Folder;
//! use touchdown_sweep::output::result_files::{self, NamedFiles};
//! use touchdown_sweep::output::tables::TablesError;
//! use touchdown_sweep::threads::run::Workers;
//! use touchdown_sweep::threads::runner::{Runner, Task};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # std::env::set_current_dir("../..")?;
//! # let home = tempfile::tempdir()?;
//! # let out = home.path();
//! let sweep = Sweep::read(Path::new("sweeps/figure-4-09.toml"))?;
//! let (workers, folder) = (Workers::start(None)?, Folder::open(out)?);
//! let runner = Runner {
//!     workers: &workers,
//!     folder: &folder,
//!     observer: &(),
//!     cancel: &AtomicBool::new(false),
//!     version: "0.1.0",
//! };
//! let run = runner.begin(Task::Sweep(&sweep, Shard::WHOLE))?;
//! let mut results = run.compute()?.results()?;
//! let draw = |_: &_, _: &str| Ok::<_, TablesError>(NamedFiles::new());
//! let (counts, _) = result_files::write(&sweep, &mut results, &folder, "0.1.0", false, draw)?;
//! results.end_journal(&sweep)?;
//! assert_eq!(counts.points, 25);
//! # Ok(())
//! # }
//! ```

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use touchdown_input::sweeps::cases::CaseTable;
use touchdown_input::sweeps::sweep_file::Sweep;

use crate::journal::header::Header;
use crate::journal::shard::Shard;
use crate::journal::{InOrder, Journal, JournalError, Opened, set_smaller_aside};
use crate::output::file_writer::Folder;
use crate::threads::run::{Observer, RunError, Workers};

/// Threads, folder and callbacks shared by runs.
pub struct Runner<'r> {
    /// The threads.
    pub workers: &'r Workers,
    /// Folder of the journals.
    pub folder: &'r Folder,
    /// Progress callbacks.
    pub observer: &'r dyn Observer,
    /// Set to stop a run.
    pub cancel: &'r AtomicBool,
    /// Version of the program, for the journals.
    pub version: &'r str,
}

/// A sweep or a table of cases to compute.
#[derive(Debug, Clone, Copy)]
pub enum Task<'w> {
    /// The points of a shard of a sweep.
    Sweep(&'w Sweep, Shard),
    /// The rows of a table of cases, whose results have this file name.
    Cases(&'w CaseTable, &'w str),
}

impl Task<'_> {
    /// Number of its points, of all shards together.
    fn points(&self) -> usize {
        match self {
            Self::Sweep(sweep, _) => sweep.design.count(),
            Self::Cases(table, _) => table.len(),
        }
    }

    /// Returns whether its points are the first of those with a greater count.
    fn can_grow(&self) -> bool {
        matches!(self, Self::Sweep(sweep, _) if sweep.design.is_nested())
    }
}

/// A run whose journal is open.
pub struct Run<'r> {
    runner: &'r Runner<'r>,
    task: Task<'r>,
    path: PathBuf,
    opened: Opened,
}

impl<'r> Runner<'r> {
    /// Begins a run as [`Runner::begin`] does, and adds the points of the same sample with fewer points, if there is a journal of
    /// it; returns how many. Any other run has none. Stops when the run is cancelled.
    ///
    /// # Errors
    /// As [`Runner::begin`].
    pub fn begin_or_grow(&'r self, task: Task<'r>) -> Result<(Run<'r>, usize), RunError> {
        if !task.can_grow() {
            return Ok((self.begin(task)?, 0));
        }
        let (path, header) = self.journal(task)?;
        set_smaller_aside(&path, &header).map_err(RunError::Journal)?;
        let mut run = self.open(task, path, &header)?;
        let taken = run.opened.take_over(&header, self.cancel);
        let taken = taken.map_err(RunError::Journal)?;
        self.observer.skip(taken);
        Ok((run, taken))
    }

    /// Place and header of the journal of a run.
    fn journal(&self, task: Task) -> Result<(PathBuf, Header), RunError> {
        let (name, header) = match task {
            Task::Sweep(sweep, shard) => {
                let header = Header::new(sweep, self.version, shard);
                let header = header.map_err(|fault| RunError::Point {
                    place: sweep.place(0),
                    fault,
                });
                (shard.journal(&sweep.stem()), header?)
            }
            Task::Cases(table, name) => (
                format!("{name}.journal"),
                Header::of_cases(table, self.version),
            ),
        };
        Ok((self.folder.path(&name), header))
    }

    /// Opens the journal of a run, or creates it, and tells the observer how many points it has.
    ///
    /// # Errors
    /// If the journal belongs to other input or cannot be opened.
    pub fn begin(&'r self, task: Task<'r>) -> Result<Run<'r>, RunError> {
        let (path, header) = self.journal(task)?;
        self.open(task, path, &header)
    }

    fn open(&'r self, task: Task<'r>, path: PathBuf, header: &Header) -> Result<Run<'r>, RunError> {
        let opened = Journal::open(&path, header).map_err(RunError::Journal)?;
        self.observer.skip(opened.done.len());
        Ok(Run {
            runner: self,
            task,
            path,
            opened,
        })
    }
}

impl Run<'_> {
    /// The journal.
    pub fn journal(&self) -> &Path {
        &self.path
    }

    /// Damage found in the journal, and its treatment.
    pub fn warnings(&self) -> &[String] {
        &self.opened.warnings
    }

    /// Points in the journal.
    pub fn earlier(&self) -> usize {
        self.opened.done.len()
    }

    /// Computes the points that are not in the journal.
    ///
    /// # Errors
    /// If the run was stopped, or a result cannot be stored. Results in the journal stay valid.
    pub fn compute(mut self) -> Result<Computed, RunError> {
        let Runner {
            workers,
            folder,
            observer,
            cancel,
            ..
        } = *self.runner;
        let opened = &mut self.opened;
        let computed = match self.task {
            Task::Sweep(sweep, shard) => workers.sweep(sweep, shard, opened, observer, cancel),
            Task::Cases(table, _) => workers.case_table(table, opened, observer, cancel),
        };
        computed.map_err(|error| match error {
            RunError::Cancelled => RunError::Kept(self.path),
            other => other,
        })?;
        Ok(Computed {
            journal: self.opened.journal,
            points: self.task.points(),
            folder: folder.path("."),
        })
    }
}

/// A run whose points are all in its journal.
#[derive(Debug)]
pub struct Computed {
    journal: Journal,
    points: usize,
    folder: PathBuf,
}

impl Computed {
    /// The results in the order of the points. Their journal stays until it is removed.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn results(self) -> Result<InOrder, JournalError> {
        let records = self.journal.into_records()?;
        InOrder::new(vec![records], self.points, &self.folder)
    }
}
