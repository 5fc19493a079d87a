//! Pictures of stability boundaries and of landings, from result tables alone.
//!
//! Equal tables give equal pictures, byte for byte. The floors, from the top:
//!
//! | floor | what |
//! |---|---|
//! | `picture` | which picture a table has |
//! | `charts`, `maps` | profiles, histories, tornado charts; contour maps and perspectives |
//! | `page` | `canvas` writes the SVG, with coordinates finer than pixels; colours, axes and ticks, legends, the sheet with its captions |
//! | `tables` | result tables as they are read |
//! | `words`, `png` | captions, titles, numbers; PNG from SVG |

#![warn(unnameable_types)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod charts;
mod maps;
mod page;
pub mod picture;
pub mod png;
mod tables;
mod words;

pub use charts::line_chart;
use charts::{
    boundary_profile, distribution_chart, history_chart, history_page, outcome_chart,
    probability_chart, shading, tornado_chart, tornado_words, work_precision,
};
use maps::{colour_bar, contour_map, heights, isolines, map_view, perspective, view_point};
pub use maps::{leading_feet, levels, map_legend, refined_map, surface};
use page::{canvas, frame, sheet, text, thinning};
pub use page::{legend, palette, style};
pub use tables::{bands_table, boundary_table, map_table};
use tables::{history_table, profile_points, sensitivity_table};
pub use words::{FigureError, axis_title, caption, label, unit};
use words::{division, ticks};
