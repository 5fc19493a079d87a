//! The index of the report's equations in docs/model.md against the comments of the code.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const MODEL: &str = include_str!("../../../../docs/model.md");
/// Equations of the report's Section II.
const LAST: u32 = 88;

/// Numbers of equations in a text: those in brackets of their own, such as (55), and not 5(4).
fn numbers(text: &str) -> BTreeSet<u32> {
    let mut found = BTreeSet::new();
    for (start, _) in text.match_indices('(') {
        let is_call = text[..start].ends_with(|before: char| before.is_alphanumeric());
        let inner = text[start + 1..].split(')').next().unwrap_or("");
        if let (false, Ok(number @ 1..=LAST)) = (is_call, inner.parse()) {
            found.insert(number);
        }
    }
    found
}

/// The comments of a file.
fn comments(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    let lines = text.lines().filter_map(|line| line.split_once("//"));
    lines.map(|(_, comment)| format!("{comment}\n")).collect()
}

fn named_in_folder(folder: &Path, named: &mut BTreeSet<u32>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            named_in_folder(&path, named);
        } else {
            named.extend(numbers(&comments(&path)));
        }
    }
}

#[test]
fn equations_are_where_the_index_says() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (_, index) = MODEL.split_once("## 11. Equations of the report").unwrap();
    let mut listed = BTreeSet::new();
    for row in index.lines().filter(|line| line.starts_with("| (")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let file = source.join(cells[3].trim_matches('`'));
        let there = numbers(&comments(&file));
        let here = numbers(cells[1]);
        assert!(here.is_subset(&there), "{row}: {there:?}");
        listed.extend(here);
    }
    assert!(listed.len() > 25, "{listed:?}");
    let mut named = BTreeSet::new();
    named_in_folder(&source, &mut named);
    assert_eq!(named, listed, "numbers in comments, and in the index");
}
