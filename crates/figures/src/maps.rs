//! Surfaces over two axes: contour maps and perspectives.

pub mod colour_bar;
pub mod contour_map;
pub mod heights;
pub mod isolines;
pub mod leading_feet;
pub mod levels;
pub mod map_legend;
pub mod map_view;
pub mod perspective;
pub mod refined_map;
pub mod surface;
pub mod view_point;
