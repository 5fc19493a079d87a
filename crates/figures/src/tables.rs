//! Result tables as they are read.

pub mod bands_table;
pub mod boundary_table;
pub mod history_table;
pub mod map_table;
pub mod sensitivity_table;
pub mod stations;
pub mod table;
