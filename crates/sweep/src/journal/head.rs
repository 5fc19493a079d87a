//! The head of a journal, which ties it to one input and one program.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

use super::error::{JournalError, io_error};
use super::frame::{self, HEADER_SEED};
use super::scan::{Piece, Scan};
use crate::journal::header::Header;

/// The head of a journal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Head {
    /// Seed of the records.
    pub seed: u32,
    /// Start of the records.
    pub length: u64,
}

impl Head {
    /// The head for a payload.
    pub fn of(payload: &[u8]) -> Self {
        Self {
            seed: crc32fast::hash(payload),
            length: (frame::OVERHEAD + payload.len()) as u64,
        }
    }
}

/// Reads, writes or repairs the head of a file for this sweep; `None` if the file is not one of this program.
pub(super) fn ensure_head(
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

/// Checks that a journal with the head `there` belongs to `header`.
pub(super) fn same(path: &Path, header: &Header, there: &Header) -> Result<(), JournalError> {
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

/// Payload of the head, if intact.
pub(super) fn read_head(file: &File, end: u64) -> io::Result<Option<Vec<u8>>> {
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

/// Makes the name of a new file survive a loss of power, if folders can be synced.
fn sync_folder(path: &Path) {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    // Not all systems let folders be opened; a sync matters only for a loss of power.
    let _ = File::open(folder.unwrap_or(Path::new("."))).and_then(|folder| folder.sync_all());
}
