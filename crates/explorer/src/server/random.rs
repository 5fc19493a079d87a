//! Unguessable random digits for tokens and nonces.

use std::io;

use rand::TryRng;
use rand::rngs::SysRng;

/// Number of random bytes.
const BYTES: usize = 16;

/// Hexadecimal digits from the random numbers of the system.
///
/// # Errors
/// If the system provides none.
pub fn random_digits() -> io::Result<String> {
    let mut bytes = [0; BYTES];
    SysRng
        .try_fill_bytes(&mut bytes)
        .map_err(io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
