//! Soil: the table [scene.soil] or a name in its place, and axes such as `soil.bearing_strength_psf`.

use touchdown_dynamics::quantities::{self, CONDITIONS, THRUST};
use touchdown_dynamics::soil::{Bearing, Soil};

use super::{NamedConditions, SceneFault, conditions};
use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};
use crate::documents::spelling::conversion;
use crate::readers::numbers::keys_of;

/// The table of soil, and its keys.
pub(crate) const SOIL: &str = "soil";
pub(crate) const SOIL_KEYS: [&str; 5] = keys_of(quantities::SOIL);

/// Soils by name, each with its bearing strength, kPa, at 5 cm: those of the Lunar Regolith Database. Only that of Surveyor 3 tells
/// sinkages, 20 kPa at 2 cm and 60 kPa at 5 cm, here a straight line; 5 cm of the others are an assumption.
const SOILS: [(&str, f64); 6] = [
    ("surveyor-1", 40.0),
    ("surveyor-3", 55.0),
    ("surveyor-5", 27.0),
    ("surveyor-6", 34.0),
    ("surveyor-7", 21.0),
    ("luna-13", 68.0),
];
/// No soil.
const ROCK: &str = "rock";
/// Part of the sinkage that named soils give back: that of the lunar soil in Project Chrono's rover demonstration.
const REBOUND: f64 = 0.004;

/// Names of the conditions of soil, in the order of [`SOIL_KEYS`].
fn names() -> [&'static str; SOIL_KEYS.len()] {
    let first = CONDITIONS.len() + THRUST.len();
    std::array::from_fn(|key| conditions(0)[first + key].name.as_str())
}

/// Finds one of these numbers in a table [scene]. An axis may replace one of a soil given by name.
pub(super) fn find<'d>(scene: &Section<'d>, name: &str) -> Option<LocatedValue<'d>> {
    let key = names().iter().position(|known| *known == name)?;
    let soil = scene.optional_section(SOIL, &SOIL_KEYS).ok()??;
    soil.optional(SOIL_KEYS[key])
}

/// The names, that of no soil first.
pub fn soil_names() -> impl Iterator<Item = &'static str> {
    std::iter::once(ROCK).chain(SOILS.map(|(name, _)| name))
}

impl NamedConditions {
    /// Sets the numbers of a soil by its name. Returns whether it is one of the [`soil_names`].
    pub fn set_soil(&mut self, word: &str) -> bool {
        let Some((_, strength)) = SOILS.iter().find(|(name, _)| *name == word) else {
            return word == ROCK;
        };
        let numbers = [
            ("bearing_strength_kpa", *strength),
            ("bearing_depth_cm", 5.0),
            ("bearing_exponent", 1.0),
            ("rebound", REBOUND),
        ];
        for ((key, name), (spelling, number)) in SOIL_KEYS.iter().zip(names()).zip(numbers) {
            if let Some(unit) = conversion(spelling, key) {
                self.set(name, unit.to_program(number));
            }
        }
        true
    }

    pub(super) fn read_soil(&mut self, scene: &Section) -> Result<(), InputError> {
        let Some(found) = scene.optional(SOIL) else {
            return Ok(());
        };
        if let Ok(word) = found.text() {
            let listed: Vec<String> = soil_names().map(|name| format!("\"{name}\"")).collect();
            return match self.set_soil(word) {
                true => Ok(()),
                false => {
                    Err(found.complain(&format!("{} or a table of numbers", listed.join(", "))))
                }
            };
        }
        let Some(soil) = scene.optional_section(SOIL, &SOIL_KEYS)? else {
            return Ok(());
        };
        for (key, name) in SOIL_KEYS.iter().zip(names()) {
            if let Some(value) = soil.optional_number(key)? {
                self.set(name, value);
            }
        }
        Ok(())
    }

    /// The soil: rock, if none of its numbers is given.
    pub(super) fn soil(&self) -> Result<Soil, SceneFault> {
        let names = names();
        if names.iter().all(|name| self.get(name).is_none()) {
            return Ok(Soil::Rock);
        }
        let [strength, depth, exponent, rebound, drag] = names.map(|name| self.need(name));
        let (bearing, drag) = (Bearing::new(strength?, depth?, exponent?, rebound?), drag?);
        (bearing.and_then(|bearing| bearing.with_inertial_drag(drag)))
            .map(Soil::Yielding)
            .map_err(|invalid| self.fault(invalid))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn soils_are_those_of_the_reference() {
        const PAGE: &str = include_str!("../../../../../docs/reference.md");
        for (name, strength) in SOILS {
            let row = format!("| `\"{name}\"` | {strength} kPa |");
            assert!(PAGE.contains(&row), "{row}");
        }
        let rows = PAGE
            .lines()
            .filter(|row| row.contains(" kPa | ") && row.starts_with("| `\""));
        assert_eq!(rows.count(), SOILS.len());
    }
}
