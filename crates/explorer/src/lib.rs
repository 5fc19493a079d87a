//! An explorer of landings in the browser.
//!
//! [`interface`] answers what a page asks, from what was [`named`]; both are free of input and output but for reading the
//! named files.

pub mod interface;
pub mod named;
