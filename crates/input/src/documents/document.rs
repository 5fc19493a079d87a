//! TOML files as trees of numbers, texts, lists and tables, each with its line.
//!
//! TOML's integers and floats are both numbers here; `nan` and `inf` are rejected everywhere, as no quantity of a
//! landing can have them.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use toml::de::{DeTable, DeValue};

use crate::documents::input_error::{InputError, Place};
use crate::documents::key_path::KeyPath;
use crate::documents::library::{Library, Source};
use crate::documents::spelling::{Conversion, conversion};

/// A file and its content.
#[derive(Debug, Clone)]
pub struct Document {
    path: PathBuf,
    text: Arc<str>,
    root: Vec<Entry>,
}

/// A key with its value.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The key, without the tables above it.
    pub key: String,
    /// Its value.
    pub node: Node,
}

/// A value with its line.
#[derive(Debug, Clone)]
pub struct Node {
    /// Line of the key (of the value itself inside a list), from 1.
    pub line: usize,
    /// The value as written in the file; tables and long lists abbreviated.
    pub written: String,
    /// The value.
    pub value: Value,
}

/// Value of a key.
#[derive(Debug, Clone)]
pub enum Value {
    /// A finite number.
    Number(f64),
    /// A text.
    Text(String),
    /// Values in square brackets, or the entries of an array of tables.
    List(Vec<Node>),
    /// Keys with values, in file order.
    Table(Vec<Entry>),
    /// A boolean, date or time; no key of these files takes one.
    Foreign,
}

impl Document {
    /// Reads a TOML file of a library.
    ///
    /// # Errors
    /// If it cannot be read, is not TOML, or holds a number that is not finite.
    pub fn read_from(path: &Path, library: Library) -> Result<Self, InputError> {
        Self::parse(path, &library.text(path)?)
    }

    /// Parses `text` as the content of the file `path`.
    ///
    /// # Errors
    /// If it is not TOML, or holds a number that is not finite.
    pub fn parse(path: &Path, text: &str) -> Result<Self, InputError> {
        let reader = Reader {
            text,
            place: Place::file(path),
        };
        let table = DeTable::parse(text).map_err(|error| reader.syntax(&error))?;
        let root = reader.entries(table.get_ref(), "")?;
        Ok(Self {
            path: path.to_owned(),
            text: text.into(),
            root,
        })
    }

    /// Path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// A verbatim copy of the file.
    pub fn source(&self) -> Source {
        Source {
            path: self.path.clone(),
            text: self.text.to_string(),
        }
    }

    /// The file as a place.
    pub fn place(&self) -> Place {
        Place::file(&self.path)
    }

    /// Keys outside any table, and the tables.
    pub fn root(&self) -> &[Entry] {
        &self.root
    }

    /// The number at `path` in the program's unit, if any.
    pub fn number(&self, path: &KeyPath) -> Option<f64> {
        let (last, tables) = path.steps.split_last()?;
        let mut entries = self.root.as_slice();
        let mut above = Conversion::NONE;
        for step in tables {
            let (found, own) = spelled(entries, &step.key)?;
            let mut node = &found.node;
            if let Some(index) = step.entry {
                let Value::List(nodes) = &node.value else {
                    return None;
                };
                node = nodes.get(index)?;
            }
            let Value::Table(below) = &node.value else {
                return None;
            };
            above = own.or(above);
            entries = below;
        }
        let (found, own) = spelled(entries, &last.key)?;
        match found.node.value {
            Value::Number(number) => Some(own.or(above).to_program(number)),
            _ => None,
        }
    }

    /// Replaces or adds the value at `path`, in the program's unit. Creates missing tables on the way, but not entries
    /// of arrays; returns false if such an entry is missing.
    pub fn write(&mut self, path: &KeyPath, value: Value) -> bool {
        let Some((last, tables)) = path.steps.split_last() else {
            return false;
        };
        let mut entries = &mut self.root;
        let mut line = 1;
        for step in tables {
            let mut node = &mut entry(entries, &step.key, line).node;
            if let Some(index) = step.entry {
                let Value::List(nodes) = &mut node.value else {
                    return false;
                };
                let Some(found) = nodes.get_mut(index) else {
                    return false;
                };
                node = found;
            }
            line = node.line;
            let Value::Table(below) = &mut node.value else {
                return false;
            };
            entries = below;
        }
        let node = &mut entry(entries, &last.key, line).node;
        node.written = match &value {
            Value::Number(number) => number.to_string(),
            Value::Text(text) => format!("{text:?}"),
            _ => node.written.clone(),
        };
        node.value = value;
        true
    }
}

/// The entry of a key in any spelling, and the conversion of its numbers.
pub(crate) fn spelled<'e>(entries: &'e [Entry], key: &str) -> Option<(&'e Entry, Conversion)> {
    let find = |entry: &'e Entry| Some((entry, conversion(&entry.key, key)?));
    entries.iter().find_map(find)
}

/// The entry of a key, converted to the program's unit; added as an empty table if missing.
fn entry<'e>(entries: &'e mut Vec<Entry>, key: &str, line: usize) -> &'e mut Entry {
    let place = |entry: &Entry| conversion(&entry.key, key);
    let index = match entries.iter().position(|entry| place(entry).is_some()) {
        Some(index) => {
            let found = &mut entries[index];
            if let Some(conversion) = place(found).filter(|found| found.converts()) {
                convert(&mut found.node, conversion);
                key.clone_into(&mut found.key);
            }
            index
        }
        None => {
            entries.push(Entry {
                key: key.to_owned(),
                node: Node {
                    line,
                    written: "a table".to_owned(),
                    value: Value::Table(Vec::new()),
                },
            });
            entries.len() - 1
        }
    };
    &mut entries[index]
}

/// Converts all numbers of a value to the program's unit.
fn convert(node: &mut Node, conversion: Conversion) {
    match &mut node.value {
        Value::Number(number) => {
            *number = conversion.to_program(*number);
            node.written = number.to_string();
        }
        Value::List(nodes) => nodes.iter_mut().for_each(|node| convert(node, conversion)),
        Value::Table(entries) => {
            for entry in entries {
                convert(&mut entry.node, conversion);
            }
        }
        Value::Text(_) | Value::Foreign => {}
    }
}

/// Converts the parser's tree into entries.
struct Reader<'t> {
    text: &'t str,
    place: Place,
}

impl Reader<'_> {
    fn syntax(&self, error: &toml::de::Error) -> InputError {
        let place = match error.span() {
            Some(span) => self.place.line(self.line(&span)),
            None => self.place.clone(),
        };
        let said = error
            .span()
            .map(|span| {
                self.text[span.start..]
                    .lines()
                    .next()
                    .unwrap_or_default()
                    .trim()
            })
            .map(|rest| match rest {
                "" => " at the end of the line".to_owned(),
                rest => format!(" at `{rest}`"),
            })
            .unwrap_or_default();
        InputError::other(format!("not TOML{said}: {}", error.message())).at(place)
    }

    fn line(&self, span: &Range<usize>) -> usize {
        1 + self.text[..span.start].matches('\n').count()
    }

    fn entries(&self, table: &DeTable<'_>, path: &str) -> Result<Vec<Entry>, InputError> {
        let mut spanned: Vec<_> = table.iter().collect();
        // The parser sorts by key; axes need the order of the file.
        spanned.sort_by_key(|(key, _)| key.span().start);
        spanned
            .into_iter()
            .map(|(key, value)| {
                let path = dotted(path, key.get_ref());
                let line = self.line(&key.span());
                let node = self.node(value.get_ref(), &value.span(), line, &path)?;
                Ok(Entry {
                    key: key.get_ref().to_string(),
                    node,
                })
            })
            .collect()
    }

    fn node(
        &self,
        value: &DeValue<'_>,
        span: &Range<usize>,
        line: usize,
        path: &str,
    ) -> Result<Node, InputError> {
        let mut written = self.text[span.clone()].to_owned();
        let value = match value {
            DeValue::Integer(number) => {
                let radix = number.radix();
                let parsed = i64::from_str_radix(number.as_str(), radix).map(|n| n as f64);
                Value::Number(self.finite(parsed.ok(), &written, line, path)?)
            }
            DeValue::Float(number) => {
                let parsed = number.as_str().parse::<f64>();
                Value::Number(self.finite(parsed.ok(), &written, line, path)?)
            }
            DeValue::String(text) => Value::Text(text.to_string()),
            DeValue::Array(items) => {
                let nodes = items
                    .iter()
                    .enumerate()
                    .map(|(index, item)| {
                        let path = format!("{path}[{}]", index + 1);
                        let line = self.line(&item.span());
                        self.node(item.get_ref(), &item.span(), line, &path)
                    })
                    .collect::<Result<_, _>>()?;
                Value::List(nodes)
            }
            DeValue::Table(table) => {
                if !written.starts_with('{') {
                    written = "a table".to_owned();
                }
                Value::Table(self.entries(table, path)?)
            }
            DeValue::Boolean(_) | DeValue::Datetime(_) => Value::Foreign,
        };
        if written.len() > 60 || written.contains('\n') {
            let bracket = if written.starts_with('{') {
                "{…}"
            } else {
                "[…]"
            };
            written = bracket.to_owned();
        }
        Ok(Node {
            line,
            written,
            value,
        })
    }

    fn finite(
        &self,
        number: Option<f64>,
        written: &str,
        line: usize,
        path: &str,
    ) -> Result<f64, InputError> {
        number.filter(|number| number.is_finite()).ok_or_else(|| {
            InputError::value(path, written, "a finite number").at(self.place.line(line))
        })
    }
}

/// `table.key`, or `key` outside any table.
pub fn dotted(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complaint(text: &str) -> String {
        match Document::parse(Path::new("f.toml"), text) {
            Ok(_) => String::new(),
            Err(error) => error.to_string(),
        }
    }

    #[test]
    fn order_is_the_files() {
        let document = Document::parse(Path::new("f"), "zeta = 1\nalpha = 2.5\n").unwrap();
        let keys: Vec<_> = document.root().iter().map(|e| e.key.as_str()).collect();
        assert_eq!(keys, ["zeta", "alpha"]);
        assert_eq!(document.root()[1].node.line, 2);
    }

    #[test]
    fn integers_floats_and_underscores_are_numbers() {
        let document = Document::parse(Path::new("f"), "a = 1_000\nb = 1e5\nc = 0x10").unwrap();
        let numbers: Vec<_> = document
            .root()
            .iter()
            .map(|e| match e.node.value {
                Value::Number(number) => number,
                _ => f64::NAN,
            })
            .collect();
        assert_eq!(numbers, [1000.0, 1e5, 16.0]);
    }

    #[test]
    fn refuses_what_is_not_finite_with_its_line_and_key() {
        assert_eq!(
            complaint("[scene]\nslope_deg = nan\n"),
            "f.toml:2: scene.slope_deg = nan: expected a finite number"
        );
        assert!(
            complaint("[axes]\nroll_deg = [0,\n -inf]")
                .starts_with("f.toml:3: axes.roll_deg[2] = -inf")
        );
        assert!(complaint("a = 1e999").contains("a = 1e999"));
    }

    #[test]
    fn values_are_written_over_others_and_into_new_tables() {
        let text = "a = 1\n[[legs]]\nx = 2\n[[legs]]\nx = 3\n";
        let mut document = Document::parse(Path::new("f"), text).unwrap();
        let mut write =
            |path, number| document.write(&KeyPath::parse(path).unwrap(), Value::Number(number));
        assert!(write("a", 7.0) && write("legs[2].strut.preload_lb", 5.0));
        assert!(!write("legs[3].x", 1.0) && !write("a.b", 1.0) && !write("a[1].b", 1.0));
        assert_eq!(document.root()[0].node.written, "7");
        let Value::List(legs) = &document.root()[1].node.value else {
            panic!("legs are a list");
        };
        let Value::Table(leg) = &legs[1].value else {
            panic!("a leg is a table");
        };
        assert_eq!((leg[1].key.as_str(), leg[1].node.line), ("strut", 4));
    }

    #[test]
    fn numbers_are_read_and_written_under_any_spelling() {
        let text = "mass_kg = 1\n[inertia_kg_m2]\nxx = 13.558179483314004\nyy = 0\n";
        let mut document = Document::parse(Path::new("f"), text).unwrap();
        let path = |dotted| KeyPath::parse(dotted).unwrap();
        let [xx, yy] = ["inertia_slug_ft2.xx", "inertia_slug_ft2.yy"].map(path);
        assert_eq!(document.number(&xx), Some(10.0));
        assert!(document.write(&yy, Value::Number(3.0)));
        assert!(document.write(&path("mass_slug"), Value::Number(2.0)));
        let keys: Vec<_> = document.root().iter().map(|e| e.key.as_str()).collect();
        assert_eq!(keys, ["mass_slug", "inertia_slug_ft2"]);
        let numbers = [xx, yy, path("mass_slug")].map(|path| document.number(&path));
        assert_eq!(numbers, [Some(10.0), Some(3.0), Some(2.0)]);
    }

    #[test]
    fn syntax_errors_have_their_line() {
        let said = complaint("a = 1\nb = = 2\n");
        assert!(said.starts_with("f.toml:2: not TOML at `"), "{said}");
        assert!(complaint("a = 1\na = 2\n").starts_with("f.toml:2:"));
        for cut in ["a = [1,\n", "a = 1\nb", "a = "] {
            let said = complaint(cut);
            assert!(said.contains("not TOML at the end of the line: "), "{said}");
        }
    }
}
