//! Merges the shards of sweeps.

use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::journal::header::Header;
use crate::journal::{Access, JournalError, Records};

/// The journals of one sweep.
#[derive(Debug)]
pub struct Shards {
    /// Their common header.
    pub header: Header,
    /// The journals.
    pub journals: Vec<Records>,
    /// Numbers of the shards without a journal.
    pub absent: Vec<usize>,
}

/// Reason why journals do not make up a sweep.
#[derive(Debug, Error)]
#[non_exhaustive]
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
        /// The first journal of the sweep.
        one: PathBuf,
        /// The journal that does not belong to it.
        other: PathBuf,
        /// The differences.
        differences: Vec<String>,
    },
}

/// Groups journals by sweep, which is identified by the name of its file. Skips those of tables of cases.
///
/// # Errors
/// If a journal cannot be read, is being written although `access` forbids it, or differs from others of its sweep in
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
