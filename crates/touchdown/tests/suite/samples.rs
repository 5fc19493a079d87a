//! Sampled landings: probabilities, an early end, and the same bytes however they are computed.

#![allow(missing_docs, reason = "tests are not an interface")]

#[allow(dead_code, reason = "every test file uses its own part")]
use crate::common::Bench;

const SAMPLE: &str = r#"title = "Dispersed touchdowns"
job = "outcome"
vehicle = "surveyor.toml"
[scene]
vertical_velocity_fps = 14
cross_slope_deg = 180
slope_deg = 15
[axes]
horizontal_velocity_fps = { mean = 10, sd = 2, from = 0, to = 20 }
friction = { from = 0.8, to = 1.2 }
roll_deg = { from = -10, to = 10 }
[sample]
design = "monte-carlo"
count = 5000
seed = 1966
stop_at_interval_width = 0.12
[solver]
tolerance = 1e-4
"#;

const RESULTS: [&str; 2] = ["results/sweep.csv", "results/sweep-probabilities.csv"];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("sweep.toml", SAMPLE);
    bench
}

fn whole(threads: &str) -> [String; 2] {
    let bench = bench();
    let done = bench.run(&["sweep", "sweep.toml", "--threads", threads]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.out.contains("which are enough"), "{}", done.out);
    assert!(done.out.contains("toppled"), "{}", done.out);
    RESULTS.map(|name| bench.read(name))
}

#[test]
fn probabilities_have_intervals_and_the_run_ends_when_they_are_narrow() {
    let results = whole("2");
    assert_eq!(whole("1"), results);
    let rows: Vec<Vec<&str>> = results[1]
        .lines()
        .map(|row| row.split(',').collect())
        .collect();
    assert_eq!(rows[0][..4], ["axis", "from", "to", "landings"]);
    assert_eq!(rows[1][..3], ["all", "", ""]);
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    let landings = number(1, 3);
    assert!(landings < 5000.0 && landings % 100.0 == 0.0);
    assert_eq!(results[0].lines().count() as f64, landings + 1.0);
    assert!(number(1, 7) - number(1, 6) <= 0.12);
    // Ten bins for each of three axes; each axis holds every landing once.
    assert_eq!(rows.len(), 2 + 30);
    let of_speed: f64 = (2..12).map(|row| number(row, 3)).sum();
    assert_eq!(of_speed, landings);
    // The fastest tenth topples, the slowest does not.
    assert_eq!(rows[2][0], "horizontal_velocity_fps");
    assert!(number(2, 5) < 0.1 && number(11, 5) > 0.8, "{}", results[1]);
}

#[cfg(unix)]
#[test]
fn a_killed_sample_ends_where_it_would_have_ended() {
    let expected = whole("2");
    let bench = bench();
    for _ in 0..3 {
        let mut run = bench
            .command(&["sweep", "sweep.toml", "--quiet"])
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_millis(60));
        run.kill().unwrap();
        run.wait().unwrap();
    }
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(RESULTS.map(|name| bench.read(name)), expected);
}

/// A shard cannot know when all are enough; together they end at the same point.
#[test]
fn shards_of_a_sample_merge_to_the_same_results() {
    let expected = whole("2");
    let bench = bench();
    let fewer = SAMPLE.replace("count = 5000", "count = 1000");
    bench.write("sweep.toml", &fewer);
    for shard in ["1/2", "2/2"] {
        let done = bench.run(&["sweep", "sweep.toml", "--shard", shard]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let merged = bench.run(&["merge", "results"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    assert_eq!(RESULTS.map(|name| bench.read(name)), expected);
}
