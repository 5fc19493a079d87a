//! The integrator taken apart: method, dense output, step control, event location.

pub mod dense;
pub mod dormand_prince;
pub mod event;
pub mod step_control;
