//! Captions, titles, numbers, the divisions of axes, and complaints in words.

pub mod axis_title;
pub mod caption;
pub mod division;
pub mod ticks;
pub mod unit;

use thiserror::Error;

/// A picture that could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FigureError {
    /// The result table is not what the picture needs.
    #[error("result table: {0}")]
    Table(String),
    /// The result table is in order, but there is no picture of it.
    #[error("has no picture: {0}")]
    NoPicture(String),
    /// The PNG cannot be made.
    #[error("PNG: {0}")]
    Rendering(String),
}

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
