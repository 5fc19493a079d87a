//! The sheet that all pictures share: title and captions above, the body, the legend below.

use crate::canvas::Canvas;
use crate::caption::Caption;
use crate::frame::Area;
use crate::legend::{self, Entry};
use crate::palette;
use crate::style::Colour;
use crate::text::{Font, text_width};

/// Margin at the left and right edge without text, pixels.
const MARGIN: f64 = 24.0;
/// Heights above the first line of the title, of its lines, and of those of the captions, pixels.
const ABOVE: f64 = 26.0;
const TITLE_LINE: f64 = 23.0;
const LINE: f64 = 20.0;
/// Space between the last line and the body, pixels.
const BELOW: f64 = 16.0;
/// Sizes of title and captions.
const TITLE: f64 = 18.0;
const TEXT: f64 = 12.0;
/// Height of the foot beyond the rows of the legend, pixels.
const FOOT: f64 = 14.0;

/// A sheet with its captions and its legend, and the area between them for the body.
pub struct Sheet {
    /// The picture.
    pub canvas: Canvas,
    /// Area of the body.
    pub body: Area,
}

/// Height of the body of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Height {
    /// Height of the whole, pixels; captions and legend take their part.
    Whole(f64),
    /// Its own height, pixels.
    Body(f64),
}

/// Begins a picture: writes the captions above and the legend below.
pub fn begin(width: f64, height: Height, caption: &Caption, entries: &[Entry]) -> Sheet {
    let text_room = width - 2.0 * MARGIN;
    let mut lines: Vec<(String, f64, f64, Colour)> = Vec::new();
    let mut y = ABOVE;
    for line in wrapped(&caption.title, TITLE, text_room) {
        lines.push((line, y, TITLE, palette::TEXT));
        y += TITLE_LINE;
    }
    for (text, colour) in [
        (Some(&caption.conditions), palette::PALE_TEXT),
        (caption.worst_over.as_ref(), palette::TEXT),
        (caption.statement.as_ref(), palette::STATEMENT),
    ] {
        for line in wrapped(text.map_or("", String::as_str), TEXT, text_room) {
            lines.push((line, y, TEXT, colour));
            y += LINE;
        }
    }
    let top = match lines.last() {
        Some((_, y, ..)) => y + BELOW,
        None => ABOVE,
    };
    let rows = legend::rows(entries, text_room);
    let foot = FOOT + legend::ROW * rows.len() as f64;
    let bottom = match height {
        Height::Whole(height) => height - foot,
        Height::Body(height) => top + height,
    };
    let mut canvas = Canvas::new((width, bottom + foot));
    for (text, y, size, colour) in lines {
        canvas.text(&text, (0.5 * width, y), Font::new(size, colour));
    }
    legend::draw(&mut canvas, &rows, 0.5 * width, bottom + 12.0);
    let body = Area {
        left: 0.0,
        top,
        right: width,
        bottom,
    };
    Sheet { canvas, body }
}

/// Breaks a text between words into lines that fit a width in pixels.
fn wrapped(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(line, size) + text_width(word, size) < width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_captions_take_more_lines_and_the_body_begins_below_them() {
        let caption = |title: &str| Caption {
            title: title.to_owned(),
            ..Caption::default()
        };
        let begin = |title: &str| begin(900.0, Height::Whole(560.0), &caption(title), &[]);
        let short = begin("Roll");
        let long = begin(&"a long title of many words ".repeat(8));
        assert!(long.body.top > short.body.top + TITLE_LINE);
        assert_eq!(long.body.bottom, short.body.bottom);
        assert!(long.canvas.into_svg().matches("<text").count() >= 2);
    }
}
