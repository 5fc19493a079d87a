//! The integrator in parts: methods, steps with dense output, step control, event location.

pub mod cubic;
pub mod dormand_prince;
pub mod event;
pub mod parabola;
pub mod ranges;
pub mod rosenbrock;
pub mod step;
pub mod step_control;
