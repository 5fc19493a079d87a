//! Results in SI units: the same numbers times the factors of the units, in tables, records, reports and pictures.

#![allow(missing_docs, reason = "tests are not an interface")]

use serde_json::Value;
use touchdown_sweep::output_units::OutputUnits;

use crate::common::{BASELINE, Bench, Done, SWEEP};

const FOOT: f64 = 0.3048;
const POUND: f64 = 4.4482216152605;
/// Endings of columns in US and in SI units, and how many of the latter one of the former is; those first that end with
/// another.
const FACTORS: [(&str, &str, f64); 5] = [
    ("_fps", "_mps", FOOT),
    ("_ftlb", "_j", POUND * FOOT),
    ("_ft", "_m", FOOT),
    ("_lb", "_n", POUND),
    ("_fps_per_unit", "_mps_per_unit", FOOT),
];

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

fn run(bench: &Bench, arguments: &[&str]) -> Done {
    let done = bench.run(arguments);
    assert_eq!(done.code, Some(0), "{arguments:?}: {}", done.err);
    done
}

/// Name and factor of a column in SI.
fn in_si(column: &str) -> (String, f64) {
    let found = (FACTORS.iter()).find_map(|(us, si, factor)| {
        let bare = column.strip_suffix(us)?;
        Some((format!("{bare}{si}"), *factor))
    });
    found.unwrap_or_else(|| (column.to_owned(), 1.0))
}

fn assert_is(si: &str, us: &str, factor: f64, place: &str) {
    match (si.parse::<f64>(), us.parse::<f64>()) {
        (Ok(si), Ok(us)) => {
            let expected = us * factor;
            let error = (si - expected).abs();
            assert!(
                error <= 4.0 * f64::EPSILON * expected.abs(),
                "{place}: {us} gives {si}"
            );
        }
        _ => assert_eq!(si, us, "{place}"),
    }
}

/// Checks every cell of a table. The columns `of_parameter` are in the unit of the parameter that another column names.
fn compare(us: &str, si: &str, of_parameter: &[&str], parameter: &str) {
    let rows = |text: &str| -> Vec<Vec<String>> {
        let rows = text.lines();
        rows.map(|row| row.split(',').map(str::to_owned).collect())
            .collect()
    };
    let (us, si) = (rows(us), rows(si));
    assert_eq!(us.len(), si.len());
    let heading = &us[0];
    let named: Vec<String> = heading.iter().map(|name| in_si(name).0).collect();
    assert_eq!(si[0], named);
    let parameter = heading.iter().position(|name| name == parameter);
    for (row, (us, si)) in us.iter().zip(&si).enumerate().skip(1) {
        for (column, name) in heading.iter().enumerate() {
            let place = format!("row {row}, {name}");
            let own = parameter.map_or(1.0, |column| in_si(&us[column]).1);
            if Some(column) == parameter {
                assert_eq!(si[column], in_si(&us[column]).0);
            } else if name == "unit" {
                assert!(us[column] != "ft" || si[column] == "m", "{place}");
            } else if of_parameter.contains(&name.as_str()) {
                assert_is(&si[column], &us[column], own, &place);
            } else {
                let per = if name.ends_with("_per_unit") {
                    own
                } else {
                    1.0
                };
                assert_is(&si[column], &us[column], in_si(name).1 / per, &place);
            }
        }
    }
}

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
    // Earlier results in the other units are results all the same.
    run(
        &bench,
        &["sweep", "sweep.toml", "--out", "si", "--units", "US"],
    );
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

#[test]
fn landings_come_out_in_si() {
    let bench = Bench::new();
    let land = |more: &[&str]| run(&bench, &[&BASELINE, more].concat()).out;
    let table = |name: &str, more: &[&str]| {
        land(&[&["--history", name], more].concat());
        bench.read(name)
    };
    compare(
        &table("us.csv", &[]),
        &table("si.csv", &["--units", "si"]),
        &[],
        "",
    );
    let text = land(&["--units", "SI"]);
    assert!(
        text.contains("vertical_velocity_mps 4.2672, horizontal_velocity_mps 3.429"),
        "{text}"
    );
    for unit in [" ft", "lb"] {
        assert!(!text.contains(unit), "{text}");
    }
    let json = |more: &[&str]| -> Value {
        serde_json::from_str(&land(&[&["--json"], more].concat())).unwrap()
    };
    let (us, si) = (json(&[]), json(&["--units", "SI"]));
    for part in ["/scene", "/result", "/work_by_leg/1", ""] {
        let [us, si] = [&us, &si].map(|report| report.pointer(part).unwrap().as_object().unwrap());
        assert_eq!(us.len(), si.len());
        for (name, value) in us.iter().filter(|(_, value)| value.is_f64()) {
            let (named, factor) = in_si(name);
            assert_is(&si[&named].to_string(), &value.to_string(), factor, name);
        }
    }
    // Velocities may be given in m/s.
    let given = [
        &["land", "--vehicle", "surveyor.toml"][..],
        &[
            "--vertical-velocity-mps=4.2672",
            "--horizontal-velocity-mps",
            "3.429",
        ],
        &BASELINE[6..],
    ];
    assert_eq!(run(&bench, &given.concat()).out, land(&[]));
    let given = [given[0], &["--vertical-velocity-mps=-1"], &BASELINE[4..]].concat();
    let said =
        ["--vertical-velocity-mps = -1: expected 0 ≤ value ≤ 10000 (in ft/s: this is -3.28084)"];
    bench.run(&given).refused(&said);
    let both = [&BASELINE[..], &["--vertical-velocity-mps=4"]].concat();
    bench
        .run(&both)
        .refused(&["--vertical-velocity", "cannot be used with"]);
}

#[test]
fn cases_come_out_in_si() {
    let bench = Bench::new();
    let scene = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
                 horizontal_velocity_fps = 3\ncross_slope_deg = 180\nslope_deg = 15\nfriction = 1\n";
    bench.write("us.toml", scene);
    bench.write("si.toml", &format!("units = \"SI\"\n{scene}"));
    let landed = ["us", "si"].map(|name| {
        let printed = run(
            &bench,
            &["land", &format!("{name}.toml"), "--out", "landed"],
        )
        .out;
        let tables = ["", "-1"].map(|end| bench.read(&format!("landed/{name}{end}.csv")));
        (printed, tables)
    });
    let [(us_printed, us), (si_printed, si)] = landed;
    assert!(
        us_printed.contains("clearance, ft  strut force, lb"),
        "{us_printed}"
    );
    assert!(
        si_printed.contains("clearance, m  strut force, N"),
        "{si_printed}"
    );
    for (us, si) in us.iter().zip(&si) {
        compare(us, si, &[], "");
    }
    run(
        &bench,
        &["land", "si.toml", "--out", "again", "--units", "US"],
    );
    assert_eq!(bench.read("again/si-1.csv"), us[1]);

    bench.write(
        "cases.csv",
        "vertical_velocity_mps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction\n4.2672,3,180,15,1\n",
    );
    let table = [
        "land",
        "--vehicle",
        "surveyor.toml",
        "--cases",
        "cases.csv",
        "--out",
    ];
    run(&bench, &[&table[..], &["one.csv"]].concat());
    run(
        &bench,
        &[&table[..], &["two.csv", "--units", "SI"]].concat(),
    );
    compare(&bench.read("one.csv"), &bench.read("two.csv"), &[], "");
}

#[test]
fn pictures_have_the_units_of_their_tables() {
    let bench = Bench::new();
    run(
        &bench,
        &["sweep", "sweep.toml", "--out", "si", "--units", "SI"],
    );
    run(&bench, &["sweep", "sweep.toml", "--out", "us"]);
    let drawn = bench.read("si/sweep.svg");
    run(&bench, &["plot", "si/sweep.csv"]);
    assert_eq!(bench.read("si/sweep.svg"), drawn);
    assert!(drawn.contains("vertical velocity 4.2672 m/s") && !drawn.contains("ft/s"));
    std::fs::copy(bench.path("us/sweep.json"), bench.path("si/sweep.json")).unwrap();
    bench.run(&["plot", "si/sweep.csv"]).refused(&[
        "si/sweep.csv",
        "record: expected speeds in m/s, as in the table",
    ]);

    for (name, units) in [("us.csv", "US"), ("si.csv", "SI")] {
        run(
            &bench,
            &[&BASELINE[..], &["--history", name, "--units", units]].concat(),
        );
    }
    run(&bench, &["plot", "si.csv"]);
    let drawn = bench.read("si.svg");
    for title in [
        "Velocity, m/s",
        "Strut force, N",
        "Footpad load, N",
        "Energy, J",
    ] {
        assert!(drawn.contains(title), "{title}");
    }
    run(
        &bench,
        &[
            "plot",
            "si.csv",
            "--columns",
            "stroke_#_m",
            "--out",
            "strokes.svg",
        ],
    );
    bench
        .run(&["plot", "us.csv", "si.csv", "--out", "both.svg"])
        .refused(&["expected histories in the same units"]);
}

#[test]
fn surfaces_come_out_in_si() {
    let bench = Bench::new();
    let told = |velocity: &str, more: &[&str]| {
        let given = [
            "surface",
            "--vehicle",
            "surveyor.toml",
            velocity,
            "--friction",
            "0.8",
        ];
        let times = ["--impact-times", "0,0.21,0.17"];
        run(&bench, &[&given[..], &times, more].concat()).out
    };
    let us: Value = serde_json::from_str(&told("--velocity=0,3,14", &["--json"])).unwrap();
    let si: Value = serde_json::from_str(&told(
        "--velocity-mps=0,0.9144,4.2672",
        &["--json", "--units", "SI"],
    ))
    .unwrap();
    assert_eq!(us["slope_deg"], si["slope_deg"]);
    let pair = |us: &Value, si: &Value, name: &str| {
        assert_is(&si.to_string(), &us.to_string(), FOOT, name);
    };
    pair(
        &us["horizontal_velocity_fps"],
        &si["horizontal_velocity_mps"],
        "velocity",
    );
    pair(
        &us["impact_points_ft"][1][2],
        &si["impact_points_m"][1][2],
        "point",
    );
    let text = told("--velocity=0,3,14", &["--units", "SI"]);
    assert!(
        text.contains("4.267200 m/s") && !text.contains("ft"),
        "{text}"
    );
    let given = [
        "surface",
        "--vehicle",
        "surveyor.toml",
        "--friction=1",
        "--impact-times=0,0.21,0.17",
    ];
    bench.run(&given).refused(&["--velocity"]);
    let wrong = [&given[..], &["--velocity-mps=0,0,-3.048"]].concat();
    bench
        .run(&wrong)
        .refused(&["--velocity-mps: expected", "(in ft/s: this is -10)"]);
}

#[test]
fn every_column_with_a_unit_comes_out_in_si() {
    const PAGE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/output.md"));
    let mut converted = 0;
    for row in PAGE.lines().filter(|row| row.starts_with("| `")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let [_, column, unit, _, _] = cells[..] else {
            continue;
        };
        let column = column.trim_matches('`');
        let quantity = OutputUnits::Si.quantity(column);
        let (name, _) = in_si(column);
        assert_eq!(quantity.name(), name);
        // Nothing else has a unit of length or force.
        assert_eq!(
            name != column,
            unit.contains("ft") || unit.contains("lb"),
            "{column}, {unit}"
        );
        converted += usize::from(name != column);
    }
    assert!(converted > 40, "{converted} columns");
}
