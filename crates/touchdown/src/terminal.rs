//! What commands share of files, messages and the terminal.

pub mod failure;
pub mod interrupt;
pub mod print;
pub mod progress;
pub mod summary;
