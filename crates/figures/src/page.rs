//! The page that pictures are drawn on: ink, grid, axes and legends.

pub mod axis_range;
pub mod ink;
pub mod legend;
pub mod mesh;
pub mod sheet;
