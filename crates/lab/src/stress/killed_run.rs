//! A sweep in a child process that is watched and killed, and the files that it leaves.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use touchdown_sweep::journal::{Access, InOrder, JournalError, Records};

use touchdown::terminal::Failure;

/// Time between two checks of a run.
const POLL_INTERVAL: Duration = Duration::from_micros(200);
/// Longest time for a run, most of which it may wait for processors.
const LONGEST_RUN: Duration = Duration::from_secs(600);

/// A sweep that runs.
pub struct KilledRun<'r> {
    child: Child,
    start: Instant,
    out: &'r Path,
    /// What stood in the folder of its results when it began.
    before: BTreeSet<OsString>,
}

/// Why watching ended.
#[derive(Debug, PartialEq, Eq)]
pub enum RunState {
    /// The run has ended.
    Ended,
    /// It is time to kill it.
    Due,
}

impl<'r> KilledRun<'r> {
    /// Starts a sweep that writes to `out`.
    pub fn start(sweep: &Path, out: &'r Path, threads: u32) -> Result<Self, Failure> {
        let before = names(out);
        let program = std::env::current_exe().map_err(Failure::running)?;
        let child = Command::new(program)
            .args(["sweep", "--quiet", "--threads", &threads.to_string()])
            .arg("--out")
            .args([out, sweep])
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(Failure::running)?;
        Ok(Self {
            child,
            start: Instant::now(),
            out,
            before,
        })
    }

    /// Waits until the run has ended, or until it is time to kill it by the number of files that it has
    /// made beside its journal, and by its age. A run is killed when `cancel` becomes true, or when it
    /// takes forever.
    pub fn watch(
        &mut self,
        cancel: &AtomicBool,
        is_due: impl Fn(usize, Duration) -> bool,
    ) -> Result<RunState, Failure> {
        loop {
            if self.child.try_wait().map_err(Failure::running)?.is_some() {
                return Ok(RunState::Ended);
            }
            let age = self.start.elapsed();
            let given_up = if cancel.load(Ordering::Relaxed) {
                Failure::Interrupted("kills begin anew".to_owned())
            } else if age > LONGEST_RUN {
                Failure::running(format!(
                    "a run has not ended within {} s",
                    LONGEST_RUN.as_secs()
                ))
            } else {
                let fresh = names(self.out).difference(&self.before).count();
                if is_due(fresh, age) {
                    return Ok(RunState::Due);
                }
                thread::sleep(POLL_INTERVAL);
                continue;
            };
            self.child.kill().map_err(Failure::running)?;
            return Err(given_up);
        }
    }

    /// Kills the run, which it cannot hinder; whether it had not just ended by itself.
    pub fn kill(mut self) -> Result<bool, Failure> {
        let killed = self.child.kill().and_then(|()| self.child.wait());
        killed
            .map(|status| !status.success())
            .map_err(Failure::running)
    }

    /// Waits for the end of the run, which has to be a good one; how long it took.
    pub fn end(self) -> Result<Duration, Failure> {
        let Output { status, stderr, .. } =
            self.child.wait_with_output().map_err(Failure::running)?;
        match status.success() {
            true => Ok(self.start.elapsed()),
            false => {
                let said = String::from_utf8_lossy(&stderr);
                Err(Failure::running(format!("a run failed: {said}")))
            }
        }
    }
}

/// Results by name, without the record.
pub fn results(stem: &str, folder: &Path) -> Result<BTreeMap<String, Vec<u8>>, Failure> {
    let mut results = BTreeMap::new();
    for name in names(folder) {
        let name = name.to_string_lossy().into_owned();
        if name.starts_with(stem) && !name.ends_with(".json") {
            let bytes = fs::read(folder.join(&name)).map_err(Failure::running)?;
            results.insert(name, bytes);
        }
    }
    Ok(results)
}

/// How many of so many points are in a journal, whole; none if there is no journal, or not yet its head.
pub fn journaled(journal: &Path, points: usize) -> Result<usize, Failure> {
    let records = match Records::open(journal, Access::Alone) {
        Ok((records, _)) => records,
        Err(JournalError::NoHeader(_)) => return Ok(0),
        Err(JournalError::Io { error, .. }) if error.kind() == io::ErrorKind::NotFound => {
            return Ok(0);
        }
        Err(error) => return Err(error.into()),
    };
    let index = journal.parent().unwrap_or(Path::new("."));
    let found = InOrder::new(vec![records], points, index)?;
    Ok(points - found.missing())
}

/// Files of a folder other than journals; none if the folder does not exist.
fn names(folder: &Path) -> BTreeSet<OsString> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|entry| entry.path());
    let others = paths.filter(|path| path.extension().is_none_or(|ending| ending != "journal"));
    others
        .filter_map(|path| path.file_name().map(OsString::from))
        .collect()
}
