//! The tables of input documents, each parsed into a type that is always valid.

pub mod choice;
pub mod deck;
pub mod method_input;
pub(crate) mod numbers;
pub mod scene_input;
pub(crate) mod search_input;
pub mod settings_input;
pub mod vehicle_file;
pub(crate) mod vehicle_tables;
