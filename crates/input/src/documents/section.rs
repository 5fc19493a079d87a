//! Reads one table of a document key by key; errors name place and key.

use std::sync::Arc;

use touchdown_dynamics::invalid::Invalid;

use crate::documents::document::{Document, Entry, Node, Value, dotted, spelled};
use crate::documents::input_error::{InputError, Place};
use crate::documents::spelling::{Conversion, conversion};

/// A table of a document, or several layered on each other: keys missing from an upper layer are looked up in the lower
/// ones. For example, a leg's own values lie on top of the vehicle's.
///
/// Keys are requested by their names in program units and found in any spelling. Numbers are returned in program units;
/// errors use the words of the file.
#[derive(Debug, Clone)]
pub struct Section<'d> {
    place: Place,
    layers: Vec<Layer<'d>>,
}

#[derive(Debug, Clone)]
pub(crate) struct Layer<'d> {
    pub(crate) entries: &'d [Entry],
    pub(crate) path: Arc<str>,
    pub(crate) line: usize,
    /// Conversion of the numbers of a table whose own key names the unit.
    conversion: Conversion,
}

impl<'d> Section<'d> {
    /// The whole document, which may have only `known` keys.
    ///
    /// # Errors
    /// Names an unknown key and the most similar known one.
    pub fn root(document: &'d Document, known: &[&str]) -> Result<Self, InputError> {
        let layer = Layer {
            entries: document.root(),
            path: "".into(),
            line: 1,
            conversion: Conversion::NONE,
        };
        Self::checked(document.place(), vec![layer], known)
    }

    /// A required table, which may have only `known` keys.
    ///
    /// # Errors
    /// If it is missing, is not a table, or has an unknown key.
    pub fn section(&self, key: &str, known: &[&str]) -> Result<Section<'d>, InputError> {
        self.optional_section(key, known)?
            .ok_or_else(|| self.missing(key, &format!("a table [{}]", self.dotted(key))))
    }

    /// An optional table.
    ///
    /// # Errors
    /// If it is not a table or has an unknown key.
    pub fn optional_section(
        &self,
        key: &str,
        known: &[&str],
    ) -> Result<Option<Section<'d>>, InputError> {
        let mut layers = Vec::new();
        for found in self.all(key) {
            // A word in place of the table in a lower layer completes nothing.
            if !layers.is_empty() && found.text().is_ok() {
                break;
            }
            layers.push(found.layer()?);
        }
        if layers.is_empty() {
            return Ok(None);
        }
        Self::checked(self.place.clone(), layers, known).map(Some)
    }

    /// The entries of an array of tables; none without the key.
    ///
    /// # Errors
    /// If it is something else or an entry has an unknown key.
    pub fn sections(&self, key: &str, known: &[&str]) -> Result<Vec<Section<'d>>, InputError> {
        let Some(found) = self.optional(key) else {
            return Ok(Vec::new());
        };
        let allowed = format!("tables [[{key}]]");
        found
            .items(&allowed)?
            .into_iter()
            .map(|item| Self::checked(self.place.clone(), vec![item.layer()?], known))
            .collect()
    }

    /// Layers this section on top of another.
    pub fn over(&self, lower: &Section<'d>) -> Section<'d> {
        let layers = [self.layers.as_slice(), lower.layers.as_slice()].concat();
        Section {
            place: self.place.clone(),
            layers,
        }
    }

    pub(crate) fn checked(
        place: Place,
        layers: Vec<Layer<'d>>,
        known: &[&str],
    ) -> Result<Self, InputError> {
        for layer in &layers {
            for (index, entry) in layer.entries.iter().enumerate() {
                let is_spelling = |key: &&&str| conversion(&entry.key, key).is_some();
                let complaint = match known.iter().find(is_spelling) {
                    None => {
                        let path = dotted(&layer.path, &entry.key);
                        InputError::unknown(&path, &entry.node.written, known)
                    }
                    Some(key) => match spelled(&layer.entries[..index], key) {
                        Some((other, _)) => said_twice(layer, entry, other),
                        None => continue,
                    },
                };
                return Err(complaint.at(place.line(entry.node.line)));
            }
        }
        Ok(Self { place, layers })
    }

    fn all(&self, key: &str) -> impl Iterator<Item = LocatedValue<'d>> {
        self.layers.iter().filter_map(move |layer| {
            let (entry, conversion) = spelled(layer.entries, key)?;
            Some(LocatedValue {
                place: self.place.clone(),
                above: Arc::clone(&layer.path),
                step: Step::Key(&entry.key),
                node: &entry.node,
                conversion: conversion.or(layer.conversion),
            })
        })
    }

    fn dotted(&self, key: &str) -> String {
        // A key missing from all layers is reported for the lowest one, common to all.
        dotted(self.layers.last().map_or("", |layer| &layer.path), key)
    }

    /// Error that `key` is missing from this section.
    pub fn missing(&self, key: &str, allowed: &str) -> InputError {
        let line = self.layers.last().map_or(1, |layer| layer.line);
        InputError::missing(&self.dotted(key), allowed).at(self.place.line(line))
    }

    /// Any error about keys that this section lacks.
    pub(crate) fn lacks(&self, complaint: &str) -> InputError {
        let line = self.layers.last().map_or(1, |layer| layer.line);
        InputError::other(complaint).at(self.place.line(line))
    }

    /// The value of `key`, if any.
    pub fn optional(&self, key: &str) -> Option<LocatedValue<'d>> {
        self.all(key).next()
    }

    /// The value of `key`.
    ///
    /// # Errors
    /// If it is missing; `allowed` describes the expected value.
    pub fn value(&self, key: &str, allowed: &str) -> Result<LocatedValue<'d>, InputError> {
        self.optional(key).ok_or_else(|| self.missing(key, allowed))
    }

    /// The number of a required `key`.
    ///
    /// # Errors
    /// If it is missing or not a number.
    pub fn number(&self, key: &str) -> Result<f64, InputError> {
        self.value(key, "a number")?.number()
    }

    /// The number of an optional `key`.
    ///
    /// # Errors
    /// If it is not a number.
    pub fn optional_number(&self, key: &str) -> Result<Option<f64>, InputError> {
        self.optional(key).map(|found| found.number()).transpose()
    }

    /// The whole number of a required `key`, from `least` to `most`.
    ///
    /// # Errors
    /// If it is missing or something else.
    pub fn whole_number(&self, key: &str, least: u64, most: u64) -> Result<u64, InputError> {
        self.value(key, &whole_numbers(least, most))?
            .whole_number(least, most)
    }

    /// The whole number of an optional `key`, from `least` to `most`.
    ///
    /// # Errors
    /// If it is something else.
    pub fn optional_whole_number(
        &self,
        key: &str,
        least: u64,
        most: u64,
    ) -> Result<Option<u64>, InputError> {
        let found = self.optional(key);
        found
            .map(|found| found.whole_number(least, most))
            .transpose()
    }

    /// The text of a required `key`.
    ///
    /// # Errors
    /// If it is missing or not text.
    pub fn text(&self, key: &str) -> Result<&'d str, InputError> {
        self.value(key, "text in quotes")?.text()
    }

    /// All keys of the uppermost layer, as spelled, with their values, in file order.
    pub fn all_values(&self) -> impl Iterator<Item = (&'d str, LocatedValue<'d>)> {
        self.layers.iter().take(1).flat_map(move |layer| {
            layer.entries.iter().map(move |entry| {
                let found = LocatedValue {
                    place: self.place.clone(),
                    above: Arc::clone(&layer.path),
                    step: Step::Key(&entry.key),
                    node: &entry.node,
                    conversion: layer.conversion,
                };
                (entry.key.as_str(), found)
            })
        })
    }

    /// Converts an error of the physics about a quantity to one at the line of its key.
    ///
    /// The quantity is a dotted key relative to this section, with an explanation in brackets if the fault is not in
    /// the key's own value.
    pub fn complain(&self, invalid: &Invalid) -> InputError {
        let key = invalid.quantity.split(" (").next().unwrap_or_default();
        let explanation = &invalid.quantity[key.len()..];
        let Some(found) = self.descend(key) else {
            // The uppermost layer is the most specific.
            let line = self.layers.first().map_or(1, |layer| layer.line);
            return InputError::value(
                &self.dotted(&invalid.quantity),
                invalid.value,
                &invalid.allowed,
            )
            .at(self.place.line(line));
        };
        match found.node.value {
            // As written, since the physics may use another unit, and the fault may be in any item of a list.
            Value::Number(_) | Value::List(_) if explanation.is_empty() => {
                found.complain(&invalid.allowed)
            }
            _ => {
                let name = format!("{}{explanation}", found.path());
                let value = found.conversion.with_unit(invalid.value);
                InputError::value(&name, value, &invalid.allowed).at(found.here())
            }
        }
    }

    fn descend(&self, dotted: &str) -> Option<LocatedValue<'d>> {
        match dotted.split_once('.') {
            None => self.optional(dotted),
            Some((table, rest)) => {
                let layers = self.all(table).filter_map(|found| found.layer().ok());
                let section = Section {
                    place: self.place.clone(),
                    layers: layers.collect(),
                };
                section.descend(rest)
            }
        }
    }
}

/// The last step of the path of a value.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Step<'d> {
    /// A key of a table, as spelled.
    Key(&'d str),
    /// An item of a list, counted from 1.
    Item(usize),
}

/// A value found in a section. Its path is put together where it is told: tables have many numbers, and errors are rare.
#[derive(Debug, Clone)]
pub struct LocatedValue<'d> {
    pub(crate) place: Place,
    /// Dotted path of the table or list above it.
    pub(crate) above: Arc<str>,
    pub(crate) step: Step<'d>,
    pub(crate) node: &'d Node,
    /// Conversion from the unit of the file to that of the program.
    pub(crate) conversion: Conversion,
}

impl<'d> LocatedValue<'d> {
    /// Its dotted path, as spelled.
    pub(crate) fn path(&self) -> String {
        match self.step {
            Step::Key(key) => dotted(&self.above, key),
            Step::Item(number) => format!("{}[{number}]", self.above),
        }
    }

    /// Its place.
    pub fn here(&self) -> Place {
        self.place.line(self.node.line)
    }

    /// Error that this value is not `allowed`.
    pub fn complain(&self, allowed: &str) -> InputError {
        let allowed = match self.node.value {
            Value::Number(number) => &self.conversion.explain(allowed, number),
            _ => allowed,
        };
        InputError::value(&self.path(), &self.node.written, allowed).at(self.here())
    }

    /// Any error, at the place of this value.
    pub fn complain_that(&self, complaint: &str) -> InputError {
        InputError::other(format!(
            "{} = {}: {complaint}",
            self.path(),
            self.node.written
        ))
        .at(self.here())
    }

    /// The value as a number in the program's unit.
    ///
    /// # Errors
    /// If it is something else.
    pub fn number(&self) -> Result<f64, InputError> {
        let Value::Number(number) = self.node.value else {
            return Err(self.complain("a number"));
        };
        match self.conversion.to_program(number) {
            number if number.is_finite() => Ok(number),
            _ => Err(self.complain("a finite number")),
        }
    }

    /// The value as a whole number from `least` to `most`.
    ///
    /// # Errors
    /// If it is something else.
    pub fn whole_number(&self, least: u64, most: u64) -> Result<u64, InputError> {
        let number = self.number()?;
        if number.fract() != 0.0 || !(least as f64..=most as f64).contains(&number) {
            return Err(self.complain(&whole_numbers(least, most)));
        }
        Ok(number as u64)
    }

    /// The value as a text.
    ///
    /// # Errors
    /// If it is something else.
    pub fn text(&self) -> Result<&'d str, InputError> {
        match &self.node.value {
            Value::Text(text) => Ok(text),
            _ => Err(self.complain("text in quotes")),
        }
    }

    /// The value as a list.
    ///
    /// # Errors
    /// If it is something else.
    pub fn items(&self, allowed: &str) -> Result<Vec<LocatedValue<'d>>, InputError> {
        let Value::List(nodes) = &self.node.value else {
            return Err(self.complain(allowed));
        };
        let path = Arc::from(self.path());
        let item = |(index, node)| LocatedValue {
            place: self.place.clone(),
            above: Arc::clone(&path),
            step: Step::Item(index + 1),
            node,
            conversion: self.conversion,
        };
        Ok(nodes.iter().enumerate().map(item).collect())
    }

    /// The value as a table with the `known` keys; `None` if it is not a table.
    ///
    /// # Errors
    /// If it has an unknown key.
    pub fn table(&self, known: &[&str]) -> Result<Option<Section<'d>>, InputError> {
        match self.layer() {
            Ok(layer) => Section::checked(self.place.clone(), vec![layer], known).map(Some),
            Err(_) => Ok(None),
        }
    }

    /// The values of this table and of tables within it, by their dotted names below it, as spelled.
    ///
    /// # Errors
    /// If it is not a table.
    pub fn leaves(&self) -> Result<Vec<(String, LocatedValue<'d>)>, InputError> {
        let mut leaves = Vec::new();
        let path = Arc::from(self.path());
        for entry in self.layer()?.entries {
            let found = LocatedValue {
                place: self.place.clone(),
                above: Arc::clone(&path),
                step: Step::Key(&entry.key),
                node: &entry.node,
                conversion: Conversion::NONE,
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
                path: self.path().into(),
                line: self.node.line,
                conversion: self.conversion,
            }),
            _ => Err(self.complain("a table")),
        }
    }
}

/// Error about the second of two spellings of one quantity.
fn said_twice(layer: &Layer, second: &Entry, first: &Entry) -> InputError {
    let (path, value) = (dotted(&layer.path, &second.key), &second.node.written);
    let (line, other) = (first.node.line, &first.key);
    let allowed = format!("one spelling of a quantity, but line {line} says {other}");
    InputError::value(&path, value, &allowed)
}

/// Whole numbers that are allowed, in words.
fn whole_numbers(least: u64, most: u64) -> String {
    format!("a whole number from {least} to {most}")
}

#[cfg(test)]
#[path = "section_tests.rs"]
mod tests;
