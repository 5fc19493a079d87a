//! The commands `sweep` and `merge`.

pub mod axis_words;
pub mod dry_run;
pub mod estimate;
pub mod merge;
pub mod overview;
pub mod sweep;
pub mod sweep_results;
