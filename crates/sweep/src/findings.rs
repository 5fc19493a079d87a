//! What a point came to, as the bytes of a journal's record.

use crate::boundary::Boundary;

/// The bytes of what a point came to; numbers keep every bit.
pub fn encode(boundary: &Boundary) -> Vec<u8> {
    // Into memory, and of types that have a form: neither can fail.
    postcard::to_stdvec(boundary).unwrap_or_default()
}

/// What a point came to; `None` for bytes that say nothing.
pub fn decode(bytes: &[u8]) -> Option<Boundary> {
    match postcard::take_from_bytes(bytes) {
        Ok((boundary, [])) => Some(boundary),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bands::Band;
    use crate::boundary::Transition;
    use touchdown_dynamics::outcome::{Class, Failure, Outcome};

    #[test]
    fn every_bit_survives() {
        let boundary = Boundary {
            transition: Some(Transition {
                to: Class::Failure,
                low: 0.1 + 0.2,
                high: f64::MIN_POSITIVE,
            }),
            bands: vec![Band {
                from: -0.0,
                to: 1.0 / 3.0,
                class: Class::Bottomed,
                outcome: Outcome::Failure(Failure::PadInclination { leg: 2 }),
                bracket_width: None,
            }],
            looks: 3,
            finds: 1,
            landings: 1 << 40,
            evaluations: u64::MAX,
        };
        let bytes = encode(&boundary);
        let read = decode(&bytes).unwrap();
        assert_eq!(read, boundary);
        assert!(read.bands[0].from.is_sign_negative());
        assert_eq!(decode(&bytes[1..]), None);
        assert_eq!(decode(&[bytes, vec![0]].concat()), None);
    }
}
