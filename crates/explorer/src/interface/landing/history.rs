//! The history of a landing, column by column.

use serde::Serialize;
use touchdown_dynamics::landing::Instant;
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
