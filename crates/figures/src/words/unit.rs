//! Units, which are suffixes of the names of columns and parameters.

/// Units by the endings of names: those of 1966, then those of SI.
const UNITS: [(&str, &str); 36] = [
    ("_slug_ft2", "slug ft²"),
    ("_lb_per_ft", "lb/ft"),
    ("_lb_s_per_ft", "lb s/ft"),
    ("_per_ft", "1/ft"),
    ("_fps2", "ft/s²"),
    ("_fps", "ft/s"),
    ("_ftlb", "ft lb"),
    ("_ftlb_s", "ft lb s"),
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
    ("_kg", "kg"),
    ("_kg_m2", "kg m²"),
    ("_m", "m"),
    ("_cm", "cm"),
    ("_mm", "mm"),
    ("_n", "N"),
    ("_n_per_m", "N/m"),
    ("_n_s_per_m", "N s/m"),
    ("_n_s2_per_m2", "N s²/m²"),
    ("_pa", "Pa"),
    ("_kpa", "kPa"),
    ("_mps", "m/s"),
    ("_j", "J"),
    ("_nm_s", "N m s"),
    ("_mps2", "m/s²"),
    ("_per_m", "1/m"),
    ("_rad", "rad"),
    ("_rad_per_s", "rad/s"),
];

/// A name without its unit, and the unit as printed; empty for pure numbers.
pub fn split_unit(name: &str) -> (&str, &'static str) {
    // Moments of inertia have their axes after the unit.
    for (unit, words) in [("_slug_ft2.", "slug ft²"), ("_kg_m2.", "kg m²")] {
        if let Some((bare, _)) = name.rsplit_once(unit) {
            return (bare, words);
        }
    }
    let fitting = UNITS.iter().filter(|(ending, _)| name.ends_with(ending));
    match fitting.max_by_key(|(ending, _)| ending.len()) {
        // Damping is a part of the name.
        Some(("_damping", unit)) => (name, unit),
        Some((ending, unit)) => (&name[..name.len() - ending.len()], unit),
        None => (name, ""),
    }
}

/// Suffixes of result columns in the units of 1966 and in SI. Those that end with another come first.
const IN_SI: [(&str, &str); 4] = [
    ("_ftlb", "_j"),
    ("_lb", "_n"),
    ("_fps", "_mps"),
    ("_ft", "_m"),
];

/// Name in SI results of a column in the units of 1966, if it is different.
pub fn in_si(name: &str) -> Option<String> {
    const PER_UNIT: &str = "_per_unit";
    if let Some(bare) = name.strip_suffix(PER_UNIT) {
        return in_si(bare).map(|column| column + PER_UNIT);
    }
    (IN_SI.iter()).find_map(|(us, si)| Some(format!("{}{si}", name.strip_suffix(us)?)))
}

/// A unit of a table as printed: empty for pure numbers, powers raised.
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
            ("roll_rad", ("roll", "rad")),
            (
                "angular_velocity_x_rad_per_s",
                ("angular_velocity_x", "rad/s"),
            ),
            ("spring_constant_n_per_m", ("spring_constant", "N/m")),
            ("rebound_growth_per_m", ("rebound_growth", "1/m")),
            (
                "rebound_damping_n_s2_per_m2",
                ("rebound_damping", "N s²/m²"),
            ),
            ("vehicle.inertia_kg_m2.xy", ("vehicle.inertia", "kg m²")),
            ("preload_n", ("preload", "N")),
        ] {
            assert_eq!(split_unit(name), expected, "{name}");
        }
        assert_eq!(printed_unit("lb s2/ft2"), "lb s²/ft²");
        assert_eq!(printed_unit("1"), "");
        for (us, si) in [
            ("from_fps", Some("from_mps")),
            ("dvh_dp_fps_per_unit", Some("dvh_dp_mps_per_unit")),
            ("strut_work_#_ftlb", Some("strut_work_#_j")),
            ("strut_force_#_lb", Some("strut_force_#_n")),
            ("z_ft", Some("z_m")),
            ("z_m", None),
            ("roll_deg", None),
        ] {
            assert_eq!(in_si(us).as_deref(), si);
        }
    }
}
