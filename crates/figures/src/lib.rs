//! Pictures of stability boundaries and of landings, from result tables alone.
//!
//! The same table gives the same picture, byte for byte.

mod axis_range;
pub mod axis_title;
pub mod bands_table;
pub mod boundary_profile;
pub mod boundary_table;
pub mod caption;
mod colour_bar;
pub mod contour_map;
pub mod figure_error;
pub mod history_chart;
pub mod history_table;
mod ink;
mod isolines;
pub mod leading_feet;
mod legend;
mod levels;
pub mod line_chart;
pub mod map_view;
mod mesh;
pub mod number;
pub mod parameter_words;
pub mod perspective;
pub mod picture;
pub mod png;
pub mod sensitivity_table;
mod shading;
mod sheet;
mod stations;
pub mod surface;
mod table;
pub mod tornado_chart;
mod tornado_words;
mod view_point;
pub mod work_precision;
