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

mod charts;
mod maps;
mod page;
pub mod picture;
pub mod png;
mod tables;
mod words;

pub use charts::{boundary_profile, history_chart, line_chart, tornado_chart, work_precision};
use charts::{
    distribution_chart, history_page, outcome_chart, probability_chart, shading, tornado_words,
};
use maps::{colour_bar, hatching, isolines, view_point};
pub use maps::{
    contour_map, leading_feet, levels, map_legend, map_view, perspective, refined_map, surface,
};
use page::{canvas, frame, sheet, text, thinning};
pub use page::{legend, palette, style};
pub use tables::{bands_table, boundary_table, history_table, map_table, sensitivity_table};
use tables::{profile_points, table};
pub use words::{axis_title, caption, figure_error, number, parameter_words, speed_unit, unit};
use words::{division, ticks};
