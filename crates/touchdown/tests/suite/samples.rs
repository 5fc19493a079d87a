//! Sampled landings: probabilities, an early end, and the same bytes however they are computed.

#![allow(missing_docs, reason = "tests are not an interface")]

mod growing;

use std::sync::LazyLock;

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
    assert!(
        done.out.contains("enough for the interval width"),
        "{}",
        done.out
    );
    assert!(done.out.contains("toppled"), "{}", done.out);
    RESULTS.map(|name| bench.read(name))
}

/// The results of a run from beginning to end.
fn uninterrupted() -> &'static [String; 2] {
    static RESULTS_OF_ONE_RUN: LazyLock<[String; 2]> = LazyLock::new(|| whole("2"));
    &RESULTS_OF_ONE_RUN
}

/// Starts the sweep three times, and kills each run soon.
#[cfg(unix)]
fn kill_runs(bench: &Bench) {
    for _ in 0..3 {
        let mut run = bench
            .command(&["sweep", "sweep.toml", "--quiet"])
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_millis(60));
        run.kill().unwrap();
        run.wait().unwrap();
    }
}

#[test]
fn probabilities_have_intervals_and_the_run_ends_when_they_are_narrow() {
    let results = uninterrupted();
    assert_eq!(whole("1"), *results);
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
    let expected = uninterrupted();
    let bench = bench();
    kill_runs(&bench);
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(RESULTS.map(|name| bench.read(name)), *expected);
}

/// A shard cannot know when all are enough; together they end at the same point.
#[test]
fn shards_of_a_sample_merge_to_the_same_results() {
    let expected = uninterrupted();
    let bench = bench();
    let fewer = SAMPLE.replace("count = 5000", "count = 400");
    bench.write("sweep.toml", &fewer);
    for shard in ["1/2", "2/2"] {
        let done = bench.run(&["sweep", "sweep.toml", "--shard", shard]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let merged = bench.run(&["merge", "results"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    assert_eq!(RESULTS.map(|name| bench.read(name)), *expected);
}

/// Transitions of dispersed touchdowns, with every kind of distribution.
const TRANSITIONS: &str = r#"title = "Dispersed transitions"
vehicle = "surveyor.toml"
[scene]
cross_slope_deg = 180
slope_deg = 15
[axes]
vertical_velocity_fps = { mean = 14 }
pitch_deg = { mean = 0 }
friction = { distribution = "triangular", from = 0.8, mode = 1, to = 1.1 }
vehicle.footpad.crush_pressure_psf = { distribution = "lognormal", mean = 1440, sd = 50 }
angular_velocity_x_dps = { distribution = "rayleigh", sigma = 0.5 }
roll_deg = { distribution = "normal", mean = 0, sd = 5, from = -10, to = 10 }
[sample]
design = "latin-hypercube"
count = 20
seed = 3
[[sample.covariance]]
axes = ["vertical_velocity_fps", "pitch_deg"]
matrix = [[0.09, 0.1], [0.1, 1]]
[search]
from_fps = 10.5
to_fps = 12.5
scan_step_fps = 1
tolerance_fps = 0.25
[solver]
tolerance = 1e-3
"#;

#[test]
fn sampled_transitions_have_quantiles_and_a_distribution() {
    let bench = Bench::new();
    bench.write("sweep.toml", TRANSITIONS);
    let done = bench.run(&["sweep", "sweep.toml", "--format", "parquet"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(
        done.out.contains("V_H quantiles, ft/s: 5 %"),
        "{}",
        done.out
    );
    let files = bench.list("results");
    for file in [
        "sweep-distribution.csv",
        "sweep-distribution.parquet",
        "sweep-distribution.png",
        "sweep-distribution.svg",
        "sweep-quantiles.csv",
        "sweep-quantiles.parquet",
    ] {
        assert!(files.iter().any(|name| name == file), "{file}: {files:?}");
    }
    let column = |file: &str, name: &str| -> Vec<String> {
        let text = bench.read(&format!("results/{file}.csv"));
        let mut rows = csv::Reader::from_reader(text.as_bytes());
        let index = rows
            .headers()
            .unwrap()
            .iter()
            .position(|known| known == name)
            .unwrap();
        rows.records()
            .map(|row| row.unwrap()[index].to_owned())
            .collect()
    };
    // The median counted by hand: points with an open end below come first, those above last.
    let ranks = column("sweep", "certainty")
        .into_iter()
        .zip(column("sweep", "first_transition_fps"));
    let mut speeds: Vec<f64> = ranks
        .map(|(certainty, speed)| match certainty.as_str() {
            "at-or-below" => f64::NEG_INFINITY,
            "above" => f64::INFINITY,
            _ => speed.parse().unwrap(),
        })
        .collect();
    speeds.sort_by(f64::total_cmp);
    assert!(
        speeds.iter().filter(|speed| speed.is_finite()).count() > 10,
        "{speeds:?}"
    );
    let shares = column("sweep-quantiles", "share");
    let median = shares.iter().position(|share| share == "0.5").unwrap();
    let quantiles = column("sweep-quantiles", "transition_fps");
    assert_eq!(quantiles[median], speeds[9].to_string());
    let points = column("sweep-distribution", "points");
    let points: usize = points
        .iter()
        .map(|count| count.parse::<usize>().unwrap())
        .sum();
    assert_eq!(points, 20);

    // Computed in parts it comes to the same.
    for shard in ["1/2", "2/2"] {
        let done = bench.run(&["sweep", "sweep.toml", "--out", "parts", "--shard", shard]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let merged = bench.run(&["merge", "parts"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    for file in [
        "sweep-quantiles.csv",
        "sweep-distribution.csv",
        "sweep-distribution.svg",
    ] {
        let [whole, parts] =
            ["results", "parts"].map(|folder| bench.read(&format!("{folder}/{file}")));
        assert_eq!(whole, parts, "{file}");
    }
    // `plot` draws the same picture.
    let drawn = bench.run(&["plot", "parts/sweep-distribution.csv", "--out", "again.svg"]);
    assert_eq!(drawn.code, Some(0), "{}", drawn.err);
    assert_eq!(
        bench.read("again.svg"),
        bench.read("parts/sweep-distribution.svg")
    );
}

/// The landings of a grid are counted, and drawn over its two axes: they tell of no probability.
#[test]
fn landings_of_a_grid_are_counted_and_drawn() {
    let bench = Bench::new();
    let grid = SAMPLE.split("[axes]").next().unwrap().to_owned()
        + "[axes]\nfriction = [0.6, 1]\nhorizontal_velocity_fps = { from = 4, to = 20, step = 4 }\n\
           [solver]\ntolerance = 1e-4\n";
    bench.write("sweep.toml", &grid);
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(!done.out.contains('%'), "{}", done.out);
    assert!(!bench.path("results/sweep-probabilities.csv").exists());
    let toppled = bench.read("results/sweep.csv").matches("unstable").count();
    assert!(toppled > 0, "{}", done.out);
    let told = format!("toppled {toppled}\n");
    assert!(done.out.contains(&told), "{}", done.out);
    let record: serde_json::Value =
        serde_json::from_str(&bench.read("results/sweep.json")).unwrap();
    let outcomes = &record["counts"]["outcomes"];
    assert_eq!(outcomes["toppled"], toppled);
    assert!(outcomes["topple_probability_95"].is_null());
    let picture = bench.read("results/sweep.svg");
    assert!(picture.contains("topples") && picture.contains("Friction coefficient"));
}

#[test]
#[rustfmt::skip]
fn wrong_distributions_are_refused() {
    for (good, wrong, fragments) in [
        ("sigma = 0.5", "sigma = 0", &["angular_velocity_x_dps.sigma = 0", "> 0"][..]),
        ("\"rayleigh\"", "\"weibull\"", &["distribution = \"weibull\"", "\"triangular\""]),
        ("mode = 1,", "mode = 2,", &["friction.mode = 2", "between from and to"]),
        ("mean = 1440", "median = 1440", &["median = 1440", "unknown key"]),
        ("pitch_deg = { mean = 0 }", "pitch_deg = { mean = 0, sd = 1 }", &["pitch_deg.sd = 1"]),
        ("\"pitch_deg\"]", "\"yaw_deg\"]", &["yaw_deg", "one of the axes"]),
        ("\"pitch_deg\"]", "\"vertical_velocity_fps\"]", &["one covariance only"]),
        ("[0.1, 1]]", "[0.2, 1]]", &["sample.covariance[1].matrix", "symmetric"]),
        ("[[0.09, 0.1], [0.1, 1]]", "[[0.09, 0.4], [0.4, 1]]", &["positive definite"]),
        ("[[0.09, 0.1], [0.1, 1]]", "[[0.09, 0.1]]", &["2 rows"]),
    ] {
        let bench = Bench::new();
        let text = TRANSITIONS.replace(good, wrong);
        assert_ne!(text, TRANSITIONS, "{good}");
        bench.write("sweep.toml", &text);
        bench.run(&["sweep", "sweep.toml"]).refused(fragments);
    }
}

/// Numbers of `[sample]` given by `--set` are those of a changed file, also in journals of shards.
#[test]
fn set_numbers_of_a_sample_are_those_of_a_changed_file() {
    let files = Bench::new();
    let changed = SAMPLE
        .replace("count = 5000", "count = 12")
        .replace("seed = 1966", "seed = 7");
    files.write("sweep.toml", &changed);
    let done = files.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let expected = files.read("results/sweep.csv");
    assert_eq!(expected.lines().count(), 13);

    let bench = bench();
    let set = ["--set", "sample.count=12", "--set", "sample.seed=7"];
    for shard in ["1/2", "2/2"] {
        let run = ["sweep", "sweep.toml", "--shard", shard];
        let done = bench.run(&[&run[..], &set].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let done = bench.run(&["merge", "results"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("results/sweep.csv"), expected);

    let width = ["--set", "sample.stop_at_interval_width=0.9"];
    let done = bench.run(&[&["sweep", "sweep.toml", "--out=wide"][..], &width].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("wide/sweep.csv").lines().count(), 101);
}

#[test]
fn numbers_of_a_sample_that_cannot_be_set_are_refused() {
    let bench = bench();
    bench.write("grid.toml", crate::common::SWEEP);
    let set = |file: &str, value: &str| bench.run(&["sweep", file, "--set", value]);
    set("grid.toml", "sample.count=5").refused(&["--set sample.count=5", "no table [sample]"]);
    set("sweep.toml", "sample.count=0").refused(&["sample.count = 0", "from 1 to 1000000000"]);
    set("sweep.toml", "sample.design=sobol").refused(&["sample.design = sobol: cannot be set"]);
    let twice = ["--set", "sample.seed=1", "--set", "sample.seed=2"];
    let done = bench.run(&[&["sweep", "sweep.toml"][..], &twice].concat());
    done.refused(&["--set sample.seed=2: set twice"]);
    // A number of a sample is no axis.
    bench.write(
        "axis.toml",
        &SAMPLE.replace("[axes]\n", "[axes]\nsample.count = [5, 6]\n"),
    );
    bench
        .run(&["sweep", "axis.toml"])
        .refused(&["axes.sample", "unknown parameter"]);
}
