//! The tables of input documents, each turned into a type that cannot be wrong.

pub mod choice;
pub mod deck;
pub mod method_input;
pub mod scene_input;
pub(crate) mod search_input;
pub mod settings_input;
pub mod vehicle_file;
pub(crate) mod vehicle_tables;
