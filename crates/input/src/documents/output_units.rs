//! Units of results.

use std::fmt;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::documents::column::{Cell, Column, cells, headings};
use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::documents::spelling::{Conversion, dotted_conversion, spelling_for_results};
use crate::documents::unit::unit;

/// Key of an input file for the units of results.
pub(crate) const UNITS: &str = "units";

/// Suffix of columns per unit of another quantity.
const PER_UNIT: &str = "_per_unit";

/// Units of tables, records, reports and pictures. Landings and journals always use the units of 1966.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum OutputUnits {
    /// Foot, slug, pound, second and degree.
    #[default]
    #[serde(rename = "US")]
    Us,
    /// Metre, kilogram, newton, joule and second; angles stay in degrees.
    #[serde(rename = "SI")]
    Si,
}

impl fmt::Display for OutputUnits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Us => "US",
            Self::Si => "SI",
        })
    }
}

impl OutputUnits {
    /// Reads the units from an input file.
    pub(crate) fn read(root: &Section) -> Result<Self, InputError> {
        let Some(found) = root.optional(UNITS) else {
            return Ok(Self::default());
        };
        let units = Self::named(found.text()?);
        units.ok_or_else(|| found.complain("\"US\" or \"SI\""))
    }

    /// Finds the units with a name.
    pub fn named(name: &str) -> Option<Self> {
        let all = [Self::Us, Self::Si];
        all.into_iter().find(|units| units.to_string() == name)
    }

    /// Results of a row by column, in these units.
    pub fn by_name<R>(self, columns: &[Column<R>], row: &R, legs: usize) -> Map<String, Value> {
        let named = headings(columns, legs).zip(cells(columns, row, legs));
        let named = named.map(|(heading, cell)| {
            let quantity = self.quantity(&heading.name);
            (quantity.name().to_owned(), quantity.cell(cell).into())
        });
        named.collect()
    }

    /// Output form of a quantity, given by its name with the program unit. A name with an SI unit keeps it.
    pub fn quantity(self, name: &str) -> Quantity {
        let as_it_is = || Quantity {
            name: name.to_owned(),
            conversion: Conversion::NONE,
        };
        if self == Self::Us {
            return as_it_is();
        }
        let (bare, end) = match name.strip_suffix(PER_UNIT) {
            Some(bare) => (bare, PER_UNIT),
            None => (name, ""),
        };
        let spelling = spelling_for_results(bare);
        match dotted_conversion(&spelling, bare) {
            Some(conversion) => Quantity {
                name: spelling + end,
                conversion,
            },
            None => as_it_is(),
        }
    }
}

/// A quantity in the units of results.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    name: String,
    conversion: Conversion,
}

impl Quantity {
    /// Name, including the unit.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Unit in words; 1 for pure numbers.
    pub fn unit(&self) -> &'static str {
        unit(&self.name)
    }

    /// True if its unit differs from that of the program.
    pub(crate) fn converts(&self) -> bool {
        self.conversion.converts()
    }

    /// Converts a number from program units to this unit.
    pub fn number(&self, number: f64) -> f64 {
        self.conversion.in_own_unit(number)
    }

    /// Converts a derivative by the quantity from per program unit to per this unit.
    pub fn derivative(&self, per_unit: f64) -> f64 {
        self.conversion.to_program(per_unit)
    }

    /// Converts the number of a cell from program units to this unit; leaves words, counts and empty cells unchanged.
    pub fn cell(&self, cell: Cell) -> Cell {
        match cell {
            Cell::Number(number) => Cell::Number(self.number(number)),
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers_come_out_in_si() {
        for (name, expected, number, in_si) in [
            (
                "first_transition_fps",
                "first_transition_mps",
                11.4,
                3.47472,
            ),
            ("min_clearance_ft", "min_clearance_m", 0.5, 0.1524),
            (
                "max_strut_force_2_lb",
                "max_strut_force_2_n",
                100.0,
                444.82216152605,
            ),
            // Energies and moments of inertia: within rounding of a decimal of fifteen digits, which they become.
            (
                "energy_closure_ftlb",
                "energy_closure_j",
                10.0,
                13.558179483314,
            ),
            ("dvh_dp_fps_per_unit", "dvh_dp_mps_per_unit", 1.0, 0.3048),
            (
                "within_vertical_velocity_fps",
                "within_vertical_velocity_mps",
                10.0,
                3.048,
            ),
            (
                "vehicle.strut.stroke_in",
                "vehicle.strut.stroke_m",
                1.0,
                0.0254,
            ),
            (
                "vehicle.inertia_slug_ft2.xy",
                "vehicle.inertia_kg_m2.xy",
                10.0,
                13.558179483314,
            ),
            // Angles, times, numbers, and what is named in SI already.
            ("roll_deg", "roll_deg", 30.0, 30.0),
            ("angular_velocity_x_dps", "angular_velocity_x_dps", 3.0, 3.0),
            ("end_time_s", "end_time_s", 2.5, 2.5),
            ("friction", "friction", 0.8, 0.8),
            ("slope_rad", "slope_rad", 0.1, 0.1),
            (
                "vehicle.block.height_mm",
                "vehicle.block.height_mm",
                7.0,
                7.0,
            ),
            (
                "angular_velocity_x_rad_per_s",
                "angular_velocity_x_rad_per_s",
                1.0,
                1.0,
            ),
        ] {
            let quantity = OutputUnits::Si.quantity(name);
            assert_eq!(
                (quantity.name(), quantity.number(number)),
                (expected, in_si)
            );
            let us = OutputUnits::Us.quantity(name);
            assert_eq!((us.name(), us.number(number)), (name, number));
        }
        let speed = OutputUnits::Si.quantity("speed_fps");
        let none = Cell::Word("none".to_owned());
        assert_eq!(
            [Cell::Empty, none.clone(), Cell::Number(10.0)].map(|cell| speed.cell(cell)),
            [Cell::Empty, none, Cell::Number(3.048)]
        );
        assert_eq!(speed.derivative(0.3048), 1.0);
        assert_eq!(speed.unit(), "m/s");
    }
}
