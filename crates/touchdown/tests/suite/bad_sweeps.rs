//! Sweeps and vehicles that cannot be used: one clear message, exit code 2, nothing written.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{Bench, SURVEYOR, SWEEP};

/// What is replaced in the sweep file, by what, and what the message must contain.
#[rustfmt::skip]
const SWEEPS: [(&str, &str, &[&str]); 38] = [
    // Unknown, missing and misplaced keys, and wrong units.
    ("friction = 1.0", "frction = 1.0", &["sweep.toml:7: scene.frction = 1.0", "did you mean friction?"]),
    ("slope_deg = 15", "slope_grad = 16", &["sweep.toml:6: scene.slope_grad = 16", "did you mean slope_deg or slope_rad?"]),
    ("friction = 1.0", "", &["sweep.toml:3: scene.friction is missing", "0 ≤ value ≤ 1000, nominal friction coefficient"]),
    ("title", "titel", &["sweep.toml:1: titel", "did you mean title?"]),
    ("[search]", "[serach]", &["sweep.toml:10: serach", "did you mean search?"]),
    ("tolerance_fps = 0.1", "", &["sweep.toml:10: search.tolerance_fps is missing"]),
    ("friction = 1.0", "horizontal_velocity_fps = 3", &["scene.horizontal_velocity_fps = 3", "[search]"]),
    ("friction = 1.0", "friction = 1.0\nroll_deg = 0", &["axes.roll_deg", "also in [scene]"]),
    ("roll_deg", "rol_deg", &["sweep.toml:9: axes.rol_deg", "did you mean roll_deg?"]),
    // Wrong types and numbers that are none.
    ("slope_deg = 15", "slope_deg = \"15\"", &["sweep.toml:6: scene.slope_deg = \"15\"", "a number"]),
    ("slope_deg = 15", "slope_deg = nan", &["sweep.toml:6: scene.slope_deg = nan", "finite"]),
    ("to_fps = 12.5", "to_fps = inf", &["sweep.toml:12: search.to_fps = inf", "finite"]),
    ("slope_deg = 15", "slope_deg = ", &["sweep.toml:6: not TOML"]),
    ("vehicle = \"surveyor.toml\"", "vehicle = 3", &["sweep.toml:2: vehicle = 3", "text in quotes"]),
    ("vehicle = \"surveyor.toml\"", "vehicle = \"x.toml\"", &["sweep.toml:2: vehicle = \"x.toml\"", "no file"]),
    // Values out of range.
    ("friction = 1.0", "friction = -0.1", &["sweep.toml:7: scene.friction = -0.1", "0 ≤ value"]),
    ("slope_deg = 15", "slope_deg = 90", &["sweep.toml:6: scene.slope_deg = 90", "< 90"]),
    ("step = 10", "step = -10", &["sweep.toml:9: axes.roll_deg.step = -10", "sign of to - from"]),
    ("step = 10", "step = 7", &["sweep.toml:9: axes.roll_deg.step = 7", "pass over to = 10", "to = 4 or 11"]),
    ("from = -10", "from = 10", &["sweep.toml:9: axes.roll_deg.from = 10", "other than to"]),
    ("{ from = -10, to = 10, step = 10 }", "[]", &["sweep.toml:9: axes.roll_deg = []", "at least one"]),
    ("roll_deg = { from = -10, to = 10, step = 10 }", "", &["sweep.toml:8: axes", "at least one"]),
    ("scan_step_fps = 1.25", "scan_step_fps = 1.25\nkeep_deg = 31", &["sweep.toml:14: search.keep_deg = 31", "0 ≤ value ≤ 30"]),
    ("scan_step_fps = 1.25", "scan_step_fps = 1.25\nparts_below = 0", &["sweep.toml:14: search.parts_below = 0", "1 ≤ value ≤ 100"]),
    ("scan_step_fps = 1.25", "scan_step_fps = 1.25\nparts_below = 2.5", &["search.parts_below = 2.5", "a whole number"]),
    ("from_fps = 10", "from_fps = 12.5", &["sweep.toml:11: search.from_fps = 12.5", "below to_fps"]),
    ("scan_step_fps = 1.25", "scan_step_fps = 0", &["sweep.toml:13: search.scan_step_fps = 0", "0 < value"]),
    ("tolerance_fps = 0.1", "tolerance_fps = 0.1\nbands = \"both\"", &["sweep.toml:15: search.bands = \"both\"", "\"first\" or \"all\""]),
    ("tolerance_fps = 0.1", "tolerance_fps = 0.1\nbands = 2", &["sweep.toml:15: search.bands = 2", "text in quotes"]),
    ("tolerance_fps = 0.1", "tolerance_fps = 2", &["sweep.toml:14: search.tolerance_fps = 2", "≤ scan_step_fps"]),
    ("tolerance_fps = 0.1", "tolerance_fps = 0.1\n[solver]\ntolerance = 1", &["sweep.toml:16: solver.tolerance = 1", "1e-12 ≤ value ≤ 1e-2"]),
    ("tolerance_fps = 0.1", "tolerance_fps = 0.1\n[solver]\ncrush_rule = \"soft\"", &["sweep.toml:16: solver.crush_rule = \"soft\"", "\"section\""]),
    // What would be ignored, and what is wrong in an axis.
    ("tolerance_fps = 0.1", "tolerance_fps = 0.1\n[solver]\n[solver.error_per_second]\nvelocity_fps = 1", &["sweep.toml:16: solver.error_per_second", "method located does not use it"]),
    (", step = 10 }\n[search]", " }\n[sample]\ndesign = \"sobol\"\ncount = 4\nseed = 1\nstop_at_interval_width = 0.1\n[search]", &["sweep.toml:14: sample.stop_at_interval_width = 0.1", "job = \"outcome\" only"]),
    (", step = 10 }\n[search]", " }\n[sample]\ndesign = \"sobol\"\ncount = 4\nseed = 1\nstop_at_interval_width = 0\n[search]", &["sweep.toml:14: sample.stop_at_interval_width = 0", "0 < value < 1"]),
    (", step = 10 }\n[search]", " }\n[sample]\ndesign = \"sobol\"\ncount = 4\nseed = 1\nstop_at_interval_width = 1\n[search]", &["sweep.toml:14: sample.stop_at_interval_width = 1", "0 < value < 1"]),
    ("[axes]", "[solver]\nmethod = \"rk4\"\n[axes]\nsolver.interval_s = [5, 0.01]", &["sweep.toml:11: axes.solver.interval_s = [5, 0.01]: at solver.interval_s = 5: solver.interval_s = 5: expected 1e-6"]),
    ("vehicle = \"surveyor.toml\"", "vehicle = \".\"", &["sweep.toml:2: vehicle = \".\": . is a folder"]),
];

/// All keys without default are asked for at once, those that vary excepted; a title is that of the file.
#[test]
fn missing_keys_are_named_all_at_once() {
    let bench = Bench::new();
    bench.write(
        "sweep.toml",
        "[axes]\nfriction = [0.5, 1]\nsearch.scan_step_fps = [1, 2]\n",
    );
    let names = [
        "vehicle",
        "scene.vertical_velocity_fps",
        "scene.cross_slope_deg",
        "scene.slope_deg",
        "search.from_fps",
        "search.to_fps",
        "search.tolerance_fps",
    ];
    let done = bench.run(&["sweep", "sweep.toml"]);
    done.refused(&["sweep.toml:1: 7 keys are missing:"]);
    let listed = done.err.lines().filter_map(|line| line.strip_prefix("  "));
    let listed: Vec<&str> = listed.filter_map(|line| line.split(':').next()).collect();
    assert_eq!(listed, names);
    bench.write("sweep.toml", "job = \"outcome\"\n[scene]\nslope_deg = 1\n");
    let outcome = bench.run(&["sweep", "sweep.toml"]);
    outcome.refused(&[
        "scene.horizontal_velocity_fps: ",
        "\n  axes: a table [axes]",
    ]);
    assert!(!outcome.err.contains("search."), "{}", outcome.err);
    bench.write("untitled.toml", &SWEEP.replacen("title", "#", 1));
    let untitled = bench.run(&["sweep", "untitled.toml", "--dry-run"]);
    assert!(untitled.out.starts_with("untitled\n"), "{}", untitled.out);
}

/// The same for the vehicle file.
#[rustfmt::skip]
const VEHICLES: [(&str, &str, &[&str]); 9] = [
    ("mass_slug = 20", "mass_slug = -20", &["surveyor.toml:4: mass_slug = -20", "0 < value"]),
    ("mass_slug = 20", "mass_lb = 643", &["surveyor.toml:4: mass_lb = 643", "did you mean mass_slug or mass_kg?"]),
    ("xy = 6.81", "xy = 400", &["surveyor.toml:8: inertia_slug_ft2", "positive definite"]),
    ("zz = 145.78", "zz = -1", &["surveyor.toml:11: inertia_slug_ft2.zz = -1", "0 < value"]),
    ("preload_lb = 185", "preload_lb = inf", &["surveyor.toml:27: strut.preload_lb = inf", "finite"]),
    ("[0, 0.1, 5.75, 7.75]", "[0, 5.75, 0.1, 7.75]", &["surveyor.toml:61: block.profile.interference_in[3] = 0.1", "increasing"]),
    ("[0, 0.1, 5.75, 7.75]\nrelative_pressure = [0, 1, 1, 21]", "[0]\nrelative_pressure = [0]", &["surveyor.toml:61: block.profile.interference_in = [0]", "at least two"]),
    ("[[legs]]\nazimuth_deg = 240", "", &["surveyor.toml:66: legs", "2 legs", "three to eight tables [[legs]]"]),
    ("azimuth_deg = 240", "azimuth_deg = 240\n[legs.strut]\npreload_lb = -5", &["surveyor.toml:75: legs[3].strut.preload_lb = -5", "0 < value"]),
];

fn refuse(bench: &Bench, fragments: &[&str]) {
    bench.run(&["sweep", "sweep.toml"]).refused(fragments);
    assert_eq!(bench.list("results"), Vec::<String>::new(), "{fragments:?}");
}

#[test]
fn bad_sweep_files_are_refused() {
    for (right, wrong, fragments) in SWEEPS {
        let bench = Bench::new();
        assert!(SWEEP.contains(right), "{right}");
        bench.write("sweep.toml", &SWEEP.replacen(right, wrong, 1));
        refuse(&bench, fragments);
    }
}

#[test]
fn bad_vehicle_files_are_refused() {
    for (right, wrong, fragments) in VEHICLES {
        let bench = Bench::new();
        assert!(SURVEYOR.contains(right), "{right}");
        bench.write("surveyor.toml", &SURVEYOR.replacen(right, wrong, 1));
        refuse(&bench, fragments);
    }
}

#[test]
fn one_bad_file_among_several_stops_all_before_the_first_landing() {
    let bench = Bench::new();
    bench.write("bad.toml", "title = 3");
    bench
        .run(&["sweep", "sweep.toml", "bad.toml"])
        .refused(&["bad.toml:1: title = 3"]);
    assert_eq!(bench.list("results"), Vec::<String>::new());
    bench
        .run(&["sweep", "sweep.toml", "./sweep.toml"])
        .refused(&["same name"]);
    bench
        .run(&["sweep", "none.toml"])
        .refused(&["none.toml: cannot be read"]);
}

#[test]
fn a_folder_without_sweep_files_is_refused() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("empty")).unwrap();
    bench
        .run(&["sweep", "empty"])
        .refused(&["empty: has no sweep files", "*.toml"]);
}

#[test]
fn an_output_folder_that_cannot_be_written_is_refused() {
    let bench = Bench::new();
    bench.write("file", "");
    bench
        .run(&["sweep", "sweep.toml", "--out", "file/results"])
        .refused(&[
            "file/results: output folder cannot be written",
            "expected a writable folder",
        ]);
}
