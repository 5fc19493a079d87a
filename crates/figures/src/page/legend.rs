//! Marks of transitions and the line under a picture that explains them.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::boundary_table::Kind;
use crate::figure_error::{FigureError, drawing};
use crate::ink;

/// A mark in a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A transition: a disc for toppling, a square for bottoming, a cross for failures, a ring where landings are
    /// undecided.
    Transition(Kind),
    /// Region of this colour: a rectangle.
    Region(Kind),
    /// The transition lies at or below the lowest speed searched: a triangle that points down.
    AtOrBelow(Kind),
    /// No transition: an open triangle.
    NoTransition,
    /// Lowest transition of a row of a map: a disc.
    Valley,
    /// Velocity that bisects the leading feet: dashes.
    Bisector,
    /// The boundary jumps: a bar.
    Jump,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws a mark of half breadth `side` with its middle at `centre`, pixels.
pub fn draw_mark(
    area: &Area,
    mark: Mark,
    centre: (i32, i32),
    side: i32,
) -> Result<(), FigureError> {
    let (x, y) = centre;
    match mark {
        Mark::Transition(kind) => {
            let colour = ink::mark(kind);
            match kind {
                Kind::Unstable => area.draw(&Circle::new(centre, side - 1, colour.filled())),
                Kind::Bottomed => {
                    let corners = [(x - side + 1, y - side + 1), (x + side - 1, y + side - 1)];
                    area.draw(&Rectangle::new(corners, colour.filled()))
                }
                Kind::Failure => area.draw(&Cross::new(centre, side - 1, colour.stroke_width(2))),
                Kind::Undecided => {
                    area.draw(&Circle::new(centre, side - 1, colour.stroke_width(2)))
                }
            }
        }
        Mark::AtOrBelow(kind) => {
            let corners = [
                (x, y + side),
                (x - side, y - side + 1),
                (x + side, y - side + 1),
            ];
            area.draw(&Polygon::new(corners, ink::mark(kind).filled()))
        }
        Mark::Region(kind) => {
            let corners = [(x - side - 2, y - side), (x + side + 2, y + side)];
            area.draw(&Rectangle::new(corners, ink::region(kind).filled()))
        }
        Mark::NoTransition => {
            let corners = [
                (x, y - side),
                (x - side, y + side - 1),
                (x + side, y + side - 1),
            ];
            let outline = [corners[0], corners[1], corners[2], corners[0]];
            area.draw(&Polygon::new(corners, WHITE.filled()))
                .map_err(drawing)?;
            area.draw(&PathElement::new(outline, ink::NONE.stroke_width(1)))
        }
        Mark::Valley => area.draw(&Circle::new(centre, side - 1, ink::VALLEY.filled())),
        Mark::Bisector => {
            let dash = [(x - 2 * side, y), (x - 2, y)];
            area.draw(&PathElement::new(dash, ink::BISECTOR.stroke_width(2)))
                .map_err(drawing)?;
            let dash = [(x + 2, y), (x + side + 2, y)];
            area.draw(&PathElement::new(dash, ink::BISECTOR.stroke_width(2)))
        }
        Mark::Jump => {
            let bar = [(x, y - side - 1), (x, y + side + 1)];
            area.draw(&PathElement::new(bar, ink::JUMP.stroke_width(3)))
        }
    }
    .map_err(drawing)
}

/// Width of a text of the legend, pixels: there is no font to measure it with.
fn width(text: &str) -> i32 {
    (text.chars().count() as f64 * 7.0) as i32
}

/// Draws marks with their meanings in one centred line.
pub fn draw_legend(area: &Area, entries: &[(Mark, String)]) -> Result<(), FigureError> {
    const GAP: i32 = 34;
    const INDENT: i32 = 13;
    let (total, _) = area.dim_in_pixel();
    let widths = entries.iter().map(|(_, text)| INDENT + width(text));
    let used: i32 = widths.sum::<i32>() + GAP * (entries.len() as i32 - 1);
    let mut x = (total as i32 - used) / 2;
    for (mark, text) in entries {
        draw_mark(area, *mark, (x, 12), ink::MARK)?;
        area.draw(&Text::new(
            text.clone(),
            (x + INDENT, 7),
            ink::text(12, ink::TEXT),
        ))
        .map_err(drawing)?;
        x += INDENT + width(text) + GAP;
    }
    Ok(())
}
