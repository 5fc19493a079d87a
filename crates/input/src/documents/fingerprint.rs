//! Fingerprints: equal for equal texts, different in practice for different ones.

/// FNV-1a of 128 bits, in hexadecimal digits.
pub fn fingerprint(text: &str) -> String {
    fingerprint_of_bytes(text.bytes())
}

/// [`fingerprint`] of bytes that need not be contiguous.
pub fn fingerprint_of_bytes(bytes: impl IntoIterator<Item = u8>) -> String {
    const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    let add = |hash: u128, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME);
    format!("{:032x}", bytes.into_iter().fold(BASIS, add))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fingerprints_are_those_of_the_published_algorithm() {
        assert_eq!(fingerprint(""), "6c62272e07bb014262b821756295c58d");
        assert_eq!(fingerprint("a"), "d228cb696f1a8caf78912b704e4a8964");
        assert_eq!(fingerprint("foobar"), "343e1662793c64bf6f0d3597ba446f18");
    }
}
