//! The one way in which this crate complains about input.

use std::fmt;
use std::path::Path;

/// Where in the input something stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    file: String,
    line: Option<usize>,
    row: Option<usize>,
}

impl Place {
    /// A file as a whole.
    pub fn file(path: &Path) -> Self {
        Self {
            file: path.display().to_string(),
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

    /// The same line, being a table's row, counted from 1 below the heading.
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

/// Longest number that is written without an exponent: any with all its digits, but not 1e300.
const LONGEST_NUMBER: usize = 24;

/// Input that cannot be used: where it stands, what it says and what is allowed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InputError {
    place: Option<Place>,
    complaint: String,
}

impl InputError {
    /// `key` has a `value` that is not what is `allowed`.
    pub fn value(key: &str, value: impl fmt::Display, allowed: &str) -> Self {
        let value = short(value.to_string());
        Self::other(format!("{key} = {value}: allowed is {allowed}"))
    }

    /// `key` is not there.
    pub fn missing(key: &str, allowed: &str) -> Self {
        Self::other(format!("{key} is missing: required is {allowed}"))
    }

    /// `key` is not one of the `known` keys; names the nearest of them.
    pub fn unknown(key: &str, value: impl fmt::Display, known: &[&str]) -> Self {
        let last = key.rsplit('.').next().unwrap_or(key);
        let guess = match nearest(last, known) {
            Some(name) => format!("did you mean {name}? "),
            None => String::new(),
        };
        let known = known.join(", ");
        Self::other(format!(
            "{key} = {value}: unknown key; {guess}allowed here: {known}"
        ))
    }

    /// Any other complaint.
    pub fn other(complaint: impl Into<String>) -> Self {
        Self {
            place: None,
            complaint: complaint.into(),
        }
    }

    /// The same complaint within a part of the input that has a name of its own.
    pub fn within(self, part: &str) -> Self {
        Self {
            complaint: format!("{part}: {}", self.complaint),
            ..self
        }
    }

    /// The same complaint without a place.
    #[must_use]
    pub fn nowhere(self) -> Self {
        Self {
            place: None,
            ..self
        }
    }

    /// The same complaint with its place.
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
            Some(place) => write!(f, "{place}: {}", self.complaint),
            None => f.write_str(&self.complaint),
        }
    }
}

impl std::error::Error for InputError {}

/// A value as it was written, but with an exponent where it is a number with too many digits.
pub(crate) fn short(value: String) -> String {
    match value.parse::<f64>() {
        Ok(number) if value.len() > LONGEST_NUMBER => format!("{number:e}"),
        _ => value,
    }
}

/// The known name most like `name`, if any is alike.
pub fn nearest<'n>(name: &str, known: &[&'n str]) -> Option<&'n str> {
    let likeness = |candidate: &&str| strsim::jaro_winkler(name, candidate);
    known
        .iter()
        .copied()
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
        .filter(|candidate| likeness(candidate) > 0.7)
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
            "a.csv:4: row 3: friction = -1: allowed is a finite number ≥ 0"
        );
    }

    #[test]
    fn long_numbers_have_an_exponent() {
        let said = |value: f64| InputError::value("x", value, "less").to_string();
        assert_eq!(said(1e300), "x = 1e300: allowed is less");
        assert_eq!(said(-1e-9), "x = -0.000000001: allowed is less");
    }

    #[test]
    fn nearest_key_ignores_strangers() {
        let known = ["slope_deg", "friction"];
        assert_eq!(nearest("slope_rad", &known), Some("slope_deg"));
        assert_eq!(nearest("xyz", &known), None);
    }
}
