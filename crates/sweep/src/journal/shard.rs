//! Shards: interleaved points of a sweep for one of several machines, and the files of their journals.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::{fmt, io};

/// One of `count` interleaved parts of the points of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Shard {
    /// Number of the part, from 1.
    number: usize,
    /// Number of parts.
    count: usize,
}

/// Most shards of a sweep.
pub const MOST_SHARDS: usize = 60_000;
/// Ending of the names of journals.
const ENDING: &str = "journal";

impl Shard {
    /// All points.
    pub const WHOLE: Self = Self {
        number: 1,
        count: 1,
    };

    /// Part `number`, from 1, of `count`.
    pub fn new(number: usize, count: usize) -> Option<Self> {
        let is_one = (1..=count).contains(&number) && count <= MOST_SHARDS;
        is_one.then_some(Self { number, count })
    }

    /// Number of the part, from 1.
    pub fn number(self) -> usize {
        self.number
    }

    /// Number of parts.
    pub fn count(self) -> usize {
        self.count
    }

    /// Number of its points, out of `points` in all.
    pub fn len(self, points: usize) -> usize {
        (points + self.count - self.number) / self.count
    }

    /// Its `index`-th point, from 0.
    pub fn point(self, index: usize) -> usize {
        self.number - 1 + index * self.count
    }

    /// Index of `point` in the shard, if it belongs to it.
    pub fn index(self, point: usize) -> Option<usize> {
        (point % self.count == self.number - 1).then_some(point / self.count)
    }

    /// Name of its journal, for the sweep `stem`.
    pub fn journal(self, stem: &str) -> String {
        if self == Self::WHOLE {
            return format!("{stem}.{ENDING}");
        }
        format!("{stem}.{}-of-{}.{ENDING}", self.number, self.count)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let read = || {
            let (number, count) = text.split_once('/')?;
            Self::new(number.parse().ok()?, count.parse().ok()?)
        };
        read().ok_or_else(|| {
            format!("expected NUMBER/COUNT with 1 ≤ NUMBER ≤ COUNT ≤ {MOST_SHARDS}, such as 3/16")
        })
    }
}

/// The journals in a folder, sorted by name.
///
/// # Errors
/// If the folder cannot be read.
pub fn journals_in(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in folder.read_dir()? {
        let path = entry?.path();
        if path.is_file() && path.extension().is_some_and(|ending| ending == ENDING) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_in_one_shard() {
        for points in [0, 1, 5, 16, 17] {
            for count in [1, 2, 3, 16] {
                let mut seen = vec![0; points];
                for number in 1..=count {
                    let shard = Shard::new(number, count).unwrap();
                    for index in 0..shard.len(points) {
                        let point = shard.point(index);
                        assert_eq!(shard.index(point), Some(index));
                        seen[point] += 1;
                    }
                }
                assert!(seen.iter().all(|times| *times == 1), "{points} in {count}");
            }
        }
        assert_eq!(Shard::new(2, 3).unwrap().index(3), None);
    }

    #[test]
    fn shards_are_read_as_written() {
        assert_eq!("3/16".parse::<Shard>().unwrap().to_string(), "3/16");
        for text in ["0/3", "4/3", "3", "a/b", "1/0", "1/60001", "-1/2"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }
}
