//! Tables of comma-separated values as they are read.

use csv::StringRecord;

use crate::input_error::{InputError, Place};

/// Heading and rows of the text of a file, without spaces about cells.
///
/// # Errors
/// Names the line that is none of a table.
pub(crate) fn read(
    file: &Place,
    text: &str,
) -> Result<(StringRecord, Vec<StringRecord>), InputError> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let broken = |error: csv::Error| {
        let place = match error.position() {
            Some(position) => file.line(position.line() as usize),
            None => file.clone(),
        };
        InputError::other(format!("not a table of comma-separated values: {error}")).at(place)
    };
    let heading = reader.headers().map_err(broken)?.clone();
    let rows = reader.records().collect::<Result<_, _>>().map_err(broken)?;
    Ok((heading, rows))
}

/// Where a row, counted from 0, stands in its file.
pub(crate) fn place(file: &Place, row: usize, record: &StringRecord) -> Place {
    let line = record.position().map_or(0, |position| position.line());
    file.line(line as usize).row(row + 1)
}
