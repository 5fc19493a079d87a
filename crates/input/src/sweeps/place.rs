//! A sweep at a single place, and sweeps read back from their records.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value as Json};
use touchdown_dynamics::per_leg::MOST_LEGS;

use crate::documents::document::{Entry, Node, Value};
use crate::documents::input_error::{InputError, Place};
use crate::documents::library::{Library, Source};
use crate::documents::toml_text::{self, entries, entry, node};
use crate::points::assignment::Assignment;
use crate::points::design::Design;
use crate::points::grid::Grid;
use crate::points::levels::Levels;
use crate::points::parameter::Parameter;
use crate::readers::scene_input::FOOTING;
use crate::readers::settings_input::solver_keys;
use crate::sweeps::sweep::Sweep;

/// Name of the vehicle file of a sweep that is read from a record.
const VEHICLE: &str = "vehicle.toml";

impl Sweep {
    /// The sweep with a single point, at these values of its axes, which may lie between or beyond those of its design.
    ///
    /// # Errors
    /// If an axis has no value, a value has no axis, or the place is not allowed.
    pub fn at(mut self, values: &[Assignment]) -> Result<Self, InputError> {
        let coordinates = coordinates(&self.axes, values)?;
        self.case_at(&coordinates)
            .map_err(|fault| InputError::other(fault.to_string()))?;
        let level = |value: &f64| Some((Levels::list(vec![*value])?, None));
        let levels: Option<Vec<_>> = coordinates.iter().map(level).collect();
        let grid = levels.and_then(|levels| Grid::new(levels).ok());
        let finite = || InputError::other("expected finite values of the axes");
        self.design = Design::Grid(grid.ok_or_else(finite)?);
        Ok(self)
    }

    /// Reads the sweep of a record (`NAME.json`) at one place. Nothing but the record is read.
    ///
    /// # Errors
    /// If the text is no record of a sweep that this version can compute; as [`Sweep::at`].
    pub fn of_record(text: &str, path: &Path, values: &[Assignment]) -> Result<Self, InputError> {
        let refuse = |complaint: &str| InputError::other(complaint).at(Place::file(path));
        let record: Json = serde_json::from_str(text).unwrap_or_default();
        let part = |key: &str| record["input"][key].as_object();
        let (Some(vehicle), Some(scene), Some(axes)) =
            (part("vehicle"), part("scene"), part("axes"))
        else {
            return Err(refuse("expected the record of a sweep"));
        };
        let Some(search) = part("search") else {
            return Err(refuse(
                "expected the record of a sweep that searches transitions",
            ));
        };
        let title = record["title"].as_str().unwrap_or_default();
        let mut input = vec![
            entry("title", word(title)),
            entry("vehicle", word(VEHICLE)),
            entry("scene", table(scene_entries(&fixed(scene, axes)))),
            entry("axes", table(axis_entries(axes, values)?)),
            entry("search", table(entries(search))),
            entry("solver", table(solver_entries(part("solver")))),
        ];
        if search.contains_key("to_mps") {
            input.insert(0, entry("units", word("SI")));
        }
        let copies = [
            (path.with_extension("toml"), toml_text::text(&input)),
            (beside(path), toml_text::text(&entries(vehicle))),
        ];
        let copies = copies.map(|(path, text)| Source { path, text });
        Self::read_from(&copies[0].path, Library::Copies(&copies))
            .map_err(|error| error.nowhere().at(Place::file(path)))
    }
}

fn beside(path: &Path) -> PathBuf {
    path.parent().unwrap_or(Path::new("")).join(VEHICLE)
}

/// Coordinates of the place where axes have these values.
fn coordinates(axes: &[Parameter], values: &[Assignment]) -> Result<Vec<f64>, InputError> {
    let names: Vec<&str> = axes.iter().map(Parameter::name).collect();
    let names = names.join(", ");
    if let Some(other) = values.iter().find(|one| !axes.contains(one.parameter())) {
        let (name, text) = (other.parameter().name(), other.text());
        return Err(InputError::other(format!(
            "{name} = {text}: does not vary in the sweep: expected {names}"
        )));
    }
    let coordinate = |axis: &Parameter| {
        let given = values.iter().find(|one| one.parameter() == axis);
        given.and_then(|one| coordinate(axis, one)).ok_or_else(|| {
            let expected = format!("a value of each axis of the sweep: {names}");
            InputError::missing(axis.name(), &expected)
        })
    };
    axes.iter().map(coordinate).collect()
}

/// Coordinate of an axis that a value, in any unit, stands for.
fn coordinate(axis: &Parameter, value: &Assignment) -> Option<f64> {
    match value.value() {
        Value::Number(number) => Some(axis.in_own_unit(number)),
        Value::Text(word) => {
            let place = axis.words().iter().position(|known| *known == word);
            place.map(|place| place as f64)
        }
        _ => None,
    }
}

/// Recorded conditions without the angles that are 0 by default, where the attitude varies by its tip.
fn fixed(scene: &Map<String, Json>, axes: &Map<String, Json>) -> Map<String, Json> {
    let mut fixed = scene.clone();
    if axes.keys().any(|name| name.starts_with("tip_")) {
        fixed.retain(|name, _| !["pitch_deg", "yaw_deg", "roll_deg"].contains(&name.as_str()));
    }
    fixed
}

/// The table `[scene]` of recorded conditions, whose names are dotted.
fn scene_entries(scene: &Map<String, Json>) -> Vec<Entry> {
    let mut own = Vec::new();
    let mut below: Vec<(&str, Vec<Entry>)> = Vec::new();
    for (name, value) in scene {
        match name.split_once('.') {
            None => own.push(entry(name, node(value))),
            Some((above, key)) => {
                let one = entry(key, node(value));
                match below.iter_mut().find(|(known, _)| *known == above) {
                    Some((_, entries)) => entries.push(one),
                    None => below.push((above, vec![one])),
                }
            }
        }
    }
    // Ground under legs is a list, whose entries are counted from 1.
    let leg = |name: &str| -> Option<usize> {
        let number = name.strip_prefix(FOOTING)?.strip_prefix('[')?;
        number.strip_suffix(']')?.parse().ok()
    };
    let most = below.iter().filter_map(|(name, _)| leg(name)).max();
    let mut footing: Vec<Vec<Entry>> = vec![Vec::new(); most.unwrap_or(0)];
    for (name, entries) in below {
        match leg(name) {
            Some(leg) if leg > 0 => footing[leg - 1] = entries,
            _ => own.push(entry(name, table(entries))),
        }
    }
    if !footing.is_empty() {
        let legs = footing.into_iter().map(table).collect();
        own.push(entry(FOOTING, of(Value::List(legs))));
    }
    own
}

/// The table `[axes]` with these values alone.
fn axis_entries(axes: &Map<String, Json>, values: &[Assignment]) -> Result<Vec<Entry>, InputError> {
    let known = axes
        .keys()
        .filter_map(|name| Parameter::named(name, MOST_LEGS));
    let axes: Vec<Parameter> = known.collect();
    let coordinates = coordinates(&axes, values)?;
    let entries = axes.iter().zip(coordinates).map(|(axis, coordinate)| {
        let value = match axis.word(coordinate) {
            Some(known) => word(known),
            None => of(Value::Number(coordinate)),
        };
        entry(axis.name(), of(Value::List(vec![value])))
    });
    Ok(entries.collect())
}

/// The table `[solver]` without what the record says in other words.
fn solver_entries(solver: Option<&Map<String, Json>>) -> Vec<Entry> {
    let keys = solver_keys().into_iter();
    let given = keys.filter_map(|key| Some(entry(key, node(solver?.get(key)?))));
    given.collect()
}

fn table(entries: Vec<Entry>) -> Node {
    of(Value::Table(entries))
}

fn word(word: &str) -> Node {
    of(Value::Text(word.to_owned()))
}

fn of(value: Value) -> Node {
    toml_text::written(value)
}
