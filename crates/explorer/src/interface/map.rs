//! `map` and `at`: transitions over one or more axes, as in the pictures.

mod picture;
mod table;

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::{Map, Value, json};
use touchdown_figures::bands_table::BandsTable;
use touchdown_figures::boundary_table::Kind;
use touchdown_figures::caption::Caption;
use touchdown_figures::unit::unit_of;

use super::complaint::{Complaint, of_table};
use super::computed::Computed;
use super::in_units::{in_units, name_in, values_in};
use super::request::{Asked, asked_units, class_named, class_words, read, written};
use crate::named::{Named, Results, ResultsKind};

use picture::Picture;
pub use table::cell;
use table::{Point, Transitions, described};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    results: Option<String>,
    computed: Option<Computed>,
    #[serde(default)]
    axes: Vec<String>,
    #[serde(default)]
    fixed: Map<String, Value>,
    units: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AtRequest {
    results: Option<String>,
    computed: Option<Computed>,
    place: Map<String, Value>,
    units: Option<String>,
}

pub fn answer(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = asked_units(request.units.as_deref())?;
    let table = transitions_of(named, request.results.as_deref(), request.computed.as_ref())?;
    let results = in_units(&table, units)?;
    let results = results.as_ref();
    let all = Transitions::read(results)?;
    let (axes, fixed) = match units {
        Some(units) => (
            request
                .axes
                .iter()
                .map(|axis| name_in(axis, units))
                .collect(),
            values_in(&request.fixed, units),
        ),
        None => (request.axes, request.fixed),
    };
    let axes = all.chosen(&axes)?;
    let fixed = all.fixed(&axes, &fixed)?;
    let points: Vec<&Point> = all.within(&fixed).collect();
    let caption = caption(results)?;
    let picture = match axes[..] {
        [slow, fast] => Picture::of(results, &all, [slow, fast], &points, &caption)?,
        _ => Picture::default(),
    };
    let bands = match (&results.bands, all.axes.len(), axes.len()) {
        (Some(bands), 1, 1) => {
            Some(BandsTable::parse(bands).map_err(|error| of_table(results, error))?)
        }
        _ => None,
    };
    let unit = caption.speed_unit;
    let told = points.iter().map(|point| {
        let place: Vec<Value> = axes.iter().map(|axis| point.place[*axis].clone()).collect();
        let mut told = point.told(place);
        if let (Some(bands), Some(at)) = (&bands, point.place[0].as_f64()) {
            told["bands"] = bands_at(bands, at);
        }
        told
    });
    let told: Vec<Value> = told.collect();
    let others = (0..all.axes.len()).filter(|axis| !axes.contains(axis));
    let others = others.map(|axis| {
        let mut other = all.described(axis);
        other["fixed"] = fixed[axis].clone().unwrap_or_default();
        other
    });
    let others: Vec<Value> = others.collect();
    let mut answer = json!({
        "title": title(results),
        "conditions": caption.conditions,
        "statement": caption.statement,
        "source": named.source_of(results),
        "speed_unit": unit.to_string(),
        "speed_column": format!("first_transition{}", unit.ending()),
        "axes": axes.iter().map(|axis| all.described(*axis)).collect::<Vec<_>>(),
        "other_axes": others,
        "points": told,
        "searched_to": caption.searched_to,
        "kinds": Kind::ALL.map(kind_words),
    });
    picture.tell(&mut answer);
    written(&answer)
}

pub fn answer_at(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: AtRequest = read(request)?;
    let units = asked_units(request.units.as_deref())?;
    let table = transitions_of(named, request.results.as_deref(), request.computed.as_ref())?;
    let results = table.as_ref();
    let shown = Transitions::read(in_units(results, units)?.as_ref())?;
    let place = match units {
        Some(units) => values_in(&request.place, units),
        None => request.place,
    };
    let nearest = shown.nearest(&place)?;
    // Landings are those of the table, in its own units, digit for digit.
    let all = Transitions::read(results)?;
    let point = &all.points[nearest];
    let place = all.place(nearest);
    let caption = caption(results)?;
    let asked = match request.computed {
        Some(computed) => computed.touchdown,
        None => Asked {
            source: Some(named.source_of(results).to_owned()),
            ..Asked::default()
        },
    };
    let speed_name = format!("horizontal_velocity{}", caption.speed_unit.ending());
    let touchdown = |speed: f64| {
        let mut values = place.clone();
        values.insert(speed_name.clone(), json!(speed));
        // Search parameters varied by a sweep are not numbers of a landing.
        values.retain(|name, _| !name.starts_with("search."));
        json!(asked.with(values.into_iter()))
    };
    let below = match &point.transition {
        Some(found) => found.low.map(touchdown),
        None => caption.searched_to.map(touchdown),
    };
    let above = point.transition.as_ref().map(|found| touchdown(found.high));
    let mut told = shown.points[nearest].told(Vec::new());
    told["place"] = json!(shown.place(nearest));
    told["below"] = json!(below);
    told["above"] = json!(above);
    written(&told)
}

/// Finds a table of results by name.
///
/// # Errors
/// If there is none.
pub fn results_of<'n>(named: &'n Named, name: &str) -> Result<&'n Results, Complaint> {
    named.results(name).ok_or_else(|| {
        let known: Vec<&str> = named.results.iter().map(|one| one.name.as_str()).collect();
        let allowed = match known.is_empty() {
            true => "a table of results that was named when the explorer was started".to_owned(),
            false => format!("one of {}", known.join(", ")),
        };
        Complaint::value("results", format!("{name:?}"), &allowed)
    })
}

/// The table of a request: one that it names, or that a page computes.
///
/// # Errors
/// If there is none, or both.
pub fn table_of<'n>(
    named: &'n Named,
    name: Option<&str>,
    computed: Option<&Computed>,
) -> Result<Cow<'n, Results>, Complaint> {
    match (name, computed) {
        (Some(name), None) => results_of(named, name).map(Cow::Borrowed),
        (None, Some(computed)) => computed.results(named).map(Cow::Owned),
        _ => Err(Complaint::request(
            "not a request: expected either `results` or `computed`",
        )),
    }
}

fn transitions_of<'n>(
    named: &'n Named,
    name: Option<&str>,
    computed: Option<&Computed>,
) -> Result<Cow<'n, Results>, Complaint> {
    let results = table_of(named, name, computed)?;
    match results.kind {
        ResultsKind::Sample => Err(Complaint::value(
            "results",
            format!("{:?}", results.name),
            "a table of transitions: this one has landings, which sample tells",
        )),
        ResultsKind::Map | ResultsKind::Profile => Ok(results),
    }
}

/// Title in the record of a table, else its name.
pub fn title(results: &Results) -> String {
    match caption(results) {
        Ok(caption) => caption.title,
        Err(_) => results.name.clone(),
    }
}

fn caption(results: &Results) -> Result<Caption, Complaint> {
    let Results {
        name,
        table,
        record,
        ..
    } = results;
    Caption::of_table(name, table, record.as_deref()).map_err(|error| of_table(results, error))
}

fn kind_words(kind: Kind) -> Value {
    let words = class_named(kind.name()).map(class_words);
    json!(words)
}

/// The bands at a place of a profile.
fn bands_at(bands: &BandsTable, place: f64) -> Value {
    let at = bands.at(&[place]);
    at.iter()
        .map(|band| {
            let name = band.kind.map_or("stable", Kind::name);
            let words = class_named(name).map(class_words);
            let mut told = json!(words);
            told["from"] = json!(band.from);
            told["to"] = json!(band.to);
            told
        })
        .collect()
}

/// Description of an axis or a column.
pub fn words_of(name: &str, values: Vec<Value>) -> Value {
    described(name, &unit_of(name), values)
}
