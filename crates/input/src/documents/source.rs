//! The text of an input file.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// A file, verbatim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// Path, as given or as named in another file.
    pub path: PathBuf,
    /// Text.
    pub text: String,
}
