//! Captions, titles, numbers and complaints in words.

pub mod axis_title;
pub mod caption;
pub mod figure_error;
pub mod number;
pub mod parameter_words;
pub mod speed_unit;
pub mod unit;
