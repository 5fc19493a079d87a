//! Reads files and keeps a copy of each.

use std::path::Path;

use touchdown_input::documents::document::Document;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::library::{Library, Source};

/// A library, with copies of the files read from it.
#[derive(Debug)]
pub struct Reading<'l> {
    /// Source of files.
    pub library: Library<'l>,
    /// Copies of them.
    pub copies: Vec<Source>,
}

impl<'l> Reading<'l> {
    /// Reads from a library.
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

    /// Reads a TOML file.
    pub fn document(&mut self, path: &Path) -> Result<Document, InputError> {
        Document::parse(path, &self.text(path)?)
    }
}
