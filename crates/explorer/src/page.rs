//! The files of the page, embedded in the program.

/// All files with their paths. Files that end with `.gz` are sent compressed, under the name without this ending.
const FILES: &[(&str, &[u8])] = &include!(concat!(env!("OUT_DIR"), "/page_files.rs"));
/// File sent for the bare address.
pub const INDEX: &str = "index.html";
const GZIP: &str = ".gz";

/// A file of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PageFile {
    /// Path, without `.gz`.
    pub path: &'static str,
    /// Content.
    pub bytes: &'static [u8],
    /// True if the content is compressed.
    pub is_gzip: bool,
}

impl PageFile {
    fn of((path, bytes): (&'static str, &'static [u8])) -> Self {
        let bare = path.strip_suffix(GZIP);
        Self {
            path: bare.unwrap_or(path),
            bytes,
            is_gzip: bare.is_some(),
        }
    }

    /// All files.
    pub fn all() -> impl Iterator<Item = Self> {
        FILES.iter().copied().map(Self::of)
    }

    /// True for the page itself.
    pub fn is_index(&self) -> bool {
        self.path == INDEX
    }

    /// The file at a path; the page itself for an empty path.
    pub fn at(path: &str) -> Option<Self> {
        let path = if path.is_empty() { INDEX } else { path };
        Self::all().find(|file| file.path == path)
    }

    /// Media type.
    pub fn media_type(&self) -> &'static str {
        match self.path.rsplit('.').next().unwrap_or_default() {
            "html" => "text/html; charset=utf-8",
            "js" | "mjs" => "text/javascript; charset=utf-8",
            "css" => "text/css; charset=utf-8",
            "json" => "application/json",
            "svg" => "image/svg+xml",
            "png" => "image/png",
            "ico" => "image/x-icon",
            "woff2" => "font/woff2",
            "wasm" => "application/wasm",
            _ => "text/plain; charset=utf-8",
        }
    }
}
