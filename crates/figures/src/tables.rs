//! Readers of result tables.

pub mod bands_table;
pub mod boundary_table;
pub mod history_table;
pub mod map_table;
pub mod profile_points;
pub mod sensitivity_table;
pub mod table;
