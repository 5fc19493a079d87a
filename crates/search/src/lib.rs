//! The search for boundaries along the horizontal velocity: scan, brackets, bands, certainty.
//!
//! A [`search_range::Search`] knows no files and lands nothing itself: it is given a function that lands at a speed
//! ([`search_range::Search::boundary`]). What it asks for at once can be landed at once. The range is scanned upward
//! ([`scan`]), steps that may hide a band are looked into, and each change is narrowed down ([`refine`]) and tested
//! ([`certainty`]). [`follow`] finds the transition of a slightly different input near a known one.

#![warn(unnameable_types)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod bands;
pub mod boundary;
pub mod certainty;
pub mod contact_warnings;
pub mod follow;
mod hidden;
pub mod hidden_band_checks;
mod landings_on_request;
mod lattice;
mod look_beside;
mod narrowed_scan;
pub mod refine;
mod run_out;
pub mod scan;
mod search_again;
pub mod search_range;
pub mod trial;
pub mod variation;

pub use landings_on_request::join_all;
