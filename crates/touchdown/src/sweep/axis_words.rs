//! The axes of a sweep and their values, in words.

use serde_json::Value;
use touchdown_input::sweeps::sweep_file::Sweep;

/// Longest axis whose values are all listed, and how many are listed of a longer one before its last.
const MOST_LISTED: usize = 16;
const LISTED_OF_LONGER: usize = 3;

/// A line for each axis: its values, or how they are distributed; then axes that move together.
pub fn text(sweep: &Sweep) -> String {
    let input = sweep.resolved_in(sweep.units);
    let mut text = String::new();
    for axis in &sweep.axes {
        let axis = sweep.units.quantity(axis.name());
        let name = axis.name();
        text += &format!("  {name}: {}\n", values(&input["axes"][name]));
    }
    for group in list(&input["axes_that_move_together"]) {
        let names: Vec<String> = list(group).iter().map(word).collect();
        text += &format!("  {} move together\n", names.join(" and "));
    }
    text
}

fn values(axis: &Value) -> String {
    match axis {
        Value::Array(values) if values.len() <= MOST_LISTED => listed(values),
        Value::Array(values) => {
            let first = listed(&values[..LISTED_OF_LONGER]);
            let last = values.last().map(word).unwrap_or_default();
            format!("{first}, …, {last} ({} values)", values.len())
        }
        Value::Object(parts) => {
            let part = |(name, value): (&String, &Value)| match value {
                // A distribution with its numbers, or a column with its values.
                Value::Object(_) | Value::Array(_) => format!("{name}, {}", values(value)),
                value => format!("{name} {}", word(value)),
            };
            parts.iter().map(part).collect::<Vec<_>>().join(", ")
        }
        other => word(other),
    }
}

fn listed(values: &[Value]) -> String {
    values.iter().map(word).collect::<Vec<_>>().join(", ")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// A number as results write it, or a word without quotes.
fn word(value: &Value) -> String {
    match (value, value.as_f64()) {
        (Value::String(word), _) => word.clone(),
        (_, Some(number)) => number.to_string(),
        (other, None) => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_are_listed_and_distributions_named() {
        assert_eq!(values(&json!([-10.0, 0.0, 7.5])), "-10, 0, 7.5");
        assert_eq!(values(&json!(["section"])), "section");
        let long: Vec<f64> = (0..25).map(|index| 5.0 * f64::from(index) - 60.0).collect();
        assert_eq!(values(&json!(long)), "-60, -55, -50, …, 60 (25 values)");
        assert_eq!(
            values(&json!({"uniform": {"from": 0.0, "to": 2.5}})),
            "uniform, from 0, to 2.5"
        );
        assert_eq!(
            values(&json!({"from": 0.0, "step": 0.5, "count": 4000})),
            "from 0, step 0.5, count 4000"
        );
    }
}
