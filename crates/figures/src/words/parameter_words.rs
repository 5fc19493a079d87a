//! Parameters by their dotted names, in words.

use crate::unit::bare_name;

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

#[cfg(test)]
mod tests {
    use super::*;

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
