//! One landing as a row of named results, with units in the names; events that never happened are empty.

use std::fmt;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::Outcome;

use crate::output_units::OutputUnits;

/// A result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Cell {
    /// A word or a sentence.
    Word(String),
    /// A quantity.
    Number(f64),
    /// A count.
    Count(u64),
    /// An event that never happened.
    Empty,
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => f.write_str(word),
            Self::Number(number) => write!(f, "{number}"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Empty => Ok(()),
        }
    }
}

impl From<Option<f64>> for Cell {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Empty, Self::Number)
    }
}

impl From<Cell> for Value {
    fn from(cell: Cell) -> Self {
        match cell {
            Cell::Word(word) => word.into(),
            Cell::Number(number) => number.into(),
            Cell::Count(count) => count.into(),
            Cell::Empty => Self::Null,
        }
    }
}

/// Name and value of a result.
pub type Column = (String, Cell);

/// All results of a landing in these units, in column order.
pub fn columns_in(units: OutputUnits, landing: &Landing) -> Vec<Column> {
    let columns = columns(landing).into_iter();
    let told = |(name, cell): Column| {
        let quantity = units.quantity(&name);
        let cell = match cell {
            Cell::Number(number) => Cell::Number(quantity.number(number)),
            other => other,
        };
        (quantity.name().to_owned(), cell)
    };
    columns.map(told).collect()
}

/// All results of a landing in program units, in column order.
pub fn columns(landing: &Landing) -> Vec<Column> {
    let mut columns = vec![column("outcome", Cell::Word(landing.outcome.to_string()))];
    let mut number = |name: &str, value| columns.push(column(name, Cell::from(value)));
    number("end_time_s", Some(landing.end_time));
    number(
        "min_stability_angle_deg",
        Some(landing.min_stability_angle.to_degrees()),
    );
    number("min_clearance_ft", Some(landing.min_clearance));
    number("tilt_deg", Some(landing.tilt.to_degrees()));
    number(
        "initial_kinetic_energy_ftlb",
        Some(landing.energies.initial_kinetic),
    );
    number(
        "potential_energy_change_ftlb",
        Some(landing.energies.potential_change),
    );
    for (leg, force) in landing.max_strut_force.iter().enumerate() {
        number(&format!("max_strut_force_{}_lb", leg + 1), Some(*force));
    }
    for (leg, stroke) in landing.max_stroke.iter().enumerate() {
        number(&format!("max_stroke_{}_ft", leg + 1), Some(*stroke));
    }
    for (leg, share) in landing.max_stroke_share.iter().enumerate() {
        number(&format!("max_stroke_share_{}", leg + 1), Some(*share));
    }
    for (leg, time) in landing.pad_contact.iter().enumerate() {
        number(&format!("pad_contact_{}_s", leg + 1), *time);
    }
    for (leg, time) in landing.block_contact.iter().enumerate() {
        number(&format!("block_contact_{}_s", leg + 1), *time);
    }
    let given = landing.energies.given_by_contact();
    number("given_by_contact_ftlb", Some(given));
    number("energy_closure_ftlb", Some(landing.energies.closure()));
    columns.push(column("steps", Cell::Count(landing.steps)));
    columns.push(column(
        "derivative_evaluations",
        Cell::Count(landing.evaluations),
    ));
    columns.push(column("failure", Cell::Word(failure(&landing.outcome))));
    columns
}

/// Names of the columns for a vehicle with `legs` legs.
pub fn names(legs: usize) -> Vec<String> {
    let before = [
        "outcome",
        "end_time_s",
        "min_stability_angle_deg",
        "min_clearance_ft",
        "tilt_deg",
        "initial_kinetic_energy_ftlb",
        "potential_energy_change_ftlb",
    ];
    let of_legs = [
        ("max_strut_force", "_lb"),
        ("max_stroke", "_ft"),
        ("max_stroke_share", ""),
        ("pad_contact", "_s"),
        ("block_contact", "_s"),
    ];
    let after = [
        "given_by_contact_ftlb",
        "energy_closure_ftlb",
        "steps",
        "derivative_evaluations",
        "failure",
    ];
    let of_legs = of_legs
        .iter()
        .flat_map(|(name, unit)| (1..=legs).map(move |leg| format!("{name}_{leg}{unit}")));
    let own = |name: &str| name.to_owned();
    before
        .map(own)
        .into_iter()
        .chain(of_legs)
        .chain(after.map(own))
        .collect()
}

/// Results of a landing in a table for `legs` legs; cells of legs that its vehicle lacks are empty.
pub fn under_headings(cells: &[Cell], legs: usize) -> Vec<String> {
    let own = names(leg_count(cells));
    let told = |name: String| {
        let index = own.iter().position(|known| *known == name);
        let cell = index.and_then(|index| cells.get(index));
        cell.map_or_else(String::new, Cell::to_string)
    };
    names(legs).into_iter().map(told).collect()
}

/// Columns for the results of a landing in a table for `legs` legs; its vehicle may have fewer.
pub fn places(results: usize, legs: usize) -> Vec<usize> {
    let own_legs = legs_of(results);
    if own_legs == legs {
        return (0..results).collect();
    }
    let (all, own) = (names(legs), names(own_legs));
    let place = |name: &String| all.iter().position(|known| known == name);
    own.iter().filter_map(place).collect()
}

/// Number of legs of the vehicle that has these results.
pub fn leg_count(cells: &[Cell]) -> usize {
    legs_of(cells.len())
}

fn legs_of(results: usize) -> usize {
    let [of_none, of_one] = [0, 1].map(|legs| names(legs).len());
    results.saturating_sub(of_none) / (of_one - of_none)
}

fn column(name: &str, cell: Cell) -> Column {
    (name.to_owned(), cell)
}

/// An outcome in words.
pub fn why(outcome: &Outcome) -> String {
    match outcome {
        Outcome::StableRockback => "it tipped up, stopped and fell back".to_owned(),
        Outcome::StableSubsided => "its motion died out near the ground".to_owned(),
        Outcome::UnstablePitch => {
            "its CG passed over the line through the critical feet".to_owned()
        }
        Outcome::UnstableToppled => "its CG passed beyond the hull of its feet".to_owned(),
        Outcome::UnstableYaw => "all feet are on one side of the plane of motion".to_owned(),
        Outcome::Bottomed { leg } => format!("strut {} used up its stroke", leg + 1),
        Outcome::BottomedPad { leg } => {
            format!("footpad {} was crushed by its whole height", leg + 1)
        }
        Outcome::BottomedBlock { leg } => {
            format!("block {} was crushed by its whole height", leg + 1)
        }
        Outcome::TimeExpired => "it was still moving at the time limit".to_owned(),
        Outcome::Failure(reason) => reason.to_string(),
        Outcome::Sliding => {
            "it slides steadily down a slope on which friction cannot stop it".to_owned()
        }
        Outcome::StableSteady => "it was steady and far from toppling".to_owned(),
    }
}

/// Reason why a landing could not be computed; otherwise empty.
fn failure(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Failure(reason) => reason.to_string(),
        _ => String::new(),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use touchdown_dynamics::landing::{Energies, FinalRates, LegWork};
    use touchdown_dynamics::outcome::Failure;

    /// A landing invented for tests of tables.
    pub fn example() -> Landing {
        Landing {
            beyond: None,
            outcome: Outcome::Failure(Failure::PadInclination { leg: 1 }),
            end_time: 1.5,
            min_stability_angle: std::f64::consts::PI / 6.0,
            min_stability_time: 1.0,
            min_clearance: 0.5,
            tilt: std::f64::consts::PI / 6.0,
            max_strut_force: [1.0, 2.0, 3.0].into(),
            max_stroke: [0.25, 0.5, 0.125].into(),
            max_stroke_share: [0.5, 1.0, 0.25].into(),
            max_pad_crush: [0.0; 3].into(),
            max_pad_crush_share: [0.0; 3].into(),
            final_rates: FinalRates {
                stability_angle: None,
                strokes: [0.0; 3].into(),
                stroke_accelerations: [0.0; 3].into(),
            },
            pad_contact: [Some(0.0), None, Some(0.25)].into(),
            block_contact: [None; 3].into(),
            energies: Energies {
                initial_kinetic: 100.0,
                potential_change: 10.0,
                thrust: 0.0,
                legs: [LegWork::default(); 3].into(),
                final_kinetic: 109.5,
            },
            steps: 7,
            evaluations: 70,
            events: 3,
        }
    }

    #[test]
    fn columns_have_the_names_of_the_contract() {
        let (names, values): (Vec<_>, Vec<_>) = columns(&example()).into_iter().unzip();
        assert_eq!(names, super::names(3));
        assert_eq!(
            names.join(","),
            "outcome,end_time_s,min_stability_angle_deg,min_clearance_ft,tilt_deg,\
             initial_kinetic_energy_ftlb,potential_energy_change_ftlb,\
             max_strut_force_1_lb,max_strut_force_2_lb,max_strut_force_3_lb,\
             max_stroke_1_ft,max_stroke_2_ft,max_stroke_3_ft,\
             max_stroke_share_1,max_stroke_share_2,max_stroke_share_3,\
             pad_contact_1_s,pad_contact_2_s,pad_contact_3_s,\
             block_contact_1_s,block_contact_2_s,block_contact_3_s,\
             given_by_contact_ftlb,energy_closure_ftlb,steps,derivative_evaluations,failure"
        );
        let expected = "failure,1.5,29.999999999999996,0.5,29.999999999999996,100,10,1,2,3,\
                        0.25,0.5,0.125,0.5,1,0.25,0,,0.25,,,,0,0.5,7,70,loaded footpad 2 inclined more than 65 deg";
        let values: Vec<String> = values.iter().map(Cell::to_string).collect();
        assert_eq!(values.join(","), expected);
    }
}
