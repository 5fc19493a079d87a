//! Documents: TOML read by key with line numbers, errors that name them, and columns of tables with their units.

pub mod column;
pub mod column_units;
pub(crate) mod csv_rows;
pub mod document;
pub mod fingerprint;
pub mod history_columns;
pub mod input_error;
pub mod key_path;
pub mod library;
pub mod output_units;
pub(crate) mod section;
pub(crate) mod spelling;
pub mod toml_text;
pub mod unit;
