//! An explorer of landings in the browser.
//!
//! [`interface`] answers the requests of a page from the [`named`] files. The `page` itself is part of the program;
//! `server` provides both to a browser on this machine, `export` in one file. The engine is independent of all this.
//!
//! The floors, from the top:
//!
//! | floor | what |
//! |---|---|
//! | `export`, `server` | the page as one file; the page over HTTP: gate, limits, calls that end when nobody waits |
//! | `page` | the files of `crates/explorer/page`, which `build.rs` lists: scripts, styles, libraries, the module |
//! | `interface` | a name and JSON in, JSON out: a file a request, without files, clocks or threads |
//! | `named` | what was named on the command line, read once: touchdowns to start from, tables of results |
//!
//! It uses `sweep` and `figures`; neither knows of it. Landings go through `land_with_summary`, strips through batches, bands through `Search`: numbers are those of
//! the command line because they come out of the same calls (`landing_report`, `history`). The crate `explorer-wasm` is the floors `interface` and `named` as a
//! WebAssembly module for exported pages, with texts in two buffers; for other machines it is empty.

#![warn(unnameable_types)]

#[cfg(feature = "server")]
pub mod export;
pub mod interface;
pub mod named;
#[cfg(feature = "server")]
pub mod page;
#[cfg(feature = "server")]
pub mod server;
