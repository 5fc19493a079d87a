//! Landings and searches on all cores.

mod landing_queue;
pub mod run;
pub mod runner;
