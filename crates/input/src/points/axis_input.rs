//! Reads the table `[axes]` of a sweep file.
//!
//! Keys are names of parameters; dotted ones are quoted or given as nested tables. Values are a list, or a table: a
//! range by `step` or by `count`, listed `values`, the `spacing` of counted ones, and the group (`zip`) of axes that
//! move together.

use crate::documents::document::{Entry, Value};
use crate::documents::input_error::InputError;
use crate::documents::section::{Layer, LocatedValue, Section, Step};
use crate::documents::spelling::Conversion;
use crate::points::levels::{Fault, Levels};
use crate::points::parameter::Parameter;
use crate::readers::choice::choice;

pub(crate) const FORM: [&str; 7] = ["from", "to", "step", "count", "spacing", "values", "zip"];
/// Keys of a sampled axis.
const SAMPLED: [&str; 7] = [
    "distribution",
    "mean",
    "sd",
    "sigma",
    "mode",
    "file",
    "column",
];
const ALLOWED: &str = "a list, { from = …, to = …, step = … } or { from = …, to = …, count = … }";
/// Stands for every leg in the name of an axis.
const ANY_LEG: &str = "[*]";
/// Meaning of the table.
pub(crate) const NEEDED: &str = "a table [axes] with at least one condition that varies";

/// A parameter and the location of its values.
#[derive(Debug, Clone)]
pub(crate) struct AxisEntry<'d> {
    pub(crate) parameter: Parameter,
    pub(crate) found: LocatedValue<'d>,
}

/// Reads the entries of `[axes]`, in file order.
pub(crate) fn entries<'d>(
    root: &Section<'d>,
    legs: usize,
) -> Result<Vec<AxisEntry<'d>>, InputError> {
    let axes = root.value("axes", NEEDED)?;
    let mut leaves = Vec::new();
    descend(&axes, &axes.layer()?, "", &mut leaves);
    if leaves.is_empty() {
        return Err(axes.complain(NEEDED));
    }
    // Nested tables may have changed the order of the lines.
    leaves.sort_by_key(|(_, found)| found.node.line);
    let mut entries: Vec<AxisEntry> = Vec::with_capacity(leaves.len());
    for (name, found) in leaves.into_iter().flat_map(|leaf| leg_by_leg(leaf, legs)) {
        let Some(parameter) = Parameter::named(&name, legs) else {
            return Err(found.complain_that(&Parameter::unknown(&name, legs)));
        };
        if parameter.program_name() == "search.bands" {
            return Err(found
                .complain_that("cannot vary: expected [search] bands, one for the whole sweep"));
        }
        if entries.iter().any(|other| other.parameter == parameter) {
            return Err(found.complain_that("varies twice: expected one axis for each parameter"));
        }
        entries.push(AxisEntry { parameter, found });
    }
    Ok(entries)
}

/// Splits an axis whose name leaves the leg open, such as `footing[*].height_ft`, into one per leg.
fn leg_by_leg<'d>(
    (name, found): (String, LocatedValue<'d>),
    legs: usize,
) -> Vec<(String, LocatedValue<'d>)> {
    if !name.contains(ANY_LEG) {
        return vec![(name, found)];
    }
    let numbered = |leg: usize| name.replacen(ANY_LEG, &format!("[{leg}]"), 1);
    (1..=legs)
        .map(|leg| (numbered(leg), found.clone()))
        .collect()
}

/// Collects all entries that are not tables of axes, with their dotted names.
fn descend<'d>(
    above: &LocatedValue<'d>,
    layer: &Layer<'d>,
    path: &str,
    leaves: &mut Vec<(String, LocatedValue<'d>)>,
) {
    for entry in layer.entries {
        let name = crate::documents::document::dotted(path, &entry.key);
        let found = LocatedValue {
            place: above.place.clone(),
            above: above.path().into(),
            step: Step::Key(&entry.key),
            node: &entry.node,
            // Values of an axis are in the unit of its name.
            conversion: Conversion::NONE,
        };
        match found.layer() {
            Ok(below) if is_table_of_axes(below.entries) => {
                descend(&found, &below, &name, leaves);
            }
            _ => leaves.push((name, found)),
        }
    }
}

/// True if a table holds further names rather than the form of an axis.
fn is_table_of_axes(entries: &[Entry]) -> bool {
    let says_form = |entry: &Entry| {
        let key = entry.key.as_str();
        FORM.contains(&key) || SAMPLED.contains(&key)
    };
    !entries.is_empty() && !entries.iter().any(says_form)
}

impl AxisEntry<'_> {
    /// The levels of a grid axis, and its group.
    pub(crate) fn levels(&self) -> Result<(Levels, Option<String>), InputError> {
        let Some(form) = self.found.table(&FORM)? else {
            return Ok((self.list(&self.found)?, None));
        };
        let group = form.optional("zip").map(|found| found.text()).transpose()?;
        Ok((self.form(&form)?, group.map(str::to_owned)))
    }

    fn form(&self, form: &Section) -> Result<Levels, InputError> {
        if let Some(values) = form.optional("values") {
            only(form, &["values", "zip"])?;
            return self.list(&values);
        }
        if !self.parameter.words().is_empty() {
            return Err(self.found.complain(&self.allowed_words()));
        }
        let [from, to] = [form.number("from")?, form.number("to")?];
        let counted = form.optional_number("count")?;
        let levels = match (counted, is_logarithmic(form)?) {
            (None, true) => {
                return Err(form.missing("count", "the number of values, from 2 to 1e7"));
            }
            (None, false) => return self.range(form, from, to),
            (Some(_), _) if form.optional("step").is_some() => {
                return Err(self
                    .found
                    .complain_that("has step and count: expected only one of them"));
            }
            (Some(count), false) => Levels::even(from, to, count),
            (Some(count), true) => Levels::logarithmic(from, to, count),
        };
        levels.map_err(complaint(form, from, to))
    }

    /// A range by its step, which must meet its end.
    fn range(&self, form: &Section, from: f64, to: f64) -> Result<Levels, InputError> {
        let found = form.value("step", "a number, or a count in its place")?;
        let levels = Levels::range(from, to, found.number()?).map_err(complaint(form, from, to))?;
        let [last, beyond] = [levels.count() - 1, levels.count()].map(|index| levels.value(index));
        // The end is met within rounding.
        if (last - to).abs() > 1e-6 * (beyond - last).abs() {
            let span = (to - from).abs();
            return Err(found.complain_that(&format!(
                "steps from {from} pass over to = {to}: expected to = {last} or {beyond}, or a step that divides {span}"
            )));
        }
        Ok(levels)
    }

    fn list(&self, found: &LocatedValue) -> Result<Levels, InputError> {
        let items = found.items(ALLOWED)?;
        let values = items.iter().map(|item| self.coordinate(item));
        Levels::list(values.collect::<Result<_, _>>()?)
            .ok_or_else(|| found.complain("a list of at least one value"))
    }

    /// The number of a list item, or the index of its word among those of the parameter.
    fn coordinate(&self, item: &LocatedValue) -> Result<f64, InputError> {
        let words = self.parameter.words();
        if words.is_empty() {
            return item.number();
        }
        let word = match &item.node.value {
            Value::Text(text) => words.iter().position(|word| word == text),
            _ => None,
        };
        word.map(|index| index as f64)
            .ok_or_else(|| item.complain(&self.allowed_words()))
    }

    fn allowed_words(&self) -> String {
        let quoted: Vec<String> = self
            .parameter
            .words()
            .iter()
            .map(|w| format!("{w:?}"))
            .collect();
        format!("a list of {}", quoted.join(", "))
    }
}

/// Error about a wrong number of an axis, at its key.
fn complaint(form: &Section, from: f64, to: f64) -> impl Fn(Fault) -> InputError {
    move |(key, allowed)| match form.optional(key) {
        Some(found) => found.complain(&format!("{allowed} (from {from} to {to})")),
        None => form.missing(key, allowed),
    }
}

/// True if the spacing of an axis is logarithmic.
pub(crate) fn is_logarithmic(form: &Section) -> Result<bool, InputError> {
    choice(form, "spacing", &[("linear", false), ("log", true)])
}

/// Rejects the first key of a form that is not among the `usable` ones.
pub(crate) fn only(form: &Section, usable: &[&str]) -> Result<(), InputError> {
    match form.all_values().find(|(key, _)| !usable.contains(key)) {
        Some((_, found)) => Err(found.complain_that(&format!(
            "not used here: expected keys among {}",
            usable.join(", ")
        ))),
        None => Ok(()),
    }
}

#[cfg(test)]
#[path = "axis_input_tests.rs"]
mod tests;
