//! An explorer of landings in the browser.
//!
//! [`interface`] answers what a page asks, from what was [`named`]. The `page` itself is part of the program, and `server` has both
//! for a browser on this machine, `export` in one file. The engine knows nothing of all this.

#[cfg(feature = "server")]
pub mod export;
pub mod interface;
pub mod named;
#[cfg(feature = "server")]
pub mod page;
#[cfg(feature = "server")]
pub mod server;
