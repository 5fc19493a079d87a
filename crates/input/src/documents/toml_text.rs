//! Documents written as TOML.

use std::fmt::Write;

use serde_json::{Map, Value as Json};

use crate::documents::document::{Entry, Node, Value};

/// Longest number written without an exponent.
const LONGEST_NUMBER: usize = 20;

/// Writes the entries of a document as TOML, with tables under headings. [`crate::documents::document::Document`] reads back the
/// same numbers.
pub fn text(entries: &[Entry]) -> String {
    let mut text = String::new();
    write_table(&mut text, "", entries);
    text
}

/// Entries of a JSON object; null is none.
pub fn entries(object: &Map<String, Json>) -> Vec<Entry> {
    let entries = object.iter().filter(|(_, value)| !value.is_null());
    entries
        .map(|(key, value)| entry(key, node(value)))
        .collect()
}

/// A key with its value.
pub fn entry(key: &str, node: Node) -> Entry {
    Entry {
        key: key.to_owned(),
        node,
    }
}

/// The node of a JSON value.
pub fn node(value: &Json) -> Node {
    written(match value {
        Json::Number(number) => Value::Number(number.as_f64().unwrap_or(f64::NAN)),
        Json::String(text) => Value::Text(text.clone()),
        Json::Array(items) => Value::List(items.iter().map(node).collect()),
        Json::Object(object) => Value::Table(entries(object)),
        Json::Null | Json::Bool(_) => Value::Foreign,
    })
}

/// The node of a value that no file contains yet.
pub fn written(value: Value) -> Node {
    Node {
        line: 1,
        written: String::new(),
        value,
    }
}

fn write_table(text: &mut String, path: &str, entries: &[Entry]) {
    for entry in entries.iter().filter(|entry| !has_heading(&entry.node)) {
        line(
            text,
            &format!("{} = {}", key(&entry.key), inline(&entry.node)),
        );
    }
    for entry in entries.iter().filter(|entry| has_heading(&entry.node)) {
        let path = match path {
            "" => key(&entry.key),
            above => format!("{above}.{}", key(&entry.key)),
        };
        let (tables, [open, close]) = match &entry.node.value {
            Value::List(nodes) => (nodes.as_slice(), ["[[", "]]"]),
            _ => (std::slice::from_ref(&entry.node), ["[", "]"]),
        };
        for table in tables {
            line(text, &format!("\n{open}{path}{close}"));
            if let Value::Table(below) = &table.value {
                write_table(text, &path, below);
            }
        }
    }
}

fn line(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

/// True for a table or a list of tables, which are written under headings.
fn has_heading(node: &Node) -> bool {
    let is_table = |node: &Node| matches!(node.value, Value::Table(_));
    match &node.value {
        Value::List(nodes) => !nodes.is_empty() && nodes.iter().all(is_table),
        _ => is_table(node),
    }
}

fn inline(node: &Node) -> String {
    match &node.value {
        Value::Number(value) => number(*value),
        Value::Text(text) => quoted(text),
        Value::List(nodes) => {
            let items: Vec<String> = nodes.iter().map(inline).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Table(entries) => {
            let pair = |entry: &Entry| format!("{} = {}", key(&entry.key), inline(&entry.node));
            let pairs: Vec<String> = entries.iter().map(pair).collect();
            format!("{{ {} }}", pairs.join(", "))
        }
        Value::Foreign => node.written.clone(),
    }
}

fn number(value: f64) -> String {
    match value.to_string() {
        _ if value.is_nan() => "nan".to_owned(),
        short if short.len() <= LONGEST_NUMBER => short,
        _ => format!("{value:e}"),
    }
}

fn key(key: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    match !key.is_empty() && key.chars().all(is_bare) {
        true => key.to_owned(),
        false => quoted(key),
    }
}

fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => {
                // Writing to a string cannot fail.
                let _ = write!(quoted, "\\u{:04x}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::documents::document::Document;

    fn written(source: &str) -> String {
        let document = Document::parse(Path::new("f"), source).unwrap();
        text(document.root())
    }

    #[test]
    fn what_is_written_reads_as_what_it_was() {
        let source = "name = \"a \\\"b\\\" \\\\ \\u0007 ä\"\nn = [0.1, 1e300, -2e-7, 100000]\n\"legs[2].x\" = { from = 1, to = 2 }\n\
                      [a]\nb = 1\n[a.c]\nd = []\n[[legs]]\nx = 1\n[[legs]]\nstrut.y = 2\nz = [[1, 2], [3, 4]]\n";
        let once = written(source);
        assert_eq!(written(&once), once);
        assert_eq!(
            once,
            "name = \"a \\\"b\\\" \\\\ \\u0007 ä\"\nn = [0.1, 1e300, -0.0000002, 100000]\n\n[\"legs[2].x\"]\nfrom = 1\nto = 2\n\n\
             [a]\nb = 1\n\n[a.c]\nd = []\n\n[[legs]]\nx = 1\n\n[[legs]]\nz = [[1, 2], [3, 4]]\n\n[legs.strut]\ny = 2\n"
        );
    }

    #[test]
    fn every_vehicle_file_stays_what_it_is() {
        let folder = Path::new(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../sweeps/vehicles"
        ));
        for file in folder.read_dir().unwrap() {
            let path = file.unwrap().path();
            let source = std::fs::read_to_string(&path).unwrap();
            let document = Document::parse(&path, &source).unwrap();
            let again = Document::parse(&path, &text(document.root())).unwrap();
            let tree = crate::sweeps::resolved_input::vehicle;
            assert_eq!(tree(&again), tree(&document));
        }
    }
}
