//! Names of journals in a results folder.

use std::io;
use std::path::{Path, PathBuf};

use crate::journal::shard::Shard;

const ENDING: &str = "journal";

/// Name of the journal of a shard of the sweep `stem`.
pub fn name(stem: &str, shard: Shard) -> String {
    if shard == Shard::WHOLE {
        return format!("{stem}.{ENDING}");
    }
    let (number, count) = (shard.number(), shard.count());
    format!("{stem}.{number}-of-{count}.{ENDING}")
}

/// The journals in a folder, sorted by name.
///
/// # Errors
/// If the folder cannot be read.
pub fn in_folder(folder: &Path) -> io::Result<Vec<PathBuf>> {
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
