//! Result tables: comma-separated values under a heading, as sweeps and landings write them, and readers of each kind.

pub mod bands_table;
pub mod boundary_table;
pub mod history_table;
pub mod map_table;
pub mod profile_points;
pub mod sensitivity_table;

use csv::StringRecord;

use crate::unit::in_si;
use crate::words::FigureError;

/// Greatest number in a table, and greatest velocity of a transition, ft/s or m/s. A table with numbers beyond them is
/// damaged: no picture has room for it.
const GREATEST: f64 = 1e12;
const GREATEST_VELOCITY: f64 = 1e4;

/// Returns whether the heading of a table (CSV) has a column with one of these names.
pub fn has_column(csv: &str, names: &[&str]) -> bool {
    let heading = csv.lines().next().unwrap_or_default();
    heading.split(',').any(|column| names.contains(&column))
}

/// Cells of a row, each with the name of its column.
pub type Cells = Vec<(String, String)>;

/// A table.
pub struct Table {
    heading: StringRecord,
    rows: Vec<StringRecord>,
}

impl Table {
    /// Reads a table.
    ///
    /// # Errors
    /// When a row is not as long as the heading.
    pub fn parse(csv: &str) -> Result<Self, FigureError> {
        let broken = |error: csv::Error| FigureError::Table(error.to_string());
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        Ok(Self {
            heading: reader.headers().map_err(broken)?.clone(),
            rows: reader.records().collect::<Result<_, _>>().map_err(broken)?,
        })
    }

    /// Names of the columns.
    pub fn names(&self) -> Vec<&str> {
        self.heading.iter().collect()
    }

    /// The column with this name, or with its name in SI results, if there is one.
    pub fn find(&self, name: &str) -> Option<usize> {
        let named = |name: &str| self.heading.iter().position(|known| known == name);
        named(name).or_else(|| named(&in_si(name)?))
    }

    /// The column with this name, or with its name in SI results.
    ///
    /// # Errors
    /// When there is none.
    pub fn column(&self, name: &str) -> Result<usize, FigureError> {
        self.find(name)
            .ok_or_else(|| FigureError::Table(format!("column {name} is missing")))
    }

    /// Values of these columns, each once, in the order of the rows.
    ///
    /// # Errors
    /// When one of the columns is missing.
    pub fn different(&self, columns: &[String]) -> Result<Vec<Cells>, FigureError> {
        let places = columns.iter().map(|name| self.column(name));
        let places = places.collect::<Result<Vec<_>, _>>()?;
        let mut found: Vec<Cells> = Vec::new();
        for row in self.rows() {
            let texts = places.iter().map(|place| row.text(*place).to_owned());
            let cells: Cells = columns.iter().cloned().zip(texts).collect();
            if !found.contains(&cells) {
                found.push(cells);
            }
        }
        Ok(found)
    }

    /// The rows with these cells, without the cells.
    ///
    /// # Errors
    /// When one of their columns is missing.
    pub fn with(&self, cells: &Cells) -> Result<Self, FigureError> {
        let places = cells.iter().map(|(name, _)| self.column(name));
        let places = places.collect::<Result<Vec<_>, _>>()?;
        let is_one = |row: &&StringRecord| {
            let mut texts = places.iter().zip(cells);
            texts.all(|(place, (_, text))| row[*place] == **text)
        };
        let rest = |row: &StringRecord| {
            let texts = row.iter().enumerate();
            let kept = texts.filter(|(place, _)| !places.contains(place));
            kept.map(|(_, text)| text).collect()
        };
        Ok(Self {
            heading: rest(&self.heading),
            rows: self.rows.iter().filter(is_one).map(rest).collect(),
        })
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        let numbered = self.rows.iter().enumerate();
        numbered.map(|(index, record)| Row {
            heading: &self.heading,
            record,
            number: index + 1,
        })
    }

    /// The rows, at least one.
    ///
    /// # Errors
    /// When there is none.
    pub fn nonempty_rows(&self) -> Result<impl Iterator<Item = Row<'_>>, FigureError> {
        if self.rows.is_empty() {
            return Err(FigureError::Table("has no rows".to_owned()));
        }
        Ok(self.rows())
    }
}

/// A row.
#[derive(Clone, Copy)]
pub struct Row<'t> {
    heading: &'t StringRecord,
    record: &'t StringRecord,
    number: usize,
}

impl<'t> Row<'t> {
    /// Text in a column.
    pub fn text(&self, column: usize) -> &'t str {
        &self.record[column]
    }

    /// The number in a column.
    ///
    /// # Errors
    /// When it is no number, or one that no result can have.
    pub fn number(&self, column: usize) -> Result<f64, FigureError> {
        self.number_within(column, -GREATEST, GREATEST)
    }

    /// The number in a column; an empty cell has none.
    ///
    /// # Errors
    /// As [`Row::number`].
    pub fn optional_number(&self, column: usize) -> Result<Option<f64>, FigureError> {
        match self.text(column) {
            "" => Ok(None),
            _ => self.number(column).map(Some),
        }
    }

    /// The velocity in a column, in its unit.
    ///
    /// # Errors
    /// When it is no velocity that a search can find.
    pub fn velocity(&self, column: usize) -> Result<f64, FigureError> {
        self.number_within(column, 0.0, GREATEST_VELOCITY)
    }

    fn number_within(&self, column: usize, least: f64, most: f64) -> Result<f64, FigureError> {
        match self.text(column).parse::<f64>() {
            Ok(number) if (least..=most).contains(&number) => Ok(number),
            _ => Err(self.error(column, &format!("a number from {least} to {most}"))),
        }
    }

    /// A complaint about the value in a column.
    pub fn error(&self, column: usize, expected: &str) -> FigureError {
        let (name, value) = (&self.heading[column], self.text(column));
        let row = self.number;
        FigureError::Table(format!("row {row}: {name} = {value}: expected {expected}"))
    }
}
