//! Units of columns, parameters and keys, given by the endings of their names.

use std::f64::consts::PI;

/// A unit of the program and the SI units allowed in its place in input files; results in SI use the first of them.
pub(crate) struct Unit {
    /// Ending of names.
    pub(crate) ending: &'static str,
    pub(crate) words: &'static str,
    pub(crate) si: &'static [SiUnit],
}

/// An SI unit that corresponds to one of the program.
pub(crate) struct SiUnit {
    /// Ending of names.
    pub(crate) ending: &'static str,
    words: &'static str,
    /// Number of these units in one program unit.
    pub(crate) factor: f64,
}

const fn unit_of(ending: &'static str, words: &'static str, si: &'static [SiUnit]) -> Unit {
    Unit { ending, words, si }
}

const fn si(ending: &'static str, words: &'static str, factor: f64) -> SiUnit {
    SiUnit {
        ending,
        words,
        factor,
    }
}

/// One foot is 0.3048 m, one inch 0.0254 m and one pound-force 4.4482216152605 N. The other factors follow from these;
/// the slug is 1 lb s2/ft.
pub(crate) const UNITS: [Unit; 18] = [
    unit_of("_slug", "slug", &[si("_kg", "kg", 14.593902937206364)]),
    unit_of(
        "_slug_ft2",
        "slug ft2",
        &[si("_kg_m2", "kg m2", 1.3558179483314003)],
    ),
    unit_of(
        "_slug_ft3",
        "slug/ft3",
        &[si("_kg_m3", "kg/m3", 515.3788183931961)],
    ),
    unit_of(
        "_ft",
        "ft",
        &[
            si("_m", "m", 0.3048),
            si("_cm", "cm", 30.48),
            si("_mm", "mm", 304.8),
        ],
    ),
    unit_of(
        "_in",
        "inch",
        &[
            si("_m", "m", 0.0254),
            si("_cm", "cm", 2.54),
            si("_mm", "mm", 25.4),
        ],
    ),
    unit_of("_lb", "lb", &[si("_n", "N", 4.4482216152605)]),
    unit_of(
        "_lb_per_ft",
        "lb/ft",
        &[si("_n_per_m", "N/m", 14.593902937206364)],
    ),
    unit_of(
        "_lb_s_per_ft",
        "lb s/ft",
        &[si("_n_s_per_m", "N s/m", 14.593902937206364)],
    ),
    unit_of(
        "_psf",
        "lb/ft2",
        &[
            si("_pa", "Pa", 47.880258980335846),
            si("_kpa", "kPa", 0.04788025898033584),
        ],
    ),
    unit_of("_fps", "ft/s", &[si("_mps", "m/s", 0.3048)]),
    unit_of("_fps2", "ft/s2", &[si("_mps2", "m/s2", 0.3048)]),
    unit_of(
        "_per_ft",
        "1/ft",
        &[si("_per_m", "1/m", 3.2808398950131235)],
    ),
    unit_of("_deg", "deg", &[si("_rad", "rad", PI / 180.0)]),
    unit_of("_dps", "deg/s", &[si("_rad_per_s", "rad/s", PI / 180.0)]),
    unit_of(
        "_damping",
        "lb s2/ft2",
        &[si("_damping_n_s2_per_m2", "N s2/m2", 47.880258980335846)],
    ),
    unit_of("_ftlb", "ft lb", &[si("_j", "J", 1.3558179483314003)]),
    unit_of(
        "_ftlb_s",
        "ft lb s",
        &[si("_nm_s", "N m s", 1.3558179483314003)],
    ),
    unit_of("_s", "s", &[]),
];

/// Unit of a column or parameter, by the ending of its name; 1 for pure numbers and words.
pub fn unit(name: &str) -> &'static str {
    // The leg number of forces and times precedes the unit; the axes of moments of inertia follow it.
    let name = match name.rsplit_once('.') {
        Some((table, _)) if table.ends_with(".inertia_slug_ft2") => table,
        Some((table, _)) if table.ends_with(".inertia_kg_m2") => table,
        _ => name,
    };
    bare_name_and_unit(name).1
}

/// Splits a name into the name without unit, and the unit in words; 1 for pure numbers and words.
pub fn bare_name_and_unit(name: &str) -> (&str, &'static str) {
    let endings = UNITS.iter().flat_map(|unit| {
        let si = unit.si.iter().map(|si| (si.ending, si.words));
        si.chain([(unit.ending, unit.words)])
    });
    let bare = |(ending, words)| Some((name.strip_suffix(ending)?, words));
    let shortest = endings.filter_map(bare).min_by_key(|(bare, _)| bare.len());
    shortest.unwrap_or((name, "1"))
}

/// Splits a name that ends with a unit of the program into the name without it, and the unit.
pub(crate) fn program_unit(name: &str) -> Option<(&str, &'static Unit)> {
    let fitting =
        (const { &UNITS }.iter()).filter_map(|unit| Some((name.strip_suffix(unit.ending)?, unit)));
    fitting.max_by_key(|(_, unit)| unit.ending.len())
}

/// A name without its unit, if that is one of the program.
pub fn without_program_unit(name: &str) -> &str {
    program_unit(name).map_or(name, |(bare, _)| bare)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_bare_without_their_longest_unit() {
        for (name, expected) in [
            ("first_transition_fps", ("first_transition", "ft/s")),
            ("max_strut_force_2_n", ("max_strut_force_2", "N")),
            (
                "vehicle.strut.spring_constant_lb_per_ft",
                ("vehicle.strut.spring_constant", "lb/ft"),
            ),
            ("steps", ("steps", "1")),
        ] {
            assert_eq!(bare_name_and_unit(name), expected);
        }
    }

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
            ("slope_rad", "rad"),
            ("angular_velocity_x_rad_per_s", "rad/s"),
            ("vehicle.inertia_kg_m2.xy", "kg m2"),
            ("vehicle.strut.structural_stiffness_n_per_m", "N/m"),
            ("vehicle.strut.rebound_growth_per_m", "1/m"),
            ("vehicle.strut.rebound_damping_n_s2_per_m2", "N s2/m2"),
            ("vehicle.block.height_mm", "mm"),
        ] {
            assert_eq!(unit(name), expected, "{name}");
        }
    }

    /// numerator / 10^power / denominator * 10^other, rounded once.
    fn ratio(numerator: u128, denominator: u128, power: i32) -> f64 {
        let (whole, mut rest) = (numerator / denominator, numerator % denominator);
        let mut digits = whole.to_string();
        for _ in 0..25 {
            rest *= 10;
            digits += &(rest / denominator).to_string();
            rest %= denominator;
        }
        format!("{digits}e{}", power - 25).parse().unwrap()
    }

    #[test]
    fn factors_are_the_definitions_to_the_last_digit() {
        // A pound-force is 44482216152605e-13 N, a foot 3048e-4 m.
        const POUND: u128 = 44_482_216_152_605;
        const FOOT: u128 = 3048;
        let factor = |ending: &str| {
            let units = UNITS.iter().flat_map(|unit| unit.si);
            let found: Vec<f64> = units
                .filter(|si| si.ending == ending)
                .map(|si| si.factor)
                .collect();
            found[0]
        };
        for (ending, expected) in [
            ("_m", ratio(FOOT, 1, -4)),
            ("_n", ratio(POUND, 1, -13)),
            ("_kg", ratio(POUND, FOOT, -9)),
            ("_n_per_m", ratio(POUND, FOOT, -9)),
            ("_kg_m2", ratio(POUND * FOOT, 1, -17)),
            ("_pa", ratio(POUND, FOOT * FOOT, -5)),
            ("_kpa", ratio(POUND, FOOT * FOOT, -8)),
            ("_damping_n_s2_per_m2", ratio(POUND, FOOT * FOOT, -5)),
            ("_per_m", ratio(1, FOOT, 4)),
            ("_mps", ratio(FOOT, 1, -4)),
            ("_mps2", ratio(FOOT, 1, -4)),
            ("_j", ratio(POUND * FOOT, 1, -17)),
        ] {
            assert_eq!(factor(ending), expected, "{ending}");
        }
    }
}
