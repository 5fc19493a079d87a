//! Where the text of input files comes from: the disk, or a copy that was kept of it.

use std::fmt::Display;
use std::fs;
use std::path::Path;

pub use crate::source::Source;

use crate::document::Document;
use crate::input_error::InputError;

/// Where files are read.
#[derive(Debug, Clone, Copy)]
pub enum Library<'l> {
    /// On this machine.
    Disk,
    /// Among copies.
    Copies(&'l [Source]),
}

impl Library<'_> {
    /// Whether there is a file.
    pub fn has(self, path: &Path) -> bool {
        match self {
            Self::Disk => path.is_file(),
            Self::Copies(sources) => sources.iter().any(|source| source.path == path),
        }
    }

    /// What is wrong with the path of a file that is to be read: that there is none, or that it is a folder.
    pub fn refusal(self, path: &Path) -> Option<String> {
        match self {
            _ if self.has(path) => None,
            Self::Disk if path.is_dir() => Some(format!("{} is a folder", path.display())),
            _ => Some(format!("there is no file {}", path.display())),
        }
    }

    /// The text of a file.
    ///
    /// # Errors
    /// When it cannot be read.
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

    /// A file that is TOML.
    ///
    /// # Errors
    /// When it cannot be read, is not TOML, or holds a number that is not finite.
    pub fn document(self, path: &Path) -> Result<Document, InputError> {
        Document::parse(path, &self.text(path)?)
    }
}
