//! Files as they are read, with a copy of each.

use std::path::Path;

use touchdown_sweep::document::Document;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::library::{Library, Source};

/// A library, and copies of what was read from it.
#[derive(Debug)]
pub struct Reading<'l> {
    /// Where files are read.
    pub library: Library<'l>,
    /// What was read.
    pub copies: Vec<Source>,
}

impl<'l> Reading<'l> {
    /// From a library.
    pub fn of(library: Library<'l>) -> Self {
        Self {
            library,
            copies: Vec::new(),
        }
    }

    /// Keeps a copy.
    pub fn keep(&mut self, source: Source) {
        if self.copies.iter().all(|known| known.path != source.path) {
            self.copies.push(source);
        }
    }

    /// The text of a file.
    pub fn text(&mut self, path: &Path) -> Result<String, InputError> {
        let text = self.library.text(path)?;
        self.keep(Source {
            path: path.to_owned(),
            text: text.clone(),
        });
        Ok(text)
    }

    /// The text of a file that may be missing.
    pub fn optional_text(&mut self, path: &Path) -> Result<Option<String>, InputError> {
        match self.library.has(path) {
            true => self.text(path).map(Some),
            false => Ok(None),
        }
    }

    /// A file that is TOML.
    pub fn document(&mut self, path: &Path) -> Result<Document, InputError> {
        Document::parse(path, &self.text(path)?)
    }
}
