//! The journal of a sweep: every point is recorded as soon as it is finished.
//!
//! An append-only file beside the results. Its first frame is the [`Header`]; every other frame is the number of a
//! point and its result. Even from a damaged file, only records written by the same program from the same input are
//! read.

pub(crate) mod early_stop;
mod error;
mod frame;
mod head;
pub mod header;
mod in_order;
pub mod merge;
pub mod point_set;
mod records;
mod scan;
pub mod shard;
mod writer;

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use same_file::Handle;

pub use error::JournalError;
pub use in_order::InOrder;
pub use records::{Access, Records};

use crate::journal::header::Header;
use crate::journal::point_set::PointSet;
use crate::summary::findings::Finding;
use error::io_error;
use head::{Head, ensure_head};
use scan::{Piece, Scan};
use writer::Writer;

/// Place, beside that of its journal, where a finished sample keeps it for a greater one.
pub fn kept(journal: &Path) -> PathBuf {
    journal.with_extension("journal.kept")
}

/// Kept journal, as a run of the same sample finds it.
enum Kept {
    /// There is none, or none of the same shard with fewer points.
    Nothing,
    /// It is damaged or differs, with the reason.
    Unusable(String),
    /// It has points of the sample with this header.
    Smaller(Records, Box<Header>),
}

impl Kept {
    fn at(path: &Path, header: &Header) -> Result<Self, JournalError> {
        if !path.is_file() {
            return Ok(Self::Nothing);
        }
        let (records, smaller) = match Records::open(path, Access::Shared) {
            Err(JournalError::NoHeader(_)) => {
                return Ok(Self::Unusable("its head is damaged".to_owned()));
            }
            opened => opened?,
        };
        if smaller.points >= header.points || smaller.shard() != header.shard() {
            return Ok(Self::Nothing);
        }
        let differences = header.differences_but_count(&smaller);
        Ok(match differences.is_empty() {
            true => Self::Smaller(records, Box::new(smaller)),
            false => Self::Unusable(format!(
                "it differs from this run (here: now, there: in the file):\n  {}",
                differences.join("\n  ")
            )),
        })
    }
}

/// Returns whether a run with `header` sets the journal at `path` aside, to take its points over: it is of the same sample with
/// fewer points, and no other such journal is kept, whose place it would take.
fn is_set_aside(path: &Path, header: &Header) -> bool {
    let is_smaller = |path: &Path| matches!(Kept::at(path, header), Ok(Kept::Smaller(..)));
    is_smaller(path) && !is_smaller(&kept(path))
}

/// Renames the journal at `path` to its kept name if a run with `header` sets it aside. [`Journal::open`] says what is wrong with
/// any other.
///
/// # Errors
/// Errors of the file system.
pub(crate) fn set_smaller_aside(path: &Path, header: &Header) -> Result<(), JournalError> {
    if is_set_aside(path, header) {
        fs::rename(path, kept(path)).map_err(|error| io_error(path, error))?;
    }
    Ok(())
}

/// A journal open for adding points; meanwhile no other process can open it.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    writer: Writer<File>,
    identity: Handle,
    head: Head,
}

/// An opened journal and its existing content.
#[derive(Debug)]
pub struct Opened {
    /// The journal.
    pub journal: Journal,
    /// Points of its shard already present, by index in the shard; for a map, by number.
    pub done: PointSet,
    /// Damage found, and its treatment.
    pub warnings: Vec<String>,
}

impl Opened {
    /// Adds the points of the same sample with fewer points from its kept journal, if there is one; returns how many.
    /// Damaged records, and a journal of other input or another program, are left out with a warning. Stops when
    /// `cancel` is set.
    ///
    /// # Errors
    /// Errors of the file system; points already added stay valid.
    pub(crate) fn take_over(
        &mut self,
        header: &Header,
        cancel: &AtomicBool,
    ) -> Result<usize, JournalError> {
        let path = kept(&self.journal.path);
        let smaller = match Kept::at(&path, header)? {
            Kept::Nothing => return Ok(0),
            Kept::Unusable(why) => {
                let warning = format!("{}: is not used, as {why}", path.display());
                self.warnings.push(warning);
                return Ok(0);
            }
            Kept::Smaller(_, smaller) => smaller,
        };
        let mut there = Journal::open(&path, &smaller)?;
        self.warnings.append(&mut there.warnings);
        let mut results = there.journal.so_far(smaller.points)?;
        let mut taken = 0;
        let going_on = |_: &usize| !cancel.load(Ordering::Relaxed);
        for index in there.done.members().take_while(going_on) {
            let point = header.shard().point(index);
            if let Some(result) = results.result(point)?
                && self.done.insert(index)
            {
                self.journal.add(point, &result)?;
                taken += 1;
            }
        }
        self.journal.finish()?;
        if !cancel.load(Ordering::Relaxed) {
            // All that it holds is in the new journal.
            drop((results, there));
            fs::remove_file(&path).map_err(|error| io_error(&path, error))?;
        }
        Ok(taken)
    }

    /// Findings of the points present, by their numbers below `points`.
    pub(crate) fn findings(&self, points: usize) -> Result<HashMap<usize, Finding>, JournalError> {
        let mut found = HashMap::new();
        if self.done.is_empty() {
            return Ok(found);
        }
        let mut results = self.journal.so_far(points)?;
        for point in self.done.members() {
            let bytes = results.result(point)?;
            let finding = bytes.as_deref().and_then(Finding::decode);
            found.extend(finding.map(|finding| (point, finding)));
        }
        Ok(found)
    }
}

impl Journal {
    /// Opens the journal at `path`, or creates it.
    ///
    /// # Errors
    /// If it is locked or belongs to other input; errors of the file system.
    pub fn open(path: &Path, header: &Header) -> Result<Opened, JournalError> {
        let refuse = |error| io_error(path, error);
        let mut warnings = Vec::new();
        loop {
            let file = lock(path)?;
            let identity = file
                .try_clone()
                .and_then(Handle::from_file)
                .map_err(refuse)?;
            // The holder of the lock may have removed the file before it exited.
            if Handle::from_path(path).ok().as_ref() != Some(&identity) {
                continue;
            }
            let Some(head) = ensure_head(&file, path, header, &mut warnings)? else {
                let aside = path.with_extension("journal.damaged");
                fs::rename(path, &aside).map_err(refuse)?;
                warnings.push(format!(
                    "{}: has no readable head and no record of this sweep; it was moved to {} and \
                     all points are run again",
                    path.display(),
                    aside.display()
                ));
                continue;
            };
            let (done, length) = recover(&file, path, head, header, &mut warnings)?;
            let journal = Self {
                path: path.to_owned(),
                writer: Writer::new(file, length),
                identity,
                head,
            };
            return Ok(Opened {
                journal,
                done,
                warnings,
            });
        }
    }

    /// Adds the result of a point.
    ///
    /// # Errors
    /// Errors of the file system; earlier records stay valid.
    pub fn add(&mut self, point: usize, result: &[u8]) -> Result<(), JournalError> {
        let mut payload = (point as u64).to_le_bytes().to_vec();
        payload.extend(result);
        let frame = frame::encode(self.head.seed, &payload);
        self.writer
            .append(&frame)
            .map_err(|error| io_error(&self.path, error))
    }

    /// Syncs added records to disk, if due, so that they survive a loss of power. To be called often.
    ///
    /// # Errors
    /// Errors of the file system; also if the file was moved or removed.
    pub fn tick(&mut self) -> Result<(), JournalError> {
        let is_due = self.writer.sync_if_due();
        match is_due.map_err(|error| io_error(&self.path, error))? {
            true => self.is_in_place(),
            false => Ok(()),
        }
    }

    /// Syncs all added records, to survive a loss of power.
    ///
    /// # Errors
    /// As [`Journal::tick`].
    pub fn finish(&mut self) -> Result<(), JournalError> {
        self.writer
            .sync()
            .map_err(|error| io_error(&self.path, error))?;
        self.is_in_place()
    }

    /// The records present, for reading while none are added.
    ///
    /// # Errors
    /// Errors of the file system.
    pub(crate) fn so_far(&self, points: usize) -> Result<InOrder, JournalError> {
        let refuse = |error| io_error(&self.path, error);
        let records = Records {
            path: self.path.clone(),
            file: self.writer.medium().try_clone().map_err(refuse)?,
            head: self.head,
        };
        let folder = self.path.parent().unwrap_or(Path::new(""));
        InOrder::new(vec![records], points, &folder.join("."))
    }

    /// Ends writing and returns the records for reading; the file stays locked.
    ///
    /// # Errors
    /// As [`Journal::tick`].
    pub fn into_records(mut self) -> Result<Records, JournalError> {
        self.finish()?;
        Ok(Records {
            path: self.path,
            file: self.writer.into_medium(),
            head: self.head,
        })
    }

    fn is_in_place(&self) -> Result<(), JournalError> {
        match Handle::from_path(&self.path) {
            Ok(found) if found == self.identity => Ok(()),
            _ => Err(JournalError::Gone(self.path.clone())),
        }
    }
}

fn lock(path: &Path) -> Result<File, JournalError> {
    let file = OpenOptions::new()
        .read(true)
        .write(true)
        .create(true)
        .truncate(false)
        .open(path)
        .map_err(|error| io_error(path, error))?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => Err(JournalError::Locked(path.to_owned())),
        Err(TryLockError::Error(error)) => Err(io_error(path, error)),
    }
}

/// Reads the points present and cuts off an unfinished end; returns the points and the remaining length.
fn recover(
    file: &File,
    path: &Path,
    head: Head,
    header: &Header,
    warnings: &mut Vec<String>,
) -> Result<(PointSet, u64), JournalError> {
    let refuse = |error| io_error(path, error);
    let mut done = PointSet::none(header.most_points());
    let end = file.metadata().map_err(refuse)?.len();
    let mut damage: Vec<(u64, u64)> = Vec::new();
    let mut scan = Scan::new(file, head.seed, head.length, end).map_err(refuse)?;
    while let Some(piece) = scan.next().map_err(refuse)? {
        match piece {
            Piece::Frame { payload, .. } => {
                let point = record(&payload).map(|(point, _)| point);
                if let Some(index) = point.and_then(|point| header.index(point)) {
                    done.insert(index);
                }
            }
            Piece::Damage { offset, length } => damage.push((offset, length)),
        }
    }
    let at_end = damage.pop_if(|(offset, length)| *offset + *length == end);
    let length = at_end.map_or(end, |(offset, _)| offset);
    for (offset, bytes) in damage {
        warnings.push(format!(
            "{}: {bytes} bytes at offset {offset} are damaged; the points in them are run again",
            path.display()
        ));
    }
    if length < end {
        warnings.push(format!(
            "{}: the last {} bytes, from offset {length} on, are no whole record and were cut off",
            path.display(),
            end - length
        ));
        file.set_len(length).map_err(refuse)?;
        file.sync_all().map_err(refuse)?;
    }
    Ok((done, length))
}

/// Length of a record, bytes, for a result of `result` bytes.
pub fn record_length(result: usize) -> usize {
    frame::OVERHEAD + size_of::<u64>() + result
}

/// Splits a payload into a point and its result.
fn record(payload: &[u8]) -> Option<(usize, &[u8])> {
    let (point, result) = payload.split_first_chunk()?;
    Some((usize::try_from(u64::from_le_bytes(*point)).ok()?, result))
}

#[cfg(test)]
mod tests;
