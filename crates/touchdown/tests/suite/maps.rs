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

/// All bands over one axis, along which transitions begin and end.
fn profile() -> String {
    SWEEP
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "roll_deg = [20, 30, 40]\n[map]\nedge_width = { roll_deg = 1 }\nerror_fps = 0.1",
        )
        .replace("to_fps = 12.5", "to_fps = 16\nbands = \"all\"")
}

const PROFILE_TABLES: [&str; 4] = ["map.csv", "map-bands.csv", "map-edges.csv", "map.json"];

fn bench_of(text: &str) -> Bench {
    let bench = Bench::new();
    bench.write("map.toml", text);
    bench
}

fn bench() -> Bench {
    bench_of(&map())
}

fn run(bench: &Bench, arguments: &[&str]) -> Done {
    let done = bench.run(arguments);
    assert_eq!(done.code, Some(0), "{arguments:?}: {}", done.err);
    done
}

#[test]
fn threads_shards_and_interruptions_leave_the_same_map() {
    let coarser = map().replace("deg = 2, roll_deg = 2", "deg = 5, roll_deg = 5");
    let bench = leaves_the_same(&coarser, &TABLES);
    assert!(bench.list("one").contains(&"map-contours.png".to_owned()));
}

#[test]
fn they_leave_the_same_map_over_one_axis() {
    let coarser = profile().replace(
        "roll_deg = 1 }\nerror_fps = 0.1",
        "roll_deg = 4 }\nerror_fps = 0.3",
    );
    let bench = leaves_the_same(&coarser, &PROFILE_TABLES);
    assert!(bench.list("one").contains(&"map.png".to_owned()));
    assert_eq!(bench.list("one").len(), PROFILE_TABLES.len() + 2);
}

/// Computes a map on one thread, in shards, and interrupted on one thread and gone on with on three: all leave the same tables.
fn leaves_the_same(text: &str, names: &[&str]) -> Bench {
    let bench = bench_of(text);
    let tables = |folder: &str| -> Vec<String> {
        let read = |name: &&str| bench.read(&format!("{folder}/{name}"));
        names.iter().map(read).collect()
    };
    run(
        &bench,
        &["sweep", "map.toml", "--out", "one", "--threads", "1"],
    );
    let expected = tables("one");

    for shard in ["1/2", "2/2"] {
        run(
            &bench,
            &["sweep", "map.toml", "--out", "shards", "--shard", shard],
        );
    }
    run(&bench, &["merge", "shards", "--out", "merged"]);
    assert_eq!(tables("merged"), expected);

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
    run(
        &bench,
        &["sweep", "map.toml", "--out", "again", "--threads", "3"],
    );
    assert_eq!(tables("again"), expected);
    bench
}

/// The rows of a table, cell by cell.
fn rows(bench: &Bench, name: &str) -> Vec<Vec<String>> {
    let text = bench.read(&format!("out/{name}"));
    let rows = text.lines().skip(1);
    rows.map(|row| row.split(',').map(str::to_owned).collect())
        .collect()
}

#[test]
fn edges_over_one_axis_lie_between_places_with_other_bands() {
    // Halved three times, cells are as wide as an edge may be.
    let bench = bench_of(&profile().replace("[20, 30, 40]", "[22, 30, 38]"));
    run(&bench, &["sweep", "map.toml", "--out", "out"]);
    // Outcomes from below at every roll.
    let mut bands: Vec<(f64, Vec<String>)> = Vec::new();
    for row in rows(&bench, "map-bands.csv") {
        let roll = row[0].parse().unwrap();
        match bands.last_mut() {
            Some((last, outcomes)) if *last == roll => outcomes.push(row[4].clone()),
            _ => bands.push((roll, vec![row[4].clone()])),
        }
    }
    assert!(bands.is_sorted_by(|a, b| a.0 < b.0));
    let unlike = bands.windows(2).filter(|pair| pair[0].1 != pair[1].1);
    let between: Vec<[f64; 2]> = unlike.map(|pair| [pair[0].0, pair[1].0]).collect();
    let edges = rows(&bench, "map-edges.csv");
    let edges = edges.iter().filter(|row| row[2] != "jump");
    let within: Vec<[f64; 2]> = edges
        .map(|row| {
            let [at, half]: [f64; 2] = [&row[0], &row[5]].map(|cell| cell.parse().unwrap());
            assert!(half <= 0.5, "{row:?}");
            [at - half, at + half]
        })
        .collect();
    assert_eq!(within, between);
    assert!(!between.is_empty());
}

#[test]
fn transitions_end_where_the_edges_are() {
    let coarser = map().replace(
        "deg = 2, roll_deg = 2 }\nerror_fps = 0.3",
        "deg = 3, roll_deg = 3 }\nerror_fps = 0.6",
    );
    let bench = bench_of(&coarser);
    let done = run(&bench, &["sweep", "map.toml", "--out", "out"]);
    assert!(done.out.contains("first transition to"), "{}", done.out);
    let edges = rows(&bench, "map-edges.csv");
    assert!(edges.iter().any(|row| row[3] == "end"));
    for row in &edges {
        // Widths of three degrees, so that nothing is farther than half of it from the edge, were it known.
        let within = [&row[6], &row[7]].map(|width| width.parse::<f64>().unwrap());
        assert!(
            row[3] != "end" || within.iter().all(|width| *width <= 5.0),
            "{row:?}"
        );
    }
    let points = rows(&bench, "map.csv");
    let levels: Vec<&str> = points
        .iter()
        .map(|row| row[row.len() - 1].as_str())
        .collect();
    assert!(levels.contains(&"0") && levels.contains(&"2"), "{levels:?}");
    // Eight steps along the sides of cells.
    assert_eq!(rows(&bench, "map-grid.csv").len(), 9 * 17);
}

/// Axes that are not refined have a picture for each of their values, which is drawn again as it was.
#[test]
fn a_map_over_three_axes_has_a_picture_for_each_value_of_the_third() {
    let coarser = map().replace("deg = 2, roll_deg = 2", "deg = 10, roll_deg = 10");
    let text = coarser
        .replace("friction = 1.0\n", "")
        .replace("roll_deg = [20", "friction = [0.9, 1.0]\nroll_deg = [20");
    let bench = bench_of(&text);
    let done = run(&bench, &["sweep", "map.toml", "--out", "out"]);
    let of = |friction: &str, stem: &str| format!("{stem}-contours-friction={friction}.svg");
    for friction in ["0.9", "1"] {
        assert!(done.out.contains(&of(friction, "out/map")), "{}", done.out);
    }
    run(
        &bench,
        &["plot", "out/map-surface.csv", "--out", "again.svg"],
    );
    let drawn = ["0.9", "1"].map(|friction| {
        let [first, again] = ["out/map", "again"].map(|stem| bench.read(&of(friction, stem)));
        assert_eq!(first, again);
        first
    });
    assert_ne!(drawn[0], drawn[1]);
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
const BAD: [(&str, &str, &[&str]); 15] = [
    ("error_fps = 0.3", "", &["map.toml:10: map.error_fps is missing", "budget_landings"]),
    ("error_fps = 0.3", "error_fps = 0", &["map.toml:12: map.error_fps = 0", "> 0"]),
    ("error_fps = 0.3", "budget_landings = 1.5", &["map.toml:12: map.budget_landings = 1.5", "whole number"]),
    ("error_fps = 0.3", "error = 0.3", &["map.toml:12: map.error = 0.3", "did you mean error_fps?"]),
    ("{ cross_slope_deg = 2, roll_deg = 2 }", "{}", &["map.toml:11: map.edge_width", "one or two of the axes"]),
    ("cross_slope_deg = 2, roll_deg = 2 }", "roll_deg = 2 }\ngrid_steps = 4", &["map.toml:12: map.grid_steps", "one axis"]),
    ("roll_deg = 2 }", "friction = 2 }", &["map.toml:11: map.edge_width.friction = 2", "no such axis: allowed are cross_slope_deg, roll_deg"]),
    ("roll_deg = 2 }", "roll_deg = 11 }", &["map.toml:11: map.edge_width.roll_deg = 11", "0 < value ≤ 10"]),
    ("roll_deg = 2 }", "roll_deg = 1e-9 }", &["map.toml:11: map.edge_width", "2^26 places"]),
    ("[20, 30, 40]", "[20, 40, 30]", &["map.toml:9: axes.roll_deg", "rise, or fall"]),
    ("[20, 30, 40]", "[20, 30, 30, 40]", &["map.toml:9: axes.roll_deg"]),
    ("[20, 30, 40]", "[40, 30, 30, 20]", &["map.toml:9: axes.roll_deg"]),
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

#[test]
fn a_map_that_is_coarser_than_asked_says_so() {
    let told = |error: &str| {
        let text = map().replace("deg = 2, roll_deg = 2", "deg = 5, roll_deg = 5");
        let text = text.replace("error_fps = 0.3", error);
        let bench = bench_of(&text);
        let done = run(&bench, &["sweep", "map.toml"]);
        let record = bench.read("results/map.json");
        let record: serde_json::Value = serde_json::from_str(&record).unwrap();
        let coarse = record["counts"]["map_cells_coarser_than_asked"].as_u64();
        let picture = bench.read("results/map-contours.svg");
        let is_told = done.out.contains("coarser than asked");
        assert_eq!(picture.contains("coarser"), is_told);
        assert_eq!(coarse.unwrap() > 0, is_told, "{}", done.out);
        is_told
    };
    assert!(told("error_fps = 0.001\nbudget_landings = 200"));
    assert!(!told("error_fps = 3"));
}
