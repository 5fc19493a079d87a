//! Units of columns and parameters, which their names carry.

/// Units by the endings of names; the longer of two that fit comes first.
const UNITS: [(&str, &str); 14] = [
    ("_lb_per_ft", "lb/ft"),
    ("_per_ft", "1/ft"),
    ("_slug_ft2", "slug ft2"),
    ("_fps2", "ft/s2"),
    ("_fps", "ft/s"),
    ("_ftlb", "ft lb"),
    ("_ft", "ft"),
    ("_deg", "deg"),
    ("_dps", "deg/s"),
    ("_slug", "slug"),
    ("_psf", "lb/ft2"),
    ("_lb", "lb"),
    ("_s", "s"),
    ("_damping", "lb s2/ft2"),
];

/// Unit of a column or parameter, by the ending of its name; 1 for pure numbers and words.
pub fn unit(name: &str) -> &'static str {
    // Forces and times of one leg carry its number before their unit, moments of inertia the axes
    // after it.
    let name = name
        .rsplit_once(".inertia_slug_ft2.")
        .map_or(name, |_| "inertia_slug_ft2");
    let found = UNITS.iter().find(|(ending, _)| name.ends_with(ending));
    found.map_or("1", |(_, unit)| unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_follow_from_names() {
        for (name, expected) in [
            ("roll_deg", "deg"),
            ("first_transition_fps", "ft/s"),
            ("vehicle.gravity_fps2", "ft/s2"),
            ("vehicle.inertia_slug_ft2.xy", "slug ft2"),
            ("vehicle.strut.structural_stiffness_lb_per_ft", "lb/ft"),
            ("vehicle.strut.rebound_damping", "lb s2/ft2"),
            ("vehicle.footpad.profile.scale", "1"),
            ("max_strut_force_1_lb", "lb"),
            ("energy_closure_ftlb", "ft lb"),
            ("friction", "1"),
        ] {
            assert_eq!(unit(name), expected, "{name}");
        }
    }
}
