//! Random digits that nobody can guess: tokens and nonces.

use std::io;

use rand::TryRng;
use rand::rngs::SysRng;

/// Random bytes of a text.
const BYTES: usize = 16;

/// Digits from the random numbers of the system.
///
/// # Errors
/// When it gives none.
pub fn random_digits() -> io::Result<String> {
    let mut bytes = [0; BYTES];
    SysRng
        .try_fill_bytes(&mut bytes)
        .map_err(io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
