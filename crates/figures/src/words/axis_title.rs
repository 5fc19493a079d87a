//! Names of columns and parameters in words and symbols: titles of axes, with units, and parts of sentences.

use std::collections::HashMap;
use std::sync::LazyLock;

use touchdown_dynamics::quantities;
use touchdown_input::documents::history_columns::OF_BODY;

use crate::unit::{bare_name, unit_of};

/// Titles of columns of histories and of conditions, by their names without units.
static TITLES: LazyLock<HashMap<&str, &str>> = LazyLock::new(|| {
    let of_input = quantities::CONDITIONS
        .iter()
        .map(|quantity| (quantity.key, quantity.title));
    let of_history = OF_BODY.iter().map(|column| (column.name(), column.title()));
    // What both name is titled as in histories.
    of_input
        .chain(of_history)
        .filter_map(|(name, title)| Some((bare_name(name), title?)))
        .collect()
});

/// The title of the axis of a column: its name in words with its unit.
pub fn axis_title(column: &str) -> String {
    let words = bare_title(column);
    match unit_of(column).as_str() {
        "" => words,
        unit => format!("{words}, {unit}"),
    }
}

/// The title of the axis of a column without its unit.
pub fn bare_title(column: &str) -> String {
    match TITLES.get(bare_name(column)) {
        Some(title) => (*title).to_owned(),
        None => capitalized(&leg_last(&parameter_words(column))),
    }
}

/// A column in words, without its unit, for a sentence or a legend.
pub fn column_words(column: &str) -> String {
    let words = bare_title(column);
    let mut letters = words.chars();
    match letters.next() {
        Some(first) => first.to_lowercase().chain(letters).collect(),
        None => String::new(),
    }
}

/// A dotted name in words, without units, such as "leg 2 strut preload".
pub fn parameter_words(name: &str) -> String {
    let bare = |key: &str| {
        bare_name(key)
            .replace("legs[", "leg ")
            .replace("footing[", "footing ")
            .replace(']', "")
            .replace("cross_slope", "cross-slope")
            .replace('_', " ")
    };
    let keys = name.strip_prefix("vehicle.").unwrap_or(name).split('.');
    keys.map(bare).collect::<Vec<_>>().join(" ")
}

/// Moves the number of a leg, which column names have before their unit, to the end of the words.
fn leg_last(words: &str) -> String {
    let mut others: Vec<&str> = words.split(' ').collect();
    let is_leg = |word: &&str| matches!(word.as_bytes(), [b'1'..=b'8']);
    let Some(index) = others.iter().rposition(is_leg) else {
        return words.to_owned();
    };
    // "leg 2 strut preload" has the word leg already.
    if index == 0 || others[index - 1] == "leg" {
        return words.to_owned();
    }
    let leg = others.remove(index);
    format!("{}, leg {leg}", others.join(" "))
}

fn capitalized(words: &str) -> String {
    let mut letters = words.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_have_words_and_units() {
        for (column, title) in [
            ("roll_deg", "Roll angle Ξ, deg"),
            ("y_rate_mps", "Velocity up the slope, m/s"),
            ("sigma_deg", "Stability angle σ, deg"),
            ("strut_force_2_lb", "Strut force, leg 2, lb"),
            ("pad_set_1_inboard_ft", "Pad set inboard, leg 1, ft"),
            (
                "vehicle.strut.rebound_damping",
                "Strut rebound damping, lb s²/ft²",
            ),
            (
                "vehicle.center_of_gravity_height_ft",
                "Center of gravity height, ft",
            ),
            (
                "vehicle.legs[2].strut.preload_lb",
                "Leg 2 strut preload, lb",
            ),
            ("friction", "Friction coefficient μ"),
            ("slope_rad", "Slope θ, rad"),
            ("vertical_velocity_mps", "Vertical velocity V_V, m/s"),
            ("vehicle.mass_kg", "Mass, kg"),
        ] {
            assert_eq!(axis_title(column), title);
        }
        assert_eq!(column_words("friction"), "friction coefficient μ");
        assert_eq!(column_words("strut_force_2_lb"), "strut force, leg 2");
        assert_eq!(
            column_words("vertical_velocity_fps"),
            "vertical velocity V_V"
        );
    }

    #[test]
    fn names_are_words_without_units() {
        for (name, words) in [
            ("vertical_velocity_fps", "vertical velocity"),
            ("cross_slope_deg", "cross-slope"),
            ("vehicle.mass_slug", "mass"),
            ("vehicle.gravity_fps2", "gravity"),
            ("vehicle.inertia_slug_ft2.xy", "inertia xy"),
            ("vehicle.legs[2].strut.preload_lb", "leg 2 strut preload"),
            (
                "vehicle.strut.compression_damping",
                "strut compression damping",
            ),
            ("vehicle.footpad.profile.scale", "footpad profile scale"),
            ("footing[2].height_ft", "footing 2 height"),
        ] {
            assert_eq!(parameter_words(name), words);
        }
    }
}
