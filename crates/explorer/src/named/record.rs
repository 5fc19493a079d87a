//! Reads the input in the record beside a table of results as a starting touchdown.

use std::path::Path;

use serde_json::{Map, Value as Json};
use touchdown_input::documents::document::{Document, Entry, Value};
use touchdown_input::documents::input_error::{InputError, Place};
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::documents::toml_text::{self, entries, entry, node, written};
use touchdown_input::points::assignment::Assignment;
use touchdown_input::readers::scene_input::{HORIZONTAL_VELOCITY, NamedConditions};
use touchdown_input::readers::settings_input::SOLVER;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::single_landing::Touchdown;

use super::source::{SEARCHED, Source, SourceKind, nothing, stem};

/// Lists of the thrust, stored in a record beside its numbers.
const THRUST: [&str; 2] = ["thrust.time_s", "thrust.force_lb"];

/// The touchdown of a record, without the values of its axes, which must be added.
///
/// # Errors
/// If the file is not a record, or has input that this version does not support.
pub fn source(record: &str, path: &Path) -> Result<Source, InputError> {
    let at = |error: InputError| error.nowhere().at(Place::file(path));
    let refuse = |complaint: String| at(InputError::other(complaint));
    let record: Json = serde_json::from_str(record)
        .map_err(|error| refuse(format!("not a record of a sweep: {error}")))?;
    let input = &record["input"];
    let (Some(vehicle), Some(scene)) = (input["vehicle"].as_object(), input["scene"].as_object())
    else {
        return Err(refuse(
            "not a record of a sweep: expected input.vehicle and input.scene".to_owned(),
        ));
    };
    let text = |key: &str| input[key].as_str().unwrap_or_default().to_owned();
    let vehicle_path = text("vehicle_file");
    let document = document(Path::new(&vehicle_path), entries(vehicle)).map_err(at)?;
    let vehicle = VehicleFile::from_document(document).map_err(at)?;
    let mut conditions = conditions(scene).map_err(at)?;
    let search = search(&input["search"]);
    if conditions.get(HORIZONTAL_VELOCITY).is_none() {
        conditions.set(HORIZONTAL_VELOCITY, 0.5 * (search[0] + search[1]));
    }
    let title = record["title"].as_str().unwrap_or_default().to_owned();
    Ok(Source {
        name: stem(path),
        title,
        file: path.display().to_string(),
        kind: SourceKind::Results,
        vehicle,
        conditions,
        solver: solver(&input["solver"]).map_err(at)?,
        search,
        units: OutputUnits::default(),
    })
}

fn conditions(scene: &Map<String, Json>) -> Result<NamedConditions, InputError> {
    let lists: Vec<&Json> = THRUST.iter().filter_map(|key| scene.get(*key)).collect();
    let mut conditions = match lists[..] {
        [times, forces] => {
            let text = format!("thrust = {{ time_s = {times}, force_lb = {forces} }}");
            let document = Document::parse(Path::new(""), &text)?;
            *Touchdown::from_document(document)?.conditions()
        }
        _ => NamedConditions::default(),
    };
    for (name, value) in scene {
        if let Some(value) = value.as_f64() {
            let one = Assignment::new(name, &value.to_string())?;
            touchdown_input::points::assignment::set_conditions(&mut conditions, &[one]);
        }
    }
    Ok(conditions)
}

/// Range of V_H, ft/s.
fn search(search: &Json) -> [f64; 2] {
    let end = |key: &str| {
        let known = [format!("search.{key}_fps"), format!("search.{key}_mps")];
        known.iter().find_map(|name| {
            let parameter = touchdown_input::points::parameter::Parameter::named(name, 3)?;
            let value = search[name.strip_prefix("search.")?].as_f64()?;
            Some(parameter.to_program(value))
        })
    };
    match (end("from"), end("to")) {
        (Some(from), Some(to)) => [from, to],
        _ => SEARCHED,
    }
}

fn solver(solver: &Json) -> Result<Document, InputError> {
    let method = solver["method"].as_str().unwrap_or("located");
    if method != "located" {
        return Err(InputError::value(
            "solver.method",
            method,
            "located: landings of results by other methods cannot be repeated",
        ));
    }
    let known = SOLVER.iter().filter_map(|key| {
        let value = node(solver.get(*key)?);
        Some(entry(key, value))
    });
    let known: Vec<Entry> = known.collect();
    match known.is_empty() {
        true => nothing(),
        false => document(
            Path::new(""),
            vec![entry("solver", written(Value::Table(known)))],
        ),
    }
}

fn document(path: &Path, entries: Vec<Entry>) -> Result<Document, InputError> {
    Document::parse(path, &toml_text::text(&entries))
}
