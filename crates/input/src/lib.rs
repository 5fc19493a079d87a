//! Input files: landers, touchdowns, sweeps and tables of cases, read into types and checked.
//!
//! Numbers are in feet, pounds, slugs and seconds, and angles of files in degrees; keys may also be in SI. A file that says something
//! wrong ends with a [`documents::input_error::InputError`], which names line, key, value and what is expected.
//!
//! **A number of the input is one entry.** Key with its unit, range, default, meaning, usual values and its place in the typed design stand together in the physics'
//! catalogue (`design/quantities`; `[search]` has its own entries in `readers/search_input`). Checks, readers, axes, `--set`, SI, options of `land`, sliders and
//! `docs/reference.md` come from it. It is below the readers because a lander built in Rust is checked by it too.
//!
//! **A column is one entry.** Its name, the kind of its cells, the function that takes it from a landing, a boundary, a band or an
//! instant, its sentence in `docs/output.md`, and the title of its axis where its name does not say it, stand together ([`documents::column`]; the catalogues are
//! [`documents::history_columns`] and the `COLUMNS` of `output` and `summary` of the crate `touchdown-sweep`). CSV, Parquet, JSON, Python, pictures and the document
//! come from it. Rows are typed until they are written.
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
