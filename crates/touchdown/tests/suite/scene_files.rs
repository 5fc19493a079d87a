//! Scene files with stacked cases, landed by the built program.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{BASELINE, Bench};

const SCENE: &str = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
                     horizontal_velocity_fps = 11.25\ncross_slope_deg = 180\nslope_deg = 15\n\
                     friction = 1.0\n";

/// The rows of a table without its heading, each as its cells.
fn rows(table: &str) -> Vec<Vec<&str>> {
    table
        .lines()
        .skip(1)
        .map(|row| row.split(',').collect())
        .collect()
}

#[test]
fn every_case_lands_as_if_it_were_told_in_full() {
    let bench = Bench::new();
    let cases = "[[case]]\nname = \"baseline\"\n[[case]]\nhorizontal_velocity_fps = 12.5\n\
                 [[case]]\ncross_slope_deg = 90\nsolver.crush_rule = \"section\"\n";
    bench.write("deck.toml", &format!("{SCENE}{cases}"));
    let done = bench.run(&["land", "deck.toml", "--out", "new", "--interval", "0.1"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let files = ["deck-2.csv", "deck-3.csv", "deck-baseline.csv", "deck.csv"];
    assert_eq!(bench.list("new"), files);

    let table = bench.read("new/deck.csv");
    let results = rows(&table);
    assert!(table.starts_with("case,outcome,end_time_s,min_stability_angle_deg"));
    assert_eq!(results.len(), 3);
    assert_eq!([results[0][0], results[1][0]], ["baseline", "2"]);
    assert!(results[0][1].starts_with("stable-") && results[1][1] == "unstable-pitch");
    for result in &results {
        assert!(done.out.contains(result[1]), "{}", done.out);
    }

    // The histories of the first case, and of the last with all that was said before it.
    let told = |options: &[&str], history: &str| {
        let history_options = ["--history", history, "--interval", "0.1"];
        let done = bench.run(&[&BASELINE[..], options, &history_options].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        bench.read(history)
    };
    assert_eq!(bench.read("new/deck-baseline.csv"), told(&[], "one.csv"));
    let last = [
        "--horizontal-velocity=12.5",
        "--cross-slope=90",
        "--crush-rule=section",
    ];
    let mut options: Vec<&str> = BASELINE.to_vec();
    options.retain(|option| {
        !["--horizontal-velocity", "11.25", "--cross-slope", "180"].contains(option)
    });
    let done = bench.run(
        &[
            &options[..],
            &last,
            &["--history", "two.csv", "--interval=0.1"],
        ]
        .concat(),
    );
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("new/deck-3.csv"), bench.read("two.csv"));
}

#[test]
fn a_scene_file_without_cases_is_one_landing() {
    let bench = Bench::new();
    bench.write("deck.toml", SCENE);
    let done = bench.run(&["land", "deck.toml", "--out", "."]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(rows(&bench.read("deck.csv")).len(), 1);
    assert!(bench.read("deck-1.csv").starts_with("t_s,x_ft,"));
}

/// What a scene file says behind the scene, and what the message must contain.
#[rustfmt::skip]
const REFUSED: [(&str, &[&str]); 6] = [
    ("[[case]]\n[[case]]\nslope_deg = 95\n", &["deck.toml:10: case 2: slope_deg = 95", "-90 < value < 90"]),
    ("[[case]]\nfrictoin = 1\n", &["deck.toml:9: case[1].frictoin = 1", "did you mean friction?"]),
    ("[[case]]\nvehicle.strut.preload_lb = -5\n", &["deck.toml:9: case 1: strut.preload_lb = -5"]),
    ("[[case]]\nsolver.method = \"euler\"\n", &["deck.toml:9: case[1].solver.method", "located"]),
    ("[[case]]\nvehicle = \"surveyor.toml\"\nsolver.error_scale = 2\n", &["deck.toml:10: case 1: solver.error_scale = 2"]),
    ("[[case]]\nname = \"../a\"\n", &["deck.toml:9: case[1].name", "letters, digits"]),
];

#[test]
fn bad_cases_are_refused_and_nothing_is_written() {
    for (cases, fragments) in REFUSED {
        let bench = Bench::new();
        bench.write("deck.toml", &format!("{SCENE}{cases}"));
        bench
            .run(&["land", "deck.toml", "--out", "new"])
            .refused(fragments);
        assert_eq!(
            bench.list("."),
            ["deck.toml", "surveyor.toml", "sweep.toml"]
        );
    }
}

#[test]
fn what_a_scene_file_says_is_not_said_beside_it() {
    let bench = Bench::new();
    bench.write("deck.toml", SCENE);
    for options in [
        &["--out", "new", "--slope", "3"][..],
        &["--out", "new", "--tolerance", "1e-5"],
        &["--out", "new", "--vehicle", "surveyor.toml"],
        &[],
    ] {
        let done = bench.run(&[&["land", "deck.toml"], options].concat());
        assert_eq!(done.code, Some(2), "{options:?}: {}", done.err);
    }
    let out = [&BASELINE[..], &["--out", "new"]].concat();
    bench.run(&out).refused(&["--out requires"]);
    assert_eq!(bench.list("new"), [""; 0]);
}

/// Lands `deck.toml` into `out` by a shell that sets a limit first: whether that succeeded, and what was said.
#[cfg(unix)]
fn land_within(bench: &Bench, limit: &str) -> (bool, String) {
    let land = format!(
        "ulimit {limit}; '{}' land deck.toml --out out --interval 1",
        crate::PROGRAM
    );
    let mut shell = std::process::Command::new("sh");
    let shell = shell.args(["-c", &land]).current_dir(bench.path("."));
    let done = shell.output().unwrap();
    let said = [done.stdout, done.stderr].concat();
    (done.status.success(), String::from_utf8(said).unwrap())
}

/// A history is written when its case has landed: no more files are open at a time for more cases.
#[test]
#[cfg(unix)]
fn more_cases_than_files_may_be_open_are_landed() {
    let bench = Bench::new();
    let case = |case: i32| {
        let speed = 1.0 + 1e-3 * f64::from(case);
        format!("[[case]]\nhorizontal_velocity_fps = {speed}\n")
    };
    let cases: String = (0..120).map(case).collect();
    bench.write("deck.toml", &format!("{SCENE}{cases}"));
    let (has_landed, said) = land_within(&bench, "-n 40");
    assert!(has_landed, "{said}");
    assert_eq!(bench.list("out").len(), 121);
    let written = "written: out/deck-1.csv to out/deck.csv, 121 files";
    assert!(said.contains(written), "{said}");
}

/// Histories of cases that have landed are kept when that of another cannot be written.
#[test]
#[cfg(unix)]
fn histories_of_finished_cases_stay() {
    let bench = Bench::new();
    let cases = "[[case]]\n[[case]]\nsolver.stop = \"time\"\nsolver.time_limit_s = 60\n";
    bench.write("deck.toml", &format!("{SCENE}{cases}"));
    let (has_landed, said) = land_within(&bench, "-f 40");
    assert!(!has_landed, "{said}");
    assert!(
        said.contains("out/deck-2.csv: cannot be written: "),
        "{said}"
    );
    assert_eq!(bench.list("out"), ["deck-1.csv"]);
    assert!(bench.read("out/deck-1.csv").starts_with("t_s,"));
}
