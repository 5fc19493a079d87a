//! Reads frames from a file with arbitrary damage.
//!
//! After bytes that are not a frame the scan skips to the next mark, so that damage costs only the records that it
//! touches.

use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};

use super::frame::{self, MARK, OVERHEAD};

/// A piece of a journal.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Piece {
    /// A whole frame.
    Frame {
        /// Start.
        offset: u64,
        /// Content.
        payload: Vec<u8>,
    },
    /// Bytes that are not a frame.
    Damage {
        /// Start.
        offset: u64,
        /// Number of bytes.
        length: u64,
    },
}

/// Iterates over the frames of a file from an offset on.
pub(crate) struct Scan<F> {
    reader: BufReader<F>,
    seed: u32,
    offset: u64,
    end: u64,
}

impl<F: Read + Seek> Scan<F> {
    /// Scans a file that ends at `end`, from `offset` on, for frames with a seed.
    pub(crate) fn new(file: F, seed: u32, offset: u64, end: u64) -> io::Result<Self> {
        let mut reader = BufReader::with_capacity(1 << 16, file);
        reader.seek(SeekFrom::Start(offset))?;
        Ok(Self {
            reader,
            seed,
            offset,
            end,
        })
    }

    /// The next piece; `None` at the end.
    pub(crate) fn next(&mut self) -> io::Result<Option<Piece>> {
        if self.offset >= self.end {
            return Ok(None);
        }
        let begin = self.offset;
        if let Some(payload) = self.frame_at(begin)? {
            self.offset = begin + (OVERHEAD + payload.len()) as u64;
            let offset = begin;
            return Ok(Some(Piece::Frame { offset, payload }));
        }
        let mut candidate = begin + 1;
        loop {
            candidate = self.next_mark(candidate)?;
            if candidate >= self.end || self.frame_at(candidate)?.is_some() {
                self.offset = candidate;
                self.seek(candidate)?;
                let length = candidate - begin;
                return Ok(Some(Piece::Damage {
                    offset: begin,
                    length,
                }));
            }
            candidate += 1;
        }
    }

    /// Payload of the frame that starts at `offset`, if any.
    fn frame_at(&mut self, offset: u64) -> io::Result<Option<Vec<u8>>> {
        let left = self.end - offset;
        if left < OVERHEAD as u64 {
            return Ok(None);
        }
        self.seek(offset)?;
        let mut start = [0; OVERHEAD];
        self.reader.read_exact(&mut start)?;
        let Some(length) = frame::announced(&start) else {
            return Ok(None);
        };
        if left < (OVERHEAD + length) as u64 {
            return Ok(None);
        }
        let mut payload = vec![0; length];
        self.reader.read_exact(&mut payload)?;
        Ok(frame::is_whole(self.seed, &start, &payload).then_some(payload))
    }

    /// Offset of the first mark at or after `offset`; the end if there is none.
    fn next_mark(&mut self, offset: u64) -> io::Result<u64> {
        self.seek(offset)?;
        let mut matched = 0;
        let mut position = offset;
        while position < self.end {
            let buffer = self.reader.fill_buf()?;
            if buffer.is_empty() {
                break;
            }
            let read = buffer.len();
            for (index, byte) in buffer.iter().enumerate() {
                // No byte of the mark repeats its first, so a failed match restarts here.
                matched = match *byte {
                    byte if byte == MARK[matched] => matched + 1,
                    byte if byte == MARK[0] => 1,
                    _ => 0,
                };
                if matched == MARK.len() {
                    return Ok(position + index as u64 + 1 - MARK.len() as u64);
                }
            }
            self.reader.consume(read);
            position += read as u64;
        }
        Ok(self.end)
    }

    /// Seeks an offset, within the buffer if possible.
    fn seek(&mut self, offset: u64) -> io::Result<()> {
        let here = self.reader.stream_position()?;
        self.reader.seek_relative(offset as i64 - here as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    const SEED: u32 = 7;

    fn pieces(bytes: &[u8]) -> Vec<Piece> {
        let mut scan = Scan::new(Cursor::new(bytes), SEED, 0, bytes.len() as u64).unwrap();
        let mut pieces = Vec::new();
        while let Some(piece) = scan.next().unwrap() {
            pieces.push(piece);
        }
        pieces
    }

    fn payloads(pieces: &[Piece]) -> Vec<&[u8]> {
        let payload = pieces.iter().map(|piece| match piece {
            Piece::Frame { payload, .. } => Some(payload.as_slice()),
            Piece::Damage { .. } => None,
        });
        payload.flatten().collect()
    }

    const RECORDS: [&[u8]; 4] = [b"one", b"", b"three \xABtdj three", b"\xAB\xABtd"];

    fn journal() -> Vec<u8> {
        let frames = RECORDS.map(|payload| frame::encode(SEED, payload));
        frames.concat()
    }

    #[test]
    fn what_was_written_is_read() {
        assert_eq!(payloads(&pieces(&journal())), RECORDS);
        assert_eq!(pieces(b""), []);
    }

    #[test]
    fn every_cut_costs_the_last_record_only() {
        let whole = journal();
        for length in 0..whole.len() {
            let found = pieces(&whole[..length]);
            let kept = payloads(&found).len();
            assert_eq!(payloads(&found), RECORDS[..kept]);
            let good: usize = RECORDS[..kept].iter().map(|r| OVERHEAD + r.len()).sum();
            let next = RECORDS[kept].len() + OVERHEAD;
            assert!(length - good < next, "cut at {length}");
            let damage = Piece::Damage {
                offset: good as u64,
                length: (length - good) as u64,
            };
            assert_eq!(found.last() == Some(&damage), length > good);
        }
    }

    #[test]
    fn every_flipped_bit_costs_one_record_only_and_its_place_is_told() {
        let whole = journal();
        for position in 0..whole.len() {
            for bit in 0..8 {
                let mut bytes = whole.clone();
                bytes[position] ^= 1 << bit;
                let found = pieces(&bytes);
                let kept = payloads(&found);
                assert_eq!(
                    kept.len(),
                    RECORDS.len() - 1,
                    "bit {bit} of byte {position}"
                );
                assert!(kept.iter().all(|payload| RECORDS.contains(payload)));
                let Some(Piece::Damage { offset, length }) = found
                    .iter()
                    .find(|piece| matches!(piece, Piece::Damage { .. }))
                else {
                    panic!("bit {bit} of byte {position} is not told");
                };
                assert!((*offset..offset + length).contains(&(position as u64)));
            }
        }
    }

    #[test]
    fn records_of_another_seed_are_damage() {
        let other = frame::encode(SEED + 1, b"other");
        let bytes = [journal(), other].concat();
        assert_eq!(payloads(&pieces(&bytes)), RECORDS);
    }
}
