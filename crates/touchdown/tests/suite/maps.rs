//! Maps that choose their points.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::process::Stdio;
use std::time::Duration;

use crate::common::{Bench, Done, SWEEP};

/// A map of two cells, across whose sides transitions end.
fn map() -> String {
    SWEEP
        .replace("cross_slope_deg = 180\n", "")
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "cross_slope_deg = [170, 180]\nroll_deg = [20, 30, 40]\n[map]\n\
             edge_width = { cross_slope_deg = 2, roll_deg = 2 }\nerror_fps = 0.3",
        )
        .replace("to_fps = 12.5", "to_fps = 15")
}

const TABLES: [&str; 5] = [
    "map.csv",
    "map-edges.csv",
    "map-grid.csv",
    "map-surface.csv",
    "map.json",
];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("map.toml", &map());
    bench
}

fn run(bench: &Bench, arguments: &[&str]) -> Done {
    let done = bench.run(arguments);
    assert_eq!(done.code, Some(0), "{arguments:?}: {}", done.err);
    done
}

fn tables(bench: &Bench, folder: &str) -> [String; 5] {
    TABLES.map(|name| bench.read(&format!("{folder}/{name}")))
}

#[test]
fn threads_shards_and_interruptions_leave_the_same_map() {
    let bench = bench();
    run(
        &bench,
        &["sweep", "map.toml", "--out", "one", "--threads", "1"],
    );
    let expected = tables(&bench, "one");
    assert!(bench.list("one").contains(&"map-contours.png".to_owned()));

    run(
        &bench,
        &["sweep", "map.toml", "--out", "three", "--threads", "3"],
    );
    assert_eq!(tables(&bench, "three"), expected);

    for shard in ["1/2", "2/2"] {
        run(
            &bench,
            &["sweep", "map.toml", "--out", "shards", "--shard", shard],
        );
    }
    run(&bench, &["merge", "shards", "--out", "merged"]);
    assert_eq!(tables(&bench, "merged"), expected);

    // Without one of its shards the map is incomplete.
    std::fs::remove_file(bench.path("shards/map.1-of-2.journal")).unwrap();
    let done = bench.run(&["merge", "shards", "--out", "half"]);
    assert_eq!(done.code, Some(1), "{}", done.err);
    assert!(
        done.err
            .contains("no journal of shards 1, points are missing"),
        "{}",
        done.err
    );

    // A shard's journal is what an interruption may leave of the whole: some points of some rounds.
    let arguments = ["sweep", "map.toml", "--out", "again", "--threads", "1"];
    let mut child = bench
        .command(&arguments)
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let journal = bench.path("again/map.journal");
    let length = || std::fs::metadata(&journal).map_or(0, |file| file.len());
    let mut first = 0;
    while first == 0 || length() < first + 1000 {
        first = if first == 0 { length() } else { first };
        if child.try_wait().unwrap().is_some() {
            break;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    let _ = child.kill();
    child.wait().unwrap();
    run(&bench, &arguments);
    assert_eq!(tables(&bench, "again"), expected);
}

#[test]
fn transitions_end_where_the_edges_are() {
    let bench = bench();
    let done = run(&bench, &["sweep", "map.toml", "--out", "out"]);
    assert!(done.out.contains("first transition to"), "{}", done.out);
    let rows = |name: &str| -> Vec<Vec<String>> {
        let text = bench.read(&format!("out/{name}"));
        let rows = text.lines().skip(1);
        rows.map(|row| row.split(',').map(str::to_owned).collect())
            .collect()
    };
    let edges = rows("map-edges.csv");
    assert!(edges.iter().any(|row| row[3] == "end"));
    for row in &edges {
        // Widths of two degrees, so that nothing is farther than one from the edge, were it known.
        let within = [&row[6], &row[7]].map(|width| width.parse::<f64>().unwrap());
        assert!(
            row[3] != "end" || within.iter().all(|width| *width <= 5.0),
            "{row:?}"
        );
    }
    let points = rows("map.csv");
    let levels: Vec<&str> = points.iter().map(|row| row[12].as_str()).collect();
    assert!(levels.contains(&"0") && levels.contains(&"2"), "{levels:?}");
    // Eight steps along the sides of cells.
    assert_eq!(rows("map-grid.csv").len(), 9 * 17);
}

#[test]
fn dry_runs_tell_of_the_first_level() {
    let bench = bench();
    let done = run(&bench, &["sweep", "map.toml", "--dry-run"]);
    assert!(done.out.contains("6 points"), "{}", done.out);
    assert!(
        done.out.contains("refined until errors are below 0.3 ft/s"),
        "{}",
        done.out
    );
}

/// What is replaced in the sweep file, by what, and what the message must contain.
#[rustfmt::skip]
const BAD: [(&str, &str, &[&str]); 12] = [
    ("error_fps = 0.3", "", &["map.toml:10: map.error_fps is missing", "budget_landings"]),
    ("error_fps = 0.3", "error_fps = 0", &["map.toml:12: map.error_fps = 0", "> 0"]),
    ("error_fps = 0.3", "budget_landings = 1.5", &["map.toml:12: map.budget_landings = 1.5", "whole number"]),
    ("error_fps = 0.3", "error = 0.3", &["map.toml:12: map.error = 0.3", "did you mean error_fps?"]),
    (", roll_deg = 2", "", &["map.toml:11: map.edge_width", "two of the axes"]),
    ("roll_deg = 2 }", "friction = 2 }", &["map.toml:11: map.edge_width.friction = 2", "no such axis: allowed are cross_slope_deg, roll_deg"]),
    ("roll_deg = 2 }", "roll_deg = 11 }", &["map.toml:11: map.edge_width.roll_deg = 11", "0 < value ≤ 10"]),
    ("roll_deg = 2 }", "roll_deg = 1e-9 }", &["map.toml:11: map.edge_width", "2^26 places"]),
    ("[20, 30, 40]", "[20, 40, 30]", &["map.toml:9: axes.roll_deg", "rise, or fall"]),
    ("[20, 30, 40]", "[20]", &["map.toml:9: axes.roll_deg", "two values or more"]),
    ("[search]", "[sample]\ndesign = \"sobol\"\ncount = 4\nseed = 1\n[search]", &["map.toml:10: map", "beside [sample]"]),
    ("title", "job = \"outcome\"\ntitle", &["map.toml:11: map", "says nothing where job"]),
];

#[test]
fn bad_maps_are_refused() {
    let bench = bench();
    for (what, by, fragments) in BAD {
        let text = map();
        assert!(text.contains(what), "{what}");
        bench.write("map.toml", &text.replacen(what, by, 1));
        bench
            .run(&["sweep", "map.toml", "--out", "out"])
            .refused(fragments);
        assert!(bench.list("out").is_empty());
    }
    bench.write(
        "map.toml",
        &map().replace("error_fps = 0.3", "budget_landings = 300"),
    );
    let done = bench.run(&["sweep", "map.toml", "--out", "out", "--shard", "1/2"]);
    done.refused(&["map.toml", "map.budget_landings", "--shard"]);
}
