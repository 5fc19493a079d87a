//! The command `plot`.

pub mod plot;
pub mod worst_case;
