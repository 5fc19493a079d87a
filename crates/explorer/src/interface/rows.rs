//! Rows of a table, and which of them lie in ranges of columns.

use csv::StringRecord;
use serde::Deserialize;

use super::complaint::{Complaint, of_table};
use crate::named::Results;

/// Rows of a table.
pub struct Rows {
    /// Names of the columns.
    pub heading: StringRecord,
    /// The rows.
    pub rows: Vec<StringRecord>,
}

/// A range of a column, ends included.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    column: String,
    from: f64,
    to: f64,
}

impl Rows {
    /// Reads the table of results.
    ///
    /// # Errors
    /// If it is not a table.
    pub fn read(results: &Results) -> Result<Self, Complaint> {
        let mut reader = csv::Reader::from_reader(results.table.as_bytes());
        let read = |error: csv::Error| of_table(results, error);
        Ok(Self {
            heading: reader.headers().map_err(read)?.clone(),
            rows: reader.records().collect::<Result<_, _>>().map_err(read)?,
        })
    }

    /// Index of a column, named by a member of the request.
    ///
    /// # Errors
    /// If there is no such column.
    pub fn column(&self, key: &str, name: &str) -> Result<usize, Complaint> {
        let place = self.heading.iter().position(|known| known == name);
        place.ok_or_else(|| {
            let known: Vec<&str> = self.heading.iter().collect();
            let allowed = format!("one of {}", known.join(", "));
            Complaint::value(key, format!("{name:?}"), &allowed)
        })
    }

    /// Whether each row lies in all of the ranges; a cell without a number lies in none.
    ///
    /// # Errors
    /// If a range is of no column.
    pub fn within(&self, ranges: &[Range]) -> Result<Vec<bool>, Complaint> {
        let mut are_within = vec![true; self.rows.len()];
        for Range { column, from, to } in ranges {
            let column = self.column("within.column", column)?;
            for (is_within, row) in are_within.iter_mut().zip(&self.rows) {
                *is_within &=
                    number(&row[column]).is_some_and(|value| (*from..=*to).contains(&value));
            }
        }
        Ok(are_within)
    }
}

/// The number of a cell, if it has one.
pub fn number(cell: &str) -> Option<f64> {
    cell.parse().ok().filter(|number: &f64| number.is_finite())
}
