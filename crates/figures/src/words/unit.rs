//! Units, which are endings of the names of columns and parameters, as pictures print them; the unit of the speeds of a
//! table.

use std::fmt;

use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::documents::unit::{bare_name_and_unit, unit};

/// Columns in m/s, one of which is in every table of speeds in SI. Axes may be in m/s in any table.
const METRES: [&str; 2] = ["first_transition_mps", "to_mps"];

/// The unit of a name as printed; empty for pure numbers.
pub fn unit_of(name: &str) -> String {
    printed_unit(unit(name))
}

/// A name without its unit.
pub fn bare_name(name: &str) -> &str {
    const DAMPING: &str = "_damping";
    let (bare, _) = bare_name_and_unit(name);
    // Damping is a part of the name.
    match name[bare.len()..].starts_with(DAMPING) {
        true => &name[..bare.len() + DAMPING.len()],
        false => bare,
    }
}

/// Name in SI results of a column in the units of 1966, if it is different.
pub fn in_si(name: &str) -> Option<String> {
    let quantity = OutputUnits::Si.quantity(name);
    (quantity.name() != name).then(|| quantity.name().to_owned())
}

/// A unit of a table as printed: empty for pure numbers, powers raised.
pub fn printed_unit(unit: &str) -> String {
    match unit {
        "1" => String::new(),
        unit => unit.replace('2', "²").replace('3', "³"),
    }
}

/// The unit of speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SpeedUnit {
    /// ft/s.
    #[default]
    FeetPerSecond,
    /// m/s.
    MetresPerSecond,
}

impl SpeedUnit {
    /// Unit of a table (CSV).
    pub fn of_table(csv: &str) -> Self {
        let heading = csv.lines().next().unwrap_or_default();
        match heading.split(',').any(|name| METRES.contains(&name)) {
            true => Self::MetresPerSecond,
            false => Self::FeetPerSecond,
        }
    }

    /// Suffix of names of speeds in this unit.
    pub fn ending(self) -> &'static str {
        match self {
            Self::FeetPerSecond => "_fps",
            Self::MetresPerSecond => "_mps",
        }
    }
}

impl fmt::Display for SpeedUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::FeetPerSecond => "ft/s",
            Self::MetresPerSecond => "m/s",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_parted_from_units() {
        for (name, bare, unit) in [
            ("roll_deg", "roll", "deg"),
            ("strut_force_1_lb", "strut_force_1", "lb"),
            ("kinetic_energy_ftlb", "kinetic_energy", "ft lb"),
            ("rebound_damping", "rebound_damping", "lb s²/ft²"),
            ("friction", "friction", ""),
            (
                "angular_velocity_x_rad_per_s",
                "angular_velocity_x",
                "rad/s",
            ),
            ("rebound_growth_per_m", "rebound_growth", "1/m"),
            ("rebound_damping_n_s2_per_m2", "rebound_damping", "N s²/m²"),
        ] {
            assert_eq!((bare_name(name), unit_of(name).as_str()), (bare, unit));
        }
        assert_eq!(unit_of("vehicle.inertia_kg_m2.xy"), "kg m²");
        assert_eq!(in_si("roll_deg"), None);
        assert_eq!(
            in_si("strut_work_#_ftlb").as_deref(),
            Some("strut_work_#_j")
        );
    }
}
