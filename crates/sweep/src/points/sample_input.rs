//! How points are sampled: the table `[sample]` of a sweep file, and the axes of such a sweep.
//!
//! An axis says its distribution: `{ from, to }`, with `spacing = "log"` too, `{ mean, sd }`, with
//! ends too, or a `column` of a `file`. Columns of one file take the values of one row, so that
//! what belongs together stays together; so do axes with the same `zip`.

use std::path::Path;

use crate::axis_input::{AxisEntry, is_logarithmic, only};
use crate::distribution::Distribution;
use crate::input_error::{InputError, Place};
use crate::library::{Library, Source};
use crate::sample::{Sample, SampledAxis, Spread};
use crate::section::LocatedValue;
use crate::section::Section;

pub(crate) const SAMPLE: [&str; 4] = ["design", "count", "seed", "stop_at_interval_width"];
/// Keys of an axis.
pub(crate) const FORM: [&str; 8] = [
    "from", "to", "spacing", "mean", "sd", "file", "column", "zip",
];
/// Greatest seed that TOML and JSON keep exactly.
const GREATEST_SEED: f64 = 9_007_199_254_740_992.0;

/// What `[sample]` says.
#[derive(Debug)]
pub(crate) struct Sampled {
    pub(crate) sample: Sample,
    /// Width of the intervals of probabilities at which enough is known.
    pub(crate) enough: Option<f64>,
}

/// Reads `[sample]` and the distributions of the axes; `None` when there is no such table. Files
/// that are read are added to the sources.
pub(crate) fn sampled(
    root: &Section,
    entries: &[AxisEntry],
    sweep: &Path,
    library: Library,
    sources: &mut Vec<Source>,
) -> Result<Option<Sampled>, InputError> {
    let Some(section) = root.optional_section("sample", &SAMPLE)? else {
        return Ok(None);
    };
    let design = section.value(
        "design",
        "\"monte-carlo\", \"latin-hypercube\" or \"sobol\"",
    )?;
    let word = design.text()?;
    let spread = Spread::ALL.into_iter().find(|spread| spread.name() == word);
    let names = Spread::ALL.map(|spread| format!("{:?}", spread.name()));
    let spread = spread.ok_or_else(|| design.complain(&names.join(", ")))?;
    let count = whole(&section, "count", 1.0, spread.most_points() as f64)?;
    let seed = whole(&section, "seed", 0.0, GREATEST_SEED)?;
    let enough = match section.optional("stop_at_interval_width") {
        None => None,
        Some(found) => match found.number()? {
            width if width > 0.0 && width < 1.0 => Some(width),
            _ => return Err(found.complain("0 < value < 1")),
        },
    };
    let mut groups: Vec<Option<String>> = Vec::new();
    let mut axes = Vec::with_capacity(entries.len());
    for entry in entries {
        let mut reader = Reader {
            sweep,
            library,
            sources,
        };
        let (distribution, group) = reader.distribution(entry)?;
        let known = groups
            .iter()
            .position(|known| group.is_some() && *known == group);
        let number = known.unwrap_or_else(|| {
            groups.push(group);
            groups.len() - 1
        });
        axes.push(SampledAxis {
            distribution,
            number,
        });
    }
    if groups.len() > spread.most_axes() {
        let most = spread.most_axes();
        return Err(design.complain_that(&format!("allowed are at most {most} axes")));
    }
    let sample = Sample::new(axes, spread, count, seed as u64);
    Ok(Some(Sampled { sample, enough }))
}

fn whole(section: &Section, key: &str, least: f64, most: f64) -> Result<usize, InputError> {
    let allowed = format!("a whole number from {least} to {most}");
    let found = section.value(key, &allowed)?;
    let number = found.number()?;
    if number.fract() != 0.0 || !(least..=most).contains(&number) {
        return Err(found.complain(&allowed));
    }
    Ok(number as usize)
}

/// Reads distributions, some of them from files.
struct Reader<'r, 'l> {
    sweep: &'r Path,
    library: Library<'l>,
    sources: &'r mut Vec<Source>,
}

impl Reader<'_, '_> {
    /// The distribution of an axis, and the group with which it moves.
    fn distribution(
        &mut self,
        entry: &AxisEntry,
    ) -> Result<(Distribution, Option<String>), InputError> {
        let allowed = "{ from = …, to = … }, { mean = …, sd = … } or { file = …, column = … } \
                       in a sample";
        let Some(form) = entry.found.table(&FORM)? else {
            return Err(entry.found.complain(allowed));
        };
        if !entry.parameter.words().is_empty() {
            return Err(entry.found.complain_that("words cannot be sampled"));
        }
        let group = form.optional("zip").map(|found| found.text()).transpose()?;
        let group = group.map(|name| format!("zip {name}"));
        if let Some(file) = form.optional("file") {
            only(&form, &["file", "column"])?;
            let column = form.value("column", "the name of a column of the file")?;
            let group = Some(format!("file {}", file.text()?));
            return Ok((self.column(&file, &column)?, group));
        }
        let distribution = if form.optional("mean").is_some() || form.optional("sd").is_some() {
            only(&form, &["mean", "sd", "from", "to", "zip"])?;
            let ends = match (form.optional("from"), form.optional("to")) {
                (None, None) => None,
                _ => Some([form.number("from")?, form.number("to")?]),
            };
            Distribution::normal(form.number("mean")?, form.number("sd")?, ends)
        } else {
            only(&form, &["from", "to", "spacing", "zip"])?;
            let is_logarithmic = is_logarithmic(&form)?;
            Distribution::uniform(form.number("from")?, form.number("to")?, is_logarithmic)
        };
        let distribution = distribution.map_err(|(key, allowed)| match form.optional(key) {
            Some(found) => found.complain(allowed),
            None => form.missing(key, allowed),
        });
        Ok((distribution?, group))
    }

    fn column(
        &mut self,
        file: &LocatedValue,
        column: &LocatedValue,
    ) -> Result<Distribution, InputError> {
        let path = self
            .sweep
            .parent()
            .unwrap_or(Path::new(""))
            .join(file.text()?);
        if let Some(refusal) = self.library.refusal(&path) {
            return Err(file.complain_that(&format!(
                "{refusal}: allowed is the path of a table, relative to this file"
            )));
        }
        let text = self.library.text(&path)?;
        let values = numbers(&path, &text, column)?;
        if !self.sources.iter().any(|source| source.path == path) {
            self.sources.push(Source { path, text });
        }
        Ok(Distribution::Column(values))
    }
}

/// The numbers of a column of a table.
fn numbers(path: &Path, text: &str, column: &LocatedValue) -> Result<Vec<f64>, InputError> {
    let place = Place::file(path);
    let broken = |error: csv::Error| {
        let complaint = format!("not a table of comma-separated values: {error}");
        InputError::other(complaint).at(place.clone())
    };
    let name = column.text()?;
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let heading = reader.headers().map_err(broken)?.clone();
    let Some(index) = heading.iter().position(|known| known == name) else {
        let known: Vec<&str> = heading.iter().collect();
        return Err(column.complain(&format!(
            "a column of {}: {}",
            path.display(),
            known.join(", ")
        )));
    };
    let mut values = Vec::new();
    for (row, record) in reader.records().enumerate() {
        let record = record.map_err(broken)?;
        let cell = record.get(index).unwrap_or("");
        match cell.parse::<f64>() {
            Ok(value) if value.is_finite() => values.push(value),
            _ => {
                let line = record
                    .position()
                    .map_or(0, |position| position.line() as usize);
                return Err(InputError::value(name, cell, "a finite number")
                    .at(place.line(line).row(row + 1)));
            }
        }
    }
    if values.is_empty() {
        return Err(InputError::other("has no rows: required is at least one").at(place));
    }
    Ok(values)
}
