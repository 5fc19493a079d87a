//! Sweeps, maps and samples, with all that they leave.

use serde_json::Value;

use super::{compare, run};
use crate::common::{Bench, SWEEP};

/// All bands over the vertical velocity and a preload, with sensitivities.
fn boundary() -> String {
    SWEEP
        .replace("vertical_velocity_fps = 14\n", "")
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "vertical_velocity_fps = [13.5, 14]\nvehicle.strut.preload_lb = [150, 185]",
        )
        .replace(
            "tolerance_fps = 0.1",
            "tolerance_fps = 0.01\nbands = \"all\"",
        )
        + "[sensitivity]\nparameters = [\"friction\", \"vehicle.block.height_ft\"]\n"
}

/// Landings with random velocities.
const OUTCOME: &str = r#"title = "Landings"
job = "outcome"
vehicle = "surveyor.toml"
[scene]
cross_slope_deg = 180
slope_deg = 15
friction = 1.0
[axes]
vertical_velocity_fps = { mean = 14, sd = 1 }
horizontal_velocity_fps = { from = 8, to = 14 }
[sample]
design = "sobol"
count = 16
seed = 1
"#;

#[test]
fn tables_of_sweeps_are_those_in_us_units_times_the_factors() {
    let bench = Bench::new();
    for (name, text) in [("boundary", boundary()), ("outcome", OUTCOME.to_owned())] {
        bench.write(&format!("{name}.toml"), &text);
        let file = format!("{name}.toml");
        run(
            &bench,
            &["sweep", &file, "--out", "us", "--format", "parquet"],
        );
        let printed = run(
            &bench,
            &[
                "sweep", &file, "--out", "si", "--format", "parquet", "--units", "SI",
            ],
        );
        assert!(!printed.out.contains("ft/s"), "{}", printed.out);
    }
    let read =
        |table: &str| ["us", "si"].map(|folder| bench.read(&format!("{folder}/{table}.csv")));
    for table in ["boundary", "boundary-bands", "outcome"] {
        let [us, si] = read(table);
        compare(&us, &si, &[], "");
    }
    let [us, si] = read("boundary-sensitivity");
    compare(&us, &si, &["value", "step", "span"], "parameter");
    let [us, si] = read("outcome-probabilities");
    compare(&us, &si, &["from", "to"], "axis");

    let record = |folder: &str| -> Value {
        serde_json::from_str(&bench.read(&format!("{folder}/boundary.json"))).unwrap()
    };
    let (us, si) = (record("us"), record("si"));
    assert_eq!(us["input_fingerprint"], si["input_fingerprint"]);
    assert_eq!(us["counts"], si["counts"]);
    assert_eq!(si["input"]["search"]["to_mps"], 3.81);
    assert_eq!(si["input"]["axes"]["vertical_velocity_mps"][1], 4.2672);
    assert_eq!(si["input"]["sensitivity"][1], "vehicle.block.height_m");
    // The picture and the Parquet file of a table have its units.
    let picture = bench.read("si/boundary-contours.svg");
    assert!(picture.contains("m/s") && !picture.contains("ft/s"));
    let parquet = std::fs::read(bench.path("si/boundary.parquet")).unwrap();
    let has = |name: &str| {
        parquet
            .windows(name.len())
            .any(|part| part == name.as_bytes())
    };
    assert!(has("first_transition_mps") && !has("first_transition_fps"));
}

#[test]
fn a_file_asks_for_si_and_the_option_wins() {
    let bench = Bench::new();
    run(&bench, &["sweep", "sweep.toml", "--out", "us"]);
    let asked = SWEEP.replace("vehicle =", "units = \"SI\"\nvehicle =");
    bench.write("sweep.toml", &asked);
    let printed = run(&bench, &["sweep", "sweep.toml", "--out", "si"]);
    assert!(
        printed.out.contains(" m/s (unstable) at roll_deg"),
        "{}",
        printed.out
    );
    let us = bench.read("us/sweep.csv");
    compare(&us, &bench.read("si/sweep.csv"), &[], "");
    // Those in the other units are replaced when told to.
    let in_us = ["sweep", "sweep.toml", "--out", "si", "--units", "US"];
    bench
        .run(&in_us)
        .refused(&["si/sweep.csv: holds results of other input"]);
    run(&bench, &[&in_us[..], &["--overwrite"]].concat());
    for file in ["sweep.csv", "sweep.json", "sweep.svg"] {
        assert_eq!(
            bench.read(&format!("si/{file}")),
            bench.read(&format!("us/{file}"))
        );
    }
    bench.write("sweep.toml", &asked.replace("\"SI\"", "\"metric\""));
    let said = ["sweep.toml:2: units = \"metric\": expected \"US\" or \"SI\""];
    bench
        .run(&["sweep", "sweep.toml", "--out", "no"])
        .refused(&said);
    assert_eq!(bench.list("no"), Vec::<String>::new());
}

#[test]
fn records_have_thrust_and_footing_in_si() {
    let bench = Bench::new();
    let sweep = SWEEP
        .replace(
            "friction = 1.0\n",
            "friction = 1.0\nthrust = { time_s = [0, 0.5], force_lb = [100, 0], offset_x_ft = 0.1 }\n",
        )
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "\"footing[2].height_ft\" = [0, 0.1]",
        );
    bench.write("sweep.toml", &sweep);
    run(
        &bench,
        &["sweep", "sweep.toml", "--out", "si", "--units", "SI"],
    );
    let record: Value = serde_json::from_str(&bench.read("si/sweep.json")).unwrap();
    let scene = &record["input"]["scene"];
    assert_eq!(scene["thrust.time_s"], serde_json::json!([0.0, 0.5]));
    assert_eq!(scene["thrust.force_n"][0], 444.82216152605);
    assert_eq!(scene["thrust.offset_x_m"], 0.03048);
    assert!(
        bench
            .read("si/sweep.csv")
            .starts_with("footing[2].height_m,")
    );
    assert!(
        bench
            .read("si/sweep.svg")
            .contains("Footing height, leg 2, m")
    );
}

#[test]
fn shards_of_any_units_give_the_same_bytes() {
    const FILES: [&str; 3] = ["sweep.csv", "sweep.json", "sweep.svg"];
    let bench = Bench::new();
    let files = |folder: &str| FILES.map(|file| bench.read(&format!("{folder}/{file}")));
    run(
        &bench,
        &["sweep", "sweep.toml", "--out", "whole", "--units", "SI"],
    );
    for (folder, of_shards, of_merge) in [
        ("told-to-shards", &["--units", "SI"][..], &[][..]),
        ("told-to-merge", &[], &["--units", "SI"]),
    ] {
        for shard in ["1/2", "2/2"] {
            let sweep = ["sweep", "sweep.toml", "--out", folder, "--shard", shard];
            run(&bench, &[&sweep, of_shards].concat());
        }
        run(&bench, &[&["merge", folder], of_merge].concat());
        assert_eq!(files(folder), files("whole"), "{folder}");
    }
    // Once more from the same journals, in the units in which the shards were computed.
    let merged = ["merge", "told-to-merge", "--out", "again"];
    run(&bench, &merged);
    run(&bench, &["sweep", "sweep.toml", "--out", "us"]);
    assert_eq!(files("again"), files("us"));
}

#[test]
fn maps_come_out_in_si() {
    let bench = Bench::new();
    let map = SWEEP.replace("vertical_velocity_fps = 14\n", "").replace(
        "roll_deg = { from = -10, to = 10, step = 10 }",
        "vertical_velocity_fps = [12, 14]\nroll_deg = [20, 40]\n[map]\n\
             edge_width = { vertical_velocity_fps = 1, roll_deg = 10 }\nerror_fps = 0.5",
    );
    bench.write("map.toml", &map);
    run(&bench, &["sweep", "map.toml", "--out", "us"]);
    run(
        &bench,
        &["sweep", "map.toml", "--out", "si", "--units", "SI"],
    );
    for table in ["map", "map-edges", "map-grid", "map-surface"] {
        let [us, si] = ["us", "si"].map(|folder| bench.read(&format!("{folder}/{table}.csv")));
        compare(&us, &si, &[], "");
    }
    run(&bench, &["plot", "si/map-surface.csv", "--out", "map.svg"]);
    let picture = bench.read("map-contours.svg");
    assert!(picture.contains("m/s") && !picture.contains("ft/s"));
    let told = run(
        &bench,
        &[
            "sweep",
            "map.toml",
            "--out",
            "new",
            "--dry-run",
            "--units",
            "SI",
        ],
    );
    assert!(
        told.out.contains("vertical_velocity_mps: 3.6576, 4.2672"),
        "{}",
        told.out
    );
    assert!(
        told.out.contains("errors are below 0.1524 m/s"),
        "{}",
        told.out
    );
}

#[test]
fn distributions_come_out_in_si() {
    let bench = Bench::new();
    let sample = SWEEP.replace("friction = 1.0\n", "").replace(
        "roll_deg = { from = -10, to = 10, step = 10 }",
        "friction = { from = 0.9, to = 1.1 }\n[sample]\ndesign = \"sobol\"\ncount = 4\nseed = 1",
    );
    bench.write("sample.toml", &sample);
    run(&bench, &["sweep", "sample.toml", "--out", "us"]);
    let told = run(
        &bench,
        &["sweep", "sample.toml", "--out", "si", "--units", "SI"],
    );
    assert!(told.out.contains("V_H quantiles, m/s"), "{}", told.out);
    for table in ["sample-quantiles", "sample-distribution"] {
        let [us, si] = ["us", "si"].map(|folder| bench.read(&format!("{folder}/{table}.csv")));
        compare(&us, &si, &[], "");
    }
    let picture = bench.read("si/sample-distribution.svg");
    assert!(picture.contains(", m/s") && !picture.contains("ft/s"));
}
