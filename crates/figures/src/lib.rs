//! Pictures of stability boundaries, from the result tables of sweeps alone.
//!
//! The same table gives the same picture, byte for byte.

pub mod axis_title;
pub mod boundary_profile;
pub mod boundary_table;
pub mod figure_error;
mod ink;
mod legend;
mod stations;
