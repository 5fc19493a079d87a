//! The files that `land` writes: where they go, and how long a history may be.

use std::path::{Path, PathBuf};

use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::output::file_writer::{Draft, Folder, WriteError};
use touchdown_sweep::output::history::History;

/// Most instants in a history: a hundred times what the longest landing needs at 0.01 s.
const LONGEST_HISTORY: f64 = 1e7;

/// Checks the time between the rows of a history, s.
pub fn interval(seconds: f64, time_limit: f64) -> Result<f64, InputError> {
    let least = time_limit / LONGEST_HISTORY;
    if seconds >= least && seconds > 0.0 {
        Ok(seconds)
    } else {
        let allowed = format!("at least {least:e} s, a ten-millionth of the time limit");
        Err(InputError::value("--interval", seconds, &allowed))
    }
}

/// Whether a file that begins with this line is a history.
pub fn is_history(line: &str) -> bool {
    line.starts_with("t_s,")
}

/// The file of a finished history.
///
/// # Errors
/// Names the file that could not be written.
pub fn ended(history: History<Draft>, path: PathBuf) -> Result<Draft, WriteError> {
    history.end().map_err(|error| WriteError { path, error })
}

/// Folder, checked to be writable, and name of a file that will be written.
pub fn place_of(file: &Path) -> Result<(Folder, String), InputError> {
    let folder = Folder::of(file)?;
    let name = file.file_name().unwrap_or(file.as_os_str());
    Ok((folder, name.to_string_lossy().into_owned()))
}
