//! The result table of a sweep and the record of how it came about.

use serde_json::{Map, Value, json};
use touchdown_dynamics::outcome::Class;

use crate::boundary::Boundary;
use crate::document::{Entry, Value as Read};
use crate::levels::Levels;
use crate::parameter::Parameter;
use crate::search_input::extent_name;
use crate::settings_input::crush_rule_name;
use crate::sweep_file::Sweep;

/// Columns of the table after those of the axes.
pub const COLUMNS: [&str; 6] = [
    "first_transition_to",
    "first_transition_fps",
    "bracket_low_fps",
    "bracket_high_fps",
    "landings",
    "derivative_evaluations",
];

/// How a sweep was run, which its input does not tell.
#[derive(Debug, Clone, Copy)]
pub struct Circumstances<'a> {
    /// Version of the program.
    pub version: &'a str,
    /// Threads used.
    pub threads: usize,
    /// Time from first to last landing, s.
    pub wall_time: f64,
}

/// Word for the transition of a point.
pub fn transition_name(boundary: &Boundary) -> String {
    match boundary.transition {
        Some(transition) => transition.to.to_string(),
        None => "none".to_owned(),
    }
}

/// The table of a sweep as CSV: one row per grid point, in grid order.
///
/// Numbers have as many digits as it takes to read the same number back, and no more.
///
/// # Errors
/// None but those of memory.
pub fn table<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let axes = sweep.axes.iter().map(|axis| axis.name());
    writer.write_record(axes.chain(COLUMNS))?;
    for (point, boundary) in boundaries.iter().enumerate() {
        let coordinates = sweep.coordinates_written(point);
        let found = boundary.transition;
        let speed = |speed: Option<f64>| speed.map_or(String::new(), |speed| speed.to_string());
        let results = [
            transition_name(boundary),
            speed(found.map(|found| found.speed())),
            speed(found.map(|found| found.low)),
            speed(found.map(|found| found.high)),
            boundary.landings.to_string(),
            boundary.evaluations.to_string(),
        ];
        writer.write_record(coordinates.into_iter().chain(results))?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

/// The record of a sweep: all of its input with defaults filled in, counts and circumstances.
pub fn record<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
    circumstances: Circumstances,
) -> Value {
    let scene: Map<String, Value> = sweep
        .fixed
        .resolved()
        .into_iter()
        .filter(|(name, _)| sweep.axes.iter().all(|axis| axis.name() != *name))
        .map(|(name, value)| (name.to_owned(), json!(value)))
        .collect();
    let axes: Map<String, Value> = sweep
        .axes
        .iter()
        .zip(sweep.grid.axes())
        .map(|(axis, levels)| (axis.name().to_owned(), levels_of(axis, levels)))
        .collect();
    json!({
        "title": sweep.title,
        "statement": sweep.statement,
        "program": { "name": "touchdown", "version": circumstances.version },
        "input": {
            "sweep_file": sweep.path.display().to_string(),
            "vehicle_file": sweep.vehicle.document.path().display().to_string(),
            "vehicle": tree(sweep.vehicle.document.root()),
            "scene": scene,
            "axes": axes,
            "search": {
                "from_fps": sweep.search.from,
                "to_fps": sweep.search.to,
                "scan_step_fps": sweep.search.scan_step,
                "tolerance_fps": sweep.search.tolerance,
                "bands": extent_name(sweep.search.extent),
            },
            "solver": {
                "tolerance": sweep.settings.tolerance(),
                "time_limit_s": sweep.settings.time_limit(),
                "crush_rule": crush_rule_name(sweep.settings.crush_rule()),
            },
        },
        "counts": {
            "points": boundaries.len(),
            "first_transition_to": count_by_kind(boundaries)
                .into_iter()
                .map(|(kind, count)| (kind, json!(count)))
                .collect::<Map<String, Value>>(),
            "landings": boundaries.iter().map(|b| b.landings).sum::<u64>(),
            "derivative_evaluations": boundaries.iter().map(|b| b.evaluations).sum::<u64>(),
            "bands": boundaries.iter().map(|b| b.bands.len()).sum::<usize>(),
            "looks_for_hidden_bands": boundaries.iter().map(|b| b.looks).sum::<u64>(),
            "hidden_bands_found": boundaries.iter().map(|b| b.finds).sum::<u64>(),
        },
        "threads": circumstances.threads,
        "wall_time_s": circumstances.wall_time,
    })
}

/// The values of an axis, words as words.
fn levels_of(axis: &Parameter, levels: &Levels) -> Value {
    levels
        .values()
        .map(|value| match axis.word(value) {
            Some(word) => json!(word),
            None => json!(value),
        })
        .collect()
}

/// Number of points for each kind of first transition that occurs, `none` last.
pub fn count_by_kind(boundaries: &[Boundary]) -> Vec<(String, usize)> {
    [Class::Unstable, Class::Bottomed, Class::Failure]
        .map(|class| class.to_string())
        .into_iter()
        .chain(["none".to_owned()])
        .map(|kind| {
            let same = |boundary: &&Boundary| transition_name(boundary) == kind;
            let count = boundaries.iter().filter(same).count();
            (kind, count)
        })
        .filter(|(_, count)| *count > 0)
        .collect()
}

fn tree(entries: &[Entry]) -> Value {
    let fields = entries
        .iter()
        .map(|entry| (entry.key.clone(), value(&entry.node.value)));
    Value::Object(fields.collect())
}

fn value(read: &Read) -> Value {
    match read {
        Read::Number(number) => json!(number),
        Read::Text(text) => json!(text),
        Read::List(nodes) => nodes.iter().map(|node| value(&node.value)).collect(),
        Read::Table(entries) => tree(entries),
        Read::Foreign => Value::Null,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::Transition;
    use std::path::Path;

    fn example() -> (Sweep<3>, Vec<Boundary>) {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-09.toml");
        let sweep = Sweep::read(Path::new(path)).unwrap();
        let at = |to, low, high| Boundary {
            transition: Some(Transition { to, low, high }),
            landings: 50,
            evaluations: 1000,
            ..Boundary::default()
        };
        let none = Boundary {
            landings: 101,
            evaluations: 2000,
            ..Boundary::default()
        };
        let boundaries = vec![
            at(Class::Unstable, 11.25, 11.5),
            none,
            at(Class::Bottomed, 0.1, 0.3),
        ];
        (sweep, boundaries)
    }

    #[test]
    fn rows_follow_the_grid() {
        let (sweep, boundaries) = example();
        let text = String::from_utf8(table(&sweep, &boundaries).unwrap()).unwrap();
        assert_eq!(
            text,
            "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,\
             landings,derivative_evaluations\n\
             -60,unstable,11.375,11.25,11.5,50,1000\n\
             -55,none,,,,101,2000\n\
             -50,bottomed,0.2,0.1,0.3,50,1000\n"
        );
    }

    #[test]
    fn record_holds_the_resolved_input() {
        let (sweep, boundaries) = example();
        let circumstances = Circumstances {
            version: "1.2.3",
            threads: 2,
            wall_time: 0.5,
        };
        let record = record(&sweep, &boundaries, circumstances);
        assert_eq!(record["program"]["version"], "1.2.3");
        assert_eq!(record["input"]["scene"]["block_friction"], 1.0);
        assert_eq!(record["input"]["scene"].get("roll_deg"), None);
        assert_eq!(record["input"]["axes"]["roll_deg"][24], 60.0);
        assert_eq!(record["input"]["vehicle"]["legs"][2]["azimuth_deg"], 240.0);
        assert_eq!(record["counts"]["landings"], 201);
        assert_eq!(record["counts"]["first_transition_to"]["bottomed"], 1);
    }
}
