//! Soil from where the user stands: by name, by numbers, as an axis, in reports and records.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::collections::BTreeMap;

use serde_json::Value;

use crate::common::{BASELINE, Bench};

/// A touchdown on soil, by a line of the table [scene].
fn scene(soil: &str) -> String {
    format!(
        "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_mps = 4.3\nhorizontal_velocity_mps = 2\n\
         cross_slope_deg = 180\nslope_deg = 12\nfriction = 0.7\n{soil}\n[solver]\nrules = \"physical\"\n"
    )
}

/// Cells of a table's row by their headings.
fn row(table: &str, index: usize) -> BTreeMap<&str, &str> {
    let mut lines = table.lines().map(|line| line.split(','));
    let heading = lines.next().unwrap();
    heading.zip(lines.nth(index).unwrap()).collect()
}

/// Outcome and greatest sinkage of footpad 1, ft, on this soil.
fn landed(bench: &Bench, soil: &str) -> (String, f64) {
    bench.write("scene.toml", &scene(soil));
    let done = bench.run(&["land", "scene.toml", "--out", "out"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("out/scene.csv");
    let cells = row(&table, 0);
    let outcome = cells["outcome"].to_owned();
    (outcome, cells["max_sinkage_1_ft"].parse().unwrap())
}

#[test]
fn a_soil_by_name_is_its_numbers_and_rock_is_none() {
    let bench = Bench::new();
    let named = landed(&bench, "soil = \"surveyor-3\"");
    let numbers = "soil = { bearing_strength_kpa = 55, bearing_depth_cm = 5, rebound = 0.004 }";
    assert_eq!(landed(&bench, numbers), named);
    assert!(named.1 > 0.05, "{named:?}");
    let rock = landed(&bench, "");
    assert_eq!(landed(&bench, "soil = \"rock\""), rock);
    assert_eq!(rock.1, 0.0);
    // Weaker soil, deeper prints.
    let weaker = landed(&bench, "soil = \"surveyor-7\"");
    assert!(weaker.1 > 1.3 * named.1, "{weaker:?}");
    // Soil that resists being pushed aside, another landing; 515.379 kg/m³ are 1 slug/ft³.
    let dragging = |key: &str| landed(&bench, &numbers.replace(" }", &format!(", {key} }}")));
    let drag = dragging("inertial_drag_kg_m3 = 1546.1364549595883");
    let same = dragging("inertial_drag_slug_ft3 = 3");
    assert!((drag.1 - same.1).abs() < 1e-9, "{drag:?} {same:?}");
    assert!((drag.1 - named.1).abs() > 1e-5, "{drag:?} {named:?}");
}

#[test]
fn reports_and_histories_tell_sinkage_on_soil_alone() {
    let bench = Bench::new();
    let soil = [
        "--set",
        "soil.bearing_strength_psf=440",
        "--set",
        "soil.bearing_depth_ft=0.16",
        "--set",
        "soil.rebound=0.004",
    ];
    for (soil, is_told) in [(&soil[..], true), (&[], false)] {
        let history = ["--units", "SI", "--history", "history.csv"];
        let done = bench.run(&[&BASELINE[..], soil, &history].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let has_line = done.out.contains("greatest sinkage, m ");
        assert_eq!(has_line, is_told, "{}", done.out);
        let history = bench.read("history.csv");
        assert_eq!(history.contains("pad_sinkage_3_m,"), is_told);
    }
}

/// An option names a soil; `--set` replaces a number of it.
#[test]
fn a_soil_is_named_on_the_command_line() {
    let bench = Bench::new();
    let landed = |soil: &[&str]| {
        let done = bench.run(&[&BASELINE[..], soil].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        done.out
    };
    let firm = ["--soil", "surveyor-3"];
    let weak = ["--soil", "surveyor-7"];
    assert_eq!(landed(&["--soil", "rock"]), landed(&[]));
    assert_ne!(landed(&weak), landed(&firm));
    let strengthened = ["--set", "soil.bearing_strength_kpa=55"];
    assert_eq!(landed(&[weak, strengthened].concat()), landed(&firm));
    let refused = bench.run(&[&BASELINE[..], &["--soil", "regolith"]].concat());
    refused.refused(&["regolith", "rock, surveyor-1, surveyor-3"]);
}

#[rustfmt::skip]
const REFUSED: [(&str, &str); 8] = [
    ("soil = \"regolith\"", "\"rock\", \"surveyor-1\", \"surveyor-3\""),
    ("soil = 3", "a table"),
    ("soil = { bearing_strength_kpa = 55 }", "bearing_depth_ft"),
    ("soil = { bearing_strength_kpa = -1, bearing_depth_cm = 5, rebound = 0.004 }", "bearing_strength_kpa"),
    ("soil = { bearing_strength_kpa = 55, bearing_depth_cm = 5, bearing_exponent = 2, rebound = 0.9 }", "unloading is steeper than sinking"),
    ("soil = { cohesion = 1 }", "cohesion"),
    ("soil = { bearing_strength_kpa = 55, bearing_depth_cm = 5, rebound = 0.004, inertial_drag_kg_m3 = -1 }", "inertial_drag_kg_m3"),
    ("soil = { inertial_drag_kg_m3 = 1500 }", "bearing_strength_psf"),
];

#[test]
fn soil_that_cannot_be_is_refused_with_what_is_allowed() {
    let bench = Bench::new();
    for (soil, told) in REFUSED {
        bench.write("scene.toml", &scene(soil));
        let done = bench.run(&["land", "scene.toml", "--out", "out"]);
        assert_eq!(done.code, Some(2), "{soil}: {}", done.err);
        let is_told = done.err.contains(told) && done.err.contains("scene.toml");
        assert!(is_told, "{soil}: {}", done.err);
    }
}

/// An axis replaces the strength of a soil given by name.
#[test]
fn strength_is_an_axis() {
    let bench = Bench::new();
    let (head, solver) = scene("soil = \"surveyor-7\"")
        .split_once("[solver]")
        .map(|(head, solver)| (head.to_owned(), solver.to_owned()))
        .unwrap();
    let axes = "[axes]\nsoil.bearing_strength_kpa = [21, 55, 1000000]\n";
    bench.write(
        "soils.toml",
        &format!("job = \"outcome\"\n{head}{axes}[solver]{solver}tolerance = 1e-6\n"),
    );
    let done = bench.run(&["sweep", "soils.toml", "--out", "out"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("out/soils.csv");
    let sinkage = |index| -> f64 { row(&table, index)["max_sinkage_1_ft"].parse().unwrap() };
    let alone = |soil: &str| landed(&bench, soil).1;
    assert!((sinkage(0) - alone("soil = \"surveyor-7\"")).abs() < 1e-6);
    assert!((sinkage(1) - alone("soil = \"surveyor-3\"")).abs() < 1e-6);
    assert!(sinkage(2) < 1e-4);
    let record: Value = serde_json::from_str(&bench.read("out/soils.json")).unwrap();
    let scene = &record["input"]["scene"];
    assert_eq!(scene["soil.rebound"], 0.004);
    // A name leaves out what has its default, so that records of before are those of now.
    assert!(scene["soil.inertial_drag_slug_ft3"].is_null());
    assert!(scene["soil.bearing_depth_ft"].as_f64().unwrap() > 0.16);
}
