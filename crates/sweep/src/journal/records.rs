//! Journals opened for reading.

use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};

use super::error::{JournalError, io_error};
use super::head::{Head, read_head, same};
use super::scan::{Piece, Scan};
use super::{Kept, is_set_aside, kept, record};
use crate::journal::header::Header;
use crate::journal::point_set::PointSet;

/// Permitted concurrent access to a journal being read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// None.
    Alone,
    /// Another process may add points; later ones are not seen.
    Shared,
}

/// A journal opened for reading.
#[derive(Debug)]
pub struct Records {
    pub(super) path: PathBuf,
    pub(super) file: File,
    pub(super) head: Head,
}

impl Records {
    /// Opens a journal and reads its header.
    ///
    /// # Errors
    /// If it has no readable header, or is being written under [`Access::Alone`]; errors of the file system.
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

    /// Points that a run with `header` would find done in the journal at `path` and, if it `grows`, in that of a smaller
    /// sample, by index in its shard. Writes nothing.
    ///
    /// # Errors
    /// If the journal belongs to other input; errors of the file system.
    pub fn done(path: &Path, header: &Header, grows: bool) -> Result<PointSet, JournalError> {
        let mut done = PointSet::none(header.most_points());
        let sets_aside = grows && is_set_aside(path, header);
        if !sets_aside && path.is_file() {
            match Self::open(path, Access::Shared) {
                // A run begins it anew.
                Err(JournalError::NoHeader(_)) => {}
                opened => {
                    let (records, there) = opened?;
                    same(path, header, &there)?;
                    records.add_points(header, &mut done)?;
                }
            }
        }
        let smaller = if sets_aside {
            path.to_owned()
        } else {
            kept(path)
        };
        if grows && let Kept::Smaller(records, _) = Kept::at(&smaller, header)? {
            records.add_points(header, &mut done)?;
        }
        Ok(done)
    }

    /// Adds its points, by index in the shard of `header`.
    fn add_points(&self, header: &Header, done: &mut PointSet) -> Result<(), JournalError> {
        let refuse = |error| io_error(&self.path, error);
        let end = self.file.metadata().map_err(refuse)?.len();
        let Head { seed, length } = self.head;
        let mut scan = Scan::new(&self.file, seed, length, end).map_err(refuse)?;
        while let Some(piece) = scan.next().map_err(refuse)? {
            if let Piece::Frame { payload, .. } = piece
                && let Some((point, _)) = record(&payload)
                && let Some(index) = header.index(point)
            {
                done.insert(index);
            }
        }
        Ok(())
    }
}
