//! Landings and searches on all cores.

mod landing_queue;
mod point;
pub mod run;
mod run_error;
