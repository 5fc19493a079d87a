//! Landings and searches on all cores.

pub(crate) mod landing_queue;
pub mod run;
pub mod runner;
