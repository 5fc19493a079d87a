//! Results of single points, and their summary over all points.

pub mod findings;
pub mod probabilities;
pub mod sweep_counts;
pub mod transition_statistics;
