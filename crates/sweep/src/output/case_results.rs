//! Table of the results of cases.

use std::io;
use std::path::Path;

use serde_json::Value;
use touchdown_dynamics::landing::Landing;
use touchdown_input::documents::column::{Cell, Kind, cells, headings};
use touchdown_input::documents::output_units::{OutputUnits, Quantity};

use crate::output::landing_table::COLUMNS;
use crate::output::parquet_table::ParquetTable;

/// First column: the name of the case.
const CASE: &str = "case";

/// True if a table of results of cases is written to this file as Parquet, as its ending says.
pub fn is_parquet(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending == "parquet")
}

/// True if `file`, with this first line, is a table of results of cases.
pub fn is_table(file: &Path, line: &str) -> bool {
    match is_parquet(file) {
        true => line.starts_with("PAR1"),
        false => line.starts_with("case,outcome,end_time_s,"),
    }
}

/// The results of cases for `file` in these units, as Parquet or CSV: `case`, then the columns of [`landing_table`] for the
/// greatest number of legs. Parquet has the input of the cases in its metadata.
///
/// [`landing_table`]: crate::output::landing_table
///
/// # Errors
/// Only out of memory.
pub fn table<'r>(
    file: &Path,
    rows: impl Iterator<Item = (&'r str, &'r Landing)> + Clone,
    units: OutputUnits,
    input: &Value,
) -> io::Result<Vec<u8>> {
    match is_parquet(file) {
        true => parquet_table(rows, units, input),
        false => Ok(csv_table(rows, units)?),
    }
}

/// Writes the table as CSV, whatever its file is called.
///
/// # Errors
/// Only out of memory.
pub fn csv_table<'r>(
    rows: impl Iterator<Item = (&'r str, &'r Landing)> + Clone,
    units: OutputUnits,
) -> Result<Vec<u8>, csv::Error> {
    let legs = most_legs(rows.clone());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_field(CASE)?;
    let quantities: Vec<Quantity> = columns(legs, units).map(|(quantity, _)| quantity).collect();
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

fn parquet_table<'r>(
    rows: impl Iterator<Item = (&'r str, &'r Landing)> + Clone,
    units: OutputUnits,
    input: &Value,
) -> io::Result<Vec<u8>> {
    let legs = most_legs(rows.clone());
    let columns: Vec<(Quantity, Kind)> = columns(legs, units).collect();
    let named = columns.iter().map(|(one, kind)| (one.name(), *kind));
    let headings: Vec<(&str, Kind)> = [(CASE, Kind::Word)].into_iter().chain(named).collect();
    let input = vec![("input", Some(input.to_string()))];
    let mut table = ParquetTable::begin(Vec::new(), input, &headings)?;
    for (name, landing) in rows {
        let cells = columns.iter().zip(cells(&COLUMNS, landing, legs));
        let cells = cells.map(|((quantity, _), cell)| quantity.cell(cell));
        let name = Cell::Word(name.to_owned());
        table.add([name].into_iter().chain(cells).collect())?;
    }
    table.end()
}

fn most_legs<'r>(rows: impl Iterator<Item = (&'r str, &'r Landing)>) -> usize {
    let legs = rows.map(|(_, landing)| landing.leg_count());
    legs.max().unwrap_or(0)
}

fn columns(legs: usize, units: OutputUnits) -> impl Iterator<Item = (Quantity, Kind)> {
    headings(&COLUMNS, legs).map(move |one| (units.quantity(&one.name), one.kind))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::summary::findings::tests::example;

    #[test]
    fn results_begin_with_the_case() {
        let landing = example();
        let rows = [("a,b", &landing), ("c", &landing)];
        let text =
            String::from_utf8(csv_table(rows.into_iter(), OutputUnits::Us).unwrap()).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[0].starts_with("case,outcome,end_time_s"));
        assert!(lines[1].starts_with("\"a,b\",failure,1.5"));
        assert_eq!(lines.len(), 3);
    }
}
