//! Numbers in pictures and texts.

/// A number to six decimals at most, with a true minus sign.
pub fn label(number: f64) -> String {
    let rounded = (number * 1e6).round() / 1e6 + 0.0;
    rounded.to_string().replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_signed_as_printed() {
        assert_eq!(label(-0.5), "\u{2212}0.5");
        assert_eq!(label(0.1 + 0.2), "0.3");
        assert_eq!(label(-1e-9), "0");
    }
}
