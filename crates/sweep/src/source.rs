//! The text of an input file.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// A file word for word.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// Its path, as it was given or follows from a file that names it.
    pub path: PathBuf,
    /// What it says.
    pub text: String,
}
