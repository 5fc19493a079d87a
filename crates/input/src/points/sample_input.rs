//! Reads the table `[sample]` of a sweep file and the axes of a sampled sweep.
//!
//! An axis is a table that names its distribution or has the keys of one: `{ from, to }`, optionally with `spacing =
//! "log"`; `{ mean, sd }`, optionally with ends; or a `column` of a `file`. Columns of one file take the values of the
//! same row, so that they stay together; so do axes with the same `zip`. Jointly normal axes have a `mean` each and a
//! covariance in `[[sample.covariance]]`.

use std::path::Path;

use crate::documents::csv_rows;
use crate::documents::input_error::{InputError, Place};
use crate::documents::library::{Library, Source};
use crate::documents::section::{LocatedValue, Section};
use crate::points::axis_input::{AxisEntry, is_logarithmic, only};
use crate::points::distribution::Distribution;
use crate::points::joint_normal::{self, JointNormal};
use crate::points::sample::{Sample, SampleDesign, SampledAxis};
use crate::readers::choice::chosen_by;

pub(crate) const SAMPLE: [&str; 5] = [
    "design",
    "count",
    "seed",
    "stop_at_interval_width",
    "covariance",
];
/// Keys of an axis.
pub(crate) const FORM: [&str; 11] = [
    "distribution",
    "from",
    "to",
    "spacing",
    "mean",
    "sd",
    "sigma",
    "mode",
    "file",
    "column",
    "zip",
];
/// Names of distributions, each with its keys.
pub(crate) const DISTRIBUTIONS: [(&str, &[&str]); 5] = [
    ("uniform", &["from", "to", "spacing"]),
    ("normal", &["mean", "sd", "from", "to"]),
    ("lognormal", &["mean", "sd"]),
    ("rayleigh", &["sigma"]),
    ("triangular", &["from", "mode", "to"]),
];
const AXIS: &str = "a table such as { from = …, to = … }, { mean = …, sd = … }, { distribution = …, … } or \
                    { file = …, column = … }";
/// Greatest seed that is read exactly; a greater one may have been rounded.
const GREATEST_SEED: u64 = 9_007_199_254_740_991;

/// The content of `[sample]`.
#[derive(Debug)]
pub(crate) struct Sampled {
    pub(crate) sample: Sample,
    /// Width of the probability intervals at which the sweep stops.
    pub(crate) enough: Option<f64>,
}

/// Reads `[sample]` and the distributions of the axes; `None` without the table. Adds the files read to the sources.
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
    let kind = chosen_by(&design, &SampleDesign::ALL.map(|kind| (kind.name(), kind)))?;
    let (count, seed, enough) = counts_of(&section, kind)?;
    let joint = joint_normal::read(&section, entries)?;
    let mut reader = Reader {
        sweep,
        library,
        sources,
    };
    let mut groups: Vec<Option<String>> = Vec::new();
    let mut numbers = Vec::with_capacity(entries.len());
    let mut forms = Vec::with_capacity(entries.len());
    for (axis, entry) in entries.iter().enumerate() {
        let is_joint = joint.iter().any(|joint| joint.axes.contains(&axis));
        let (form, group) = reader.axis(entry, is_joint)?;
        let known = (groups.iter()).position(|known| group.is_some() && *known == group);
        numbers.push(known.unwrap_or_else(|| {
            groups.push(group);
            groups.len() - 1
        }));
        forms.push(form);
    }
    if groups.len() > kind.most_axes() {
        let most = kind.most_axes();
        return Err(design.complain_that(&format!("expected at most {most} axes with this design")));
    }
    let axes = forms
        .into_iter()
        .enumerate()
        .map(|(axis, form)| match form {
            AxisForm::Single(distribution) => SampledAxis::Single {
                distribution,
                number: numbers[axis],
            },
            AxisForm::Joint { mean } => joint_axis(&joint, axis, mean, &numbers),
        });
    let sample = Sample::new(axes.collect(), kind, count, seed);
    Ok(Some(Sampled { sample, enough }))
}

/// A sample of the same axes by the numbers of `[sample]`.
pub(crate) fn drawn_again(root: &Section, sample: &Sample) -> Result<Sampled, InputError> {
    let section = root.section("sample", &SAMPLE)?;
    let (count, seed, enough) = counts_of(&section, sample.design())?;
    let sample = Sample::new(sample.axes().to_vec(), sample.design(), count, seed);
    Ok(Sampled { sample, enough })
}

/// Count, seed, and the width of intervals at which the sweep stops.
fn counts_of(
    section: &Section,
    kind: SampleDesign,
) -> Result<(usize, u64, Option<f64>), InputError> {
    let count = section.whole_number("count", 1, kind.most_points() as u64)? as usize;
    let seed = section.whole_number("seed", 0, GREATEST_SEED)?;
    let enough = match section.optional("stop_at_interval_width") {
        None => None,
        Some(found) => match found.number()? {
            width if width > 0.0 && width < 1.0 => Some(width),
            _ => return Err(found.complain("0 < value < 1")),
        },
    };
    Ok((count, seed, enough))
}

/// Form in which an axis is given.
enum AxisForm {
    Single(Distribution),
    /// One of several jointly normal axes.
    Joint {
        mean: f64,
    },
}

/// Draws one of several jointly normal axes, each with its own random number.
fn joint_axis(joint: &[JointNormal], axis: usize, mean: f64, numbers: &[usize]) -> SampledAxis {
    let place = joint.iter().find_map(|joint| {
        let place = joint.axes.iter().position(|other| *other == axis)?;
        Some((joint, place))
    });
    let (factors, covariances) = match place {
        Some((joint, place)) => {
            let of_axes = |row: &[f64]| joint.axes.iter().copied().zip(row.to_vec()).collect();
            let covariances: Vec<(usize, f64)> = of_axes(&joint.covariance[place]);
            let factors: Vec<(usize, f64)> = of_axes(&joint.cholesky[place]);
            (factors, covariances)
        }
        None => (Vec::new(), Vec::new()),
    };
    let factors = factors.into_iter().filter(|(_, factor)| *factor != 0.0);
    SampledAxis::Joint {
        mean,
        factors: factors
            .map(|(axis, factor)| (numbers[axis], factor))
            .collect(),
        covariances,
    }
}

/// Reads distributions, some of them from files.
struct Reader<'r, 'l> {
    sweep: &'r Path,
    library: Library<'l>,
    sources: &'r mut Vec<Source>,
}

impl Reader<'_, '_> {
    /// Reads the form of an axis, and its group.
    fn axis(
        &mut self,
        entry: &AxisEntry,
        is_joint: bool,
    ) -> Result<(AxisForm, Option<String>), InputError> {
        let Some(form) = entry.found.table(&FORM)? else {
            return Err(entry.found.complain(AXIS));
        };
        if !entry.parameter.words().is_empty() {
            return Err(entry
                .found
                .complain_that("a parameter with words cannot be sampled"));
        }
        if is_joint {
            only(&form, &["mean"])?;
            let mean = form.number("mean")?;
            return Ok((AxisForm::Joint { mean }, None));
        }
        if let Some(file) = form.optional("file") {
            only(&form, &["file", "column"])?;
            let column = form.value("column", "the name of a column of the file")?;
            let distribution = self.column(&file, &column)?;
            let group = format!("file {}", file.text()?);
            return Ok((AxisForm::Single(distribution), Some(group)));
        }
        let group = form.optional("zip").map(|zip| zip.text()).transpose()?;
        let group = group.map(|name| format!("zip {name}"));
        Ok((AxisForm::Single(distribution(&form)?), group))
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
                "{refusal}: expected the path of a table, relative to this file"
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

/// Reads the distribution that a table names or whose keys it has.
fn distribution(form: &Section) -> Result<Distribution, InputError> {
    let [uniform, normal, ..] = DISTRIBUTIONS;
    let (name, keys) = match form.optional("distribution") {
        Some(word) => chosen_by(&word, &DISTRIBUTIONS.map(|known| (known.0, known)))?,
        None if form.optional("mean").is_some() || form.optional("sd").is_some() => normal,
        None => uniform,
    };
    only(form, &[keys, &["distribution", "zip"][..]].concat())?;
    let number = |key| form.number(key);
    let distribution = match name {
        "normal" => {
            let ends = match (form.optional("from"), form.optional("to")) {
                (None, None) => None,
                _ => Some([number("from")?, number("to")?]),
            };
            Distribution::normal(number("mean")?, number("sd")?, ends)
        }
        "lognormal" => Distribution::lognormal(number("mean")?, number("sd")?),
        "rayleigh" => Distribution::rayleigh(number("sigma")?),
        "triangular" => Distribution::triangular(number("from")?, number("mode")?, number("to")?),
        _ => Distribution::uniform(number("from")?, number("to")?, is_logarithmic(form)?),
    };
    distribution.map_err(|(key, allowed)| match form.optional(key) {
        Some(value) => value.complain(allowed),
        None => form.missing(key, allowed),
    })
}

/// Reads the numbers of a column of a table.
fn numbers(path: &Path, text: &str, column: &LocatedValue) -> Result<Vec<f64>, InputError> {
    let place = Place::file(path);
    let name = column.text()?;
    let (heading, rows) = csv_rows::read(&place, text)?;
    let mut found = heading
        .iter()
        .enumerate()
        .filter(|(_, known)| *known == name);
    let (index, again) = (found.next(), found.next());
    if again.is_some() {
        let path = path.display();
        return Err(column.complain_that(&format!(
            "expected a column that {path} has once: it has several of that name"
        )));
    }
    let Some((index, _)) = index else {
        let known: Vec<&str> = heading.iter().collect();
        return Err(column.complain(&format!(
            "a column of {}: {}",
            path.display(),
            known.join(", ")
        )));
    };
    let mut values = Vec::new();
    for (row, record) in rows.iter().enumerate() {
        let cell = record.get(index).unwrap_or("");
        match cell.parse::<f64>() {
            Ok(value) if value.is_finite() => values.push(value),
            _ => {
                return Err(InputError::value(name, cell, "a finite number")
                    .at(csv_rows::place(&place, row, record)));
            }
        }
    }
    if values.is_empty() {
        return Err(InputError::other("has no rows: expected at least one row").at(place));
    }
    Ok(values)
}
