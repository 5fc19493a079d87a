//! Units, which the names of columns and parameters end with.

/// Units by the endings of names: the longer of two that fit comes first.
const UNITS: [(&str, &str); 16] = [
    ("_slug_ft2", "slug ft²"),
    ("_lb_per_ft", "lb/ft"),
    ("_per_ft", "1/ft"),
    ("_fps2", "ft/s²"),
    ("_fps", "ft/s"),
    ("_ftlb", "ft lb"),
    ("_ft", "ft"),
    ("_in", "in"),
    ("_deg", "deg"),
    ("_dps", "deg/s"),
    ("_slug", "slug"),
    ("_psf", "lb/ft²"),
    ("_lb", "lb"),
    ("_us", "µs"),
    ("_s", "s"),
    ("_damping", "lb s²/ft²"),
];

/// A name without its unit, and the unit as it is printed; the unit is empty for pure numbers.
pub fn split_unit(name: &str) -> (&str, &'static str) {
    // Moments of inertia have their axes after the unit.
    if let Some((bare, _)) = name.rsplit_once("_slug_ft2.") {
        return (&name[..bare.len()], "slug ft²");
    }
    match UNITS.iter().find(|(ending, _)| name.ends_with(ending)) {
        // Damping is a part of the name.
        Some(("_damping", unit)) => (name, unit),
        Some((ending, unit)) => (&name[..name.len() - ending.len()], unit),
        None => (name, ""),
    }
}

/// A unit of a table as it is printed: nothing for pure numbers, powers raised.
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
    fn units_are_split_from_names() {
        for (name, expected) in [
            ("roll_deg", ("roll", "deg")),
            ("strut_force_1_lb", ("strut_force_1", "lb")),
            ("kinetic_energy_ftlb", ("kinetic_energy", "ft lb")),
            ("rebound_damping", ("rebound_damping", "lb s²/ft²")),
            ("spring_constant_lb_per_ft", ("spring_constant", "lb/ft")),
            ("friction", ("friction", "")),
        ] {
            assert_eq!(split_unit(name), expected, "{name}");
        }
        assert_eq!(printed_unit("lb s2/ft2"), "lb s²/ft²");
        assert_eq!(printed_unit("1"), "");
    }
}
