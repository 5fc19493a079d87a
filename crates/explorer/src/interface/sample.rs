//! `sample`: landings of a table, with the input of each.

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::{Value, json};
use touchdown_dynamics::outcome::Class;
use touchdown_figures::levels::Levels;

use super::complaint::{Complaint, of_table};
use super::in_units::in_units;
use super::map::{cell, results_of, title, words_of};
use super::request::{asked_units, class_words, hex, read, written};
use crate::named::{Named, Results, ResultsKind};

/// Number of colours of a scale.
const RAMP: usize = 12;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    results: String,
    units: Option<String>,
}

pub fn answer(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = asked_units(request.units.as_deref())?;
    let as_written = sample_of(named, &request.results)?;
    let converted = in_units(as_written, units)?;
    let results = converted.as_ref();
    let (heading, columns) = columns(results)?;
    let axes = results.axes.len();
    let outcomes = columns[outcome_column(results)].clone();
    let mut told = heading
        .iter()
        .zip(columns)
        .map(|(name, values)| words_of(name, values));
    let mut inputs: Vec<Value> = told.by_ref().take(axes).collect();
    let others: Vec<Value> = told.skip(1).collect();
    if let Cow::Owned(_) = converted {
        // Landings are those of the table, in its own units, digit for digit.
        let (heading, columns) = self::columns(as_written)?;
        let written = heading.iter().zip(columns);
        for (input, (name, values)) in inputs.iter_mut().zip(written) {
            input["written"] = json!({"name": name, "values": values});
        }
    }
    let mut words: Vec<String> = Vec::new();
    let mut outcome = Vec::new();
    for cell in &outcomes {
        let word = cell.as_str().unwrap_or_default();
        let place = words.iter().position(|known| known == word);
        outcome.push(place.unwrap_or_else(|| {
            words.push(word.to_owned());
            words.len() - 1
        }));
    }
    let class_of: Vec<usize> = words.iter().map(|word| class_place(word)).collect();
    let class: Vec<usize> = outcome.iter().map(|place| class_of[*place]).collect();
    written(&json!({
        "title": title(results),
        "source": named.source_of(results),
        "inputs": inputs,
        "outcomes": words,
        "outcome": outcome,
        "classes": Class::ALL.map(class_words),
        "class": class,
        "results": others,
        "ramp": ramp(),
    }))
}

/// Finds a table of landings by name.
///
/// # Errors
/// If there is none.
pub fn sample_of<'n>(named: &'n Named, name: &str) -> Result<&'n Results, Complaint> {
    let results = results_of(named, name)?;
    match results.kind {
        ResultsKind::Sample => Ok(results),
        ResultsKind::Map | ResultsKind::Profile => Err(Complaint::value(
            "results",
            format!("{name:?}"),
            "a table of landings: this one has transitions, which map tells",
        )),
    }
}

/// Index of the column of outcomes, which follows the axes.
pub fn outcome_column(results: &Results) -> usize {
    results.axes.len()
}

/// Colours of maps from the least to the greatest.
fn ramp() -> Vec<String> {
    let borders: Vec<f64> = (1..RAMP).map(|border| border as f64).collect();
    let levels = Levels::listed(&borders).ok();
    let colour = |levels: Levels| {
        (0..RAMP)
            .map(|step| hex(levels.colour(step as f64)))
            .collect()
    };
    levels.map(colour).unwrap_or_default()
}

/// Names and cells of the columns of a table.
fn columns(results: &Results) -> Result<(csv::StringRecord, Vec<Vec<Value>>), Complaint> {
    let mut reader = csv::Reader::from_reader(results.table.as_bytes());
    let heading = reader
        .headers()
        .map_err(|error| of_table(results, error))?
        .clone();
    let mut columns: Vec<Vec<Value>> = vec![Vec::new(); heading.len()];
    for row in reader.records() {
        let row = row.map_err(|error| of_table(results, error))?;
        for (column, text) in columns.iter_mut().zip(&row) {
            column.push(cell(text));
        }
    }
    Ok((heading, columns))
}

/// Index of the class of an outcome among all classes.
pub fn class_place(outcome: &str) -> usize {
    let class = Class::of_outcome(outcome).unwrap_or(Class::Undecided);
    let place = Class::ALL.iter().position(|known| *known == class);
    place.unwrap_or_default()
}
