//! Sweeps of lander touchdowns: from input files to result tables.
//!
//! | step | modules |
//! |---|---|
//! | read what was asked | [`document`], [`section`], [`found`], [`vehicle_file`], [`scene_input`], [`settings_input`], [`method_input`], [`sweep_file`], [`axes`], [`cases`], [`deck`] |
//! | find where the lander begins to topple | [`trial`], [`boundary`], [`bands`], [`scan`], [`refine`], [`lattice`], [`hidden`], [`certainty`] |
//! | do so on every core | [`run`] |
//! | tell | [`results`], [`bands_table`], [`history`], [`landing_table`], [`deposit`] |
//!
//! Nothing here prints: progress goes to a [`run::Observer`], complaints are
//! [`input_error::InputError`]s.

pub mod axes;
pub mod bands;
pub mod bands_table;
pub mod boundary;
pub mod cases;
pub mod certainty;
pub mod deck;
pub mod deposit;
pub mod document;
pub mod found;
pub mod hidden;
pub mod history;
pub mod input_error;
pub mod landing_table;
pub mod lattice;
pub mod method_input;
pub mod refine;
pub mod results;
pub mod run;
pub mod scan;
pub mod scene_input;
mod search_input;
pub mod section;
pub mod settings_input;
pub mod sweep_file;
pub mod trial;
pub mod vehicle_file;
