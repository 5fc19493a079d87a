//! Wild landings as a table of cases, to be landed again one by one.

use std::collections::BTreeMap;

use touchdown_sweep::sweep_file::Sweep;

/// Landings by their numbers, and why each is worth landing again.
pub type Reasons = BTreeMap<usize, Vec<String>>;

/// A table for `touchdown land --cases`: every coordinate with all the digits of its number.
///
/// # Errors
/// None but those of memory.
pub fn written(sweep: &Sweep, reasons: &Reasons) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let axes = sweep.axes.iter().map(|axis| axis.name());
    writer.write_record(["case", "note"].into_iter().chain(axes))?;
    for (number, why) in reasons {
        writer.write_field(number.to_string())?;
        writer.write_field(why.join("; "))?;
        writer.write_record(sweep.coordinates_written(*number))?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}
