//! Whole runs of the program.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::process::Stdio;

use crate::common::{BASELINE, Bench, SWEEP};

#[test]
fn help_teaches_units_and_the_sense_of_the_cross_slope() {
    let bench = Bench::new();
    let help = bench.run(&["land", "--help"]);
    assert_eq!(help.code, Some(0));
    for fragment in [
        "180 is straight downhill",
        "FT/S",
        "deg/s",
        "Examples:",
        "--cases cases.csv",
    ] {
        // Help is wrapped to the terminal.
        let words: Vec<&str> = help.out.split_whitespace().collect();
        assert!(words.join(" ").contains(fragment), "{fragment}");
    }
    let help = bench.run(&["sweep", "--help"]);
    assert!(help.out.contains("scan_step_fps = 0.25"));
    let help = bench.run(&["--help"]);
    assert!(help.out.contains("Exit codes"));
}

#[test]
fn a_sweep_writes_table_picture_and_record_the_same_for_any_threads() {
    let bench = Bench::new();
    for threads in ["1", "2"] {
        let done = bench.run(&[
            "sweep",
            "sweep.toml",
            "--out",
            threads,
            "--threads",
            threads,
            "--bands",
            "all",
        ]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        assert!(done.out.contains("3 points"), "{}", done.out);
        assert!(done.out.contains("landings/s"), "{}", done.out);
        assert_eq!(
            bench.list(threads),
            [
                "sweep-bands.csv",
                "sweep.csv",
                "sweep.json",
                "sweep.png",
                "sweep.svg"
            ]
        );
    }
    assert_eq!(bench.read("1/sweep.csv"), bench.read("2/sweep.csv"));
    assert_eq!(
        bench.read("1/sweep-bands.csv"),
        bench.read("2/sweep-bands.csv")
    );
    assert_eq!(bench.read("1/sweep.svg"), bench.read("2/sweep.svg"));
    let table = bench.read("1/sweep.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(
        rows[0],
        "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,\
         landings,derivative_evaluations,certainty,disputed_from_fps,disputed_to_fps,\
         solver_tolerance,stable_landings_below,patchy_to_fps,patchy_landings,patchy_not_stable"
    );
    assert_eq!(rows.len(), 4);
    assert!(rows[1].starts_with("-10,") && rows[2].starts_with("0,") && rows[3].starts_with("10,"));
    assert!(
        bench
            .read("1/sweep.json")
            .contains("\"block_friction\": 1.0")
    );
}

#[test]
fn a_folder_is_swept_file_by_file_with_bands_and_an_overview() {
    let bench = Bench::new();
    std::fs::create_dir_all(bench.path("studies/vehicles")).unwrap();
    let all = crate::common::SWEEP
        .replace("\"surveyor.toml\"", "\"../surveyor.toml\"")
        .replace(
            "tolerance_fps = 0.1",
            "tolerance_fps = 0.1\nbands = \"all\"",
        );
    bench.write("studies/b.toml", &all);
    bench.write(
        "studies/a.toml",
        &all.replace("cross_slope_deg = 180", "cross_slope_deg = 80"),
    );
    bench.write("studies/vehicles/none.toml", "");
    let done = bench.run(&["sweep", "studies"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let lines: Vec<&str> = done.out.lines().collect();
    assert!(
        lines[0].starts_with("sweep  points  first transition to"),
        "{}",
        done.out
    );
    assert!(
        lines[1].starts_with("a ") && lines[2].starts_with("b "),
        "{}",
        done.out
    );
    assert!(
        lines[2].contains("3 unstable") && lines[2].contains("roll_deg = "),
        "{}",
        done.out
    );
    let bands = bench.read("results/b-bands.csv");
    let rows: Vec<&str> = bands.lines().collect();
    assert_eq!(
        rows[0],
        "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps,kind,certainty,disputed_from_fps,\
         disputed_to_fps,solver_tolerance"
    );
    assert!(rows[1].starts_with("-10,1,10,11."), "{bands}");
    assert!(rows[2].starts_with("-10,2,11.") && rows[2].contains(",12.5,unstable,,unstable-"));

    let first = bench.run(&["sweep", "studies", "--bands", "first", "--out", "first"]);
    assert_eq!(first.code, Some(0), "{}", first.err);
    assert!(!bench.list("first").contains(&"b-bands.csv".to_owned()));
    let transitions = |table: String| -> Vec<String> {
        let short = |row: &str| row.splitn(6, ',').take(5).collect::<Vec<_>>().join(",");
        table.lines().map(short).collect()
    };
    assert_eq!(
        transitions(bench.read("first/b.csv")),
        transitions(bench.read("results/b.csv"))
    );
}

#[test]
fn options_hold_instead_of_what_the_sweep_file_says() {
    let bench = Bench::new();
    bench.write(
        "light.toml",
        &crate::common::SURVEYOR.replace("mass_slug = 20", "mass_slug = 19"),
    );
    let statement = format!("statement = \"stated: 11 ft/s\"\n{}", crate::common::SWEEP);
    bench.write("sweep.toml", &statement);
    let changed = ["--vehicle", "light.toml", "--crush-rule", "section"];
    let done = bench.run(&[&["sweep", "sweep.toml"], &changed[..]].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    let record = bench.read("results/sweep.json");
    assert!(record.contains("\"crush_rule\": \"section\""));
    assert!(record.contains("\"mass_slug\": 19.0"));
    // What was stated of another vehicle does not stand above this one's picture.
    let picture = bench.read("results/sweep.svg");
    assert!(!record.contains("stated") && !picture.contains("stated"));
}

#[test]
fn a_single_row_has_a_profile_and_quiet_is_quiet() {
    let bench = Bench::new();
    let two = crate::common::SWEEP
        .replace("slope_deg = 15\n", "")
        .replace("[axes]", "[axes]\nslope_deg = [15]");
    bench.write("sweep.toml", &two.replace("step = 10", "step = 20"));
    let done = bench.run(&["sweep", "sweep.toml", "--quiet"]);
    assert_eq!(
        (done.code, done.out.as_str(), done.err.as_str()),
        (Some(0), "", "")
    );
    assert_eq!(
        bench.list("results"),
        ["sweep.csv", "sweep.json", "sweep.png", "sweep.svg"]
    );
    assert!(
        bench
            .read("results/sweep.csv")
            .starts_with("slope_deg,roll_deg,first")
    );
}

#[test]
fn a_landing_is_told_and_its_history_written() {
    let bench = Bench::new();
    let history = [
        "--history",
        "h.csv",
        "--interval",
        "0.1",
        "--angular-velocity",
        "-1,0,0.5",
    ];
    let done = bench.run(&[&BASELINE[..], &history].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    for fragment in [
        "outcome",
        "least stability angle",
        "closure",
        "derivative evaluations",
    ] {
        assert!(done.out.contains(fragment), "{fragment}: {}", done.out);
    }
    let history = bench.read("h.csv");
    assert!(history.starts_with("t_s,x_ft,"));
    assert!(history.lines().count() > 5);
}

#[test]
fn a_landing_is_told_as_json() {
    let bench = Bench::new();
    let done = bench.run(&[&BASELINE[..], &["--json", "--roll", "-5"]].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.out.starts_with('{'));
    assert!(done.out.contains("\"roll_deg\": -5.0"), "{}", done.out);
    // What never happened has no time.
    let never = "\"block_contact_1_s\": null";
    assert!(done.out.contains(never), "{}", done.out);
    for known in ["\"model\": ", "\"vehicle_fingerprint\": \"", "\"commit\": "] {
        assert!(done.out.contains(known), "{known}: {}", done.out);
    }
    assert!(
        done.out.contains("\"min_stability_angle_deg\""),
        "{}",
        done.out
    );
}

#[test]
fn json_tells_all_numbers_of_the_method() {
    let bench = Bench::new();
    let told = |more: &[&str]| {
        let method = ["--json", "--method", "report"];
        let done = bench.run(&[&BASELINE[..], &method, more].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let report: serde_json::Value = serde_json::from_str(&done.out).unwrap();
        report["solver"]["method_in_full"]
            .as_str()
            .unwrap()
            .to_owned()
    };
    let plain = told(&[]);
    assert_ne!(told(&["--error-scale", "2"]), plain);
    assert_ne!(told(&["--first-interval", "0.001"]), plain);
}

#[test]
fn the_usage_of_land_shows_what_may_be_given_together() {
    let done = Bench::new().run(&["land"]);
    done.refused(&["touchdown land <SCENE.toml> --out <DIR>"]);
    assert!(
        !done.err.contains("--vehicle <FILE> [SCENE"),
        "{}",
        done.err
    );
}

#[test]
fn the_version_names_that_of_the_model() {
    let done = Bench::new().run(&["--version"]);
    assert!(done.out.contains("(model version "), "{}", done.out);
}

#[test]
fn cases_are_landed_in_their_order() {
    let bench = Bench::new();
    bench.write(
        "cases.csv",
        "note,case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,pitch_deg,\
         yaw_deg,roll_deg,slope_deg,friction\n\
         slow,7,14,2,180,0,0,0,15,1\nfast,3,14,13,180,0,0,0,15,1\n",
    );
    let done = bench.land_cases(&["new/out.csv", "--threads", "2"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("new/out.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert!(rows[0].starts_with("case,outcome,end_time_s,min_stability_angle_deg"));
    assert!(rows[1].starts_with("7,stable-"), "{}", rows[1]);
    assert!(rows[2].starts_with("3,unstable-pitch"), "{}", rows[2]);
    assert_eq!(bench.list("new"), ["out.csv"]);
}

#[test]
fn cases_go_to_a_parquet_file_that_is_named_so() {
    let bench = Bench::new();
    bench.write(
        "cases.csv",
        "vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction\n14,2,180,15,1\n",
    );
    for _ in ["there is none", "there is an earlier one"] {
        let done = bench.land_cases(&["out.parquet"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let table = std::fs::read(bench.path("out.parquet")).unwrap();
    assert!(table.starts_with(b"PAR1") && table.ends_with(b"PAR1"));
    bench.write("other.parquet", "not a table\n");
    let refused = bench.land_cases(&["other.parquet"]);
    assert_eq!(refused.code, Some(2), "{}", refused.err);
}

/// Whoever reads may stop reading, as `head` does.
#[test]
fn a_closed_pipe_is_no_failure() {
    let bench = Bench::new();
    let mut land = bench
        .command(&BASELINE)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    drop(land.stdout.take());
    assert_eq!(land.wait().unwrap().code(), Some(0));
}

#[test]
fn a_card_deck_lands_as_its_sample_run() {
    let bench = Bench::new();
    bench.write(
        "sample.txt",
        include_str!("../../../input/src/readers/deck/sample_deck.txt"),
    );
    let done = bench.run(&["import-deck", "sample.txt", "--out", "deck"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let files = ["sample-cases.csv", "sample-scene.toml", "sample.toml"];
    assert_eq!(bench.list("deck"), files);
    let done = bench.run(&[
        "land",
        "--vehicle",
        "deck/sample.toml",
        "--cases",
        "deck/sample-cases.csv",
        "--out",
        "outcomes.csv",
        "--quiet",
    ]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let outcomes = bench.read("outcomes.csv");
    let rows: Vec<&str> = outcomes.lines().collect();
    assert_eq!(rows.len(), 3);
    // The converged branch of the sample run.
    assert!(
        rows[1].starts_with("4,stable-rockback,2.303"),
        "{}",
        rows[1]
    );
    assert!(rows[2].starts_with("5,"), "{}", rows[2]);
    // The stack as a scene file tells of the second run only what changes, and lands the same.
    let scene = bench.read("deck/sample-scene.toml");
    let second = scene.rsplit("[[case]]").next().unwrap();
    assert!(second.contains("horizontal_velocity_fps = 9.5") && !second.contains("friction"));
    let done = bench.run(&["land", "deck/sample-scene.toml", "--out", "landings"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("landings/sample-scene.csv"), outcomes);
}

/// The speed up to which landings keep an angle falls with the angle, and just below it they keep it.
#[test]
fn a_search_for_an_angle_that_is_kept_finds_where_it_is_not() {
    let bench = Bench::new();
    let axes = SWEEP.replace(
        "roll_deg = { from = -10, to = 10, step = 10 }",
        "search.keep_deg = [0, 5, 10, 20]",
    );
    let axes = axes.replace("from_fps = 10", "from_fps = 2").replace(
        "tolerance_fps = 0.1",
        "tolerance_fps = 0.001\nscan = \"skipping\"",
    );
    bench.write("sweep.toml", &axes);
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("results/sweep.csv");
    let speeds: Vec<[f64; 2]> = (table.lines().skip(1))
        .map(|row| {
            let cells: Vec<&str> = row.split(',').collect();
            [0, 2].map(|cell| cells[cell].parse().unwrap())
        })
        .collect();
    assert_eq!(speeds.len(), 4);
    assert!(
        speeds.windows(2).all(|pair| pair[1][1] < pair[0][1]),
        "{speeds:?}"
    );
    for [kept, speed] in &speeds[1..] {
        let least = |speed: f64| -> f64 {
            let scene = "scene.toml";
            bench.write(
                scene,
                &format!(
                    "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 14\ncross_slope_deg = 180\n\
                     slope_deg = 15\nfriction = 1.0\nhorizontal_velocity_fps = {speed}\n"
                ),
            );
            let done = bench.run(&["land", scene, "--out", "landed", "--interval", "1"]);
            assert_eq!(done.code, Some(0), "{}", done.err);
            let table = bench.read("landed/scene.csv");
            let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
            let column = (rows[0].iter()).position(|name| *name == "min_stability_angle_deg");
            rows[1][column.unwrap()].parse().unwrap()
        };
        assert!(least(speed - 0.002) >= *kept, "{kept}");
        assert!(least(speed + 0.002) < *kept, "{kept}");
    }
}
