//! Parameters by their dotted names, in words.

/// Endings of names that are units; the longer of two that fit comes first.
const UNITS: [&str; 12] = [
    "_slug_ft2",
    "_lb_per_ft",
    "_per_ft",
    "_fps2",
    "_fps",
    "_ft",
    "_deg",
    "_dps",
    "_slug",
    "_psf",
    "_lb",
    "_s",
];

/// A dotted name without units, such as "leg 2 strut preload".
pub fn parameter_words(name: &str) -> String {
    let bare = |key: &str| {
        let unit = UNITS.iter().find(|unit| key.ends_with(*unit));
        let key = unit.map_or(key, |unit| &key[..key.len() - unit.len()]);
        key.replace("legs[", "leg ")
            .replace(']', "")
            .replace('_', " ")
    };
    let keys = name.strip_prefix("vehicle.").unwrap_or(name).split('.');
    keys.map(bare).collect::<Vec<_>>().join(" ")
}

/// A unit as it is printed: nothing for pure numbers, powers raised.
pub fn printed_unit(unit: &str) -> String {
    match unit {
        "1" => String::new(),
        unit => unit.replace('2', "²"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words_without_units() {
        for (name, words) in [
            ("vertical_velocity_fps", "vertical velocity"),
            ("vehicle.mass_slug", "mass"),
            ("vehicle.gravity_fps2", "gravity"),
            ("vehicle.inertia_slug_ft2.xy", "inertia xy"),
            ("vehicle.legs[2].strut.preload_lb", "leg 2 strut preload"),
            (
                "vehicle.strut.compression_damping",
                "strut compression damping",
            ),
            ("vehicle.footpad.profile.scale", "footpad profile scale"),
        ] {
            assert_eq!(parameter_words(name), words);
        }
        assert_eq!(printed_unit("lb s2/ft2"), "lb s²/ft²");
        assert_eq!(printed_unit("1"), "");
    }
}
