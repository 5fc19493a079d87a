//! The patchy stretch above a first transition.

use serde::{Deserialize, Serialize};

/// Speeds above a first transition at which stable landings and others alternate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PatchyStretch {
    /// Upper end, ft/s: whole scan steps above the transition, or the highest speed of the search.
    pub to: f64,
    /// Landings at even parts of it.
    pub landings: u64,
    /// Those of them that are not stable.
    pub not_stable: u64,
}
