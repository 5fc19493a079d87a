//! Drawing tools of all pictures: the canvas, colours, frames, legends, and the sheet with its captions.

pub mod canvas;
pub mod frame;
pub mod legend;
pub mod palette;
pub mod sheet;
pub mod style;
pub mod text;
pub mod thinning;
