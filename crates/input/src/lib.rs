//! What files say: landers, touchdowns, sweeps and tables of cases, read into types and checked.
//!
//! Numbers are in feet, pounds, slugs and seconds, and angles of files in degrees; keys may also be in SI. A file that says something
//! wrong ends with a [`documents::input_error::InputError`], which names line, key, value and what is expected.
//!
//! The crate has floors; each uses only those below it (checked by `scripts/floors.py`):
//!
//! | floor | content |
//! |---|---|
//! | [`sweeps`] | sweeps, cases of a scene file, tables of cases, the input of every point |
//! | [`points`] | axes, their values and their order |
//! | [`readers`] | tables of input documents, parsed into types |
//! | [`documents`] | TOML with line numbers, input errors, columns and units |

#![warn(unnameable_types)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod documents;
pub mod points;
pub mod readers;
pub mod sweeps;
