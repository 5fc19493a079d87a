//! Frames: a mark, a length and a checksum before a payload. Whatever happened to a file, a payload that can be read
//! from it is one that was written.
//!
//! | bytes | what |
//! |---|---|
//! | 4 | the mark |
//! | 4 | length of the payload, little-endian |
//! | 4 | CRC-32 of the seed, the length and the payload, little-endian |
//! | … | the payload |
//!
//! The seed of a record is the checksum of its journal's header, so that it belongs to that header alone.

/// First bytes of every frame.
pub(crate) const MARK: [u8; 4] = *b"\xABtdj";
/// Bytes before the payload.
pub(crate) const OVERHEAD: usize = 12;
/// Longest payload, bytes: far more than the bands of any point.
pub(crate) const LONGEST: usize = 1 << 22;
/// Seed of header frames.
pub(crate) const HEADER_SEED: u32 = 0;

/// Encodes a frame.
pub(crate) fn encode(seed: u32, payload: &[u8]) -> Vec<u8> {
    let length = (payload.len() as u32).to_le_bytes();
    let mut frame = Vec::with_capacity(OVERHEAD + payload.len());
    frame.extend(MARK);
    frame.extend(length);
    frame.extend(checksum(seed, length, payload).to_le_bytes());
    frame.extend(payload);
    frame
}

/// Length of the payload according to the first [`OVERHEAD`] bytes of a frame.
pub(crate) fn announced(start: &[u8; OVERHEAD]) -> Option<usize> {
    let [m0, m1, m2, m3, l0, l1, l2, l3, ..] = *start;
    let length = u32::from_le_bytes([l0, l1, l2, l3]) as usize;
    ([m0, m1, m2, m3] == MARK && length <= LONGEST).then_some(length)
}

/// True if a payload matches the checksum of its frame.
pub(crate) fn is_whole(seed: u32, start: &[u8; OVERHEAD], payload: &[u8]) -> bool {
    let [_, _, _, _, l0, l1, l2, l3, c0, c1, c2, c3] = *start;
    checksum(seed, [l0, l1, l2, l3], payload) == u32::from_le_bytes([c0, c1, c2, c3])
}

fn checksum(seed: u32, length: [u8; 4], payload: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&seed.to_le_bytes());
    hasher.update(&length);
    hasher.update(payload);
    hasher.finalize()
}
