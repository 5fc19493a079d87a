//! Profiles, histories, tornado charts and lines over one axis.

pub mod boundary_profile;
pub mod distribution_chart;
pub mod history_chart;
pub mod history_page;
pub mod line_chart;
pub mod outcome_chart;
pub mod probability_chart;
pub mod shading;
pub mod tornado_chart;
pub mod tornado_words;
pub mod work_precision;
