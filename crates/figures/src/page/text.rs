//! Texts of a picture: type, width, letters that XML does not allow, subscripts.

use crate::style::Colour;

/// Mean width of a letter relative to the type size: there is no font to measure with.
const LETTER: f64 = 0.58;

/// The part of a text at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its first letter.
    Start,
    /// Its middle.
    Middle,
    /// Its last letter.
    End,
}

/// Size (pixels), colour and anchor of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Font {
    pub(super) size: f64,
    pub(super) colour: Colour,
    pub(super) anchor: Anchor,
    pub(super) is_upright: bool,
}

impl Font {
    /// A horizontal text centred at its place.
    pub fn new(size: f64, colour: Colour) -> Self {
        Self {
            size,
            colour,
            anchor: Anchor::Middle,
            is_upright: false,
        }
    }

    /// With another part of the text at its place.
    pub fn anchor(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// Turned to read upward.
    pub fn upright(self) -> Self {
        Self {
            is_upright: true,
            ..self
        }
    }
}

/// Estimated width of a text in a type size, pixels.
pub fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * LETTER * size
}

/// A text escaped for XML.
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe += "&amp;",
            '<' => safe += "&lt;",
            '>' => safe += "&gt;",
            letter if letter.is_control() => safe.push(' '),
            letter => safe.push(letter),
        }
    }
    safe
}

/// Sets the letters of V_H and V_V as subscripts.
pub fn with_subscripts(text: &str) -> String {
    let mut parts = text.split("V_");
    let mut set = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.chars().next() {
            Some(index @ ('H' | 'V')) => {
                set += &format!("V<tspan dy=\"3\" font-size=\"75%\">{index}</tspan>");
                let rest = &part[1..];
                if !rest.is_empty() {
                    // Back to the base line.
                    set += &format!("<tspan dy=\"-3\">{rest}</tspan>");
                }
            }
            _ => {
                set += "V_";
                set += part;
            }
        }
    }
    set
}
