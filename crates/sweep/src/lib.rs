//! Sweeps of lander touchdowns: from input files to result tables.
//!
//! | step | modules |
//! |---|---|
//! | read what was asked | [`document`], [`section`], [`vehicle_file`], [`scene_input`], [`settings_input`], [`method_input`], [`sweep_file`], [`scene_file`], [`instead`], [`cases`], [`deck`], [`input_keys`] |
//! | what varies, and the input of every point | [`parameter`], [`levels`], [`grid`], [`distribution`], [`sample`], [`design`], [`case`] |
//! | find where the lander begins to topple | [`trial`], [`boundary`], [`bands`], [`scan`], [`refine`], [`lattice`], [`hidden`], [`looks`], [`certainty`], [`spared`] |
//! | how much its place depends on the input | [`sensitivity`] |
//! | keep it whatever happens | [`journal`], [`header`], [`point_set`], [`shard`], [`merge`], [`library`] |
//! | do so on every core | `at_once`, `exchange`, [`run`] |
//! | measure what it costs | [`measured_scenes`] |
//! | tell | [`findings`], [`tally`], [`probabilities`], [`tables`], [`results`], [`bands_table`], [`history`], [`landing_table`], [`deposit`] |
//!
//! Nothing here prints: progress goes to a [`run::Observer`], complaints are
//! [`input_error::InputError`]s.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod at_once;
mod axis_input;
pub mod bands;
pub mod bands_table;
pub mod boundary;
pub mod case;
pub mod cases;
pub mod certainty;
pub mod deck;
pub mod deposit;
pub mod design;
pub mod distribution;
pub mod document;
mod exchange;
pub mod findings;
pub mod first_transition;
pub mod grid;
pub mod header;
pub mod hidden;
pub mod history;
pub mod input_error;
pub mod input_keys;
pub mod instead;
pub mod journal;
pub mod key_path;
mod known;
pub mod landing_table;
pub mod lattice;
pub mod levels;
pub mod library;
pub mod looks;
mod loose_scan;
pub mod measured_scenes;
pub mod merge;
pub mod method_input;
pub mod parameter;
mod parquet_table;
pub mod point_set;
pub mod probabilities;
pub mod refine;
mod resolved_input;
pub mod results;
pub mod run;
pub mod sample;
mod sample_input;
pub mod scan;
pub mod scene_file;
pub mod scene_input;
mod search_input;
pub mod search_range;
pub mod section;
pub mod sensitivity;
pub mod settings_input;
pub mod shard;
pub mod source;
pub mod spared;
pub mod sweep;
pub mod sweep_file;
pub mod tables;
pub mod tally;
pub mod trial;
pub mod unit;
pub mod vehicle_file;
