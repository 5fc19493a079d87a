//! What all pictures are drawn with: the canvas, colours, axes, legends, and the sheet with its captions.

pub mod canvas;
pub mod frame;
pub mod ink;
pub mod legend;
pub mod sheet;
pub mod thinning;
pub mod ticks;
