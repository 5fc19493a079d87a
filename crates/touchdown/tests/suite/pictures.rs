//! Pictures that were drawn before are drawn again, bit by bit.
//!
//! Those of `results` stand beside their tables; of those of the corpus `tests/golden/pictures.csv` has fingerprints. A change of
//! drawings changes them: look at the pictures, draw `results` anew with `touchdown plot`, and renew the fingerprints with
//! `scripts/golden.sh`.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use touchdown_input::documents::fingerprint::fingerprint;

use crate::common::Bench;
use crate::golden::{RENEW, golden};

/// Files in a folder and the folders in it.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(files(&path)),
            false => found.push(path),
        }
    }
    found.sort();
    found
}

fn ends_with(path: &Path, end: &str) -> bool {
    path.to_str().is_some_and(|path| path.ends_with(end))
}

/// Pictures of a table by the ends of their names; none if it has no picture.
fn drawn(table: &Path) -> BTreeMap<String, String> {
    let bench = Bench::new();
    bench.run(&["plot", table.to_str().unwrap(), "--out", "new/picture.svg"]);
    let paths = match bench.path("new").is_dir() {
        true => files(&bench.path("new")),
        false => Vec::new(),
    };
    let end = |path: &Path| {
        path.file_name()?
            .to_str()?
            .strip_prefix("picture")
            .map(str::to_owned)
    };
    let picture = |path: PathBuf| (end(&path).unwrap(), fs::read_to_string(&path).unwrap());
    paths.into_iter().map(picture).collect()
}

#[test]
fn committed_pictures_are_drawn_again_from_their_tables() {
    let results = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../results");
    let mut compared = 0;
    for table in files(&results) {
        let Some(stem) = table.to_str().unwrap().strip_suffix(".csv") else {
            continue;
        };
        let ends = ["", "-contours", "-contours-negative", "-perspective"];
        let kept = ends.map(|end| format!("{end}.svg"));
        let kept = kept.map(|end| (fs::read_to_string(format!("{stem}{end}")).ok(), end));
        if kept.iter().all(|(kept, _)| kept.is_none()) {
            continue;
        }
        let drawn = drawn(&table);
        for (kept, end) in kept {
            assert!(
                drawn.get(&end) == kept.as_ref(),
                "{stem}{end} is drawn otherwise"
            );
            compared += usize::from(kept.is_some());
        }
    }
    // Those of other sweeps may lie there, too.
    assert!(compared >= 31, "{compared} pictures");
}

#[test]
fn the_readme_begins_with_the_picture_of_a_map_with_edges() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |name: &str| fs::read_to_string(root.join(name)).unwrap();
    let page = read("README.md");
    let (_, first) = page.split_once("![").unwrap();
    let (_, first) = first.split_once("](").unwrap();
    let (stem, _) = first.split_once("-contours.png)").unwrap();
    let record: serde_json::Value = serde_json::from_str(&read(&format!("{stem}.json"))).unwrap();
    assert!(record["input"]["map"].is_object(), "{stem}");
    assert!(read(&format!("{stem}-edges.csv")).lines().count() > 2);
    let picture = fs::read(root.join(format!("{stem}-contours.png"))).unwrap();
    assert!(picture.starts_with(b"\x89PNG"));
}

#[test]
fn pictures_of_the_corpus_are_drawn_as_they_were() {
    let tables = golden().join("expected");
    let mut found = "picture,fingerprint\n".to_owned();
    for table in files(&tables).iter().filter(|path| ends_with(path, ".csv")) {
        let name = table.strip_prefix(&tables).unwrap().with_extension("");
        for (end, svg) in drawn(table) {
            writeln!(found, "{}{end},{}", name.display(), fingerprint(&svg)).unwrap();
        }
    }
    let place = golden().join("pictures.csv");
    if std::env::var_os(RENEW).is_some() {
        fs::write(place, found).unwrap();
        return;
    }
    let expected = fs::read_to_string(place).unwrap();
    let others: Vec<&str> = found
        .lines()
        .filter(|line| !expected.contains(line))
        .collect();
    assert!(others.is_empty(), "drawn otherwise: {others:#?}");
    assert_eq!(found, expected);
}
