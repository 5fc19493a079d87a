//! Printing to standard output, whose reader may have closed it.

use std::io::{ErrorKind, Write, stdout};
use std::path::PathBuf;

use crate::failure::Failure;

/// Prints a text. A reader who has seen enough and closed the pipe, as `head` does, is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let what = format!("standard output cannot be written: {error}");
            Err(Failure::Running(what))
        }
        _ => Ok(()),
    }
}

/// Prints the paths of files, one a line.
pub fn print_paths(files: &[PathBuf]) -> Result<(), Failure> {
    let lines = files.iter().map(|file| format!("{}\n", file.display()));
    print(&lines.collect::<String>())
}
