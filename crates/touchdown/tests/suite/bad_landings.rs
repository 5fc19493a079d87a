//! Landings and cases that cannot be used: one clear message, exit code 2, nothing written.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{BASELINE, Bench, LAND_CASES};

const HEADING: &str = "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,\
                       pitch_deg,yaw_deg,roll_deg,slope_deg,friction";
const GOOD: &str = "1,14,11,180,0,0,0,15,1";

/// Options added to the baseline's, and what the message must contain.
#[rustfmt::skip]
const OPTIONS: [(&[&str], &[&str]); 12] = [
    (&["--roll", "nan"], &["nan", "--roll", "a finite number"]),
    (&["--pitch", "inf"], &["inf", "--pitch", "a finite number"]),
    (&["--block-friction", "-1"], &["--block-friction = -1", "0 ≤ value"]),
    (&["--tip", "5", "--tip-azimuth", "0", "--yaw", "1"], &["--yaw = 1", "not both"]),
    (&["--tip", "5"], &["--tip-azimuth is missing"]),
    (&["--tip", "-5", "--tip-azimuth", "0"], &["--tip = -5", "0 ≤ value ≤ 180"]),
    (&["--angular-velocity", "1,2"], &["--angular-velocity", "x,y,z"]),
    (&["--crush-rule", "soft"], &["soft", "pivot-rate"]),
    (&["--tolerance", "0"], &["--tolerance = 0", "1e-12 ≤ value ≤ 1e-2"]),
    (&["--time-limit", "-1"], &["--time-limit = -1", "10000"]),
    (&["--history", "h.csv", "--interval", "0"], &["--interval = 0"]),
    (&["--history", "surveyor.toml/h.csv"], &["output folder cannot be written"]),
];

/// The rows of a table of cases, and what the message must contain.
#[rustfmt::skip]
const CASES: [(&str, &[&str]); 7] = [
    ("2,14,eleven,180,0,0,0,15,1", &["cases.csv:3: row 2: horizontal_velocity_fps = eleven", "finite"]),
    ("2,14,NaN,180,0,0,0,15,1", &["cases.csv:3: row 2: horizontal_velocity_fps = NaN", "finite"]),
    ("2,14,11,180,0,0,0,15,-1", &["cases.csv:3: row 2: friction = -1", "0 ≤ value ≤ 1000"]),
    ("2,14,11,180,0,0,0,-90,1", &["cases.csv:3: row 2: slope_deg = -90", "-90 < value"]),
    ("2,14,11,180,0,0,0,,1", &["cases.csv:3: row 2: slope_deg is missing"]),
    ("2,14,-11,180,0,0,0,15,1", &["cases.csv:3: row 2: horizontal_velocity_fps = -11", "0 ≤ value ≤ 10000"]),
    ("2,14,11", &["cases.csv:3: not a table"]),
];

#[test]
fn bad_options_are_refused() {
    for (options, fragments) in OPTIONS {
        let bench = Bench::new();
        bench.run(&[&BASELINE, options].concat()).refused(fragments);
        assert_eq!(bench.list("."), ["surveyor.toml", "sweep.toml"]);
    }
}

#[test]
fn conditions_without_default_are_asked_for() {
    let bench = Bench::new();
    for option in [
        "--horizontal-velocity",
        "--cross-slope",
        "--slope",
        "--friction",
    ] {
        let position = BASELINE.iter().position(|word| *word == option).unwrap();
        let rest = [&BASELINE[..position], &BASELINE[position + 2..]].concat();
        bench.run(&rest).refused(&[&format!("{option} is missing")]);
    }
}

#[test]
fn bad_rows_are_refused_before_the_first_landing() {
    for (row, fragments) in CASES {
        let bench = Bench::new();
        bench.write("cases.csv", &format!("{HEADING}\n{GOOD}\n{row}\n"));
        bench.land_cases(&["out.csv"]).refused(fragments);
        assert_eq!(
            bench.list("."),
            ["cases.csv", "surveyor.toml", "sweep.toml"]
        );
    }
}

#[test]
fn bad_tables_are_refused() {
    let bench = Bench::new();
    bench.write(
        "cases.csv",
        &format!(
            "{}\n{GOOD}\n",
            HEADING.replace("slope_deg,f", "slope_grad,f")
        ),
    );
    bench.land_cases(&["out.csv"]).refused(&[
        "cases.csv:1: column slope_grad: no such column",
        "did you mean slope_deg",
    ]);
    bench.write("cases.csv", HEADING);
    bench
        .land_cases(&["out.csv"])
        .refused(&["cases.csv: has no rows"]);
    bench.write("cases.csv", &format!("{HEADING}\n{GOOD}\n"));
    bench
        .land_cases(&["."])
        .refused(&["is a folder", "name of a file"]);
    bench.run(&LAND_CASES[..5]).refused(&["--out"]);
    bench
        .land_cases(&["out.csv", "--slope", "3"])
        .refused(&["--slope", "--cases"]);
}
