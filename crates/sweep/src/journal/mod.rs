//! The journal of a sweep: every finished point, from the moment it is finished.
//!
//! An append-only file beside the results. Its first frame is the [`Header`]; every other frame is
//! the number of a point and what the point came to. Whatever happened to the file, what is read
//! from it was written by a run of the same input with the same program.

pub(crate) mod early_stop;
mod frame;
pub mod header;
mod in_order;
pub mod journal_files;
pub mod merge;
pub mod point_set;
mod scan;
pub mod shard;
mod writer;

use std::collections::HashMap;
use std::fmt;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use same_file::Handle;

pub use in_order::InOrder;

use crate::findings::Finding;
use crate::header::Header;
use crate::point_set::PointSet;
use frame::HEADER_SEED;
use scan::{Piece, Scan};
use writer::Writer;

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

/// A journal open for more points; no other process can open it meanwhile.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    writer: Writer<File>,
    identity: Handle,
    head: Head,
}

/// A journal, and what was in it already.
#[derive(Debug)]
pub struct Opened {
    /// The journal.
    pub journal: Journal,
    /// Which points of its shard it holds, by their index in the shard; of a map, by their numbers.
    pub done: PointSet,
    /// What was found damaged and what became of it.
    pub warnings: Vec<String>,
}

impl Opened {
    /// What the points came to that are there, by their numbers below `points`.
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
    /// Opens the journal at `path`, or begins it.
    ///
    /// # Errors
    /// When it is locked or belongs to something else, and whatever the file system says.
    pub fn open(path: &Path, header: &Header) -> Result<Opened, JournalError> {
        let refuse = |error| io_error(path, error);
        let mut warnings = Vec::new();
        loop {
            let file = lock(path)?;
            let identity = file
                .try_clone()
                .and_then(Handle::from_file)
                .map_err(refuse)?;
            // Whoever held the lock may have removed the file and gone.
            if Handle::from_path(path).ok().as_ref() != Some(&identity) {
                continue;
            }
            let Some(head) = head(&file, path, header, &mut warnings)? else {
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

    /// Adds what a point came to.
    ///
    /// # Errors
    /// Whatever the file system says; what was added before stays good.
    pub fn add(&mut self, point: usize, result: &[u8]) -> Result<(), JournalError> {
        let mut payload = (point as u64).to_le_bytes().to_vec();
        payload.extend(result);
        let frame = frame::encode(self.head.seed, &payload);
        self.writer
            .append(&frame)
            .map_err(|error| io_error(&self.path, error))
    }

    /// Makes everything added survive a loss of power if that was not done for a second; to be
    /// called often.
    ///
    /// # Errors
    /// Whatever the file system says, and when the file is no longer where it was.
    pub fn tick(&mut self) -> Result<(), JournalError> {
        let is_due = self.writer.sync_if_due();
        match is_due.map_err(|error| io_error(&self.path, error))? {
            true => self.is_in_place(),
            false => Ok(()),
        }
    }

    /// Makes everything added survive a loss of power.
    ///
    /// # Errors
    /// As [`Journal::tick`].
    pub fn finish(&mut self) -> Result<(), JournalError> {
        self.writer
            .sync()
            .map_err(|error| io_error(&self.path, error))?;
        self.is_in_place()
    }

    /// The records that are there, for reading while nothing is added.
    ///
    /// # Errors
    /// Whatever the file system says.
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

    /// Ends writing; the records are there to be read, and the file is still nobody else's.
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

fn io_error(path: &Path, error: io::Error) -> JournalError {
    JournalError::Io {
        path: path.to_owned(),
        error,
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

/// The head of a journal.
#[derive(Debug, Clone, Copy)]
struct Head {
    /// Seed of the records.
    seed: u32,
    /// Where they begin.
    length: u64,
}

impl Head {
    fn of(payload: &[u8]) -> Self {
        Self {
            seed: crc32fast::hash(payload),
            length: (frame::OVERHEAD + payload.len()) as u64,
        }
    }
}

/// The head of a file, if it is that of this sweep, or was made so; `None` when the file is none
/// of ours.
fn head(
    file: &File,
    path: &Path,
    header: &Header,
    warnings: &mut Vec<String>,
) -> Result<Option<Head>, JournalError> {
    let refuse = |error| io_error(path, error);
    let payload = header.to_bytes();
    let expected = Head::of(&payload);
    let end = file.metadata().map_err(refuse)?.len();
    let mut write = |warning: Option<&str>| {
        warnings.extend(warning.map(|text| format!("{}: {text}", path.display())));
        let mut start = file;
        start.seek(SeekFrom::Start(0))?;
        start.write_all(&frame::encode(HEADER_SEED, &payload))?;
        start.sync_all()?;
        sync_folder(path);
        Ok(Some(expected))
    };
    if end == 0 {
        return write(None).map_err(refuse);
    }
    if let Some(found) = read_head(file, end).map_err(refuse)? {
        let Some(there) = Header::from_bytes(&found) else {
            return Err(JournalError::NoHeader(path.to_owned()));
        };
        same(path, header, &there)?;
        return Ok(Some(Head::of(&found)));
    }
    // The records tell whether the head was that of this sweep.
    if has_records(file, expected, end).map_err(refuse)? {
        let mended = "the head, at offset 0, was damaged and has been mended";
        return write(Some(mended)).map_err(refuse);
    }
    if end <= expected.length {
        file.set_len(0).map_err(refuse)?;
        let anew = "held nothing but an unfinished head; begun anew";
        return write(Some(anew)).map_err(refuse);
    }
    Ok(None)
}

/// Checks that a journal with the head `there` is one of `header`.
fn same(path: &Path, header: &Header, there: &Header) -> Result<(), JournalError> {
    let mut differences = header.differences(there);
    if there.shard() != header.shard() {
        let (now, then) = (header.shard(), there.shard());
        differences.push(format!("shard: {now} here, {then} there"));
    }
    match differences.is_empty() {
        true => Ok(()),
        false => Err(JournalError::Different {
            path: path.to_owned(),
            differences,
        }),
    }
}

/// The payload of the head, if it is whole.
fn read_head(file: &File, end: u64) -> io::Result<Option<Vec<u8>>> {
    let piece = Scan::new(file, HEADER_SEED, 0, end)?.next()?;
    Ok(match piece {
        Some(Piece::Frame { offset: 0, payload }) => Some(payload),
        _ => None,
    })
}

fn has_records(file: &File, head: Head, end: u64) -> io::Result<bool> {
    let mut scan = Scan::new(file, head.seed, head.length.min(end), end)?;
    while let Some(piece) = scan.next()? {
        if matches!(piece, Piece::Frame { .. }) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Reads what points are there and cuts off an unfinished end; the points, and the length that is
/// left.
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

/// Makes a new file's name survive a loss of power, where folders can be synced.
fn sync_folder(path: &Path) {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    // Not all systems let folders be opened, and none need it for anything but a loss of power.
    let _ = File::open(folder.unwrap_or(Path::new("."))).and_then(|folder| folder.sync_all());
}

/// Bytes that a record takes whose result takes so many.
pub fn record_length(result: usize) -> usize {
    frame::OVERHEAD + size_of::<u64>() + result
}

/// A point and what it came to, from a payload.
fn record(payload: &[u8]) -> Option<(usize, &[u8])> {
    let (point, result) = payload.split_first_chunk()?;
    Some((usize::try_from(u64::from_le_bytes(*point)).ok()?, result))
}

/// Who else may be at work on a journal that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// Nobody.
    Alone,
    /// Whoever adds points: those added later are not seen.
    Shared,
}

/// A journal for reading.
#[derive(Debug)]
pub struct Records {
    path: PathBuf,
    file: File,
    head: Head,
}

impl Records {
    /// Opens a journal with its header.
    ///
    /// # Errors
    /// When it has no readable header or is being written although `access` is for oneself alone, and whatever the file
    /// system says.
    pub fn open(path: &Path, access: Access) -> Result<(Self, Header), JournalError> {
        let refuse = |error| io_error(path, error);
        let file = File::open(path).map_err(refuse)?;
        match (access, file.try_lock_shared()) {
            (Access::Alone, Err(TryLockError::WouldBlock)) => {
                return Err(JournalError::Locked(path.to_owned()));
            }
            (_, Err(TryLockError::Error(error))) => return Err(refuse(error)),
            _ => {}
        }
        let end = file.metadata().map_err(refuse)?.len();
        let payload = read_head(&file, end).map_err(refuse)?;
        let header = payload.as_deref().and_then(Header::from_bytes);
        let (Some(payload), Some(header)) = (payload, header) else {
            return Err(JournalError::NoHeader(path.to_owned()));
        };
        let records = Self {
            path: path.to_owned(),
            file,
            head: Head::of(&payload),
        };
        Ok((records, header))
    }

    /// Which points a run with `header` would find done in the journal at `path`, by their index in its shard; nothing is
    /// written.
    ///
    /// # Errors
    /// When the journal is another's, and whatever the file system says.
    pub fn done(path: &Path, header: &Header) -> Result<PointSet, JournalError> {
        let (records, there) = Self::open(path, Access::Shared)?;
        same(path, header, &there)?;
        let refuse = |error| io_error(path, error);
        let mut done = PointSet::none(header.most_points());
        let end = records.file.metadata().map_err(refuse)?.len();
        let Head { seed, length } = records.head;
        let mut scan = Scan::new(&records.file, seed, length, end).map_err(refuse)?;
        while let Some(piece) = scan.next().map_err(refuse)? {
            if let Piece::Frame { payload, .. } = piece
                && let Some((point, _)) = record(&payload)
                && let Some(index) = header.index(point)
            {
                done.insert(index);
            }
        }
        Ok(done)
    }
}

#[cfg(test)]
mod tests;
