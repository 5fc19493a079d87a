//! Guards output files: a command must not overwrite its inputs, nor existing files that are not its own, unless told
//! to.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use touchdown_input::documents::input_error::InputError;

/// Longest first line examined, bytes.
const LONGEST_LINE: u64 = 1 << 16;

/// The inputs of a command, and whether it may overwrite files of others.
#[derive(Debug, Clone, Copy)]
pub struct OutputGuard<'a> {
    /// Input files of the command.
    pub inputs: &'a [&'a Path],
    /// True if files that are not its own may be replaced.
    pub overwrite: bool,
}

impl OutputGuard<'_> {
    /// Checks that `file` may be written: it is not an input, and either does not exist or has a first line accepted by
    /// `is_own`.
    ///
    /// # Errors
    /// Names the file and what is expected.
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

    /// Checks that `file` may be written: it is not an input, and either does not exist or already has this content.
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
