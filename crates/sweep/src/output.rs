//! Tables and records of results, and tables of cases.

pub mod bands_table;
pub mod case_results;
pub mod file_writer;
pub mod history;
pub mod landing_report;
pub mod landing_table;
mod map_tables;
pub mod output_guard;
mod parquet_table;
pub mod result_files;
pub mod results;
mod sensitivity_table;
pub mod tables;
pub mod warnings;
