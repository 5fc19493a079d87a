//! Shards of sweeps, computed anywhere, put together again.

use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::header::Header;
use crate::journal::{Access, JournalError, Records};

/// The journals of one sweep.
#[derive(Debug)]
pub struct Shards {
    /// What all of them belong to.
    pub header: Header,
    /// The journals.
    pub journals: Vec<Records>,
    /// Numbers of the shards of which there is no journal.
    pub absent: Vec<usize>,
}

/// Why journals do not make a sweep.
#[derive(Debug, Error)]
pub enum MergeError {
    /// One of them cannot be read.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// Two of them do not belong together.
    #[error(
        "{}: does not belong to {}. What differs (here: in the latter, there: in the former):\n  {}",
        .other.display(), .one.display(), .differences.join("\n  ")
    )]
    Strangers {
        /// The first of the sweep.
        one: PathBuf,
        /// The one that does not belong to it.
        other: PathBuf,
        /// In what they differ.
        differences: Vec<String>,
    },
}

/// Sorts journals by their sweeps, whose names are those of the sweep files; those of tables of cases are left out.
///
/// # Errors
/// When a journal cannot be read, is being written where that matters, or differs from others of its sweep in
/// anything that determines results.
pub fn by_sweep(paths: &[PathBuf], access: Access) -> Result<Vec<Shards>, MergeError> {
    let mut sweeps: Vec<(PathBuf, Shards)> = Vec::new();
    let mut numbers: Vec<Vec<usize>> = Vec::new();
    for path in paths {
        let (records, header) = Records::open(path, access)?;
        if header.sweep_file().is_none() {
            continue;
        }
        let stem = |header: &Header| {
            let stem = header.sweep_file().and_then(Path::file_stem);
            stem.map(Path::new).map(Path::to_owned)
        };
        let known = sweeps
            .iter()
            .position(|(_, shards)| stem(&shards.header) == stem(&header));
        let Some(index) = known else {
            numbers.push(vec![header.shard().number()]);
            let shards = Shards {
                header,
                journals: vec![records],
                absent: Vec::new(),
            };
            sweeps.push((path.clone(), shards));
            continue;
        };
        let (one, shards) = &mut sweeps[index];
        let mut differences = shards.header.differences(&header);
        let (mine, others) = (shards.header.shard(), header.shard());
        if mine.count() != others.count() {
            differences.push(format!("shard: {mine} here, {others} there"));
        } else if numbers[index].contains(&others.number()) {
            differences.push(format!("shard {others} is there twice"));
        }
        if !differences.is_empty() {
            return Err(MergeError::Strangers {
                one: one.clone(),
                other: path.clone(),
                differences,
            });
        }
        numbers[index].push(others.number());
        shards.journals.push(records);
    }
    let complete = |((_, mut shards), numbers): ((_, Shards), Vec<usize>)| {
        let all = 1..=shards.header.shard().count();
        shards.absent = all.filter(|number| !numbers.contains(number)).collect();
        shards
    };
    Ok(sweeps.into_iter().zip(numbers).map(complete).collect())
}
