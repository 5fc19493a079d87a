//! Every number that a corpus of input gives: landings, boundaries, bands, maps, samples, sensitivities and histories, in which
//! each key has a value that is neither its default nor equal to another's.
//!
//! `tests/golden/input` has the input, `tests/golden/expected` the tables and records. A change of the model changes them: then
//! `scripts/golden.sh` renews them and prints what changed. A change of anything else must not.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::common::Bench;

/// Set to renew what is expected.
pub const RENEW: &str = "TOUCHDOWN_RENEW_GOLDEN";

/// What is run in the folder of the input, by the name of the folder of its results; `OUT` stands for that folder.
const RUNS: [(&str, &[&str]); 17] = [
    (
        "landings",
        &[
            "land",
            "--vehicle",
            "three.toml",
            "--cases",
            "landings.csv",
            "--out",
            "OUT/landings.csv",
        ],
    ),
    (
        "methods",
        &[
            "land",
            "--vehicle",
            "three.toml",
            "--cases",
            "methods.csv",
            "--units",
            "SI",
            "--out",
            "OUT/methods.csv",
        ],
    ),
    (
        "history-us",
        &[
            "land",
            "history-us.toml",
            "--interval",
            "0.1",
            "--out",
            "OUT",
        ],
    ),
    (
        "history-si",
        &[
            "land",
            "history-si.toml",
            "--interval",
            "0.1",
            "--out",
            "OUT",
        ],
    ),
    (
        "three-struts",
        &[
            "land",
            "three-struts.toml",
            "--interval",
            "0.1",
            "--out",
            "OUT",
        ],
    ),
    ("first-us", &["sweep", "first-us.toml", "--out", "OUT"]),
    ("first-si", &["sweep", "first-si.toml", "--out", "OUT"]),
    ("bands", &["sweep", "bands.toml", "--out", "OUT"]),
    ("map-two", &["sweep", "map-two.toml", "--out", "OUT"]),
    ("map-one", &["sweep", "map-one.toml", "--out", "OUT"]),
    ("map-budget", &["sweep", "map-budget.toml", "--out", "OUT"]),
    (
        "monte-carlo",
        &["sweep", "monte-carlo.toml", "--out", "OUT"],
    ),
    (
        "latin-hypercube",
        &["sweep", "latin-hypercube.toml", "--out", "OUT"],
    ),
    ("sobol", &["sweep", "sobol.toml", "--out", "OUT"]),
    ("engine", &["sweep", "engine.toml", "--out", "OUT"]),
    (
        "sensitivity",
        &["sweep", "sensitivity.toml", "--out", "OUT"],
    ),
    (
        "in-si",
        &[
            "sweep",
            "bands.toml",
            "--set",
            "vertical_velocity_fps=13.3",
            "--units",
            "SI",
            "--out",
            "OUT",
        ],
    ),
];

pub fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

/// Tables and records in a folder by their names.
fn results(folder: &Path) -> BTreeMap<String, String> {
    let Ok(entries) = fs::read_dir(folder) else {
        return BTreeMap::new();
    };
    let paths = entries.map(|entry| entry.unwrap().path());
    let kept = paths.filter(|path| {
        path.extension()
            .is_some_and(|form| form == "csv" || form == "json")
    });
    kept.map(|path| {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        let text = if name.ends_with(".json") {
            record(&text)
        } else {
            text
        };
        (name, text)
    })
    .collect()
}

/// A record without what every version of the program changes.
fn record(text: &str) -> String {
    let mut record: Value = serde_json::from_str(text).unwrap();
    let entries = record.as_object_mut().unwrap();
    entries.remove("program");
    entries.remove("input_fingerprint");
    serde_json::to_string_pretty(&record).unwrap() + "\n"
}

/// What differs between two results: of tables column by column, of records line by line.
fn differences(expected: &str, found: &str) -> Vec<String> {
    let [expected, found] = [expected, found].map(|text| {
        let rows = text.lines().map(|row| row.split(',').collect::<Vec<_>>());
        rows.collect::<Vec<_>>()
    });
    if expected.len() != found.len() {
        return vec![format!("{} rows became {}", expected.len(), found.len())];
    }
    if expected.first() != found.first() {
        return other_columns(&expected, &found);
    }
    let mut columns: BTreeMap<usize, (usize, f64, [&str; 2])> = BTreeMap::new();
    for (before, after) in expected.iter().zip(&found).skip(1) {
        let width = before.len().max(after.len());
        for column in 0..width {
            let [was, is] = [before, after].map(|row| row.get(column).copied().unwrap_or(""));
            if was == is {
                continue;
            }
            let difference = match [was, is].map(|cell| cell.parse::<f64>()) {
                [Ok(was), Ok(is)] => (is - was).abs(),
                _ => f64::INFINITY,
            };
            let (rows, greatest, example) = columns.entry(column).or_insert((0, -1.0, [was, is]));
            *rows += 1;
            if difference > *greatest {
                (*greatest, *example) = (difference, [was, is]);
            }
        }
    }
    let name = |column: usize| match expected[0].get(column) {
        Some(&"{") | None => "line",
        Some(name) => name,
    };
    let lines = columns.iter().map(|(column, (rows, greatest, [was, is]))| {
        format!(
            "{}: {rows} of {} rows, by {greatest:.1e} at most: {was} became {is}",
            name(*column),
            expected.len() - 1
        )
    });
    lines.collect()
}

/// Differences between tables whose columns are not the same: new columns, columns that are gone, and kept ones that differ.
fn other_columns(expected: &[Vec<&str>], found: &[Vec<&str>]) -> Vec<String> {
    let columns = |rows: &[Vec<&str>]| -> BTreeMap<String, Vec<String>> {
        let named = rows[0].iter().enumerate();
        let cells = named.map(|(at, name)| {
            let column = rows[1..].iter().map(|row| row[at].to_owned());
            ((*name).to_owned(), column.collect())
        });
        cells.collect()
    };
    let [before, after] = [expected, found].map(columns);
    let told = |name: &String, word: &str| format!("{name}: {word}");
    let new = after.keys().filter(|name| !before.contains_key(*name));
    let gone = before.keys().filter(|name| !after.contains_key(*name));
    let kept = before
        .iter()
        .filter(|(name, cells)| after.get(*name).is_some_and(|others| others != *cells));
    (new.map(|name| told(name, "is new")))
        .chain(gone.map(|name| told(name, "is gone")))
        .chain(kept.map(|(name, _)| told(name, "differs")))
        .collect()
}

#[test]
fn the_corpus_gives_every_number_that_it_gave() {
    let bench = Bench::new();
    for entry in fs::read_dir(golden().join("input")).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        bench.write(path.file_name().unwrap().to_str().unwrap(), &text);
    }
    let renews = std::env::var_os(RENEW).is_some();
    let mut changes = Vec::new();
    for (name, arguments) in RUNS {
        let out = format!("out/{name}");
        let arguments: Vec<String> = arguments
            .iter()
            .map(|word| word.replace("OUT", &out))
            .collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        fs::create_dir_all(bench.path(&out)).unwrap();
        let done = bench.run(&[&arguments[..], &["--quiet"]].concat());
        assert_eq!(done.code, Some(0), "{name}: {}", done.err);
        let kept = golden().join("expected").join(name);
        let (expected, found) = (results(&kept), results(&bench.path(&out)));
        let files: BTreeSet<&String> = expected.keys().chain(found.keys()).collect();
        for file in files {
            let lines = match (expected.get(file), found.get(file)) {
                (Some(expected), Some(found)) if expected == found => continue,
                (Some(expected), Some(found)) => differences(expected, found),
                (None, _) => vec!["is new".to_owned()],
                (_, None) => vec!["is gone".to_owned()],
            };
            changes.extend(lines.iter().map(|line| format!("{name}/{file}: {line}\n")));
        }
        if renews {
            let _ = fs::remove_dir_all(&kept);
            fs::create_dir_all(&kept).unwrap();
            for (file, text) in &found {
                fs::write(kept.join(file), text).unwrap();
            }
        }
    }
    if renews {
        println!("{}", changes.concat());
    } else {
        assert!(
            changes.is_empty(),
            "{} (scripts/golden.sh renews)",
            changes.concat()
        );
    }
}

#[test]
fn shards_of_the_corpus_are_merged_into_the_whole() {
    let bench = Bench::new();
    for name in ["three.toml", "first-us.toml"] {
        let text = fs::read_to_string(golden().join("input").join(name)).unwrap();
        bench.write(name, &text);
    }
    for shard in ["2/3", "1/3", "3/3"] {
        let done = bench.run(&[
            "sweep",
            "first-us.toml",
            "--shard",
            shard,
            "--out",
            "out",
            "--quiet",
        ]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let journals = bench.list("out");
    let second = journals
        .iter()
        .find(|name| name.contains("2-of-3"))
        .unwrap();
    let copy = bench.path("out/copy.journal");
    fs::copy(bench.path("out").join(second), &copy).unwrap();
    (bench.run(&["merge", "out", "--quiet"]))
        .refused(&["copy.journal", "shard 2/3 is there twice"]);
    fs::remove_file(copy).unwrap();
    let done = bench.run(&["merge", "out", "--quiet"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let expected = results(&golden().join("expected/first-us"));
    let found = results(&bench.path("out"));
    assert!(expected.keys().eq(found.keys()), "{:?}", found.keys());
    for (file, found) in found {
        let lines = differences(&expected[&file], &found);
        assert!(lines.is_empty(), "{file}: {lines:?}");
    }
}
