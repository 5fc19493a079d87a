//! Result tables as Parquet files, one row group at a time.
//!
//! The columns are those of the CSV file, with types; an empty cell is null. The metadata hold the units of the columns
//! and the full input of the sweep, as JSON, and the program that wrote them.

use std::io;
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

use crate::file_writer::Draft;
use crate::results;
use crate::sweep_file::Sweep;
use crate::unit::unit;

/// Rows of a group, which are held in memory.
const GROUP: usize = 1 << 16;
/// Columns of words; all columns not listed here or in `COUNTS` hold numbers.
const WORDS: [&str; 10] = [
    "first_transition_to",
    "outcome",
    "kind",
    "edge_kind",
    "failure",
    "axis",
    "certainty",
    "parameter",
    "unit",
    "dependence",
];
const COUNTS: [&str; 14] = [
    "landings",
    "derivative_evaluations",
    "band",
    "steps",
    "toppled",
    "bottomed",
    "undecided",
    "failed",
    "not_stable",
    "points",
    "looks",
    "level",
    "edge",
    "triangle",
];
/// A table being written.
pub(crate) struct ParquetTable {
    writer: SerializedFileWriter<Draft>,
    kinds: Vec<Physical>,
    rows: Vec<Vec<String>>,
}

impl ParquetTable {
    /// Starts a table with a heading.
    pub(crate) fn begin(draft: Draft, sweep: &Sweep, heading: &[String]) -> io::Result<Self> {
        let has_words = |name: &str| {
            let axis = sweep.axes.iter().find(|axis| axis.name() == name);
            axis.is_some_and(|axis| !axis.words().is_empty())
        };
        // Bin ends are words for an axis with words.
        let has_bins = heading.iter().any(|name| name == "axis");
        let has_word_bins = has_bins && sweep.axes.iter().any(|axis| !axis.words().is_empty());
        let kind = |name: &String| match name.as_str() {
            word if WORDS.contains(&word) || has_words(word) => Physical::BYTE_ARRAY,
            "from" | "to" if has_word_bins => Physical::BYTE_ARRAY,
            count if COUNTS.contains(&count) => Physical::INT64,
            _ => Physical::DOUBLE,
        };
        let kinds: Vec<Physical> = heading.iter().map(kind).collect();
        let columns = heading.iter().zip(&kinds).map(|(name, kind)| {
            let word = (*kind == Physical::BYTE_ARRAY).then_some(LogicalType::String);
            Type::primitive_type_builder(name, *kind)
                .with_repetition(Repetition::OPTIONAL)
                .with_logical_type(word)
                .build()
                .map(Arc::new)
        });
        let columns = columns.collect::<Result<Vec<_>, _>>().map_err(failed)?;
        let schema = Type::group_type_builder("touchdown")
            .with_fields(columns)
            .build()
            .map_err(failed)?;
        let units: Map<String, Value> = heading
            .iter()
            .map(|name| (name.clone(), json!(unit(name))))
            .collect();
        let program = results::program(env!("CARGO_PKG_VERSION"));
        let metadata = [
            ("title", Some(sweep.title.clone())),
            ("units", Some(json!(units).to_string())),
            ("input", Some(sweep.resolved_in(sweep.units).to_string())),
            ("input_fingerprint", Some(results::input_fingerprint(sweep))),
            ("program", Some(program.to_string())),
            ("commit", results::COMMIT.map(str::to_owned)),
        ];
        let metadata = metadata.map(|(key, value)| KeyValue::new(key.to_owned(), value));
        let properties = WriterProperties::builder()
            .set_key_value_metadata(Some(metadata.to_vec()))
            .set_created_by("touchdown".to_owned())
            .build();
        let writer = SerializedFileWriter::new(draft, Arc::new(schema), Arc::new(properties));
        Ok(Self {
            writer: writer.map_err(failed)?,
            kinds,
            rows: Vec::new(),
        })
    }

    /// Adds a row.
    pub(crate) fn add(&mut self, row: &[String]) -> io::Result<()> {
        self.rows.push(row.to_vec());
        match self.rows.len() {
            GROUP => self.write_group().map_err(failed),
            _ => Ok(()),
        }
    }

    /// Finishes the table.
    pub(crate) fn end(mut self) -> io::Result<Draft> {
        self.write_group().map_err(failed)?;
        self.writer.into_inner().map_err(failed)
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        if self.rows.is_empty() {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for column in 0..self.kinds.len() {
            let cells = || self.rows.iter().map(|row| row[column].as_str());
            let full = || cells().filter(|cell| !cell.is_empty());
            let levels: Vec<i16> = cells().map(|cell| i16::from(!cell.is_empty())).collect();
            let Some(mut writer) = group.next_column()? else {
                break;
            };
            match writer.untyped() {
                ColumnWriter::DoubleColumnWriter(writer) => {
                    let values: Vec<f64> = full().map(number).collect::<Result<_, _>>()?;
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                ColumnWriter::Int64ColumnWriter(writer) => {
                    let values: Vec<i64> = full().map(number).collect::<Result<_, _>>()?;
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                ColumnWriter::ByteArrayColumnWriter(writer) => {
                    let values: Vec<ByteArray> = full().map(ByteArray::from).collect();
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

fn number<T: std::str::FromStr>(cell: &str) -> Result<T, ParquetError> {
    let refuse = |_| ParquetError::General(format!("{cell} is no number"));
    cell.parse().map_err(refuse)
}

fn failed(error: ParquetError) -> io::Error {
    io::Error::other(error)
}
