//! `scene_file`, `history_file`, `command` and `table_file`: export a landing, or a table of results, for use elsewhere.

use serde::Deserialize;
use serde_json::json;
use touchdown_dynamics::landing::{Instant, land_located_while};
use touchdown_input::documents::document::{Entry, Node, Value};
use touchdown_input::documents::toml_text;
use touchdown_input::documents::unit::without_program_unit;
use touchdown_input::points::assignment::Assignment;
use touchdown_input::points::parameter::Home;
use touchdown_sweep::output::history::History;

use super::IsOver;
use super::complaint::{Complaint, of_table};
use super::computed::Computed;
use super::in_units::in_units;
use super::landing::{INTERVAL, interval};
use super::map::table_of;
use super::request::{Asked, asked_units, read, units, written};
use super::rows::{Range, Rows};
use super::touchdown::Touchdown;
use crate::named::{Named, SourceKind};

const SCENE_FILE: &str = "touchdown.toml";
const VEHICLE_FILE: &str = "vehicle.toml";
/// The option of `touchdown land` for a condition or a key of the solver, if there is one for it alone.
fn option_of(name: &str) -> Option<String> {
    let is_single = !name.contains('.') && !name.starts_with("angular_velocity");
    is_single.then(|| format!("--{}", without_program_unit(name).replace('_', "-")))
}

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Request {
    touchdown: Asked,
    units: Option<String>,
    interval_s: f64,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            touchdown: Asked::default(),
            units: None,
            interval_s: INTERVAL,
        }
    }
}

pub fn scene_file(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = units(request.units.as_deref(), named.units)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    touchdown.scene()?;
    let mut entries = vec![
        entry("vehicle", Value::Text(VEHICLE_FILE.to_owned())),
        entry("units", Value::Text(units.to_string())),
        entry("scene", Value::Table(scene_entries(&touchdown))),
    ];
    entries.extend(touchdown.solver.root().iter().cloned());
    let files = [
        json!({"name": SCENE_FILE, "text": toml_text::text(&entries)}),
        json!({"name": VEHICLE_FILE, "text": toml_text::text(touchdown.vehicle.document.root())}),
    ];
    written(&json!({ "files": files }))
}

pub fn history_file(named: &Named, request: &str, is_over: IsOver) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = units(request.units.as_deref(), named.units)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    let scene = touchdown.scene()?;
    let seconds = interval(&touchdown, request.interval_s)?;
    let mut history = History::new(Vec::new(), units);
    let mut observe = |instant: &Instant| history.add(instant);
    let vehicle = &touchdown.vehicle.vehicle;
    let (settings, goes_on) = (&touchdown.settings, || !is_over());
    land_located_while(vehicle, &scene, settings, seconds, &mut observe, goes_on)
        .ok_or_else(Complaint::over)?;
    let table = history.end().map_err(Complaint::engine)?;
    let text = String::from_utf8(table).map_err(Complaint::engine)?;
    written(&json!({"files": [json!({"name": "history.csv", "text": text})]}))
}

pub fn command(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    touchdown.scene()?;
    let source = touchdown.source;
    let vehicle_file = source.vehicle.document.path().display().to_string();
    let is_own_vehicle = request.touchdown.vehicle.is_some();
    // The vehicle of a sweep may have values of axes, that of a scene file values of a case.
    let is_as_in_file = matches!(source.kind, SourceKind::Vehicle);
    let has_thrust = !touchdown.conditions.thrust_knots().is_empty();
    if is_own_vehicle || !is_as_in_file || has_thrust {
        let command = format!("touchdown land {SCENE_FILE} --out landing");
        return written(&json!({"command": command, "needs": [SCENE_FILE, VEHICLE_FILE]}));
    }
    let mut words = vec!["touchdown land --vehicle".to_owned(), quoted(&vehicle_file)];
    let mut set = Vec::new();
    for (name, value) in given(&touchdown) {
        match option_of(name) {
            Some(option) => words.push(format!("{option}={value}")),
            None => set.push(format!("{name}={value}")),
        }
    }
    let of_vehicle = |one: &&Assignment| one.parameter().home() == Home::Vehicle;
    set.extend(
        (touchdown.set.iter().filter(of_vehicle))
            .map(|one| format!("{}={}", one.parameter().name(), one.text())),
    );
    for entry in touchdown.solver_entries() {
        if let Some(option) = option_of(&entry.key) {
            match &entry.node.value {
                Value::Number(number) => words.push(format!("{option}={number}")),
                Value::Text(word) => words.push(format!("{option}={word}")),
                _ => {}
            }
        }
    }
    words.extend(set.iter().map(|one| format!("--set {}", quoted(one))));
    written(&json!({"command": words.join(" "), "needs": []}))
}

/// The given conditions, by name.
fn given(touchdown: &Touchdown) -> Vec<(&'static str, f64)> {
    let conditions = &touchdown.conditions;
    let resolved = conditions.resolved().into_iter();
    resolved
        .filter(|(name, _)| conditions.get(name).is_some())
        .collect()
}

/// Entries of the table `[scene]`.
fn scene_entries(touchdown: &Touchdown) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut tables = [("thrust", Vec::new()), ("soil", Vec::new())];
    let mut footing: Vec<Vec<Entry>> = Vec::new();
    let knots = touchdown.conditions.thrust_knots();
    if !knots.is_empty() {
        let list = |index: usize| {
            let numbers = knots.iter().map(|knot| node(Value::Number(knot[index])));
            Value::List(numbers.collect())
        };
        tables[0].1 = vec![entry("time_s", list(0)), entry("force_lb", list(1))];
    }
    for (name, value) in given(touchdown) {
        let number = Value::Number(value);
        let of_table = name.split_once('.').and_then(|(table, key)| {
            let (_, entries) = tables.iter_mut().find(|(known, _)| *known == table)?;
            Some((entries, key))
        });
        if let Some((entries, key)) = of_table {
            entries.push(entry(key, number));
            continue;
        }
        let of_leg = name
            .strip_prefix("footing[")
            .and_then(|rest| rest.split_once("]."));
        match of_leg.and_then(|(leg, key)| Some((leg.parse::<usize>().ok()?, key))) {
            Some((leg, key)) => {
                footing.resize_with(footing.len().max(leg), Vec::new);
                footing[leg - 1].push(entry(key, number));
            }
            None => entries.push(entry(name, number)),
        }
    }
    for (key, table) in tables {
        if !table.is_empty() {
            entries.push(entry(key, Value::Table(table)));
        }
    }
    if !footing.is_empty() {
        let tables = footing.into_iter().map(|leg| node(Value::Table(leg)));
        entries.push(entry("footing", Value::List(tables.collect())));
    }
    entries
}

fn entry(key: &str, value: Value) -> Entry {
    Entry {
        key: key.to_owned(),
        node: node(value),
    }
}

fn node(value: Value) -> Node {
    Node {
        line: 1,
        written: String::new(),
        value,
    }
}

/// Quotes a word for a shell.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=+:,".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TableRequest {
    results: Option<String>,
    computed: Option<Computed>,
    #[serde(default)]
    within: Vec<Range>,
    units: Option<String>,
}

/// A table of results as a file, or those of its rows that lie within ranges.
pub fn table_file(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: TableRequest = read(request)?;
    let units = asked_units(request.units.as_deref())?;
    let table = table_of(named, request.results.as_deref(), request.computed.as_ref())?;
    let results = in_units(&table, units)?;
    let rows = Rows::read(&results)?;
    let are_within = rows.within(&request.within)?;
    let fault = |error: csv::Error| of_table(&results, error);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&rows.heading).map_err(fault)?;
    for (row, _) in rows.rows.iter().zip(are_within).filter(|(_, is)| *is) {
        writer.write_record(row).map_err(fault)?;
    }
    let bytes = writer.into_inner().map_err(Complaint::engine)?;
    let name = match request.within.is_empty() {
        true => format!("{}.csv", results.name),
        false => format!("{}-selected.csv", results.name),
    };
    written(&json!({"files": [{"name": name, "text": String::from_utf8_lossy(&bytes)}]}))
}
