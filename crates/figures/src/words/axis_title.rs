//! Titles of axes: names of columns in words and symbols, with units.

use crate::parameter_words::parameter_words;
use crate::unit::split_unit;

/// Columns with a symbol in their title, or with other words than their names.
const TITLES: [(&str, &str); 22] = [
    ("vertical_velocity_fps", "Vertical velocity V_V, ft/s"),
    ("horizontal_velocity_fps", "Horizontal velocity V_H, ft/s"),
    ("cross_slope_deg", "Cross-slope angle λ, deg"),
    ("slope_deg", "Slope θ, deg"),
    ("friction", "Friction coefficient μ"),
    ("block_friction", "Friction coefficient of the blocks"),
    ("pitch_deg", "Pitch angle Ψ, deg"),
    ("yaw_deg", "Yaw angle Φ, deg"),
    ("roll_deg", "Roll angle Ξ, deg"),
    ("tip_deg", "Tip angle ν, deg"),
    ("tip_azimuth_deg", "Tip azimuth Γ, deg"),
    ("nominal_roll_deg", "Nominal roll angle K, deg"),
    ("x_ft", "Position across, ft"),
    ("y_ft", "Position up the slope, ft"),
    ("z_ft", "Position down, ft"),
    ("x_rate_fps", "Velocity across, ft/s"),
    ("y_rate_fps", "Velocity up the slope, ft/s"),
    ("z_rate_fps", "Velocity down, ft/s"),
    ("angular_velocity_x_dps", "Angular velocity about x, deg/s"),
    ("angular_velocity_y_dps", "Angular velocity about y, deg/s"),
    ("angular_velocity_z_dps", "Angular velocity about z, deg/s"),
    ("sigma_deg", "Stability angle σ, deg"),
];

/// The title of the axis of a column: its name in words with its unit.
pub fn axis_title(column: &str) -> String {
    if let Some((_, title)) = TITLES.iter().find(|(name, _)| *name == column) {
        return (*title).to_owned();
    }
    let (bare, unit) = split_unit(column);
    // The same quantity in another unit.
    let titled = TITLES.iter().find(|(name, _)| split_unit(name).0 == bare);
    let words = match titled.and_then(|(_, title)| title.rsplit_once(", ")) {
        Some((words, _)) => words.to_owned(),
        None => capitalized(&leg_last(&parameter_words(column))),
    };
    match unit {
        "" => words,
        unit => format!("{words}, {unit}"),
    }
}

/// The title of the axis of a column without its unit.
pub fn bare_title(column: &str) -> String {
    let title = axis_title(column);
    let bare = title.strip_suffix(split_unit(column).1).unwrap_or(&title);
    bare.trim_end_matches([' ', ',']).to_owned()
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
}
