//! The captions of a picture, from the record beside its table.

use serde_json::Value;

use crate::axis_title::{column_words, parameter_words};
use crate::division::Division;
use crate::unit::{SpeedUnit, bare_name, unit_of};
use crate::words::FigureError;
use crate::words::label;

/// Greatest velocity that a search can reach, ft/s; in m/s it is less.
const MOST_SEARCHED: f64 = 1e4;

/// Caption above a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Caption {
    /// Title of the picture.
    pub title: String,
    /// Fixed conditions, in a smaller second line.
    pub conditions: String,
    /// Axes over which the picture shows the worst case, if any.
    pub worst_over: Option<String>,
    /// Statement of the report of 1966 about this figure.
    pub statement: Option<String>,
    /// Highest speed searched, if known: the upper end of the picture.
    pub searched_to: Option<f64>,
    /// Error that a refined map was asked for, if any.
    pub map_error: Option<f64>,
    /// Axes with logarithmic scales.
    pub logarithmic: Vec<String>,
    /// Unit of the speeds of the picture.
    pub speed_unit: SpeedUnit,
    /// True if the vehicle's feet are like the report's: three, at azimuths of 0, 120 and 240 deg about the CG.
    pub has_report_feet: bool,
}

impl Caption {
    /// The caption of a table (CSV) of this name, from the record beside it if there is one.
    ///
    /// # Errors
    /// As [`Caption::from_record`].
    pub fn of_table(name: &str, table: &str, record: Option<&str>) -> Result<Self, FigureError> {
        let speed_unit = SpeedUnit::of_table(table);
        let mut caption = match record {
            Some(record) => Self::from_record(record, speed_unit)?,
            None => Self {
                speed_unit,
                ..Self::default()
            },
        };
        if caption.title.is_empty() {
            name.clone_into(&mut caption.title);
        }
        Ok(caption)
    }

    /// Reads the caption from the record that a sweep writes beside its table, whose speeds are in this unit, or from the report
    /// of a landing.
    ///
    /// # Errors
    /// When the record is not JSON, or is in other units than the table. What it leaves out is left out of the picture.
    pub fn from_record(record: &str, speed_unit: SpeedUnit) -> Result<Self, FigureError> {
        let record: Value = serde_json::from_str(record)
            .map_err(|error| FigureError::Table(format!("record: {error}")))?;
        let text = |value: &Value| value.as_str().map(str::to_owned);
        // Reports have what was put in beside what came out.
        let input = match &record["input"] {
            Value::Null => &record,
            input => input,
        };
        let mut parts: Vec<String> = text(&input["vehicle"]["name"]).into_iter().collect();
        for (name, value) in input["scene"].as_object().into_iter().flatten() {
            parts.extend(
                value
                    .as_f64()
                    .and_then(|value| in_words(name, value, input)),
            );
        }
        parts.extend(text(&input["solver"]["rules_in_full"]));
        if let Some(kept) = input["search"]["keep_deg"].as_f64() {
            parts.push(format!("stability angle of {} deg kept", label(kept)));
        }
        let cells = |name: &str| record["counts"][name].as_u64().unwrap_or(0);
        let coarse = cells("map_cells_coarser_than_asked");
        if coarse > 0 {
            let all = cells("map_cells");
            parts.push(format!("{coarse} of {all} cells coarser than asked"));
        }
        let searched_to = input["search"][format!("to{}", speed_unit.ending())].as_f64();
        if searched_to.is_none() && input["search"].is_object() {
            return Err(FigureError::Table(format!(
                "record: expected speeds in {speed_unit}, as in the table"
            )));
        }
        if let Some(speed) = searched_to.filter(|speed| !(0.0..=MOST_SEARCHED).contains(speed)) {
            return Err(FigureError::Table(format!(
                "record: to{} = {speed}: expected a number from 0 to {MOST_SEARCHED}",
                speed_unit.ending()
            )));
        }
        Ok(Self {
            title: text(&record["title"]).unwrap_or_default(),
            conditions: parts.join(" · "),
            worst_over: None,
            statement: text(&record["statement"]),
            searched_to,
            map_error: input["map"][format!("error{}", speed_unit.ending())].as_f64(),
            logarithmic: logarithmic(&record["spacing"]),
            speed_unit,
            has_report_feet: has_report_feet(&input["vehicle"]),
        })
    }

    /// Division of the scale of an axis.
    pub(crate) fn division(&self, axis: &str) -> Division {
        match self.logarithmic.iter().any(|known| known == axis) {
            true => Division::Decades,
            false => Division::Linear,
        }
    }

    /// Words for points without a transition.
    pub fn without_transition(&self) -> String {
        match self.searched_to {
            Some(speed) => format!("stable up to {} {}", label(speed), self.speed_unit),
            None => "no transition".to_owned(),
        }
    }

    /// The caption of one of a family of pictures, with its values of the other axes, as tables have them. Statements on the
    /// sweep do not hold for it.
    pub(crate) fn at(&self, cells: &[(String, String)]) -> Self {
        if cells.is_empty() {
            return self.clone();
        }
        let words = cells.iter().map(|(axis, value)| {
            let value = value.parse().map_or_else(|_| value.clone(), label);
            let words = format!("{} {value} {}", parameter_words(axis), unit_of(axis));
            words.trim_end().to_owned()
        });
        Self {
            title: [self.title.clone()]
                .into_iter()
                .chain(words)
                .collect::<Vec<_>>()
                .join(", "),
            statement: None,
            ..self.clone()
        }
    }

    /// The caption of a picture that shows the lowest transition over some axes of a sweep. Statements on the sweep do
    /// not hold for it.
    pub fn worst_over(self, others: &[String]) -> Self {
        if others.is_empty() {
            return self;
        }
        let words: Vec<String> = others.iter().map(|axis| column_words(axis)).collect();
        Self {
            worst_over: Some(format!("V_H at worst over {}", listed(&words))),
            statement: None,
            ..self
        }
    }
}

/// Words in a sentence: "a, b and c".
fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [word] => word.clone(),
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    }
}

/// The axes whose spacing in a record is logarithmic.
fn logarithmic(spacing: &Value) -> Vec<String> {
    let axes = spacing.as_object().into_iter().flatten();
    axes.filter(|(_, spacing)| *spacing == "log")
        .map(|(axis, _)| axis.clone())
        .collect()
}

fn has_report_feet(vehicle: &Value) -> bool {
    let offset = ["x_ft", "y_ft", "x_m", "y_m"];
    let offset = offset.map(|axis| &vehicle[format!("center_of_gravity_offset_{axis}")]);
    if offset
        .iter()
        .any(|part| part.as_f64().is_some_and(|part| part != 0.0))
    {
        return false;
    }
    let azimuths = vehicle["legs"].as_array().into_iter().flatten();
    let mut azimuths: Vec<f64> = azimuths
        .filter_map(|leg| leg["azimuth_deg"].as_f64())
        .collect();
    azimuths.sort_by(f64::total_cmp);
    azimuths == [0.0, 120.0, 240.0]
}

/// A fixed condition in words. `None` for zero, unless zero is worth telling, and for block friction equal to friction.
fn in_words(name: &str, value: f64, input: &Value) -> Option<String> {
    let number = label(value);
    let words = match name {
        "vertical_velocity_fps"
        | "horizontal_velocity_fps"
        | "vertical_velocity_mps"
        | "horizontal_velocity_mps" => {
            format!(
                "{} {number} {}",
                bare_name(name).replace('_', " "),
                unit_of(name)
            )
        }
        "cross_slope_deg" => format!("cross-slope {number} deg"),
        "slope_deg" => format!("slope {number} deg"),
        "friction" => format!("friction {number}"),
        "block_friction" if input["scene"]["friction"].as_f64() == Some(value) => return None,
        "block_friction" => format!("block friction {number}"),
        _ if value == 0.0 => return None,
        _ => {
            format!(
                "{} {number} {}",
                bare_name(name).replace('_', " "),
                unit_of(name)
            )
        }
    };
    Some(words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const RECORD: &str = r#"{"title": "Figure", "statement": "1966: none", "input": {
        "vehicle": {"name": "Surveyor"}, "search": {"to_fps": 25},
        "scene": {"vertical_velocity_fps": 14.0, "friction": 1.0, "block_friction": 1.0,
                  "pitch_deg": 0.0, "nominal_roll_deg": -10.0},
        "solver": {"rules_in_full": "1966 rules, crush rule section"}}}"#;

    #[test]
    fn conditions_are_told_in_words_where_they_say_something() {
        let caption = Caption::from_record(RECORD, SpeedUnit::default()).unwrap();
        assert_eq!(
            caption.conditions,
            "Surveyor · vertical velocity 14 ft/s · friction 1 · nominal roll \u{2212}10 deg · \
             1966 rules, crush rule section"
        );
        let kept = RECORD.replace("\"to_fps\": 25", "\"to_fps\": 25, \"keep_deg\": 5");
        let kept = Caption::from_record(&kept, SpeedUnit::default()).unwrap();
        let expected = format!("{} · stability angle of 5 deg kept", caption.conditions);
        assert_eq!(kept.conditions, expected);
        assert_eq!(caption.statement.as_deref(), Some("1966: none"));
        assert_eq!(caption.searched_to, Some(25.0));
        assert!(!caption.has_report_feet);
        let others = ["friction", "vehicle.strut.preload_lb", "roll_deg"].map(str::to_owned);
        let worst = caption.worst_over(&others);
        assert_eq!(
            worst.worst_over.as_deref(),
            Some("V_H at worst over friction coefficient μ, strut preload and roll angle Ξ")
        );
        assert_eq!(worst.statement, None);
    }

    #[test]
    fn the_reports_vehicle_is_known_by_its_feet() {
        let has_report_feet = |azimuths: &[f64], offset: f64| {
            let legs = azimuths
                .iter()
                .map(|azimuth| json!({"azimuth_deg": azimuth}));
            let legs: Vec<Value> = legs.collect();
            let vehicle = json!({"legs": legs, "center_of_gravity_offset_y_ft": offset});
            let record = json!({"input": {"vehicle": vehicle}}).to_string();
            Caption::from_record(&record, SpeedUnit::default())
                .unwrap()
                .has_report_feet
        };
        assert!(has_report_feet(&[0.0, 120.0, 240.0], 0.0));
        assert!(has_report_feet(&[240.0, 0.0, 120.0], 0.0));
        assert!(!has_report_feet(&[0.0, 120.0, 240.0], -0.1));
        assert!(!has_report_feet(&[0.0, 90.0, 180.0, 270.0], 0.0));
        assert!(!has_report_feet(&[60.0, 180.0, 300.0], 0.0));
    }

    #[test]
    fn axes_are_logarithmic_where_the_record_says_so_whatever_their_values() {
        let record = json!({
            "input": {"axes": {"friction": [0.1, 1.0, 10.0], "slope_deg": [5, 10, 20]}},
            "spacing": {"friction": "log"},
        });
        let caption = Caption::from_record(&record.to_string(), SpeedUnit::default()).unwrap();
        assert_eq!(caption.division("friction"), Division::Decades);
        assert_eq!(caption.division("slope_deg"), Division::Linear);
    }

    #[test]
    fn a_record_that_tells_little_is_no_fault_but_one_that_is_none_is() {
        let read = |record| Caption::from_record(record, SpeedUnit::default());
        assert_eq!(read("{}").unwrap(), Caption::default());
        let complaint = read("{").unwrap_err().to_string();
        assert!(complaint.contains("record:"), "{complaint}");
    }

    #[test]
    fn a_record_has_the_units_of_its_table() {
        let in_si = RECORD.replace("to_fps\": 25", "to_mps\": 7.62").replace(
            "vertical_velocity_fps\": 14.0",
            "vertical_velocity_mps\": 4.2672",
        );
        let caption = Caption::from_record(&in_si, SpeedUnit::MetresPerSecond).unwrap();
        assert_eq!(caption.searched_to, Some(7.62));
        assert!(caption.conditions.contains("vertical velocity 4.2672 m/s"));
        for (record, unit) in [
            (in_si.as_str(), SpeedUnit::FeetPerSecond),
            (RECORD, SpeedUnit::MetresPerSecond),
        ] {
            let complaint = Caption::from_record(record, unit).unwrap_err().to_string();
            let expected = format!("record: expected speeds in {unit}, as in the table");
            assert!(complaint.contains(&expected), "{complaint}");
        }
    }
}
