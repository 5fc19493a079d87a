//! `docs/output.md` names the columns of the files that the program writes, in their order.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::golden::golden;
use serde_json::Value;
use tempfile::TempDir;
use touchdown_input::documents::unit::unit;
use touchdown_sweep::output::tables;

const PAGE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/output.md"));
const LEGS: usize = 3;

/// A small sweep with every table of a boundary search.
const BOUNDARY: &str = r#"title = "Two rolls"
vehicle = "vehicle.toml"
[scene]
vertical_velocity_fps = 14
cross_slope_deg = 180
slope_deg = 15
friction = 1.0
[axes]
roll_deg = [0, 10]
[search]
from_fps = 11
to_fps = 12
scan_step_fps = 0.5
tolerance_fps = 0.1
bands = "all"
[sensitivity]
parameters = ["friction"]
"#;

/// A small sample of landings.
const OUTCOME: &str = r#"title = "Four landings"
job = "outcome"
vehicle = "vehicle.toml"
[scene]
vertical_velocity_fps = 14
cross_slope_deg = 180
slope_deg = 15
friction = 1.0
[axes]
horizontal_velocity_fps = { from = 1, to = 3 }
[sample]
design = "sobol"
count = 4
seed = 1
"#;

/// A small sample of transitions.
const DISPERSED: &str = r#"title = "Three transitions"
vehicle = "vehicle.toml"
[scene]
vertical_velocity_fps = 14
cross_slope_deg = 180
slope_deg = 15
[axes]
friction = { from = 0.9, to = 1.1 }
[sample]
design = "sobol"
count = 3
seed = 1
[search]
from_fps = 10
to_fps = 14
scan_step_fps = 1
tolerance_fps = 0.5
"#;

const CASES: &str = "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,\
                     friction,pitch_deg,yaw_deg,roll_deg\n1,14,3,180,15,1,0,0,0\n";

/// The columns that the page lists under a marker; those of legs once for each leg.
///
/// Rows with `#` that follow each other belong to one leg where `by_leg` says so, as in histories;
/// otherwise each goes through all legs by itself.
fn documented(name: &str, by_leg: bool) -> Vec<String> {
    let marker = format!("<!-- columns: {name} -->\n");
    let (_, rest) = PAGE.split_once(&marker).unwrap_or_else(|| panic!("{name}"));
    let mut lines = rest.lines();
    assert_eq!(lines.next(), Some("| column | unit | meaning |"));
    let names: Vec<&str> = lines
        .skip(1)
        .take_while(|row| row.starts_with('|'))
        .map(|row| row.split('`').nth(1).unwrap())
        .collect();
    let of_leg = |name: &str, leg: usize| name.replace('#', &leg.to_string());
    let mut columns = Vec::new();
    for group in names.chunk_by(|a, b| by_leg && a.contains('#') && b.contains('#')) {
        match group[0].contains('#') {
            true => columns
                .extend((1..=LEGS).flat_map(|leg| group.iter().map(move |name| of_leg(name, leg)))),
            false => columns.extend(group.iter().map(|name| (*name).to_owned())),
        }
    }
    columns
}

struct Bench {
    folder: TempDir,
}

impl Bench {
    fn new() -> Self {
        let folder = TempDir::new().unwrap();
        let vehicle = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../sweeps/vehicles/surveyor-table-4-1.toml");
        fs::copy(vehicle, folder.path().join("vehicle.toml")).unwrap();
        Self { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn run(&self, arguments: &[&str]) -> String {
        let done = Command::new(env!("CARGO_BIN_EXE_touchdown"))
            .args(arguments)
            .current_dir(&self.folder)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{arguments:?}: {said}");
        String::from_utf8(done.stdout).unwrap()
    }

    /// The heading of a table without its first `before` columns.
    fn heading(&self, name: &str, before: usize) -> Vec<String> {
        let text = fs::read_to_string(self.path(name)).unwrap();
        let heading = text.lines().next().unwrap();
        heading.split(',').skip(before).map(str::to_owned).collect()
    }

    fn counts(&self, name: &str) -> Vec<String> {
        let text = fs::read_to_string(self.path(name)).unwrap();
        let record: Value = serde_json::from_str(&text).unwrap();
        for key in record.as_object().unwrap().keys() {
            assert!(PAGE.contains(&format!("`{key}`")), "{key} is not described");
        }
        record["counts"]
            .as_object()
            .unwrap()
            .keys()
            .cloned()
            .collect()
    }
}

/// The page has the tables of the catalogue, word for word.
#[test]
fn the_page_says_what_the_catalogue_says() {
    let tables = tables::documented().into_iter().map(|(name, rows)| {
        format!("<!-- columns: {name} -->\n| column | unit | meaning |\n|---|---|---|\n{rows}\n")
    });
    let missing: String = tables.filter(|table| !PAGE.contains(table)).collect();
    assert!(missing.is_empty(), "docs/output.md needs\n\n{missing}");
}

#[test]
fn columns_of_sweeps_are_described() {
    let bench = Bench::new();
    fs::write(bench.path("two.toml"), BOUNDARY).unwrap();
    fs::write(bench.path("four.toml"), OUTCOME).unwrap();
    fs::write(bench.path("three.toml"), DISPERSED).unwrap();
    bench.run(&[
        "sweep",
        "two.toml",
        "four.toml",
        "three.toml",
        "--out",
        "out",
    ]);
    for (file, before, name) in [
        ("out/two.csv", 1, "transitions"),
        ("out/two-bands.csv", 1, "bands"),
        ("out/two-sensitivity.csv", 1, "sensitivities"),
        ("out/four.csv", 1, "landings"),
        ("out/four-probabilities.csv", 0, "probabilities"),
        ("out/three-quantiles.csv", 0, "quantiles"),
        ("out/three-distribution.csv", 0, "distribution"),
    ] {
        assert_eq!(
            bench.heading(file, before),
            documented(name, false),
            "{file}"
        );
    }
    let sorted = |mut keys: Vec<String>| {
        keys.sort();
        keys
    };
    for record in ["out/two.json", "out/four.json"] {
        let counts = sorted(bench.counts(record));
        assert_eq!(counts, sorted(documented("counts", false)), "{record}");
    }
}

#[test]
fn columns_of_maps_are_described() {
    let bench = Bench::new();
    let map = BOUNDARY
        .replace("[sensitivity]\nparameters = [\"friction\"]\n", "")
        .replace("cross_slope_deg = 180\n", "")
        .replace("bands = \"all\"\n", "")
        .replace(
            "roll_deg = [0, 10]",
            "cross_slope_deg = [170, 180]\nroll_deg = [20, 40]\n[map]\n\
             edge_width = { roll_deg = 10, cross_slope_deg = 10 }\nerror_fps = 1",
        );
    fs::write(bench.path("map.toml"), &map).unwrap();
    bench.run(&["sweep", "map.toml", "--out", "out"]);
    let described = |name| documented(name, false);
    let points = [described("transitions"), described("map points")].concat();
    assert_eq!(bench.heading("out/map.csv", 2), points);
    let edges = |axes: &[&str]| {
        let mut edges = described("map edges");
        edges.pop();
        edges.extend(axes.iter().map(|axis| format!("within_{axis}")));
        edges
    };
    let both = edges(&["cross_slope_deg", "roll_deg"]);
    assert_eq!(bench.heading("out/map-edges.csv", 2), both);
    assert_eq!(bench.heading("out/map-grid.csv", 2), described("map grid"));
    assert_eq!(
        bench.heading("out/map-surface.csv", 2),
        described("map surface")
    );
    let family = map.replace(", cross_slope_deg = 10", "");
    fs::write(bench.path("family.toml"), family).unwrap();
    bench.run(&["sweep", "family.toml", "--out", "out"]);
    assert_eq!(bench.heading("out/family.csv", 2), points);
    let one = edges(&["roll_deg"]);
    assert_eq!(bench.heading("out/family-edges.csv", 2), one);
}

#[test]
fn columns_of_landings_are_described() {
    let bench = Bench::new();
    fs::write(bench.path("cases.csv"), CASES).unwrap();
    let vehicle = ["land", "--vehicle", "vehicle.toml"];
    let table = ["--cases", "cases.csv", "--out", "outcomes.csv"];
    bench.run(&[&vehicle[..], &table].concat());
    assert_eq!(
        bench.heading("outcomes.csv", 1),
        documented("landings", false)
    );
    let touchdown = [
        "--vertical-velocity=14",
        "--horizontal-velocity=3",
        "--cross-slope=180",
        "--slope=15",
        "--friction=1",
        "--history=history.csv",
        "--json",
    ];
    let beyond = ["--stop=time", "--time-limit=6"];
    let printed = bench.run(&[&vehicle[..], &touchdown, &beyond].concat());
    let starts = |name: &str, with: &[&str]| with.iter().any(|start| name.starts_with(start));
    let documented_history = |others: &[&str]| {
        let mut history = documented("history", true);
        history.retain(|name| !starts(name, others) && !name.contains("_sinkage_"));
        history
    };
    let of_three_struts = [
        "foot_",
        "stroke_a_",
        "stroke_b_",
        "strut_force_a_",
        "strut_force_b_",
    ];
    let others = [&of_three_struts[..], &["thrust_work"]].concat();
    assert_eq!(bench.heading("history.csv", 0), documented_history(&others));
    let tripod = golden().join("expected/three-struts/three-struts-tripod.csv");
    let tripod = fs::read_to_string(tripod).unwrap();
    let heading: Vec<&str> = tripod.lines().next().unwrap().split(',').collect();
    assert_eq!(heading, documented_history(&["gamma_", "alpha_"]));
    let landing: Value = serde_json::from_str(&printed).unwrap();
    let decided = landing["verdict_time_s"].as_f64().unwrap();
    assert!(decided < landing["result"]["end_time_s"].as_f64().unwrap());
    assert_eq!(landing["went_on_to"], "time-expired");
    let of_reports = documented("reports", false);
    for key in landing.as_object().unwrap().keys() {
        let is_described = of_reports.contains(key) || PAGE.contains(&format!("`{key}`"));
        assert!(is_described, "{key} is not described");
    }
    for key in of_reports {
        assert!(!landing[&key].is_null(), "{key}");
    }
}

/// The page of the model says what each column of a history is.
#[test]
fn columns_of_histories_are_in_the_model() {
    let model = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/model.md"));
    let (_, history) = PAGE.split_once("<!-- columns: history -->").unwrap();
    let rows = history
        .lines()
        .skip(3)
        .take_while(|row| row.starts_with('|'));
    let names: Vec<&str> = rows.map(|row| row.split('`').nth(1).unwrap()).collect();
    assert!(names.len() > 30, "{names:?}");
    for name in names {
        assert!(model.contains(&format!("`{name}`")), "{name}");
    }
}

#[test]
fn units_are_those_that_columns_carry() {
    let rows = PAGE.lines().filter(|row| row.starts_with("| `"));
    let cells =
        |row: &str| -> Vec<String> { row.split('|').map(|c| c.trim().to_owned()).collect() };
    let mut checked = 0;
    for row in rows.map(cells).filter(|row| row.len() == 5) {
        let unit_of_row = row[2].replace('·', " ");
        // Words have no unit; that of some columns follows from another column.
        if unit_of_row.is_empty() || unit_of_row.contains("of ") || unit_of_row.contains("per ") {
            continue;
        }
        assert_eq!(unit_of_row, unit(row[1].trim_matches('`')), "{}", row[1]);
        checked += 1;
    }
    assert!(checked > 60, "{checked} units");
}
