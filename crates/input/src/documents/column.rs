//! Columns of result tables. Each is one entry of a catalogue: its name, the kind of its cells, where they come from,
//! and a sentence for the documents.

use std::fmt;

use serde_json::Value;

use crate::documents::unit::unit;

/// Content of a cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A word or a sentence.
    Word(String),
    /// A quantity in program units.
    Number(f64),
    /// A small number without unit, written as a power of ten.
    Power(f64),
    /// A count.
    Count(u64),
    /// Nothing: what never happened, or is not known.
    Empty,
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => f.write_str(word),
            Self::Number(number) => write!(f, "{number}"),
            Self::Power(number) => write!(f, "{number:e}"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Empty => Ok(()),
        }
    }
}

impl From<Option<f64>> for Cell {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Empty, Self::Number)
    }
}

/// A word, or nothing if it has no letters.
impl From<String> for Cell {
    fn from(word: String) -> Self {
        match word.is_empty() {
            true => Self::Empty,
            false => Self::Word(word),
        }
    }
}

impl From<Cell> for Value {
    fn from(cell: Cell) -> Self {
        match cell {
            Cell::Word(word) => word.into(),
            Cell::Number(number) | Cell::Power(number) => number.into(),
            Cell::Count(count) => count.into(),
            Cell::Empty => Self::Null,
        }
    }
}

/// Kind of the cells of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Words.
    Word,
    /// Numbers.
    Number,
    /// Counts.
    Count,
}

/// Heading of a column: its name in program units, and the kind of its cells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// Name with its unit.
    pub name: String,
    /// Kind of the cells.
    pub kind: Kind,
}

impl Heading {
    /// A column of numbers.
    pub fn number(name: String) -> Self {
        let kind = Kind::Number;
        Self { name, kind }
    }
}

/// Stands for the number of a leg in names.
const LEG: &str = "#";

/// Source of the cells of a column.
#[derive(Debug)]
enum Source<R> {
    Word(fn(&R) -> String),
    Number(fn(&R) -> Option<f64>),
    Power(fn(&R) -> Option<f64>),
    Count(fn(&R) -> u64),
    /// Words for some tables, numbers for others.
    Either(fn(&R) -> Cell),
    /// A number for each leg by its index; `None` for legs that a vehicle lacks.
    Legs(fn(&R, usize) -> Option<f64>),
}

/// A column of tables whose rows are made from an `R`; with `#` in its name, one for each leg.
#[derive(Debug)]
pub struct Column<R> {
    name: &'static str,
    source: Source<R>,
    /// Unit in words, if it does not follow from the name.
    unit: Option<&'static str>,
    title: Option<&'static str>,
    about: &'static str,
}

impl<R> Column<R> {
    const fn new(name: &'static str, source: Source<R>, about: &'static str) -> Self {
        Self {
            name,
            source,
            unit: None,
            title: None,
            about,
        }
    }

    /// A column of words; empty ones give empty cells.
    pub const fn word(name: &'static str, of: fn(&R) -> String, about: &'static str) -> Self {
        Self::new(name, Source::Word(of), about)
    }

    /// A column of numbers in program units.
    pub const fn number(
        name: &'static str,
        of: fn(&R) -> Option<f64>,
        about: &'static str,
    ) -> Self {
        Self::new(name, Source::Number(of), about)
    }

    /// A column of small numbers, written as powers of ten.
    pub const fn power(name: &'static str, of: fn(&R) -> Option<f64>, about: &'static str) -> Self {
        Self::new(name, Source::Power(of), about)
    }

    /// A column of counts.
    pub const fn count(name: &'static str, of: fn(&R) -> u64, about: &'static str) -> Self {
        Self::new(name, Source::Count(of), about)
    }

    /// A column of numbers that are words in some tables.
    pub const fn either(name: &'static str, of: fn(&R) -> Cell, about: &'static str) -> Self {
        Self::new(name, Source::Either(of), about)
    }

    /// A column of numbers for each leg; `#` in the name stands for its number.
    pub const fn legs(
        name: &'static str,
        of: fn(&R, usize) -> Option<f64>,
        about: &'static str,
    ) -> Self {
        Self::new(name, Source::Legs(of), about)
    }

    /// Sets the unit in words.
    #[must_use]
    pub const fn in_unit(mut self, unit: &'static str) -> Self {
        self.unit = Some(unit);
        self
    }

    /// Gives its axis in pictures a title, without the unit.
    #[must_use]
    pub const fn titled(mut self, title: &'static str) -> Self {
        self.title = Some(title);
        self
    }

    /// Title of its axis in pictures; none if the words of the name say it.
    pub fn title(&self) -> Option<&'static str> {
        self.title
    }

    /// Name in program units, with `#` for the number of a leg.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Meaning, as a part of a sentence of the documents in Markdown.
    pub fn about(&self) -> &'static str {
        self.about
    }

    /// Kind of its cells.
    pub fn kind(&self) -> Kind {
        match self.source {
            Source::Word(_) => Kind::Word,
            Source::Count(_) => Kind::Count,
            _ => Kind::Number,
        }
    }

    /// True if there is one for each leg.
    pub fn is_of_legs(&self) -> bool {
        matches!(self.source, Source::Legs(_))
    }

    /// Name of the column of a leg, counted from 1.
    pub fn name_of_leg(&self, leg: usize) -> String {
        self.name.replace(LEG, &leg.to_string())
    }

    /// Name without the number of a leg, for all legs together.
    pub fn name_without_leg(&self) -> String {
        self.name.replace("_#", "")
    }

    /// Number of a row in a column of numbers.
    pub fn number_of(&self, row: &R) -> Option<f64> {
        match self.source {
            Source::Number(of) => of(row),
            _ => None,
        }
    }

    /// Headings of its columns for vehicles with `legs` legs.
    pub fn headings(&self, legs: usize) -> impl Iterator<Item = Heading> {
        let kind = self.kind();
        (1..=self.width(legs)).map(move |leg| Heading {
            name: self.name_of_leg(leg),
            kind,
        })
    }

    /// Cells of its columns for vehicles with `legs` legs.
    pub fn cells(&self, row: &R, legs: usize) -> impl Iterator<Item = Cell> {
        (0..self.width(legs)).map(move |leg| match self.source {
            Source::Word(of) => of(row).into(),
            Source::Number(of) => of(row).into(),
            Source::Power(of) => of(row).map_or(Cell::Empty, Cell::Power),
            Source::Count(of) => Cell::Count(of(row)),
            Source::Either(of) => of(row),
            Source::Legs(of) => of(row, leg).into(),
        })
    }

    fn width(&self, legs: usize) -> usize {
        match self.source {
            Source::Legs(_) => legs,
            _ => 1,
        }
    }

    /// Its row in the documents: name, unit and meaning.
    fn described(&self) -> String {
        let unit = match (self.unit, self.kind()) {
            (Some(unit), _) => unit.to_owned(),
            (None, Kind::Word) => String::new(),
            (None, _) => unit(self.name).replace("ft lb", "ft·lb"),
        };
        let unit = match unit.as_str() {
            "" => " ".to_owned(),
            unit => format!(" {unit} "),
        };
        format!("| `{}` |{unit}| {} |\n", self.name, self.about)
    }
}

/// Headings of all columns for vehicles with `legs` legs.
pub fn headings<R>(columns: &[Column<R>], legs: usize) -> impl Iterator<Item = Heading> {
    columns.iter().flat_map(move |column| column.headings(legs))
}

/// Cells of a row for vehicles with `legs` legs.
pub fn cells<R>(columns: &[Column<R>], row: &R, legs: usize) -> impl Iterator<Item = Cell> {
    columns
        .iter()
        .flat_map(move |column| column.cells(row, legs))
}

/// Rows of the columns in the table of a document, in Markdown: name, unit and meaning.
pub fn described<R>(columns: &[Column<R>]) -> String {
    columns.iter().map(Column::described).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row as text, for tests of tables.
    fn text(row: impl IntoIterator<Item = Cell>) -> String {
        let cells: Vec<String> = row.into_iter().map(|cell| cell.to_string()).collect();
        cells.join(",")
    }

    /// A heading as text, for tests of tables.
    fn names(heading: impl IntoIterator<Item = Heading>) -> String {
        let names: Vec<String> = heading.into_iter().map(|one| one.name).collect();
        names.join(",")
    }

    struct Row {
        word: &'static str,
        legs: Vec<f64>,
    }

    const COLUMNS: [Column<Row>; 4] = [
        Column::word("word", |row| row.word.to_owned(), "a word"),
        Column::legs(
            "force_#_lb",
            |row, leg| row.legs.get(leg).copied(),
            "a force",
        ),
        Column::power("small", |_| Some(3e-5), "a small number"),
        Column::count("count", |row| row.legs.len() as u64, "a count"),
    ];

    #[test]
    fn every_column_is_stated_once() {
        let row = Row {
            word: "",
            legs: vec![0.5, 2.0],
        };
        let heading: Vec<Heading> = headings(&COLUMNS, 3).collect();
        let kinds: Vec<Kind> = heading.iter().map(|one| one.kind).collect();
        let number = [Kind::Number; 4];
        assert_eq!(kinds, [&[Kind::Word][..], &number, &[Kind::Count]].concat());
        assert_eq!(
            names(heading),
            "word,force_1_lb,force_2_lb,force_3_lb,small,count"
        );
        let cells: Vec<Cell> = cells(&COLUMNS, &row, 3).collect();
        assert_eq!((&cells[0], &cells[3]), (&Cell::Empty, &Cell::Empty));
        assert_eq!(text(cells), ",0.5,2,,3e-5,2");
        assert_eq!(
            described(&COLUMNS),
            "| `word` | | a word |\n\
             | `force_#_lb` | lb | a force |\n\
             | `small` | 1 | a small number |\n\
             | `count` | 1 | a count |\n"
        );
    }
}
