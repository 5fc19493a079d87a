//! Table of the results of cases.

use crate::findings::Finding;
use crate::landing_table::{self, Cell};
use crate::output_units::{OutputUnits, Quantity};

/// True if a file with this first line is a table of results of cases.
pub fn is_table(line: &str) -> bool {
    line.starts_with("case,outcome,end_time_s,")
}

/// The results of cases as CSV in these units: `case`, then the columns of [`landing_table`] for the greatest number of
/// legs.
///
/// # Errors
/// Only out of memory.
pub fn table<'r>(
    rows: impl Iterator<Item = (&'r str, &'r Finding)> + Clone,
    units: OutputUnits,
) -> Result<Vec<u8>, csv::Error> {
    let cells = |finding: &'r Finding| -> &'r [Cell] {
        match finding {
            Finding::Landing { cells, .. } => cells,
            _ => &[],
        }
    };
    let legs = rows
        .clone()
        .map(|(_, finding)| landing_table::leg_count(cells(finding)));
    let legs = legs.max().unwrap_or(0);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_field("case")?;
    let names = landing_table::names(legs);
    let quantities: Vec<Quantity> = names.iter().map(|name| units.quantity(name)).collect();
    writer.write_record(quantities.iter().map(Quantity::name))?;
    for (name, finding) in rows {
        writer.write_field(name)?;
        let row = landing_table::under_headings(cells(finding), legs);
        let row = quantities.iter().zip(&row);
        writer.write_record(row.map(|(quantity, cell)| quantity.cell(cell)))?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}
