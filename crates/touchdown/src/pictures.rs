//! The command `plot`.

pub mod plot;
