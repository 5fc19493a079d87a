//! `table_file`: a table of results as a file, or those of its rows that lie within ranges.

use serde::Deserialize;
use serde_json::json;

use super::complaint::{Complaint, of_table};
use super::computed::Computed;
use super::in_units::in_units;
use super::map::table_of;
use super::request::{asked_units, read, written};
use super::rows::{Range, Rows};
use crate::named::Named;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    results: Option<String>,
    computed: Option<Computed>,
    #[serde(default)]
    within: Vec<Range>,
    units: Option<String>,
}

pub fn answer(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = asked_units(request.units.as_deref())?;
    let table = table_of(named, request.results.as_deref(), request.computed.as_ref())?;
    let results = in_units(&table, units)?;
    let rows = Rows::read(&results)?;
    let are_within = rows.within(&request.within)?;
    let fault = |error: csv::Error| of_table(&results, error);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&rows.heading).map_err(fault)?;
    for (row, _) in rows.rows.iter().zip(are_within).filter(|(_, is)| *is) {
        writer.write_record(row).map_err(fault)?;
    }
    let bytes = writer.into_inner().map_err(Complaint::engine)?;
    let name = match request.within.is_empty() {
        true => format!("{}.csv", results.name),
        false => format!("{}-selected.csv", results.name),
    };
    written(&json!({"files": [{"name": name, "text": String::from_utf8_lossy(&bytes)}]}))
}
