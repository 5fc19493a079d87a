//! Sweeps, the cases of a scene file, and the input of every point.

pub mod case;
mod input_in_units;
pub mod measured_scenes;
pub mod overrides;
pub mod place;
pub mod resolved_input;
pub mod scene_file;
pub mod single_landing;
pub mod sweep;
pub mod sweep_file;
