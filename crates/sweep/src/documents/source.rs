//! The text of an input file.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// A file word for word.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// Its path, as given or as another file names it.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
}
