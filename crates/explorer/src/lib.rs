//! An explorer of landings in the browser.
//!
//! [`interface`] answers the requests of a page from the [`named`] files. The `page` itself is part of the program;
//! `server` provides both to a browser on this machine, `export` in one file. The engine is independent of all this.

#[cfg(feature = "server")]
pub mod export;
pub mod interface;
pub mod named;
#[cfg(feature = "server")]
pub mod page;
#[cfg(feature = "server")]
pub mod server;
