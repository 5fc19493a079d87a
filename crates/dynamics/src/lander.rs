//! The vehicle and its touchdown, checked once and correct from then on, and the settings of the computation.

mod footprint;
pub mod ground;
pub mod method;
pub mod scene;
pub mod settings;
pub mod three_strut_leg;
pub mod thrust;
pub mod vehicle;
