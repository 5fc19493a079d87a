//! The history of a landing, column by column, and its energy balance as stacked parts that close.

use serde::Serialize;
use touchdown_dynamics::landing::{Instant, LegWork};
use touchdown_figures::axis_title::column_words;
use touchdown_figures::unit::unit_of;
use touchdown_input::documents::history_columns::{names, values};
use touchdown_input::documents::output_units::OutputUnits;

/// Columns with the names used in history files.
#[derive(Debug, Serialize)]
pub struct History {
    columns: Vec<Column>,
}

#[derive(Debug, Serialize)]
struct Column {
    name: String,
    title: String,
    unit: String,
    values: Vec<f64>,
}

impl History {
    /// Builds it from the instants of a landing.
    pub fn of(instants: &[Instant], units: OutputUnits) -> Self {
        let names = instants.first().map(names).unwrap_or_default();
        let quantities: Vec<_> = names.iter().map(|name| units.quantity(name)).collect();
        let mut told: Vec<Column> = (quantities.iter())
            .map(|quantity| Column {
                name: quantity.name().to_owned(),
                title: column_words(quantity.name()),
                unit: unit_of(quantity.name()),
                values: Vec::with_capacity(instants.len()),
            })
            .collect();
        for instant in instants {
            let values = values(instant).into_iter().zip(&quantities);
            for (column, (value, quantity)) in told.iter_mut().zip(values) {
                column.values.push(quantity.number(value));
            }
        }
        Self { columns: told }
    }
}

/// Energies at every instant.
#[derive(Debug, Serialize)]
pub struct Energies {
    unit: &'static str,
    /// Available energy: kinetic energy at contact, potential energy released, and work of the thrust.
    total: Vec<f64>,
    parts: Vec<Part>,
    /// Energy not explained by the parts.
    closure: Vec<f64>,
}

#[derive(Debug, Serialize)]
struct Part {
    name: &'static str,
    title: &'static str,
    values: Vec<f64>,
}

/// Name and title of a part absorbed by the legs.
type LegPart = (&'static str, &'static str, fn(&LegWork) -> f64);

const LEG_PARTS: [LegPart; 6] = [
    ("strut", "struts", |work| work.strut),
    ("pad_crush", "footpads, crushing", |work| work.pad_crush),
    ("pad_friction", "footpads, sliding", |work| {
        work.pad_friction
    }),
    ("block_crush", "blocks, crushing", |work| work.block_crush),
    ("block_friction", "blocks, sliding", |work| {
        work.block_friction
    }),
    ("stop", "stops", |work| work.stop),
];

impl Energies {
    /// Builds it from the instants of a landing, the first at first contact.
    pub fn of(instants: &[Instant], units: OutputUnits) -> Self {
        let energy = units.quantity("energy_ftlb");
        let initial = instants.first().map_or(0.0, |first| first.kinetic_energy);
        let total = |at: &Instant| initial + at.potential_change + at.thrust_work.unwrap_or(0.0);
        let taken = |at: &Instant, of: fn(&LegWork) -> f64| -> f64 {
            at.legs.iter().map(|leg| of(&leg.work)).sum()
        };
        let closure = |at: &Instant| {
            let spent: f64 = LEG_PARTS.iter().map(|(.., of)| taken(at, *of)).sum();
            total(at) - at.kinetic_energy - spent
        };
        let kinetic = Part {
            name: "kinetic",
            title: "kinetic energy",
            values: instants
                .iter()
                .map(|at| energy.number(at.kinetic_energy))
                .collect(),
        };
        let legs = LEG_PARTS.iter().map(|&(name, title, of)| Part {
            name,
            title,
            values: instants
                .iter()
                .map(|at| energy.number(taken(at, of)))
                .collect(),
        });
        Self {
            unit: energy.unit(),
            total: instants.iter().map(|at| energy.number(total(at))).collect(),
            closure: instants
                .iter()
                .map(|at| energy.number(closure(at)))
                .collect(),
            parts: std::iter::once(kinetic).chain(legs).collect(),
        }
    }
}
