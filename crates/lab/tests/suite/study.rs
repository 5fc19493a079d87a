//! The study of Phase II, from the committed results.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::fs;
use std::path::Path;

use crate::common::{Bench, Done};

const RESULTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../results");

/// Copies tables and records; of pictures only the names matter.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let there = to.join(path.file_name().unwrap());
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("csv" | "json") => drop(fs::copy(&path, there).unwrap()),
            Some("svg" | "png") => fs::write(there, "").unwrap(),
            None if path.is_dir() => copy(&path, &there),
            _ => {}
        }
    }
}

fn study(bench: &Bench) -> Done {
    let arguments = [
        "study",
        "phase-2",
        "--results",
        "r",
        "--vehicle",
        "surveyor.toml",
    ];
    bench.run(&arguments)
}

#[test]
fn what_is_committed_is_what_the_results_say() {
    let bench = Bench::new();
    copy(Path::new(RESULTS), &bench.path("r"));
    let done = study(&bench);
    assert_eq!(done.code, Some(0), "{}", done.err);
    for page in ["phase-2.md", "README.md"] {
        let committed = fs::read_to_string(Path::new(RESULTS).join(page)).unwrap();
        assert_eq!(bench.read(&format!("r/{page}")), committed, "{page}");
    }
    let study = bench.read("r/phase-2.md");
    for claim in 1..=17 {
        assert!(study.contains(&format!("\n| C{claim:02} |")), "C{claim:02}");
    }
}

#[test]
fn special_studies_are_what_the_program_says() {
    let bench = Bench::new();
    fs::create_dir(bench.path("r")).unwrap();
    let vehicles = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/vehicles");
    let [level, sample] =
        ["table-4-1", "sample-deck"].map(|name| format!("{vehicles}/surveyor-{name}.toml"));
    let done = bench.run(&[
        "study",
        "special",
        "--results",
        "r",
        "--vehicle",
        &level,
        "--sample-vehicle",
        &sample,
    ]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let committed = fs::read_to_string(Path::new(RESULTS).join("special-studies.md")).unwrap();
    let page = bench.read("r/special-studies.md");
    assert_eq!(page, committed);
    for picture in page.split("](").skip(1) {
        let name = picture.split(')').next().unwrap();
        assert!(bench.path("r").join(name).is_file(), "{name}");
        assert!(Path::new(RESULTS).join(name).is_file(), "{name}");
    }
}

#[test]
fn scatter_follows_its_table() {
    let bench = Bench::new();
    copy(Path::new(RESULTS), &bench.path("r"));
    let table = bench.read("r/scatter.csv");
    let line = |end: &str| {
        let lines = table
            .lines()
            .filter(|line| line.starts_with("figure-4-09,roll_deg,0,"));
        lines
            .filter(|line| line.contains(end))
            .map(str::to_owned)
            .next()
            .unwrap()
    };
    let low = line(",10.9,20,");
    let changed = low.replace(",20,0", ",20,7");
    assert_ne!(low, changed);
    bench.write("r/scatter.csv", &table.replace(&low, &changed));
    assert_eq!(study(&bench).code, Some(0));
    let page = bench.read("r/phase-2.md");
    assert!(
        page.contains("| figure-4-09 | 0 | 11.40 | 10.90 |"),
        "{page}"
    );
    bench.write("r/scatter.csv", "figure\n1\n");
    study(&bench).refused(&["r/scatter.csv: columns are figure,condition"]);
}

#[test]
fn verdicts_follow_the_results() {
    let bench = Bench::new();
    copy(Path::new(RESULTS), &bench.path("r"));
    let row = |id: &str| -> String {
        let text = bench.read("r/phase-2.md");
        text.lines()
            .find(|line| line.starts_with(&format!("| {id} |")))
            .unwrap()
            .to_owned()
    };
    assert_eq!(study(&bench).code, Some(0));
    assert!(row("C05").contains("| agrees |"), "{}", row("C05"));
    let table = bench.read("r/figure-4-09.csv");
    let baseline = table.lines().find(|line| line.starts_with("0,")).unwrap();
    let changed = baseline.replace("0,unstable,11.", "0,unstable,10.");
    bench.write("r/figure-4-09.csv", &table.replace(baseline, &changed));
    assert_eq!(study(&bench).code, Some(0));
    assert!(
        row("C05").contains("| 10.") && row("C05").contains("| **differs** |"),
        "{}",
        row("C05")
    );
}

#[test]
fn missing_results_are_named() {
    let bench = Bench::new();
    study(&bench).refused(&["r/figure-4-05-bands.csv: cannot be read", "study --help"]);
    assert!(bench.list("r").is_empty());
    copy(Path::new(RESULTS), &bench.path("r"));
    let table = bench.read("r/figure-4-23.csv");
    let cut: Vec<&str> = table
        .lines()
        .filter(|line| !line.starts_with("112.5,"))
        .collect();
    bench.write("r/figure-4-23.csv", &cut.join("\n"));
    study(&bench).refused(&["r/figure-4-23.csv: has no point [112.5]"]);
}
