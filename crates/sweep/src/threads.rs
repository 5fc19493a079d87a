//! Landings and searches on all cores.

pub(crate) mod exchange;
pub mod run;
