//! Checks of the results of a landing.

use touchdown_dynamics::outcome::{Failure, Outcome};
use touchdown_dynamics::scene::Settings;
use touchdown_sweep::landing_table::{self, Cell};

/// Largest part of the energy involved by which its account may stay open, in units of the tolerance, for
/// each so many seconds begun.
const OPEN: f64 = 4.0;
const OPEN_IN: f64 = 3.0;
/// Added to the energy involved, ft·lb: what is left of it where hardly anything moves.
const LITTLE_ENERGY: f64 = 1.0;

/// What landings are held against.
#[derive(Debug)]
pub struct LandingChecks {
    time_limit: f64,
    tolerance: f64,
    /// Names of the results.
    names: Vec<String>,
}

impl LandingChecks {
    /// Of landings of a vehicle with so many legs, computed with these settings.
    pub fn of(settings: &Settings, legs: usize) -> Self {
        Self {
            time_limit: settings.time_limit(),
            tolerance: settings.tolerance(),
            names: landing_table::names(legs),
        }
    }

    /// The energy, ft·lb, by which the account stays open, and its part of the energy involved; none of landings
    /// that ended without a result, as what broke them may show in the last step.
    pub fn open(&self, outcome: &Outcome, cells: &[Cell]) -> Option<[f64; 2]> {
        let involved = self.number(cells, "initial_kinetic_energy_ftlb")
            + self.number(cells, "potential_energy_change_ftlb").abs()
            + LITTLE_ENERGY;
        let open = self.number(cells, "energy_closure_ftlb").abs();
        (!matches!(outcome, Outcome::Failure(_))).then_some([open, open / involved])
    }

    /// A count among the results.
    pub fn count(&self, cells: &[Cell], name: &str) -> u64 {
        match self.cell(cells, name) {
            Some(Cell::Count(count)) => *count,
            _ => 0,
        }
    }

    /// The first check that fails, if any does.
    pub fn complaint(&self, outcome: &Outcome, cells: &[Cell]) -> Option<String> {
        if *outcome == Outcome::Failure(Failure::NonFinite) {
            return Some(Failure::NonFinite.to_string());
        }
        let end = self.number(cells, "end_time_s");
        for (name, cell) in self.names.iter().zip(cells) {
            let Cell::Number(number) = cell else {
                continue;
            };
            let is_contact = name.starts_with("pad_contact") || name.starts_with("block_contact");
            let is_outside = is_contact && !(0.0..=end).contains(number);
            if !number.is_finite() || is_outside {
                return Some(format!("{name} is {number}"));
            }
        }
        if !(0.0..=self.time_limit).contains(&end) {
            return Some(format!("end_time_s is {end}"));
        }
        let [_, open] = self.open(outcome, cells)?;
        let most = OPEN * self.tolerance * (end / OPEN_IN).ceil().max(1.0);
        (open > most).then(|| format!("{open:.1e} of the energy is not accounted for"))
    }

    fn number(&self, cells: &[Cell], name: &str) -> f64 {
        match self.cell(cells, name) {
            Some(Cell::Number(number)) => *number,
            _ => f64::NAN,
        }
    }

    fn cell<'c>(&self, cells: &'c [Cell], name: &str) -> Option<&'c Cell> {
        let place = self.names.iter().position(|known| known == name)?;
        cells.get(place)
    }
}

#[cfg(test)]
pub mod tests {
    use touchdown_dynamics::scene::CrushRule;

    use super::*;

    pub fn settings() -> Settings {
        Settings::new(3e-5, 40.0, CrushRule::default()).unwrap()
    }

    /// A landing made up, with some of its results changed.
    pub fn landed(changes: &[(&str, Cell)]) -> Vec<Cell> {
        let customary = |name: &str| match name {
            "outcome" | "failure" => Cell::Word(String::new()),
            "initial_kinetic_energy_ftlb" => Cell::Number(99.0),
            "end_time_s" => Cell::Number(2.0),
            "steps" | "derivative_evaluations" => Cell::Count(20),
            _ => Cell::Number(0.0),
        };
        let cell = |name: String| {
            let change = changes.iter().find(|(changed, _)| *changed == name);
            change.map_or_else(|| customary(&name), |(_, cell)| cell.clone())
        };
        landing_table::names(3).into_iter().map(cell).collect()
    }

    #[test]
    fn only_what_makes_no_sense_is_complained_of() {
        let checks = LandingChecks::of(&settings(), 3);
        let complaint = |name, number| {
            let cells = landed(&[(name, Cell::Number(number))]);
            checks.complaint(&Outcome::UnstablePitch, &cells)
        };
        // Energy in play is 100 ft·lb, of which 4 × 3e-5 may be missing.
        assert_eq!(complaint("energy_closure_ftlb", -0.011), None);
        let open = complaint("energy_closure_ftlb", -0.013).unwrap();
        assert_eq!(open, "1.3e-4 of the energy is not accounted for");
        let long = [("energy_closure_ftlb", 0.023), ("end_time_s", 3.5)];
        let long = long.map(|(name, number)| (name, Cell::Number(number)));
        assert_eq!(
            checks.complaint(&Outcome::TimeExpired, &landed(&long)),
            None
        );
        for (name, number) in [
            ("pad_contact_2_s", 2.5),
            ("block_contact_1_s", -0.5),
            ("end_time_s", 40.5),
            ("end_time_s", -0.5),
            ("max_strut_force_3_lb", f64::NAN),
            ("min_clearance_ft", f64::INFINITY),
        ] {
            let said = complaint(name, number).unwrap();
            assert!(said.contains(" is "), "{said}");
        }
    }

    #[test]
    fn energy_is_not_asked_of_landings_without_a_result() {
        let checks = LandingChecks::of(&settings(), 3);
        let cells = landed(&[("energy_closure_ftlb", Cell::Number(50.0))]);
        let chattering = Outcome::Failure(Failure::Chattering);
        assert_eq!(checks.complaint(&chattering, &cells), None);
        let broken = Outcome::Failure(Failure::NonFinite);
        assert!(checks.complaint(&broken, &cells).is_some());
    }
}
