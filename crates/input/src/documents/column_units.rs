//! Columns of tables in other units than they were written in.

use crate::documents::output_units::{OutputUnits, Quantity};
use crate::documents::spelling::{Conversion, dotted_conversion, program_spelling};

/// A column of a table in other units.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnInUnits {
    from: Conversion,
    to: Quantity,
}

impl ColumnInUnits {
    /// Form in these units of a column with this name, whose unit may be of either.
    pub fn of(name: &str, units: OutputUnits) -> Self {
        let program_name = program_spelling(name);
        let to = units.quantity(&program_name);
        match dotted_conversion(name, &program_name) {
            Some(from) if to.name() != name => Self { from, to },
            // What is in these units already stays, digit for digit.
            _ => Self {
                from: Conversion::NONE,
                to: OutputUnits::Us.quantity(name),
            },
        }
    }

    /// Name, including the unit.
    pub fn name(&self) -> &str {
        self.to.name()
    }

    /// Converts a number of the column.
    pub fn number(&self, number: f64) -> f64 {
        self.to.number(self.from.to_program(number))
    }
}

/// Units of names that end with theirs: those of more of them; `None` where no name tells.
pub fn units_of_names<'n>(names: impl IntoIterator<Item = &'n str>) -> Option<OutputUnits> {
    let mut more_in_si = 0;
    for name in names {
        let is_in = |units| ColumnInUnits::of(name, units).name() == name;
        more_in_si += match (is_in(OutputUnits::Us), is_in(OutputUnits::Si)) {
            (false, true) => 1,
            (true, false) => -1,
            _ => 0,
        };
    }
    match more_in_si {
        0 => None,
        1.. => Some(OutputUnits::Si),
        _ => Some(OutputUnits::Us),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_come_from_either_units_and_names_tell_theirs() {
        for (name, us, si) in [
            (
                "first_transition_mps",
                "first_transition_fps",
                "first_transition_mps",
            ),
            (
                "first_transition_fps",
                "first_transition_fps",
                "first_transition_mps",
            ),
            ("min_clearance_m", "min_clearance_ft", "min_clearance_m"),
            (
                "vehicle.strut.preload_n",
                "vehicle.strut.preload_lb",
                "vehicle.strut.preload_n",
            ),
            (
                "vehicle.inertia_kg_m2.xy",
                "vehicle.inertia_slug_ft2.xy",
                "vehicle.inertia_kg_m2.xy",
            ),
            (
                "footing[2].height_m",
                "footing[2].height_ft",
                "footing[2].height_m",
            ),
            ("roll_deg", "roll_deg", "roll_deg"),
            ("landings", "landings", "landings"),
        ] {
            let [in_us, in_si] =
                [OutputUnits::Us, OutputUnits::Si].map(|units| ColumnInUnits::of(name, units));
            assert_eq!((in_us.name(), in_si.name()), (us, si));
            for there in [&in_us, &in_si]
                .into_iter()
                .filter(|there| there.name() == name)
            {
                assert_eq!(there.number(0.1), 0.1);
            }
        }
        let feet = ColumnInUnits::of("vertical_velocity_mps", OutputUnits::Us);
        assert_eq!(feet.number(4.2672), 14.0);
        let of = |names: &[&str]| units_of_names(names.iter().copied());
        assert_eq!(of(&["roll_deg", "friction"]), None);
        assert_eq!(
            of(&["mass_kg", "height_m", "preload_lb"]),
            Some(OutputUnits::Si)
        );
        assert_eq!(of(&["first_transition_fps"]), Some(OutputUnits::Us));
    }
}
