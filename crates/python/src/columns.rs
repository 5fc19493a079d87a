//! Columns of numbers and words for NumPy, and what the catalogue says of those of results.

use std::collections::HashMap;

use bytemuck::{NoUninit, cast_slice};
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyDict, PyTuple};
use touchdown_input::documents::column::{self, Cell, Kind};
use touchdown_sweep::output::{bands_table, landing_table, results};

/// A column of results.
#[derive(Debug)]
pub enum Column {
    /// Numbers; NaN if missing.
    Numbers(Vec<f64>),
    /// Counts.
    Counts(Vec<i64>),
    /// Words, as indices into a list; -1 if missing.
    Words(Vec<i32>, WordList),
}

impl Column {
    /// A column of this kind with so many rows, all missing.
    pub fn missing(kind: Kind, rows: usize) -> Self {
        match kind {
            Kind::Word => Self::Words(vec![-1; rows], WordList::default()),
            Kind::Number => Self::Numbers(vec![f64::NAN; rows]),
            Kind::Count => Self::Counts(vec![0; rows]),
        }
    }

    /// A column of words out of these, all missing.
    pub fn of_words(words: &[impl ToString], rows: usize) -> Self {
        let mut list = WordList::default();
        for word in words {
            list.place(&word.to_string());
        }
        Self::Words(vec![-1; rows], list)
    }

    /// Sets the cell of a row.
    pub fn set(&mut self, row: usize, cell: Cell) {
        match (self, cell) {
            (Self::Numbers(numbers), Cell::Number(number) | Cell::Power(number)) => {
                numbers[row] = number;
            }
            (Self::Counts(counts), Cell::Count(count)) => counts[row] = count as i64,
            (words, Cell::Word(word)) => words.set_word(row, &word),
            _ => {}
        }
    }

    /// Sets the word of a row in a column of words.
    pub fn set_word(&mut self, row: usize, word: &str) {
        if let Self::Words(codes, words) = self {
            codes[row] = words.place(word);
        }
    }

    /// The column as passed to Python: bytes, number type, and words.
    pub fn into_python<'py>(self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        match self {
            Self::Numbers(numbers) => (array(py, &numbers), "f8", None::<Vec<String>>),
            Self::Counts(counts) => (array(py, &counts), "i8", None),
            Self::Words(codes, list) => (array(py, &codes), "i4", Some(list.words)),
        }
        .into_pyobject(py)
    }
}

/// Words in order of appearance.
#[derive(Debug, Default)]
pub struct WordList {
    words: Vec<String>,
    places: HashMap<String, i32>,
}

impl WordList {
    fn place(&mut self, word: &str) -> i32 {
        if let Some(place) = self.places.get(word) {
            return *place;
        }
        let place = self.words.len() as i32;
        self.words.push(word.to_owned());
        self.places.insert(word.to_owned(), place);
        place
    }
}

/// Results of a row by name; those of legs are tuples.
pub fn by_name<'py, R>(
    py: Python<'py>,
    columns: &[column::Column<R>],
    row: &R,
    legs: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let results = PyDict::new(py);
    for column in columns {
        let mut cells = column.cells(row, legs).map(|cell| value(py, cell));
        match column.is_of_legs() {
            true => {
                let cells: Vec<_> = cells.collect::<PyResult<_>>()?;
                results.set_item(column.name_without_leg(), PyTuple::new(py, cells)?)?;
            }
            false => results.set_item(column.name(), cells.next().transpose()?.flatten())?,
        }
    }
    Ok(results)
}

/// A cell as a Python object; None if it is empty.
fn value(py: Python<'_>, cell: Cell) -> PyResult<Option<Bound<'_, PyAny>>> {
    Ok(match cell {
        Cell::Word(word) => Some(word.into_pyobject(py)?.into_any()),
        Cell::Number(number) | Cell::Power(number) => Some(number.into_pyobject(py)?.into_any()),
        Cell::Count(count) => Some(count.into_pyobject(py)?.into_any()),
        Cell::Empty => None,
    })
}

/// A column of results: name of the attribute, name of the column with `#` for the number of a leg, what it says.
type Described = (String, &'static str, &'static str);

/// The columns of the results of a landing, of those that only its report has, of a boundary and of a band.
#[pyfunction]
pub fn columns() -> HashMap<&'static str, Vec<Described>> {
    HashMap::from([
        ("landing", described(&landing_table::COLUMNS)),
        ("report", described(&landing_table::OF_REPORTS)),
        ("boundary", described(&results::COLUMNS)),
        ("band", described(&bands_table::COLUMNS)),
    ])
}

fn described<R>(columns: &[column::Column<R>]) -> Vec<Described> {
    let columns = columns.iter();
    columns
        .map(|column| (column.name_without_leg(), column.name(), column.about()))
        .collect()
}

/// Numbers as bytes, from which NumPy makes an array without another copy.
pub fn array<'py, T: NoUninit>(py: Python<'py>, numbers: &[T]) -> Bound<'py, PyByteArray> {
    PyByteArray::new(py, cast_slice(numbers))
}
