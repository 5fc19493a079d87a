//! Pictures of result tables, drawn anew.

#![allow(missing_docs, reason = "tests are not an interface")]

#[allow(dead_code, reason = "every test file uses its own part")]
use crate::common::Bench;

const HEADING: &str = "cross_slope_deg,roll_deg,first_transition_to,first_transition_fps,\
                       bracket_low_fps,bracket_high_fps\n";

/// A grid of two by two points, and the profile in its first row.
fn grid() -> String {
    let rows = [(90, -10, 14), (90, 10, 15), (180, -10, 12), (180, 10, 13)];
    let rows = rows
        .map(|(slope, roll, speed)| format!("{slope},{roll},unstable,{speed},{speed},{speed}\n"));
    format!("{HEADING}{}", rows.concat())
}

#[test]
fn a_sweep_is_drawn_again_as_it_was() {
    let bench = Bench::new();
    assert_eq!(
        bench.run(&["sweep", "sweep.toml", "--bands", "all"]).code,
        Some(0)
    );
    let drawn = |name: &str| std::fs::read(bench.path(name)).unwrap();
    let before = (drawn("results/sweep.svg"), drawn("results/sweep.png"));
    std::fs::remove_file(bench.path("results/sweep.svg")).unwrap();
    let done = bench.run(&["plot", "results/sweep.csv"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(done.out, "results/sweep.svg\nresults/sweep.png\n");
    assert_eq!(
        before,
        (drawn("results/sweep.svg"), drawn("results/sweep.png"))
    );
}

#[test]
fn a_table_alone_is_enough_and_two_axes_have_two_pictures() {
    let bench = Bench::new();
    bench.write("grid.csv", &grid());
    let done = bench.run(&["plot", "grid.csv", "--out", "new/map.svg"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(
        bench.list("new"),
        ["map-contours.svg", "map-perspective.svg"]
    );
    let done = bench.run(&["plot", "grid.csv", "--out", "map.png"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let png = std::fs::read(bench.path("map-contours.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
    // Width and height stand in the first chunk: twice 900 by 860.
    assert_eq!(png[16..24], [0, 0, 7, 8, 0, 0, 6, 184]);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let bench = Bench::new();
    bench.write("grid.csv", &grid());
    let plot = |arguments: &[&str]| bench.run(&[&["plot"], arguments].concat());
    plot(&["none.csv"]).refused(&["none.csv: cannot be read"]);
    plot(&["sweep.toml"]).refused(&["sweep.toml: result table:"]);
    plot(&["grid.csv", "--out", "map.pdf"]).refused(&["map.pdf", "ends in .svg or .png"]);
    plot(&["grid.csv", "grid.csv", "--out", "map.svg"]).refused(&["map.svg", "one table"]);
    bench.write("grid.csv", &grid().replace(",13,13,13", ",fast,13,13"));
    plot(&["grid.csv"]).refused(&["grid.csv: result table: row 4: first_transition_fps = fast"]);
    bench.write("grid.csv", &grid().replace("180,10", "170,10"));
    plot(&["grid.csv"]).refused(&["grid.csv: has no picture", "a grid of two"]);
    bench.write("grid.csv", &grid());
    bench.write("grid.json", "{");
    plot(&["grid.csv"]).refused(&["grid.csv: result table: record:"]);
    assert_eq!(bench.list(".").len(), 4);
}
