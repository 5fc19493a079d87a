//! Columns of numbers and words for NumPy.

use std::collections::HashMap;

use bytemuck::{NoUninit, cast_slice};
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyTuple};

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
    /// A column of words, all missing.
    pub fn no_words(rows: usize) -> Self {
        Self::Words(vec![-1; rows], WordList::default())
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

/// Numbers as bytes, from which NumPy makes an array without another copy.
pub fn array<'py, T: NoUninit>(py: Python<'py>, numbers: &[T]) -> Bound<'py, PyByteArray> {
    PyByteArray::new(py, cast_slice(numbers))
}
