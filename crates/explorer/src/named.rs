//! The named input files, read once.

mod record;
mod results;
mod source;

use std::path::{Path, PathBuf};

use touchdown_input::documents::document::Document;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::library::{self, Library};
use touchdown_input::documents::output_units::OutputUnits;

pub use results::{Results, ResultsKind};
pub use source::{Source, SourceKind};

/// Default vehicle if no file is named.
const SURVEYOR: &str = "sweeps/vehicles/surveyor-table-4-1.toml";
const SURVEYOR_TEXT: &str = include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml");

/// Everything that requests can refer to.
#[derive(Debug, Clone)]
pub struct Named {
    /// Starting touchdowns, at least one.
    pub sources: Vec<Source>,
    /// Tables of results.
    pub results: Vec<Results>,
    /// Default units of answers.
    pub units: OutputUnits,
    /// The files as named, without those that were skipped.
    pub files: Vec<PathBuf>,
    /// Tables with neither transitions nor landings, such as those of edges and probabilities beside others.
    pub skipped: Vec<PathBuf>,
    /// Copies of all files read.
    pub copies: Vec<library::Source>,
}

impl Named {
    /// Reads files: vehicles, scenes, sweeps, tables of results; the Surveyor without any. Units default to those of
    /// the first file.
    ///
    /// # Errors
    /// Names the first file that is none of these, or the fault in it. Other tables are skipped, unless all files are.
    pub fn read(
        files: &[PathBuf],
        library: Library,
        units: Option<OutputUnits>,
    ) -> Result<Self, InputError> {
        let own = [library::Source {
            path: PathBuf::from(SURVEYOR),
            text: SURVEYOR_TEXT.to_owned(),
        }];
        let mut named = Self {
            sources: Vec::new(),
            results: Vec::new(),
            units: OutputUnits::default(),
            files: Vec::new(),
            skipped: Vec::new(),
            copies: Vec::new(),
        };
        let mut reading = Reading::of(library);
        for file in files {
            let is_known = named.add(&mut reading, file)?;
            let list = if is_known {
                &mut named.files
            } else {
                &mut named.skipped
            };
            list.push(file.clone());
        }
        if let (true, Some(file)) = (named.files.is_empty(), named.skipped.first()) {
            let complaint =
                "expected a table of transitions or of landings, as touchdown sweep writes them";
            return Err(InputError::in_file(file, complaint));
        }
        if named.sources.is_empty() {
            let mut reading = Reading::of(Library::Copies(&own));
            named
                .sources
                .push(Source::of_vehicle(&mut reading, Path::new(SURVEYOR))?);
        }
        named.units = units.unwrap_or(named.sources[0].units);
        named.copies = reading.copies;
        Ok(named)
    }

    /// Adds a file; false for a table with neither transitions nor landings.
    fn add(&mut self, reading: &mut Reading, file: &Path) -> Result<bool, InputError> {
        match file.extension().and_then(|ending| ending.to_str()) {
            Some("csv") => {
                let Some((mut results, source)) = Results::read(reading, file)? else {
                    return Ok(false);
                };
                if let Some(source) = source {
                    results.source = Some(self.add_source(source));
                }
                results.name = unnamed(&results.name, |name| self.results(name).is_some());
                self.results.push(results);
            }
            Some("toml") => {
                for source in Source::read(reading, file)? {
                    self.add_source(source);
                }
            }
            _ => {
                let complaint =
                    "expected a vehicle, scene or sweep file (.toml), or a table of results (.csv)";
                return Err(InputError::in_file(file, complaint));
            }
        }
        Ok(true)
    }

    /// Adds a source under a unique name.
    fn add_source(&mut self, mut source: Source) -> String {
        source.name = unnamed(&source.name, |name| self.source(Some(name)).is_some());
        let name = source.name.clone();
        self.sources.push(source);
        name
    }

    /// The source with a name, or the first.
    pub fn source(&self, name: Option<&str>) -> Option<&Source> {
        match name {
            None => self.sources.first(),
            Some(name) => self.sources.iter().find(|source| source.name == name),
        }
    }

    /// Name of the source of the landings of a table: the first of all if the table has no record.
    pub fn source_of<'n>(&'n self, results: &'n Results) -> &'n str {
        match &results.source {
            Some(source) => source,
            None => &self.sources[0].name,
        }
    }

    /// Finds a table of results by name.
    pub fn results(&self, name: &str) -> Option<&Results> {
        self.results.iter().find(|results| results.name == name)
    }
}

/// A library, with copies of the files read from it.
#[derive(Debug)]
pub struct Reading<'l> {
    /// Source of files.
    pub library: Library<'l>,
    /// Copies of them.
    pub copies: Vec<library::Source>,
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
    pub fn keep(&mut self, source: library::Source) {
        if self.copies.iter().all(|known| known.path != source.path) {
            self.copies.push(source);
        }
    }

    /// The text of a file.
    pub fn text(&mut self, path: &Path) -> Result<String, InputError> {
        let text = self.library.text(path)?;
        self.keep(library::Source {
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

/// A name, with a number appended if taken.
fn unnamed(name: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let mut free = name.to_owned();
    let mut number = 1;
    while is_taken(&free) {
        number += 1;
        free = format!("{name}-{number}");
    }
    free
}
