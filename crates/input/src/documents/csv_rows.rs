//! Reads tables of comma-separated values.

use csv::StringRecord;

use crate::documents::input_error::{InputError, Place};

/// Heading and rows of the text of a file; spaces around cells are removed.
///
/// # Errors
/// Names a line that does not belong to a table.
pub(crate) fn read(
    file: &Place,
    text: &str,
) -> Result<(StringRecord, Vec<StringRecord>), InputError> {
    // With both characters at the end of a line, positions of records are a line too low.
    let text = text.replace("\r\n", "\n");
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

/// Place of a row, counted from 0, in its file.
pub(crate) fn place(file: &Place, row: usize, record: &StringRecord) -> Place {
    let line = record.position().map_or(0, |position| position.line());
    file.line(line as usize).row(row + 1)
}
