//! Input files as texts: the disk that has them, or stored copies.

use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::documents::input_error::InputError;

/// A file, verbatim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// Path, as given or as named in another file.
    pub path: PathBuf,
    /// Text.
    pub text: String,
}

/// Source of files.
#[derive(Debug, Clone, Copy)]
pub enum Library<'l> {
    /// The disk of this machine.
    Disk,
    /// Stored copies.
    Copies(&'l [Source]),
}

impl Library<'_> {
    /// True if a file exists.
    pub fn has(self, path: &Path) -> bool {
        match self {
            Self::Disk => path.is_file(),
            Self::Copies(sources) => sources.iter().any(|source| source.path == path),
        }
    }

    /// Reason why the path of an input file cannot be read: it does not exist, or is a folder.
    pub fn refusal(self, path: &Path) -> Option<String> {
        match self {
            _ if self.has(path) => None,
            Self::Disk if path.is_dir() => Some(format!("{} is a folder", path.display())),
            _ => Some(format!("there is no file {}", path.display())),
        }
    }

    /// Reads the text of a file.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn text(self, path: &Path) -> Result<String, InputError> {
        let refuse = |what: &dyn Display| InputError::unreadable(path, what);
        match self {
            Self::Disk => fs::read_to_string(path).map_err(|error| refuse(&error)),
            Self::Copies(sources) => match sources.iter().find(|source| source.path == path) {
                Some(source) => Ok(source.text.clone()),
                None => Err(refuse(&"the journal holds no copy of it")),
            },
        }
    }
}
