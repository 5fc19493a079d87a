//! The reference of input files describes the keys that the program reads, no more and no less.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::collections::BTreeMap;

use touchdown_dynamics::quantity::{IfMissing, Quantity};
use touchdown_input::documents::unit::unit;
use touchdown_input::sweeps::input_keys::{tables, word_choices};

const REFERENCE: &str = include_str!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../docs/reference.md"
));

/// Rows of a table of the page, cell by cell.
type Rows = Vec<Vec<String>>;

/// The tables of keys of the page, by the names in their markers.
fn documented() -> BTreeMap<String, Rows> {
    let mut found = BTreeMap::new();
    let mut lines = REFERENCE.lines();
    while let Some(line) = lines.next() {
        let marker = line.strip_prefix("<!-- keys: ");
        let Some(name) = marker.and_then(|rest| rest.strip_suffix(" -->")) else {
            continue;
        };
        let heading = lines.next().unwrap_or_default();
        assert_eq!(heading, "| key | unit | allowed | default | meaning |");
        let rows = lines.by_ref().take_while(|row| row.starts_with('|'));
        let cells = |row: &str| -> Vec<String> {
            let inner = row.trim_matches('|').split('|');
            inner.map(|cell| cell.trim().to_owned()).collect()
        };
        let rows: Rows = rows.skip(1).map(cells).collect();
        for row in &rows {
            assert_eq!(row.len(), 5, "{name}: {row:?}");
            assert!(!row[4].is_empty(), "{name}: {} has no meaning", row[0]);
        }
        assert!(found.insert(name.to_owned(), rows).is_none(), "{name}");
    }
    found
}

#[test]
fn keys_are_those_of_the_code() {
    let of_code: BTreeMap<String, Vec<String>> = tables()
        .into_iter()
        .map(|table| {
            let keys = table.keys.iter().map(|key| format!("`{key}`"));
            (table.name.to_owned(), keys.collect())
        })
        .collect();
    let of_page: BTreeMap<String, Vec<String>> = documented()
        .into_iter()
        .map(|(name, rows)| (name, rows.into_iter().map(|row| row[0].clone()).collect()))
        .collect();
    let names = |tables: &BTreeMap<String, Vec<String>>| -> Vec<String> {
        tables.keys().cloned().collect()
    };
    assert_eq!(names(&of_page), names(&of_code));
    for (name, keys) in of_code {
        let sorted = |mut keys: Vec<String>| {
            keys.sort();
            keys
        };
        assert_eq!(sorted(of_page[&name].clone()), sorted(keys), "{name}");
    }
}

#[test]
fn words_and_their_defaults_are_those_of_the_code() {
    let page = documented();
    for choice in word_choices() {
        let key = format!("`{}`", choice.key);
        let row = page[choice.table].iter().find(|row| row[0] == key);
        let row = row.unwrap_or_else(|| panic!("{key} is not described"));
        let words: Vec<String> = choice
            .words
            .iter()
            .map(|word| format!("`\"{word}\"`"))
            .collect();
        assert_eq!(row[2], words.join(", "), "{key}");
        let default = match choice.key {
            // The default of the friction profile is the last letter.
            "friction_profile" => &words[2],
            "rules" | "crush_rule" | "rest_rule" | "toppling_rule" | "contact_rule" => {
                "the vehicle's"
            }
            "stop" => "`\"rest\"`, in sweeps that search `\"verdict\"`",
            _ => &words[0],
        };
        assert_eq!(row[3], default, "{key}");
    }
}

/// Row of a number of a table, as the page should have it.
fn row(table: &str, number: &Quantity) -> String {
    let per = if table.ends_with("per_second") {
        " per s"
    } else {
        ""
    };
    let unit = unit(&format!("{table}.{}", number.key)).replace(' ', "·");
    let and = if number.relation.is_empty() { "" } else { ", " };
    let default = match number.if_missing {
        IfMissing::Required => String::new(),
        IfMissing::Number(number) => number.to_string(),
        IfMissing::Words(words) => words.to_owned(),
    };
    format!(
        "| `{}` | {}{per} | {}{and}{} | {default} | {} |",
        number.key,
        unit.replace('2', "²").replace('3', "³"),
        number
            .range
            .to_string()
            .replace('-', "−")
            .replace("e−", "e-"),
        number.relation,
        number.meaning,
    )
    .replace("|  |", "| |")
}

#[test]
fn numbers_are_described_as_in_the_catalogue() {
    let lines: Vec<&str> = REFERENCE.lines().collect();
    let mut missing = Vec::new();
    for table in tables() {
        let marker = format!("<!-- keys: {} -->", table.name);
        let start = lines.iter().position(|line| *line == marker).unwrap();
        let end = lines[start..].iter().position(|line| line.is_empty());
        let rows = &lines[start..start + end.unwrap_or(lines.len() - start)];
        let needed = table.numbers.iter().map(|number| row(table.name, number));
        missing.extend(
            needed
                .filter(|row| !rows.contains(&row.as_str()))
                .map(|row| (table.name, row)),
        );
    }
    let told: String = missing
        .iter()
        .map(|(table, row)| format!("{table}: {row}\n"))
        .collect();
    assert!(
        missing.is_empty(),
        "docs/reference.md needs these rows:\n{told}"
    );
}

#[test]
fn units_are_those_that_keys_carry() {
    let page = documented();
    let with_units = [
        ("vehicle", ""),
        ("vehicle.inertia_slug_ft2", "vehicle.inertia_slug_ft2."),
        ("vehicle.linkage", ""),
        ("vehicle.strut", ""),
        ("vehicle.secondary", ""),
        ("vehicle.footpad", ""),
        ("vehicle.block", ""),
        ("vehicle.legs", ""),
        ("scene", ""),
        ("search", ""),
        ("solver", ""),
    ];
    for (table, prefix) in with_units {
        for row in page[table].iter().filter(|row| !row[1].is_empty()) {
            let name = format!("{prefix}{}", row[0].trim_matches('`'));
            let plain = row[1].replace('·', " ").replace('²', "2").replace('³', "3");
            assert_eq!(plain, unit(&name), "{name}");
        }
    }
}
