//! Table of the results of cases.

use touchdown_dynamics::landing::Landing;

use crate::column::{cells, headings};
use crate::landing_table::COLUMNS;
use crate::output_units::{OutputUnits, Quantity};

/// True if a file with this first line is a table of results of cases.
pub fn is_table(line: &str) -> bool {
    line.starts_with("case,outcome,end_time_s,")
}

/// The results of cases as CSV in these units: `case`, then the columns of [`landing_table`] for the greatest number of
/// legs.
///
/// [`landing_table`]: crate::landing_table
///
/// # Errors
/// Only out of memory.
pub fn table<'r>(
    rows: impl Iterator<Item = (&'r str, &'r Landing)> + Clone,
    units: OutputUnits,
) -> Result<Vec<u8>, csv::Error> {
    let legs = rows.clone().map(|(_, landing)| landing.leg_count());
    let legs = legs.max().unwrap_or(0);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_field("case")?;
    let names = headings(&COLUMNS, legs).map(|one| units.quantity(&one.name));
    let quantities: Vec<Quantity> = names.collect();
    writer.write_record(quantities.iter().map(Quantity::name))?;
    for (name, landing) in rows {
        writer.write_field(name)?;
        let row = quantities.iter().zip(cells(&COLUMNS, landing, legs));
        writer.write_record(row.map(|(quantity, cell)| quantity.cell(cell).to_string()))?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}
