//! The search for boundaries along the horizontal velocity: scan, brackets, bands, certainty.

pub mod bands;
pub mod boundary;
pub mod certainty;
pub mod contact_warnings;
pub mod first_transition;
pub mod hidden;
pub mod hidden_band_checks;
pub(crate) mod join_all;
pub(crate) mod landings_on_request;
pub mod lattice;
pub(crate) mod look_beside;
pub(crate) mod narrowed_scan;
pub mod patchy;
pub mod refine;
pub(crate) mod run_out;
pub mod scan;
pub(crate) mod search_again;
pub mod search_range;
pub mod skipped;
pub mod trial;
pub mod variation;
