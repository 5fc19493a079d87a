//! `touchdown ask`: V_H at a place, in words and as JSON.

#![allow(missing_docs, reason = "tests are not an interface")]

use serde_json::Value;

use crate::common::{Bench, SWEEP};

#[test]
fn the_answer_is_that_of_the_sweep_in_words_and_numbers() {
    let bench = Bench::new();
    bench.write("sweep.toml", SWEEP);
    assert_eq!(
        bench.run(&["sweep", "sweep.toml", "--out", "out"]).code,
        Some(0)
    );
    let table = bench.read("out/sweep.csv");
    let row: Vec<&str> = table.lines().nth(2).unwrap().split(',').collect();
    let place = format!("roll_deg={}", row[0]);
    for file in ["sweep.toml", "out/sweep.csv", "out/sweep.json"] {
        let done = bench.run(&["ask", file, "--at", &place, "--json"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let answer: Value = serde_json::from_str(&done.out).unwrap();
        assert_eq!(
            answer["boundary"]["first_transition_fps"].to_string(),
            row[2]
        );
        assert_eq!(answer["boundary"]["landings"].to_string(), row[5]);
    }
    let speed: f64 = row[2].parse().unwrap();
    let at = |more: &str| {
        let done = bench.run(&["ask", "out/sweep.csv", "--at", &format!("{place},{more}")]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        done.out
    };
    let below = at(&format!("horizontal_velocity_fps={}", speed - 0.5));
    assert!(below.contains(&format!("V_H {speed:.4} ft/s")), "{below}");
    assert!(below.contains("0.5000 ft/s below V_H: stable"), "{below}");
    let above = at(&format!(
        "horizontal_velocity_mps={}",
        (speed + 0.5) * 0.3048
    ));
    assert!(above.contains("0.5000 ft/s above V_H: "), "{above}");
    assert!(!above.contains("V_H: stable"), "{above}");
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let bench = Bench::new();
    bench.write("sweep.toml", SWEEP);
    bench.write("x.json", "{}");
    let outcome = SWEEP.split("[search]").next().unwrap();
    let outcome = outcome.replacen(
        "[scene]",
        "job = \"outcome\"\n[scene]\nhorizontal_velocity_fps = 1",
        1,
    );
    bench.write("outcome.toml", &outcome);
    for (file, at, fragments) in [
        (
            "sweep.toml",
            "slope_deg=1",
            &["slope_deg = 1: does not vary in the sweep: expected roll_deg"][..],
        ),
        (
            "sweep.toml",
            "horizontal_velocity_fps=1",
            &["roll_deg is missing"],
        ),
        (
            "sweep.toml",
            "roll_deg=1,horizontal_velocity_fps=-1",
            &["horizontal velocity = -1"],
        ),
        ("sweep.toml", "roll_deg=1,roll_rad=0.1", &["twice"]),
        ("sweep.toml", "rol_deg=1", &["did you mean roll_deg"]),
        (
            "x.csv",
            "roll_deg=1",
            &["x.json: expected the record of a sweep"],
        ),
        (
            "y.csv",
            "roll_deg=1",
            &["y.json: ", "or results beside their record"],
        ),
        (".", "roll_deg=1", &["is a folder", "NAME.csv"]),
        (
            "outcome.toml",
            "roll_deg=1",
            &["outcome.toml: expected a sweep that searches transitions"],
        ),
    ] {
        bench.run(&["ask", file, "--at", at]).refused(fragments);
    }
}
