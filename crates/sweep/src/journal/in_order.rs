//! Reads the records of one or more journals in point order without holding them in memory.
//!
//! A temporary file stores the location of every point's record, eight bytes each, accessed through one page in memory.
//! Points are computed nearly in order, so pages seldom change.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;

use touchdown_input::sweeps::sweep_file::Sweep;

use super::error::{JournalError, io_error};
use super::frame::{self, OVERHEAD};
use super::records::Records;
use super::scan::{Piece, Scan};
use super::{kept, record};

/// Bits of an index entry for the offset; the rest count journals from 1.
const OFFSET_BITS: u32 = 48;
/// Entries per page of the index.
const PAGE: usize = 1 << 13;

/// Results by point.
#[derive(Debug)]
pub struct InOrder {
    journals: Vec<Reader>,
    index: Index,
    points: usize,
    found: usize,
}

#[derive(Debug)]
struct Reader {
    records: Records,
    reader: BufReader<File>,
}

impl InOrder {
    /// Scans journals for the records of `points` points; the index is kept in `folder`.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn new(journals: Vec<Records>, points: usize, folder: &Path) -> Result<Self, JournalError> {
        let refuse = |error| io_error(folder, error);
        let mut index = Index::new(points, folder).map_err(refuse)?;
        let mut found = 0;
        let mut readers = Vec::with_capacity(journals.len());
        for (number, records) in journals.into_iter().enumerate() {
            let mark = (number as u64 + 1) << OFFSET_BITS;
            let refuse = |error| io_error(&records.path, error);
            let end = records.file.metadata().map_err(refuse)?.len();
            let mut scan = Scan::new(&records.file, records.head.seed, records.head.length, end)
                .map_err(refuse)?;
            while let Some(piece) = scan.next().map_err(refuse)? {
                let Piece::Frame { offset, payload } = piece else {
                    continue;
                };
                let point = record(&payload).map(|(point, _)| point);
                let Some(point) = point.filter(|point| *point < points) else {
                    continue;
                };
                let entry = index.entry(point).map_err(refuse)?;
                if *entry == 0 {
                    *entry = mark | offset;
                    found += 1;
                }
            }
            let file = records.file.try_clone().map_err(refuse)?;
            readers.push(Reader {
                reader: BufReader::with_capacity(1 << 16, file),
                records,
            });
        }
        for reader in &mut readers {
            let Reader { records, reader } = reader;
            reader
                .rewind()
                .map_err(|error| io_error(&records.path, error))?;
        }
        Ok(Self {
            journals: readers,
            index,
            points,
            found,
        })
    }

    /// Number of points without a record.
    pub fn missing(&self) -> usize {
        self.points - self.found
    }

    /// The first points without a record, at most `most` of them.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn first_missing(&mut self, most: usize) -> io::Result<Vec<usize>> {
        let mut missing = Vec::new();
        for point in 0..self.points {
            if missing.len() == most.min(self.points - self.found) {
                break;
            }
            if *self.index.entry(point)? == 0 {
                missing.push(point);
            }
        }
        Ok(missing)
    }

    /// Keeps the journal of a whole sweep that can grow, once results are written from it; removes any other.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn end_journal(self, sweep: &Sweep) -> Result<(), JournalError> {
        if !sweep.design.is_nested() {
            return self.remove_journals();
        }
        for Reader { records, .. } in &self.journals {
            let path = &records.path;
            std::fs::rename(path, kept(path)).map_err(|error| io_error(path, error))?;
        }
        Ok(())
    }

    /// Removes the journals once results are written from them; they stay locked until then.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn remove_journals(self) -> Result<(), JournalError> {
        for Reader { records, .. } in &self.journals {
            let path = &records.path;
            std::fs::remove_file(path).map_err(|error| io_error(path, error))?;
        }
        Ok(())
    }

    /// Reads the result of a point; `None` without a record.
    ///
    /// # Errors
    /// Errors of the file system; also if the journal has changed since it was scanned.
    pub fn result(&mut self, point: usize) -> Result<Option<Vec<u8>>, JournalError> {
        let entry = *self.index.entry(point).map_err(JournalError::index)?;
        let offset = entry & ((1 << OFFSET_BITS) - 1);
        let Some(number) = ((entry >> OFFSET_BITS) as usize).checked_sub(1) else {
            return Ok(None);
        };
        let journal = &mut self.journals[number];
        let read = journal.read(offset);
        let path = &journal.records.path;
        let payload = read.map_err(|error| io_error(path, error))?;
        match record(&payload) {
            Some((found, result)) if found == point => Ok(Some(result.to_vec())),
            _ => Err(io_error(path, changed())),
        }
    }
}

fn changed() -> io::Error {
    io::Error::other("changed while it was read")
}

impl Reader {
    fn read(&mut self, offset: u64) -> io::Result<Vec<u8>> {
        let here = self.reader.stream_position()?;
        self.reader.seek_relative(offset as i64 - here as i64)?;
        let mut start = [0; OVERHEAD];
        self.reader.read_exact(&mut start)?;
        let length = frame::announced(&start).ok_or_else(changed)?;
        let mut payload = vec![0; length];
        self.reader.read_exact(&mut payload)?;
        match frame::is_whole(self.records.head.seed, &start, &payload) {
            true => Ok(payload),
            false => Err(changed()),
        }
    }
}

/// A number for every point, initially zero, in a file.
#[derive(Debug)]
struct Index {
    file: File,
    /// The page in memory, followed by its number.
    page: Vec<u64>,
    number: usize,
}

impl Index {
    fn new(points: usize, folder: &Path) -> io::Result<Self> {
        let file = tempfile::tempfile_in(folder)?;
        let pages = points.div_ceil(PAGE).max(1);
        file.set_len((pages * PAGE * 8) as u64)?;
        Ok(Self {
            file,
            page: vec![0; PAGE],
            number: 0,
        })
    }

    fn entry(&mut self, point: usize) -> io::Result<&mut u64> {
        let number = point / PAGE;
        if number != self.number {
            let bytes: Vec<u8> = self.page.iter().flat_map(|e| e.to_le_bytes()).collect();
            self.go_to(self.number)?;
            self.file.write_all(&bytes)?;
            self.go_to(number)?;
            let mut bytes = vec![0; PAGE * 8];
            self.file.read_exact(&mut bytes)?;
            let (entries, _) = bytes.as_chunks::<8>();
            self.page = entries.iter().map(|e| u64::from_le_bytes(*e)).collect();
            self.number = number;
        }
        Ok(&mut self.page[point % PAGE])
    }

    fn go_to(&mut self, page: usize) -> io::Result<u64> {
        self.file.seek(SeekFrom::Start((page * PAGE * 8) as u64))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_index_keeps_what_is_put_in_it() {
        let folder = tempfile::tempdir().unwrap();
        let count = 3 * PAGE + 17;
        let mut index = Index::new(count, folder.path()).unwrap();
        let value = |point: usize| point as u64 * 31 + 1;
        for point in (0..count).step_by(7).chain((3..count).step_by(7)) {
            *index.entry(point).unwrap() = value(point);
        }
        for point in 0..count {
            let expected = if point % 7 == 0 || point % 7 == 3 {
                value(point)
            } else {
                0
            };
            assert_eq!(*index.entry(point).unwrap(), expected, "{point}");
        }
    }
}
