//! What commands share of files, messages and the terminal.

pub mod failure;
pub mod interrupt;
pub mod progress;
pub mod summary;

use std::io::{ErrorKind, Write, stdout};
use std::path::PathBuf;

use failure::Failure;

/// Prints a text to standard output. A reader who has seen enough and closed the pipe, as `head` does, is no failure.
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
