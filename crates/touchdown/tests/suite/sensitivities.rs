//! `touchdown sweep --sensitivity`: table, chart and record, shards, and what cannot be asked.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{Bench, SWEEP};

const TABLE: &str = "results/sweep-sensitivity.csv";

fn asked() -> String {
    format!("{SWEEP}[sensitivity]\nparameters = [\"friction\", \"vehicle.strut.preload_lb\"]\n")
}

#[test]
fn a_sweep_tells_what_its_transitions_depend_on_and_draws_it() {
    let bench = Bench::new();
    let plain = bench.run(&["sweep", "sweep.toml", "--out", "plain"]);
    assert_eq!(plain.code, Some(0), "{}", plain.err);
    let arguments = [
        "sweep",
        "sweep.toml",
        "--sensitivity",
        "friction,vehicle.strut.preload_lb",
    ];
    let done = bench.run(&arguments);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.out.contains("of 6 have a derivative"), "{}", done.out);
    // The search is what it is without.
    assert_eq!(
        bench.read("results/sweep.csv"),
        bench.read("plain/sweep.csv")
    );
    let table = bench.read(TABLE);
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 1 + 3 * 2);
    assert_eq!(rows[0][..4], ["roll_deg", "parameter", "unit", "value"]);
    assert_eq!(
        rows[2][..4],
        ["-10", "vehicle.strut.preload_lb", "lb", "185"]
    );
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));

    // The chart is drawn again as it was, with the title of the sweep.
    let chart = bench.read("results/sweep-sensitivity.svg");
    assert!(chart.contains("Roll at cross-slope 180 deg"));
    assert!(bench.path("results/sweep-sensitivity.png").exists());
    assert_eq!(
        bench.run(&["plot", TABLE, "--out", "again.svg"]).code,
        Some(0)
    );
    assert_eq!(bench.read("again.svg"), chart);

    // Asked in the file, in shards: the same bytes.
    let bench = Bench::new();
    bench.write("sweep.toml", &asked());
    for shard in ["1/2", "2/2"] {
        let done = bench.run(&["sweep", "sweep.toml", "--shard", shard]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    assert_eq!(bench.run(&["merge", "results"]).code, Some(0));
    assert_eq!(bench.read(TABLE), table);
    assert!(
        bench
            .read("results/sweep.json")
            .contains("\"sensitivity_landings\": ")
    );
}

#[test]
fn what_no_transition_can_depend_on_is_refused() {
    let bench = Bench::new();
    let ask = |names: &str| bench.run(&["sweep", "sweep.toml", "--sensitivity", names]);
    ask("frction").refused(&["--sensitivity frction", "did you mean friction?"]);
    ask("horizontal_velocity_fps").refused(&["the search varies it"]);
    ask("solver.crush_rule").refused(&["solver.crush_rule", "expected keys of the scene"]);
    ask("friction,scene.friction").refused(&["scene.friction", "listed twice"]);
    ask("tip_deg").refused(&["sweep.toml", "tip_deg", "has no value"]);
    let wrong = |right: &str, wrong: &str, fragments: &[&str]| {
        bench.write("sweep.toml", &asked().replace(right, wrong));
        bench.run(&["sweep", "sweep.toml"]).refused(fragments);
    };
    wrong(
        "\"friction\"",
        "3",
        &[
            "sweep.toml:16: sensitivity.parameters[1] = 3",
            "text in quotes",
        ],
    );
    wrong(
        "parameters",
        "parameter",
        &["sweep.toml:16", "did you mean parameters?"],
    );
    wrong(
        "[\"friction\", \"vehicle.strut.preload_lb\"]",
        "[]",
        &["at least one name"],
    );
    wrong(
        "vehicle.strut",
        "vehicle.strutt",
        &["sweep.toml:16", "did you mean vehicle.strut.preload_lb"],
    );
    assert_eq!(bench.list("results"), Vec::<String>::new());
}
