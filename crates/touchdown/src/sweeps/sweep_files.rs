//! The sweeps that a command line names: files, and all sweep files of folders.

use std::path::{Path, PathBuf};

use touchdown_input::documents::input_error::InputError;
use touchdown_input::sweeps::sweep_file::Sweep;

/// Reads all sweeps before anything is run.
///
/// # Errors
/// When one of them cannot be used, or two would have results of the same name.
pub fn read(paths: &[PathBuf]) -> Result<Vec<Sweep>, InputError> {
    let mut sweeps: Vec<Sweep> = Vec::with_capacity(paths.len());
    for file in files(paths)? {
        let sweep = Sweep::read(&file)?;
        if let Some(other) = sweeps.iter().find(|other| other.stem() == sweep.stem()) {
            let complaint = format!(
                "has the same name as {}: expected names that differ, as results are named \
                 after them",
                other.path.display()
            );
            return Err(InputError::in_file(&file, complaint));
        }
        sweeps.push(sweep);
    }
    Ok(sweeps)
}

/// The paths with every folder replaced by the TOML files in it, in the order of their names;
/// folders in it, such as that of the vehicles, are left alone.
fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, InputError> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            files.extend(sweep_files_in(path)?);
        } else {
            files.push(path.clone());
        }
    }
    Ok(files)
}

fn sweep_files_in(folder: &Path) -> Result<Vec<PathBuf>, InputError> {
    let unreadable = |error: std::io::Error| InputError::unreadable(folder, error);
    let mut found = Vec::new();
    for entry in folder.read_dir().map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.is_file() && path.extension().is_some_and(|ending| ending == "toml") {
            found.push(path);
        }
    }
    if found.is_empty() {
        let complaint = "has no sweep files: expected at least one file *.toml";
        return Err(InputError::in_file(folder, complaint));
    }
    found.sort();
    Ok(found)
}
