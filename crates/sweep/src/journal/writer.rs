//! Appends to a journal: every frame reaches the system at once, and the disk within a second.

use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::time::{Duration, Instant};

/// Greatest interval between two syncs to disk.
pub(crate) const SYNC_INTERVAL: Duration = Duration::from_millis(900);

/// Target of a journal: a file, or a fault to be tested.
pub(crate) trait Medium {
    /// Appends bytes.
    fn append(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Syncs the bytes, to survive a loss of power.
    fn sync(&mut self) -> io::Result<()>;
    /// Truncates to a length.
    fn cut(&mut self, length: u64) -> io::Result<()>;
}

impl Medium for File {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.seek(SeekFrom::End(0))?;
        self.write_all(bytes)
    }

    fn sync(&mut self) -> io::Result<()> {
        self.sync_data()
    }

    fn cut(&mut self, length: u64) -> io::Result<()> {
        self.set_len(length)
    }
}

/// The end of a journal.
#[derive(Debug)]
pub(crate) struct Writer<M> {
    medium: M,
    length: u64,
    synced: Instant,
    is_dirty: bool,
}

impl<M: Medium> Writer<M> {
    /// Continues at `length`, the end of the medium.
    pub(crate) fn new(medium: M, length: u64) -> Self {
        Self {
            medium,
            length,
            synced: Instant::now(),
            is_dirty: false,
        }
    }

    /// Appends a frame: all of it, or nothing as far as still possible.
    pub(crate) fn append(&mut self, frame: &[u8]) -> io::Result<()> {
        if let Err(error) = self.medium.append(frame) {
            // If this fails too, the next reader cuts off the partial frame.
            let _ = self.medium.cut(self.length);
            return Err(error);
        }
        self.length += frame.len() as u64;
        self.is_dirty = true;
        Ok(())
    }

    /// Syncs to disk if due; returns whether it did.
    pub(crate) fn sync_if_due(&mut self) -> io::Result<bool> {
        if self.synced.elapsed() < SYNC_INTERVAL {
            return Ok(false);
        }
        self.sync()?;
        Ok(true)
    }

    /// The medium.
    pub(crate) fn medium(&self) -> &M {
        &self.medium
    }

    /// Returns the medium.
    pub(crate) fn into_medium(self) -> M {
        self.medium
    }

    /// Syncs to disk.
    pub(crate) fn sync(&mut self) -> io::Result<()> {
        if self.is_dirty {
            self.medium.sync()?;
            self.is_dirty = false;
        }
        self.synced = Instant::now();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disk with limited room, on which syncing may fail.
    struct Disk {
        bytes: Vec<u8>,
        room: usize,
        can_sync: bool,
    }

    impl Medium for Disk {
        fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
            let fits = bytes.len().min(self.room - self.bytes.len());
            self.bytes.extend(&bytes[..fits]);
            match fits == bytes.len() {
                true => Ok(()),
                false => Err(io::ErrorKind::StorageFull.into()),
            }
        }

        fn sync(&mut self) -> io::Result<()> {
            match self.can_sync {
                true => Ok(()),
                false => Err(io::Error::other("the disk is gone")),
            }
        }

        fn cut(&mut self, length: u64) -> io::Result<()> {
            self.bytes.truncate(length as usize);
            Ok(())
        }
    }

    fn writer(room: usize, can_sync: bool) -> Writer<Disk> {
        let disk = Disk {
            bytes: Vec::new(),
            room,
            can_sync,
        };
        Writer::new(disk, 0)
    }

    #[test]
    fn a_full_disk_leaves_whole_frames() {
        for room in 0..12 {
            let mut writer = writer(room, true);
            let frames = [b"abcd", b"efgh", b"ijkl"];
            let error = frames.iter().find_map(|frame| writer.append(*frame).err());
            assert_eq!(error.unwrap().kind(), io::ErrorKind::StorageFull);
            assert_eq!(writer.medium.bytes, b"abcdefghijkl"[..room / 4 * 4]);
        }
    }

    #[test]
    fn a_failed_sync_is_told_and_not_forgotten() {
        let mut writer = writer(100, false);
        assert!(writer.sync().is_ok(), "nothing to be written");
        writer.append(b"abcd").unwrap();
        assert!(writer.sync().is_err());
        assert!(writer.sync().is_err());
    }
}
