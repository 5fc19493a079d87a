//! A value found under a key: what it is, and complaints about it.

use crate::document::{Node, Value, dotted};
use crate::input_error::{InputError, Place};
use crate::section::{Layer, Section};

/// A value found in a section.
#[derive(Debug, Clone)]
pub struct Found<'d> {
    pub(crate) place: Place,
    pub(crate) path: String,
    pub(crate) node: &'d Node,
}

impl<'d> Found<'d> {
    /// Where it stands.
    pub fn here(&self) -> Place {
        self.place.line(self.node.line)
    }

    /// The complaint that this value is not what is `allowed`.
    pub fn complain(&self, allowed: &str) -> InputError {
        InputError::value(&self.path, &self.node.written, allowed).at(self.here())
    }

    /// Any complaint, at the place of this value.
    pub fn complain_that(&self, complaint: &str) -> InputError {
        InputError::other(format!(
            "{} = {}: {complaint}",
            self.path, self.node.written
        ))
        .at(self.here())
    }

    /// The complaint that this key is unknown.
    pub fn unknown(&self, known: &[&str]) -> InputError {
        InputError::unknown(&self.path, &self.node.written, known).at(self.here())
    }

    /// The value as a number.
    ///
    /// # Errors
    /// When it is something else.
    pub fn number(&self) -> Result<f64, InputError> {
        match self.node.value {
            Value::Number(number) => Ok(number),
            _ => Err(self.complain("a number")),
        }
    }

    /// The value as a text.
    ///
    /// # Errors
    /// When it is something else.
    pub fn text(&self) -> Result<&'d str, InputError> {
        match &self.node.value {
            Value::Text(text) => Ok(text),
            _ => Err(self.complain("a text in quotes")),
        }
    }

    /// The value as a list.
    ///
    /// # Errors
    /// When it is something else.
    pub fn items(&self, allowed: &str) -> Result<Vec<Found<'d>>, InputError> {
        let Value::List(nodes) = &self.node.value else {
            return Err(self.complain(allowed));
        };
        let item = |(index, node)| Found {
            place: self.place.clone(),
            path: format!("{}[{}]", self.path, index + 1),
            node,
        };
        Ok(nodes.iter().enumerate().map(item).collect())
    }

    /// The value as a table with the `known` keys, if it is a table.
    ///
    /// # Errors
    /// When it has an unknown key.
    pub fn table(&self, known: &[&str]) -> Result<Option<Section<'d>>, InputError> {
        match self.layer() {
            Ok(layer) => Section::checked(self.place.clone(), vec![layer], known).map(Some),
            Err(_) => Ok(None),
        }
    }

    /// The values of this table and of the tables within it, by their dotted names below it.
    ///
    /// # Errors
    /// When it is no table.
    pub fn leaves(&self) -> Result<Vec<(String, Found<'d>)>, InputError> {
        let mut leaves = Vec::new();
        for entry in self.layer()?.entries {
            let found = Found {
                place: self.place.clone(),
                path: dotted(&self.path, &entry.key),
                node: &entry.node,
            };
            match &entry.node.value {
                Value::Table(_) => leaves.extend(
                    found
                        .leaves()?
                        .into_iter()
                        .map(|(name, leaf)| (dotted(&entry.key, &name), leaf)),
                ),
                _ => leaves.push((entry.key.clone(), found)),
            }
        }
        Ok(leaves)
    }

    pub(crate) fn layer(&self) -> Result<Layer<'d>, InputError> {
        match &self.node.value {
            Value::Table(entries) => Ok(Layer {
                entries,
                path: self.path.clone(),
                line: self.node.line,
            }),
            _ => Err(self.complain("a table")),
        }
    }
}
