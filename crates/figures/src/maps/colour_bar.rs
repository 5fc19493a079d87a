//! The colour bar of a map.

use crate::canvas::Canvas;
use crate::frame::Area;
use crate::heights::Heights;
use crate::palette;
use crate::style::Style;
use crate::text::{Anchor, Font};
use crate::unit::SpeedUnit;
use crate::words::label;

/// Width of the column with its numbers, pixels.
const WIDTH: f64 = 92.0;
/// Position and width of the colours in the column, and greatest height of one of them, pixels.
const LEFT: f64 = 8.0;
const COLOUR: f64 = 20.0;
const TOP: f64 = 60.0;
const STEP: f64 = 34.0;
/// Space below the colours, pixels.
const BELOW: f64 = 60.0;

/// Splits a body into a part for a map, which may reach `overlap` pixels into the column's margin, and one for the
/// column.
pub fn beside(body: Area, overlap: f64) -> [Area; 2] {
    let border = body.right - WIDTH;
    let map = Area {
        right: border + overlap,
        ..body
    };
    let column = Area {
        left: border,
        ..body
    };
    [map, column]
}

/// Overlap of a contour map with the column, pixels.
pub const OVERLAP: f64 = 12.0;

/// Draws the colour bands that heights reach, the highest on top.
pub fn draw(canvas: &mut Canvas, area: Area, heights: &Heights, unit: SpeedUnit) {
    let levels = &heights.levels;
    let Some((least, greatest)) = heights.range else {
        return;
    };
    let (left, top) = (area.left + LEFT, area.top + TOP);
    let font = Font::new(12.0, palette::TEXT).anchor(Anchor::Start);
    for (text, y) in [("V_H,", top - 34.0), (&unit.to_string(), top - 18.0)] {
        canvas.text(text, (left, y), font);
    }
    let mut bands = levels.bands();
    bands.retain(|[low, high]| least < *high && *low <= greatest);
    let step = STEP.min((area.height() - TOP - BELOW) / bands.len() as f64);
    for (index, [low, _]) in bands.iter().rev().enumerate() {
        let y = top + step * index as f64;
        let style = Style::fill(levels.colour(*low)).outlined(palette::TEXT, 1.0);
        canvas.rectangle((left, y), (left + COLOUR, y + step), style);
        if index + 1 < bands.len() {
            canvas.text(&label(*low), (left + COLOUR + 6.0, y + step), font);
        }
    }
}
