//! Wild landings as a table of cases, to be landed again one by one.

use std::collections::BTreeMap;

use super::wild_sweep::WildSweep;

/// Landings by their numbers, and why each is worth landing again.
pub type Reasons = BTreeMap<usize, Vec<String>>;

/// A table for `touchdown land --cases` of landings of several vehicles over the same axes: every coordinate with all the
/// digits of its number.
///
/// # Errors
/// None but those of memory.
pub fn written(kept: &[(&WildSweep, Reasons)]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    if let Some((first, _)) = kept.first() {
        let axes = first.sweep.axes.iter().map(|axis| axis.name());
        writer.write_record(["case", "vehicle", "note"].into_iter().chain(axes))?;
    }
    for (wild, reasons) in kept {
        for (number, why) in reasons {
            writer.write_field(wild.case_name(*number))?;
            writer.write_field(wild.vehicle_file())?;
            writer.write_field(why.join("; "))?;
            let cells = wild.sweep.cells_of_point(*number).into_iter();
            writer.write_record(cells.map(|cell| cell.to_string()))?;
        }
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}
