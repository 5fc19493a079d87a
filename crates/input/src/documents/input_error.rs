//! Errors in the input: place, key, value and what was expected.

use std::fmt;
use std::path::Path;
use std::sync::Arc;

use crate::documents::spelling::{did_you_mean, meant};

/// A place in the input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    file: Arc<str>,
    line: Option<usize>,
    row: Option<usize>,
}

impl Place {
    /// A file as a whole.
    pub fn file(path: &Path) -> Self {
        Self {
            file: path.display().to_string().into(),
            line: None,
            row: None,
        }
    }

    /// The same file at a line, counted from 1.
    pub fn line(&self, line: usize) -> Self {
        Self {
            line: Some(line),
            ..self.clone()
        }
    }

    /// The same line as a table row, counted from 1 below the heading.
    pub fn row(&self, row: usize) -> Self {
        Self {
            row: Some(row),
            ..self.clone()
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(row) = self.row {
            write!(f, ": row {row}")?;
        }
        Ok(())
    }
}

/// Longest number written without an exponent: any with all its digits, but not 1e300.
const LONGEST_NUMBER: usize = 24;

/// Unusable input: its place, key and value, and the expected values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputError {
    place: Option<Place>,
    complaint: String,
    subject: Option<Box<Subject>>,
    is_of_files: bool,
}

/// Subject of an error, for programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Subject {
    /// The key, dotted if in a table.
    pub key: String,
    /// Its value as written; `None` if missing.
    pub value: Option<String>,
    /// Allowed values.
    pub allowed: String,
}

impl InputError {
    /// `key` has a `value` that is not `allowed`.
    pub fn value(key: &str, value: impl fmt::Display, allowed: &str) -> Self {
        let value = short(value.to_string());
        Self::other(format!("{key} = {value}: expected {allowed}")).about(key, Some(value), allowed)
    }

    /// `key` is missing.
    pub fn missing(key: &str, allowed: &str) -> Self {
        Self::other(format!("{key} is missing: expected {allowed}")).about(key, None, allowed)
    }

    /// `key` is not a spelling of any `known` key; names the most similar one.
    pub fn unknown(key: &str, value: impl fmt::Display, known: &[&str]) -> Self {
        let last = key.rsplit('.').next().unwrap_or(key);
        let guess = did_you_mean(&meant(last, known));
        let known = known.join(", ");
        Self::other(format!(
            "{key} = {value}: unknown key; {guess}known keys: {known}"
        ))
        .about(key, Some(value.to_string()), &known)
    }

    /// Any other error.
    pub fn other(complaint: impl Into<String>) -> Self {
        Self {
            place: None,
            complaint: complaint.into(),
            subject: None,
            is_of_files: false,
        }
    }

    /// Any fault of a file.
    pub fn in_file(file: &Path, complaint: impl Into<String>) -> Self {
        Self::other(complaint).at(Place::file(file))
    }

    /// A file or folder that cannot be read.
    pub fn unreadable(file: &Path, why: impl fmt::Display) -> Self {
        Self {
            is_of_files: true,
            ..Self::in_file(file, format!("cannot be read: {why}"))
        }
    }

    /// A folder in which no file can be written.
    pub fn unwritable(folder: &Path, why: impl fmt::Display) -> Self {
        let complaint =
            format!("output folder cannot be written: {why}: expected a writable folder");
        Self {
            is_of_files: true,
            ..Self::in_file(folder, complaint)
        }
    }

    /// True if a file or folder cannot be read or written, whatever its content.
    pub fn is_of_files(&self) -> bool {
        self.is_of_files
    }

    fn about(self, key: &str, value: Option<String>, allowed: &str) -> Self {
        let subject = Subject {
            key: key.to_owned(),
            value,
            allowed: allowed.to_owned(),
        };
        Self {
            subject: Some(Box::new(subject)),
            ..self
        }
    }

    /// The key, value and allowed values, if the error is about a single key.
    pub fn subject(&self) -> Option<&Subject> {
        self.subject.as_deref()
    }

    /// The same error within a named part of the input.
    pub fn within(self, part: &str) -> Self {
        Self {
            complaint: format!("{part}: {}", self.complaint),
            ..self
        }
    }

    /// The same error without a place.
    #[must_use]
    pub fn nowhere(self) -> Self {
        Self {
            place: None,
            ..self
        }
    }

    /// The same error with its place.
    pub fn at(self, place: Place) -> Self {
        Self {
            place: Some(place),
            ..self
        }
    }
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            // A document without a file has no name.
            Some(place) if !place.file.is_empty() => write!(f, "{place}: {}", self.complaint),
            _ => f.write_str(&self.complaint),
        }
    }
}

impl std::error::Error for InputError {}

/// A value as written, but with an exponent if it is a number with too many digits.
pub(crate) fn short(value: String) -> String {
    match value.parse::<f64>() {
        Ok(number) if value.len() > LONGEST_NUMBER => format!("{number:e}"),
        _ => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn says_place_key_value_and_what_is_allowed() {
        let place = Place::file(Path::new("a.csv")).line(4).row(3);
        let error = InputError::value("friction", -1, "a finite number ≥ 0").at(place);
        assert_eq!(
            error.to_string(),
            "a.csv:4: row 3: friction = -1: expected a finite number ≥ 0"
        );
    }

    #[test]
    fn long_numbers_have_an_exponent() {
        let said = |value: f64| InputError::value("x", value, "less").to_string();
        assert_eq!(said(1e300), "x = 1e300: expected less");
        assert_eq!(said(-1e-9), "x = -0.000000001: expected less");
    }
}
