//! Checks of the results of a landing.

use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::{Failure, Outcome};
use touchdown_dynamics::scene::Settings;
use touchdown_input::documents::column::{Cell, cells, headings};
use touchdown_sweep::output::landing_table::COLUMNS;

/// Largest part of the energy involved by which its account may stay open, in units of the tolerance, for
/// each so many seconds begun.
const OPEN: f64 = 4.0;
const OPEN_IN: f64 = 3.0;
/// Added to the energy involved, ft·lb: what is left of it where hardly anything moves.
const LITTLE_ENERGY: f64 = 1.0;

/// Limits that results of landings must keep.
#[derive(Debug)]
pub struct LandingChecks {
    time_limit: f64,
    tolerance: f64,
}

impl LandingChecks {
    /// Limits for landings computed with these settings.
    pub fn of(settings: &Settings) -> Self {
        Self {
            time_limit: settings.time_limit(),
            tolerance: settings.tolerance(),
        }
    }

    /// The energy, ft·lb, by which the account stays open, and its part of the energy involved; none of landings
    /// that ended without a result, as what broke them may show in the last step.
    pub fn open(&self, landing: &Landing) -> Option<[f64; 2]> {
        let energies = &landing.energies;
        let involved = energies.initial_kinetic + energies.potential_change.abs() + LITTLE_ENERGY;
        let open = energies.closure().abs();
        (!matches!(landing.outcome, Outcome::Failure(_))).then_some([open, open / involved])
    }

    /// The first check that fails, if any does.
    pub fn complaint(&self, landing: &Landing) -> Option<String> {
        if landing.outcome == Outcome::Failure(Failure::NonFinite) {
            return Some(Failure::NonFinite.to_string());
        }
        let (legs, end) = (landing.leg_count(), landing.end_time);
        for (heading, cell) in headings(&COLUMNS, legs).zip(cells(&COLUMNS, landing, legs)) {
            let Cell::Number(number) = cell else {
                continue;
            };
            if !number.is_finite() {
                return Some(format!("{} is {number}", heading.name));
            }
        }
        let contacts = landing.pad_contact.iter().chain(&landing.block_contact);
        for time in contacts.flatten().chain([&end]) {
            if !(0.0..=end.min(self.time_limit)).contains(time) {
                return Some(format!("a contact or the end is at {time} s"));
            }
        }
        let [_, open] = self.open(landing)?;
        let most = OPEN * self.tolerance * (end / OPEN_IN).ceil().max(1.0);
        (open > most).then(|| format!("{open:.1e} of the energy is not accounted for"))
    }
}

#[cfg(test)]
pub mod tests {
    use touchdown_dynamics::landing::{Energies, FinalRates, LegWork};
    use touchdown_dynamics::scene::CrushRule;

    use super::*;

    pub fn settings() -> Settings {
        Settings::new(3e-5, 40.0, CrushRule::default()).unwrap()
    }

    /// A landing with 99 ft·lb at first contact, of which these stay open, after two seconds and twenty steps.
    pub fn landed(outcome: Outcome, open: f64) -> Landing {
        Landing {
            outcome,
            end_time: 2.0,
            beyond: None,
            min_stability_angle: 0.0,
            min_stability_time: 0.0,
            min_clearance: 0.0,
            tilt: 0.0,
            max_strut_force: [0.0; 3].into(),
            max_stroke: [0.0; 3].into(),
            max_stroke_share: [0.0; 3].into(),
            max_stroke_table_share: [0.0; 3].into(),
            max_pad_crush: [0.0; 3].into(),
            max_pad_crush_share: [0.0; 3].into(),
            max_sinkage: [0.0; 3].into(),
            final_rates: FinalRates {
                stability_angle: None,
                strokes: [0.0; 3].into(),
                stroke_accelerations: [0.0; 3].into(),
            },
            pad_contact: [Some(0.0); 3].into(),
            block_contact: [None; 3].into(),
            energies: Energies {
                initial_kinetic: 99.0,
                potential_change: 0.0,
                thrust: 0.0,
                legs: [LegWork::default(); 3].into(),
                final_kinetic: 99.0 - open,
            },
            steps: 20,
            evaluations: 20,
            events: 0,
        }
    }

    #[test]
    fn only_what_makes_no_sense_is_complained_of() {
        let checks = LandingChecks::of(&settings());
        let landing = |open| landed(Outcome::UnstablePitch, open);
        // Energy in play is 100 ft·lb, of which 4 × 3e-5 may be missing.
        assert_eq!(checks.complaint(&landing(-0.011)), None);
        let open = checks.complaint(&landing(-0.013)).unwrap();
        assert_eq!(open, "1.3e-4 of the energy is not accounted for");
        let mut long = landed(Outcome::TimeExpired, 0.023);
        long.end_time = 3.5;
        assert_eq!(checks.complaint(&long), None);
        let faults: [fn(&mut Landing); 6] = [
            |landing| landing.pad_contact[1] = Some(2.5),
            |landing| landing.block_contact[0] = Some(-0.5),
            |landing| landing.end_time = 40.5,
            |landing| landing.end_time = -0.5,
            |landing| landing.max_strut_force[2] = f64::NAN,
            |landing| landing.min_clearance = f64::INFINITY,
        ];
        for fault in faults {
            let mut faulty = landing(0.0);
            fault(&mut faulty);
            let said = checks.complaint(&faulty).unwrap();
            assert!(said.contains(" is "), "{said}");
        }
    }

    #[test]
    fn energy_is_not_asked_of_landings_without_a_result() {
        let checks = LandingChecks::of(&settings());
        let chattering = Outcome::Failure(Failure::Chattering);
        assert_eq!(checks.complaint(&landed(chattering, 50.0)), None);
        let broken = Outcome::Failure(Failure::NonFinite);
        assert!(checks.complaint(&landed(broken, 50.0)).is_some());
    }
}
