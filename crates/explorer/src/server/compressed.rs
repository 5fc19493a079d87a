//! Files of the page and answers to other machines, compressed.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::LazyLock;

use flate2::Compression;
use flate2::write::GzEncoder;
use hyper::body::Bytes;
use hyper::header::{ACCEPT_ENCODING, HeaderMap};

use crate::page::PageFile;

/// Name of the encoding in headers.
pub const GZIP: &str = "gzip";
/// Bytes below which an answer is sent as it is.
const SMALL: usize = 4096;

/// Files of the page that are embedded as they are, compressed once. The page itself has a nonce and stays as it is.
static FILES: LazyLock<HashMap<&str, Bytes>> = LazyLock::new(|| {
    let files = PageFile::all().filter(|file| !file.is_gzip && !file.is_index());
    let compressed = files.filter_map(|file| {
        let bytes = gzip(file.bytes, Compression::default()).ok()?;
        Some((file.path, Bytes::from(bytes)))
    });
    compressed.collect()
});

/// True if a client takes compressed answers.
pub fn is_taken(headers: &HeaderMap) -> bool {
    let accepted = headers.get(ACCEPT_ENCODING);
    let accepted = accepted.and_then(|value| value.to_str().ok());
    let mut ways = accepted.unwrap_or_default().split(',');
    ways.any(|way| way.trim() == GZIP)
}

/// A file, compressed; `None` if it is only sent as it is.
pub fn file(file: &PageFile) -> Option<Bytes> {
    match file.is_gzip {
        true => Some(Bytes::from_static(file.bytes)),
        false => FILES.get(file.path).cloned(),
    }
}

/// A large answer, compressed quickly; `None` for a small one.
pub fn answer(json: &str) -> Option<Vec<u8>> {
    match json.len() < SMALL {
        true => None,
        false => gzip(json.as_bytes(), Compression::fast()).ok(),
    }
}

fn gzip(bytes: &[u8], level: Compression) -> io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), level);
    encoder.write_all(bytes)?;
    encoder.finish()
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use flate2::read::GzDecoder;

    use super::*;

    #[test]
    fn large_answers_are_compressed_and_small_ones_are_not() {
        let large = "[0.125]".repeat(SMALL);
        let packed = answer(&large).unwrap();
        assert!(packed.len() < large.len() / 10);
        let mut again = String::new();
        GzDecoder::new(packed.as_slice())
            .read_to_string(&mut again)
            .unwrap();
        assert_eq!(again, large);
        assert_eq!(answer("[0.125]"), None);
    }
}
