//! The full input of a sweep in the units of its results.

use serde_json::{Map, Value, json};

use crate::documents::output_units::{OutputUnits, Quantity};
use crate::sweeps::sweep_file::Sweep;

impl Sweep {
    /// [`Sweep::resolved`] with names and numbers converted from program units to those of results.
    pub fn resolved_in(&self, units: OutputUnits) -> Value {
        match units {
            OutputUnits::Us => self.resolved(),
            OutputUnits::Si => Tree { units }.value("", self.resolved(), &[]),
        }
    }
}

struct Tree {
    units: OutputUnits,
}

impl Tree {
    /// Converts the value of a key. Its numbers have the unit of the key, or of a key above it.
    fn value(&self, key: &str, value: Value, above: &[Quantity]) -> Value {
        match value {
            // Parts are counts without unit, whatever the unit of the axis.
            Value::Object(entries) if key == "parts_of_first_level" => {
                let renamed = entries.into_iter();
                let renamed = renamed.map(|(axis, parts)| (self.name(&axis), parts));
                Value::Object(renamed.collect())
            }
            Value::Object(entries) => {
                let is_product = key == "covariance";
                let entry = |(key, value): (String, Value)| {
                    let own = self.units.quantity(&key);
                    let name = own.name().to_owned();
                    let told = match (own.converts(), is_product) {
                        (false, _) => self.value(&key, value, above),
                        (true, false) => self.value(&key, value, &[own]),
                        (true, true) => self.value(&key, value, &[above, &[own]].concat()),
                    };
                    (name, told)
                };
                Value::Object(entries.into_iter().map(entry).collect::<Map<_, _>>())
            }
            Value::Array(items) => {
                let items = items.into_iter();
                items.map(|item| self.value(key, item, above)).collect()
            }
            Value::String(name) if ["sensitivity", "axes_that_move_together"].contains(&key) => {
                json!(self.name(&name))
            }
            Value::Number(ref number) if !above.is_empty() && key != "count" => {
                let told = |number| above.iter().fold(number, |number, one| one.number(number));
                number.as_f64().map_or(value, |number| json!(told(number)))
            }
            other => other,
        }
    }

    fn name(&self, name: &str) -> String {
        self.units.quantity(name).name().to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_numbers_change_together_and_counts_stay() {
        let read = json!({
            "vehicle": {"mass_slug": 10.0, "inertia_slug_ft2": {"xx": 10.0},
                        "footpad": {"profile": {"depth_in": [0.0, 1.0], "multiplier": [1.0, 2.0]}}},
            "axes": {
                "vertical_velocity_fps": {"jointly-normal": {"mean": 10.0, "covariance":
                    {"vertical_velocity_fps": 1.0, "pitch_deg": 1.0}}},
                "vehicle.strut.preload_lb": {"from": 100.0, "step": 100.0, "count": 4000},
                "roll_deg": [0.0, 10.0],
            },
            "search": {"to_fps": 10.0, "bands": "all"},
            "sensitivity": ["vehicle.strut.preload_lb", "friction"],
            "axes_that_move_together": [["friction", "vehicle.mass_slug"]],
            "map": {"parts_of_first_level": {"vehicle.mass_slug": 8, "roll_deg": 4}, "error_fps": 0.1},
        });
        let tree = Tree {
            units: OutputUnits::Si,
        };
        let expected = json!({
            "vehicle": {"mass_kg": 145.93902937206364, "inertia_kg_m2": {"xx": 13.558179483314},
                        "footpad": {"profile": {"depth_m": [0.0, 0.0254], "multiplier": [1.0, 2.0]}}},
            "axes": {
                "vertical_velocity_mps": {"jointly-normal": {"mean": 3.048, "covariance":
                    {"vertical_velocity_mps": 0.09290304, "pitch_deg": 0.3048}}},
                "vehicle.strut.preload_n":
                    {"from": 444.82216152605, "step": 444.82216152605, "count": 4000},
                "roll_deg": [0.0, 10.0],
            },
            "search": {"to_mps": 3.048, "bands": "all"},
            "sensitivity": ["vehicle.strut.preload_n", "friction"],
            "axes_that_move_together": [["friction", "vehicle.mass_kg"]],
            "map": {"parts_of_first_level": {"vehicle.mass_kg": 8, "roll_deg": 4}, "error_mps": 0.03048},
        });
        assert_eq!(tree.value("", read, &[]), expected);
    }
}
