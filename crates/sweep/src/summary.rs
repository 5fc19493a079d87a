//! What a sweep finds at a point, and what all points come to.

pub mod findings;
pub mod landing_table;
pub mod probabilities;
pub mod sweep_counts;
pub mod transition_statistics;
