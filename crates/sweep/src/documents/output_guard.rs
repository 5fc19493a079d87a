//! Files that a command may write: none that it reads, and none that is there already and not its own, unless it is told
//! to.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use crate::input_error::InputError;

/// Longest first line that is looked at, bytes.
const LONGEST_LINE: u64 = 1 << 16;

/// What a command reads, and whether it may replace what others have written.
#[derive(Debug, Clone, Copy)]
pub struct OutputGuard<'a> {
    /// Files that the command reads.
    pub inputs: &'a [&'a Path],
    /// Whether it was told to replace files that are not its own.
    pub overwrite: bool,
}

impl OutputGuard<'_> {
    /// Checks that `file` may be written: it is not read, and either not there or with a first line that `is_own` knows.
    ///
    /// # Errors
    /// Names the file and what is allowed.
    pub fn check(&self, file: &Path, is_own: impl Fn(&str) -> bool) -> Result<(), InputError> {
        let first_line = |file| {
            let mut line = Vec::new();
            let mut reader = BufReader::new(fs::File::open(file).ok()?.take(LONGEST_LINE));
            reader.read_until(b'\n', &mut line).ok()?;
            Some(String::from_utf8_lossy(&line).trim_end().to_owned())
        };
        self.refuse_inputs(file)?;
        self.refuse(file, || first_line(file).is_some_and(|line| is_own(&line)))
    }

    /// Checks that `file` may be written: it is not read, and either not there or the same already.
    ///
    /// # Errors
    /// As [`OutputGuard::check`].
    pub fn check_same(&self, file: &Path, bytes: &[u8]) -> Result<(), InputError> {
        self.refuse_inputs(file)?;
        self.refuse(file, || fs::read(file).is_ok_and(|there| there == bytes))
    }

    fn refuse_inputs(&self, file: &Path) -> Result<(), InputError> {
        let real = |path: &Path| path.canonicalize().ok();
        let is_input = (self.inputs.iter()).any(|input| {
            let both = real(input).zip(real(file));
            both.is_some_and(|(input, file)| input == file)
        });
        match is_input {
            true => Err(InputError::in_file(
                file,
                "is read by this command and cannot be written too: expected another file",
            )),
            false => Ok(()),
        }
    }

    fn refuse(&self, file: &Path, is_own: impl FnOnce() -> bool) -> Result<(), InputError> {
        let refused = |complaint| Err(InputError::in_file(file, complaint));
        if file.is_dir() {
            return refused("is a folder: expected the name of a file");
        }
        if self.overwrite || !file.exists() || is_own() {
            return Ok(());
        }
        refused(
            "exists and is no earlier result of this command: expected another file, or --overwrite",
        )
    }
}
