//! Sweeps, the cases of a scene file, and the input of every point.

pub mod case;
pub mod cases;
mod input_in_units;
pub mod input_keys;
pub mod measured_scenes;
pub mod origin;
pub mod overrides;
mod place;
pub mod resolved_input;
pub mod scene_file;
pub mod single_landing;
pub mod sweep;
pub mod sweep_file;
