//! All of a sweep's input with defaults filled in, as a tree of names and values.

use serde_json::{Map, Value, json};

use crate::document::{Entry, Value as Read};
use crate::levels::Levels;
use crate::parameter::Parameter;
use crate::search_input::extent_name;
use crate::settings_input::crush_rule_name;
use crate::sweep_file::Sweep;

/// Longest axis whose values are told one by one.
const MOST_VALUES: usize = 1000;

impl<const LEGS: usize> Sweep<LEGS> {
    /// Everything that determines the results, and nothing else: neither title nor file names.
    pub fn resolved(&self) -> Value {
        let scene: Map<String, Value> = self
            .fixed
            .resolved()
            .into_iter()
            .filter(|(name, _)| self.axes.iter().all(|axis| axis.name() != *name))
            .map(|(name, value)| (name.to_owned(), json!(value)))
            .collect();
        let axes: Map<String, Value> = self
            .axes
            .iter()
            .zip(self.grid.axes())
            .map(|(axis, levels)| (axis.name().to_owned(), levels_of(axis, levels)))
            .collect();
        let together: Vec<Vec<&str>> = self
            .grid
            .dimensions()
            .iter()
            .filter(|together| together.len() > 1)
            .map(|together| {
                together
                    .iter()
                    .map(|axis| self.axes[*axis].name())
                    .collect()
            })
            .collect();
        json!({
            "vehicle": tree(self.vehicle.document.root()),
            "scene": scene,
            "axes": axes,
            "axes_that_move_together": together,
            "search": {
                "from_fps": self.search.from,
                "to_fps": self.search.to,
                "scan_step_fps": self.search.scan_step,
                "tolerance_fps": self.search.tolerance,
                "bands": extent_name(self.search.extent),
            },
            "solver": {
                "tolerance": self.settings.tolerance(),
                "time_limit_s": self.settings.time_limit(),
                "crush_rule": crush_rule_name(self.settings.crush_rule()),
            },
        })
    }
}

/// The values of an axis, words as words; of a long one its first and last, and their number.
fn levels_of(axis: &Parameter, levels: &Levels) -> Value {
    let value = |value: f64| match axis.word(value) {
        Some(word) => json!(word),
        None => json!(value),
    };
    match levels {
        Levels::List(_) => levels.values().map(value).collect(),
        short if short.count() <= MOST_VALUES => levels.values().map(value).collect(),
        Levels::Range { from, step, count } => json!({"from": from, "step": step, "count": count}),
        Levels::Even { from, to, count } => json!({"from": from, "to": to, "count": count}),
        Levels::Logarithmic { from, to, count } => {
            json!({"from": from, "to": to, "count": count, "spacing": "log"})
        }
    }
}

fn tree(entries: &[Entry]) -> Value {
    let fields = entries
        .iter()
        .map(|entry| (entry.key.clone(), value(&entry.node.value)));
    Value::Object(fields.collect())
}

fn value(read: &Read) -> Value {
    match read {
        Read::Number(number) => json!(number),
        Read::Text(text) => json!(text),
        Read::List(nodes) => nodes.iter().map(|node| value(&node.value)).collect(),
        Read::Table(entries) => tree(entries),
        Read::Foreign => Value::Null,
    }
}
