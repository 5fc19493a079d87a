//! An explorer of landings in the browser.
//!
//! [`interface`] answers what a page asks, from what was [`named`]. The `page` itself is part of the program, and `server` has both
//! for a browser on this machine. The engine knows nothing of all this.

pub mod interface;
pub mod named;
pub mod page;
#[cfg(feature = "server")]
pub mod server;
