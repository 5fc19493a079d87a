//! Tables of results in the units of a request.

use std::borrow::Cow;

use serde_json::{Map, Value, json};
use touchdown_input::documents::column_units::ColumnInUnits;
use touchdown_input::documents::output_units::OutputUnits;

use super::complaint::{Complaint, of_table};
use crate::named::Results;

/// Results with every column in these units; unchanged without units, or where all are in them already.
///
/// # Errors
/// If a table is not one.
pub fn in_units(
    results: &Results,
    units: Option<OutputUnits>,
) -> Result<Cow<'_, Results>, Complaint> {
    let heading = results.table.lines().next().unwrap_or_default();
    let differ = |units: &OutputUnits| {
        let mut names = heading.split(',');
        names.any(|name| ColumnInUnits::of(name, *units).name() != name)
    };
    let Some(units) = units.filter(differ) else {
        return Ok(Cow::Borrowed(results));
    };
    let table = |csv: &str| table_in(csv, units).map_err(|error| of_table(results, error));
    let beside = |csv: &Option<String>| csv.as_deref().map(table).transpose();
    let axes = results.axes.iter();
    Ok(Cow::Owned(Results {
        axes: axes.map(|axis| name_in(axis, units)).collect(),
        table: table(&results.table)?,
        bands: beside(&results.bands)?,
        surface: beside(&results.surface)?,
        edges: beside(&results.edges)?,
        record: results
            .record
            .as_deref()
            .map(|record| record_in(record, units)),
        ..results.clone()
    }))
}

/// The name of a column in these units.
pub fn name_in(name: &str, units: OutputUnits) -> String {
    ColumnInUnits::of(name, units).name().to_owned()
}

/// Values by name in these units.
pub fn values_in(values: &Map<String, Value>, units: OutputUnits) -> Map<String, Value> {
    let converted = values.iter().map(|(name, value)| {
        let column = ColumnInUnits::of(name, units);
        let value = match value.as_f64() {
            Some(number) => json!(column.number(number)),
            None => value.clone(),
        };
        (column.name().to_owned(), value)
    });
    converted.collect()
}

/// A table (CSV) in these units.
fn table_in(csv: &str, units: OutputUnits) -> Result<String, csv::Error> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let columns: Vec<ColumnInUnits> = (reader.headers()?.iter())
        .map(|name| ColumnInUnits::of(name, units))
        .collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns.iter().map(ColumnInUnits::name))?;
    for row in reader.records() {
        let row = row?;
        let cells = columns
            .iter()
            .zip(&row)
            .map(|(column, cell)| match cell.parse() {
                Ok(number) => column.number(number).to_string(),
                Err(_) => cell.to_owned(),
            });
        writer.write_record(cells)?;
    }
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// A record with the conditions and the search in these units.
fn record_in(record: &str, units: OutputUnits) -> String {
    let Ok(mut told) = serde_json::from_str::<Value>(record) else {
        return record.to_owned();
    };
    for part in ["scene", "search"] {
        if let Some(numbers) = told["input"][part].as_object() {
            told["input"][part] = json!(values_in(numbers, units));
        }
    }
    told.to_string()
}
