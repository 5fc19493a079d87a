//! The points of a sweep: the axes, their values and their order.

pub mod assignment;
pub(crate) mod axis_input;
pub mod design;
pub mod distribution;
pub mod grid;
pub(crate) mod joint_normal;
pub mod levels;
pub(crate) mod map_input;
pub mod parameter;
pub mod refined_grid;
pub mod sample;
pub(crate) mod sample_input;
pub(crate) mod sensitivity_input;
pub mod set_value;
