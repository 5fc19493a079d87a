//! Cells of a table of cases, independent of their storage.

use std::fmt;
use std::path::Path;

use csv::StringRecord;

use crate::documents::csv_rows;
use crate::documents::fingerprint::fingerprint;
use crate::documents::input_error::{InputError, Place};

/// Content of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CaseCell<'c> {
    /// Empty.
    Empty,
    /// A number, in the unit of its column.
    Number(f64),
    /// A text, possibly that of a number.
    Text(&'c str),
}

impl fmt::Display for CaseCell<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => Ok(()),
            Self::Number(number) => number.fmt(f),
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// The cells of a table of cases.
pub trait CaseCells: fmt::Debug + Send + Sync {
    /// Number of rows.
    fn len(&self) -> usize;

    /// True if there are no rows.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Content of a cell; row and column count from 0.
    fn cell(&self, row: usize, column: usize) -> CaseCell<'_>;

    /// Adds the row where an error arose.
    fn at_row(&self, row: usize, error: InputError) -> InputError;

    /// Equal if all cells are equal.
    fn fingerprint(&self) -> String;
}

/// The rows of a CSV file.
#[derive(Debug)]
pub(super) struct CsvRows {
    place: Place,
    rows: Vec<StringRecord>,
    fingerprint: String,
}

impl CsvRows {
    /// Parses the text of a file into heading and rows.
    pub(super) fn parse(path: &Path, text: &str) -> Result<(StringRecord, Self), InputError> {
        let place = Place::file(path);
        let (heading, rows) = csv_rows::read(&place, text)?;
        let fingerprint = fingerprint(text);
        let rows = Self {
            place,
            rows,
            fingerprint,
        };
        Ok((heading, rows))
    }
}

impl CaseCells for CsvRows {
    fn len(&self) -> usize {
        self.rows.len()
    }

    fn cell(&self, row: usize, column: usize) -> CaseCell<'_> {
        match self.rows[row].get(column) {
            None | Some("") => CaseCell::Empty,
            Some(text) => CaseCell::Text(text),
        }
    }

    fn at_row(&self, row: usize, error: InputError) -> InputError {
        error.at(csv_rows::place(&self.place, row, &self.rows[row]))
    }

    fn fingerprint(&self) -> String {
        self.fingerprint.clone()
    }
}
