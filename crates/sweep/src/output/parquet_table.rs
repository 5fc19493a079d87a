//! Result tables as Parquet files, one row group at a time.
//!
//! The columns are those of the CSV file, with types; an empty cell is null. The metadata hold the units of the columns
//! and the full input, as JSON, and the program that wrote them.

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use serde_json::{Map, Value, json};
use touchdown_input::documents::column::{Cell, Kind};
use touchdown_input::documents::unit::unit;
use touchdown_input::sweeps::sweep_file::Sweep;

use crate::output::results;

/// Rows of a group, which are held in memory.
const GROUP: usize = 1 << 16;

/// A table being written.
pub(crate) struct ParquetTable<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    columns: usize,
    rows: Vec<Vec<Cell>>,
}

/// Metadata by name; what is `None` is a name alone.
type Metadata = Vec<(&'static str, Option<String>)>;

/// What the table of a sweep says of its input.
pub(crate) fn of_sweep(sweep: &Sweep) -> Metadata {
    vec![
        ("title", Some(sweep.title.clone())),
        ("input", Some(sweep.resolved_in(sweep.units).to_string())),
        ("input_fingerprint", Some(results::input_fingerprint(sweep))),
    ]
}

impl<W: Write + Send> ParquetTable<W> {
    /// Starts a table with columns of these names and kinds, and what its metadata say of the input.
    pub(crate) fn begin(file: W, input: Metadata, columns: &[(&str, Kind)]) -> io::Result<Self> {
        let units: Map<String, Value> = (columns.iter())
            .map(|(name, _)| ((*name).to_owned(), json!(unit(name))))
            .collect();
        let count = columns.len();
        let columns = columns.iter().map(|(name, kind)| {
            let (physical, logical) = match kind {
                Kind::Word => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
                Kind::Number => (Physical::DOUBLE, None),
                Kind::Count => (Physical::INT64, None),
            };
            Type::primitive_type_builder(name, physical)
                .with_repetition(Repetition::OPTIONAL)
                .with_logical_type(logical)
                .build()
                .map(Arc::new)
        });
        let columns = columns.collect::<Result<Vec<_>, _>>().map_err(failed)?;
        let schema = Type::group_type_builder("touchdown")
            .with_fields(columns)
            .build()
            .map_err(failed)?;
        let program = results::program(env!("CARGO_PKG_VERSION"));
        let mut metadata = input;
        metadata.extend([
            ("units", Some(json!(units).to_string())),
            ("program", Some(program.to_string())),
            ("commit", results::COMMIT.map(str::to_owned)),
        ]);
        let metadata = (metadata.into_iter())
            .map(|(key, value)| KeyValue::new(key.to_owned(), value))
            .collect();
        let properties = WriterProperties::builder()
            .set_key_value_metadata(Some(metadata))
            .set_created_by("touchdown".to_owned())
            .build();
        let writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties));
        Ok(Self {
            writer: writer.map_err(failed)?,
            columns: count,
            rows: Vec::new(),
        })
    }

    /// Adds a row.
    pub(crate) fn add(&mut self, row: Vec<Cell>) -> io::Result<()> {
        self.rows.push(row);
        match self.rows.len() {
            GROUP => self.write_group().map_err(failed),
            _ => Ok(()),
        }
    }

    /// Finishes the table.
    pub(crate) fn end(mut self) -> io::Result<W> {
        self.write_group().map_err(failed)?;
        self.writer.into_inner().map_err(failed)
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        if self.rows.is_empty() {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for column in 0..self.columns {
            let cells = || self.rows.iter().map(|row| &row[column]);
            let levels: Vec<i16> = cells()
                .map(|cell| i16::from(*cell != Cell::Empty))
                .collect();
            let Some(mut writer) = group.next_column()? else {
                break;
            };
            match writer.untyped() {
                ColumnWriter::DoubleColumnWriter(writer) => {
                    let number = |cell: &Cell| match cell {
                        Cell::Number(number) | Cell::Power(number) => Some(*number),
                        _ => None,
                    };
                    let values: Vec<f64> = cells().filter_map(number).collect();
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                ColumnWriter::Int64ColumnWriter(writer) => {
                    let count = |cell: &Cell| match cell {
                        Cell::Count(count) => Some(*count as i64),
                        _ => None,
                    };
                    let values: Vec<i64> = cells().filter_map(count).collect();
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                ColumnWriter::ByteArrayColumnWriter(writer) => {
                    let word = |cell: &Cell| match cell {
                        Cell::Word(word) => Some(ByteArray::from(word.as_str())),
                        _ => None,
                    };
                    let values: Vec<ByteArray> = cells().filter_map(word).collect();
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                _ => {
                    return Err(ParquetError::General(
                        "a column of no known kind".to_owned(),
                    ));
                }
            }
            writer.close()?;
        }
        group.close()?;
        self.rows.clear();
        Ok(())
    }
}

fn failed(error: ParquetError) -> io::Error {
    io::Error::other(error)
}
