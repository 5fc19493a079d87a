//! Captions, titles, numbers, the divisions of axes, and complaints in words.

pub mod axis_title;
pub mod caption;
pub mod division;
pub mod figure_error;
pub mod number;
pub mod ticks;
pub mod unit;
