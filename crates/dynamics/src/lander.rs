//! What lands and how: a vehicle and a touchdown, checked once and correct from then on, and how that is computed.

pub mod error_control;
mod footprint;
pub mod ground;
pub mod method;
pub mod scene;
pub mod settings;
pub mod thrust;
pub mod vehicle;
