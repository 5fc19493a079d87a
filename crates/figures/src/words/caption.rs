//! The lines of a picture that its table does not tell, from the record beside it.

use serde_json::Value;

use crate::figure_error::FigureError;

/// What stands above a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Caption {
    /// Title of the picture.
    pub title: String,
    /// Fixed conditions, in a smaller second line.
    pub conditions: String,
    /// What was said before of what the picture shows.
    pub statement: Option<String>,
    /// Highest speed searched, ft/s, if known: the upper end of the picture.
    pub searched_to: Option<f64>,
}

impl Caption {
    /// Reads the caption from the record that a sweep writes beside its table.
    ///
    /// # Errors
    /// When the record is not JSON. What it leaves out is left out of the picture.
    pub fn from_record(record: &str) -> Result<Self, FigureError> {
        let record: Value = serde_json::from_str(record)
            .map_err(|error| FigureError::Table(format!("record: {error}")))?;
        let text = |value: &Value| value.as_str().map(str::to_owned);
        let input = &record["input"];
        let mut parts: Vec<String> = text(&input["vehicle"]["name"]).into_iter().collect();
        for (name, value) in input["scene"].as_object().into_iter().flatten() {
            parts.extend(
                value
                    .as_f64()
                    .and_then(|value| in_words(name, value, input)),
            );
        }
        if input["solver"]["crush_rule"] == "section" {
            parts.push("section crush rule".to_owned());
        }
        Ok(Self {
            title: text(&record["title"]).unwrap_or_default(),
            conditions: parts.join(" · "),
            statement: text(&record["statement"]),
            searched_to: input["search"]["to_fps"].as_f64(),
        })
    }
}

/// A fixed condition in words, unless it is zero, or follows from another, where that is the rule.
fn in_words(name: &str, value: f64, input: &Value) -> Option<String> {
    let words = match name {
        "vertical_velocity_fps" => format!("vertical velocity {value} ft/s"),
        "horizontal_velocity_fps" => format!("horizontal velocity {value} ft/s"),
        "cross_slope_deg" => format!("cross-slope {value} deg"),
        "slope_deg" => format!("slope {value} deg"),
        "friction" => format!("friction {value}"),
        "block_friction" if input["scene"]["friction"].as_f64() == Some(value) => return None,
        "block_friction" => format!("block friction {value}"),
        _ if value == 0.0 => return None,
        _ => {
            let bare = name
                .trim_end_matches("_deg")
                .trim_end_matches("_dps")
                .replace('_', " ");
            let unit = if name.ends_with("_dps") {
                "deg/s"
            } else {
                "deg"
            };
            format!("{bare} {value} {unit}")
        }
    };
    Some(words.replace(" -", " \u{2212}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const RECORD: &str = r#"{"title": "Figure", "statement": "1966: none", "input": {
        "vehicle": {"name": "Surveyor"}, "search": {"to_fps": 25},
        "scene": {"vertical_velocity_fps": 14.0, "friction": 1.0, "block_friction": 1.0,
                  "pitch_deg": 0.0, "nominal_roll_deg": -10.0},
        "solver": {"crush_rule": "section"}}}"#;

    #[test]
    fn conditions_are_told_in_words_where_they_say_something() {
        let caption = Caption::from_record(RECORD).unwrap();
        assert_eq!(
            caption.conditions,
            "Surveyor · vertical velocity 14 ft/s · friction 1 · nominal roll \u{2212}10 deg · \
             section crush rule"
        );
        assert_eq!(caption.statement.as_deref(), Some("1966: none"));
        assert_eq!(caption.searched_to, Some(25.0));
    }

    #[test]
    fn a_record_that_tells_little_is_no_fault_but_one_that_is_none_is() {
        assert_eq!(Caption::from_record("{}").unwrap(), Caption::default());
        let complaint = Caption::from_record("{").unwrap_err().to_string();
        assert!(complaint.contains("record:"), "{complaint}");
    }
}
