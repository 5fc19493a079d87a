//! The search for boundaries along the horizontal velocity: scan, brackets, bands, certainty.

pub(crate) mod at_once;
pub mod bands;
pub mod boundary;
pub mod certainty;
pub mod first_transition;
pub mod hidden;
pub mod lattice;
pub mod looks;
pub(crate) mod loose_scan;
pub mod refine;
pub mod scan;
pub mod search_range;
pub mod spared;
pub mod trial;
