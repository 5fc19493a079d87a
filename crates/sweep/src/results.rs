//! The result table of a sweep and the record of how it came about.

use serde_json::{Map, Value, json};
use touchdown_dynamics::outcome::Class;

use crate::boundary::Boundary;
use crate::certainty::Certainty;
use crate::document::{Entry, Value as Read};
use crate::method_input::method_name;
use crate::search_input::{DOUBTS, EXTENTS, REFINEMENTS, SCANS, word};
use crate::settings_input::{crush_rule_name, friction_profile_name};
use crate::sweep_file::Sweep;

/// Columns of the table after those of the axes.
pub const COLUMNS: [&str; 9] = [
    "first_transition_to",
    "first_transition_fps",
    "bracket_low_fps",
    "bracket_high_fps",
    "landings",
    "derivative_evaluations",
    "certainty",
    "disputed_from_fps",
    "disputed_to_fps",
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
    let axes = sweep.grid.axes().iter().map(|axis| axis.name());
    writer.write_record(axes.chain(COLUMNS))?;
    for (point, boundary) in boundaries.iter().enumerate() {
        let coordinates = sweep.grid.coordinates(point);
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
        let certainty = found.map_or(Certainty::Untested, |found| found.certainty);
        writer.write_record(
            coordinates
                .iter()
                .map(f64::to_string)
                .chain(results)
                .chain(certainty.cells()),
        )?;
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
        .filter(|(name, _)| sweep.grid.axes().iter().all(|axis| axis.name() != *name))
        .map(|(name, value)| (name.to_owned(), json!(value)))
        .collect();
    let axes: Map<String, Value> = sweep
        .grid
        .axes()
        .iter()
        .map(|axis| {
            (
                axis.name().to_owned(),
                json!(axis.values().collect::<Vec<_>>()),
            )
        })
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
                "bands": word(&EXTENTS, sweep.search.extent),
                "scan": word(&SCANS, sweep.search.scan),
                "refinement": word(&REFINEMENTS, sweep.search.refinement),
                "certainty": word(&DOUBTS, sweep.search.doubt),
            },
            "solver": {
                "tolerance": sweep.settings.tolerance(),
                "time_limit_s": sweep.settings.time_limit(),
                "crush_rule": crush_rule_name(sweep.settings.crush_rule()),
                "friction_profile": friction_profile_name(sweep.settings.friction_profile()),
                "method": method_name(&sweep.settings.method()),
            },
        },
        "counts": {
            "points": boundaries.len(),
            "first_transition_to": count_by_kind(boundaries)
                .into_iter()
                .map(|(kind, count)| (kind, json!(count)))
                .collect::<Map<String, Value>>(),
            "scan_speeds_skipped": boundaries.iter().map(|b| b.skipped).sum::<u64>(),
            "certainty_landings": boundaries.iter().map(|b| b.tests).sum::<u64>(),
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
            transition: Some(Transition {
                to,
                low,
                high,
                certainty: Certainty::Certain,
            }),
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
             landings,derivative_evaluations,certainty,disputed_from_fps,disputed_to_fps\n\
             -60,unstable,11.375,11.25,11.5,50,1000,certain,,\n\
             -55,none,,,,101,2000,,,\n\
             -50,bottomed,0.2,0.1,0.3,50,1000,certain,,\n"
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
