//! Marks of a picture, and the lines under it that explain them.

use crate::boundary_table::Kind;
use crate::canvas::{Canvas, Point};
use crate::palette;
use crate::style::{Colour, Style, WHITE};
use crate::text::{Anchor, Font, text_width};

/// A mark in a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mark {
    /// A transition: a disc for toppling, a square for bottoming, a cross for failures, a ring for undecided landings.
    Transition(Kind),
    /// The transition lies at or below the lowest speed searched: a triangle that points down.
    AtOrBelow(Kind),
    /// No transition: an open triangle.
    NoTransition,
    /// Lowest transition of a row of a map: a disc.
    Lowest,
    /// The boundary jumps: a bar.
    Jump,
    /// An open circle of this colour.
    Ring(Colour),
    /// A disc of this colour.
    Disc(Colour),
    /// A point without a surface beside it: a disc in the colour of its level, with an outline.
    Lone(Colour),
    /// An interval: a thin vertical bar.
    Interval,
    /// A line of this style.
    Line(Style),
    /// An area of this style.
    Area(Style),
    /// A striped area: stable landings and others alternate.
    Patchy,
    /// A hatched area: the error of a map is estimated larger than asked.
    Hatched,
}

/// Draws a mark of half breadth `side`, centred at a place, pixels.
pub(crate) fn draw_mark(canvas: &mut Canvas, mark: Mark, (x, y): Point, side: f64) {
    match mark {
        Mark::Transition(kind) => {
            let colour = palette::mark(kind);
            let inner = side - 1.0;
            match kind {
                Kind::Unstable => canvas.circle((x, y), inner, Style::fill(colour)),
                Kind::Bottomed => canvas.rectangle(
                    (x - inner, y - inner),
                    (x + inner, y + inner),
                    Style::fill(colour),
                ),
                Kind::Failure => {
                    for up in [inner, -inner] {
                        let ends = [(x - inner, y + up), (x + inner, y - up)];
                        canvas.curve(&ends, Style::stroke(colour, 2.0));
                    }
                }
                Kind::Undecided => canvas.circle((x, y), inner, Style::stroke(colour, 2.0)),
            }
        }
        Mark::AtOrBelow(kind) => {
            let corners = [
                (x, y + side),
                (x - side, y - side + 1.0),
                (x + side, y - side + 1.0),
            ];
            canvas.polygon(&corners, Style::fill(palette::mark(kind)));
        }
        Mark::NoTransition => {
            let corners = [
                (x, y - side),
                (x - side, y + side - 1.0),
                (x + side, y + side - 1.0),
            ];
            canvas.polygon(&corners, Style::fill(WHITE).outlined(palette::NONE, 1.0));
        }
        Mark::Lowest => canvas.circle((x, y), side - 1.0, Style::fill(palette::LOWEST)),
        Mark::Jump => {
            let ends = [(x, y - side - 1.0), (x, y + side + 1.0)];
            canvas.curve(&ends, Style::stroke(palette::JUMP, palette::JUMP_WIDTH));
        }
        Mark::Ring(colour) => canvas.circle((x, y), side - 1.0, Style::stroke(colour, 1.5)),
        Mark::Disc(colour) => canvas.circle((x, y), side - 1.0, Style::fill(colour)),
        Mark::Lone(colour) => {
            let style = Style::fill(colour).outlined(palette::TEXT, 1.0);
            canvas.circle((x, y), side, style);
        }
        Mark::Interval => {
            let ends = [(x, y - side - 2.0), (x, y + side + 2.0)];
            canvas.curve(&ends, Style::stroke(palette::TEXT, 1.0));
        }
        Mark::Line(style) => {
            canvas.curve(&[(x - LINE / 2.0, y), (x + LINE / 2.0, y)], style);
        }
        Mark::Patchy => {
            for left in [-1.5, -0.5, 0.5, 1.5] {
                let x = x + left * palette::STRIPES_APART;
                canvas.curve(&[(x, y - side), (x, y + side)], stripe());
            }
        }
        Mark::Hatched => {
            for left in [-1.0, 0.0, 1.0] {
                let x = x + left * palette::HATCH_APART;
                canvas.curve(&[(x - side, y - side), (x + side, y + side)], hatch());
            }
        }
        Mark::Area(style) => {
            canvas.rectangle(
                (x - side - 4.0, y - side),
                (x + side + 4.0, y + side),
                style,
            );
        }
    }
}

/// Style of the stripes of a patchy area.
pub fn stripe() -> Style {
    Style::stroke(palette::PATCHY, palette::STRIPE)
}

/// Style of hatching.
pub fn hatch() -> Style {
    Style::stroke(palette::HATCH, palette::HATCH_WIDTH)
}

/// Length of the sample of a line, pixels.
const LINE: f64 = 34.0;
/// Size of the text, and space between entries and between rows, pixels.
const SIZE: f64 = 12.0;
const GAP: f64 = 26.0;
/// Height of a row, pixels.
pub const ROW: f64 = 20.0;

/// A mark and its meaning.
pub type Entry = (Mark, String);

/// Width of a mark with the space after it, pixels.
fn mark_width(mark: Mark) -> f64 {
    match mark {
        Mark::Line(_) => LINE + 8.0,
        Mark::Area(_) | Mark::Patchy | Mark::Hatched => 26.0,
        _ => 18.0,
    }
}

fn entry_width((mark, text): &Entry) -> f64 {
    mark_width(*mark) + text_width(text, SIZE)
}

/// Splits the entries into rows that fit a width in pixels.
pub fn rows(entries: &[Entry], width: f64) -> Vec<&[Entry]> {
    let mut rows = Vec::new();
    let (mut start, mut used) = (0, 0.0);
    for (index, entry) in entries.iter().enumerate() {
        let wanted = entry_width(entry) + if index > start { GAP } else { 0.0 };
        if index > start && used + wanted > width {
            rows.push(&entries[start..index]);
            (start, used) = (index, entry_width(entry));
        } else {
            used += wanted;
        }
    }
    rows.extend((start < entries.len()).then(|| &entries[start..]));
    rows
}

/// Draws rows of entries, each centred about `middle`, the first at height `top`.
pub(crate) fn draw(canvas: &mut Canvas, rows: &[&[Entry]], middle: f64, top: f64) {
    for (row, entries) in rows.iter().enumerate() {
        let y = top + ROW * row as f64;
        let used: f64 = entries.iter().map(entry_width).sum();
        let mut x = middle - 0.5 * (used + GAP * (entries.len() as f64 - 1.0));
        for (mark, text) in *entries {
            let width = mark_width(*mark);
            draw_mark(canvas, *mark, (x + 0.5 * (width - 8.0), y), palette::MARK);
            let font = Font::new(SIZE, palette::TEXT).anchor(Anchor::Start);
            canvas.text(text, (x + width, y), font);
            x += width + text_width(text, SIZE) + GAP;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of the picture of a mark at a place.
    fn numbers(mark: Mark, place: Point) -> Vec<f64> {
        let mut canvas = Canvas::new((500.0, 500.0));
        draw_mark(&mut canvas, mark, place, 5.0);
        let svg = canvas.into_svg();
        let parts = svg.split(|c: char| !(c.is_ascii_digit() || "-.".contains(c)));
        parts.filter_map(|part| part.parse().ok()).collect()
    }

    #[test]
    fn a_mark_looks_the_same_wherever_it_stands() {
        let of_kinds = [
            Kind::Unstable,
            Kind::Bottomed,
            Kind::Failure,
            Kind::Undecided,
        ];
        let of_kinds = of_kinds.map(|kind| [Mark::Transition(kind), Mark::AtOrBelow(kind)]);
        let others = [
            Mark::NoTransition,
            Mark::Lowest,
            Mark::Jump,
            Mark::Ring(WHITE),
            Mark::Lone(WHITE),
            Mark::Interval,
            Mark::Line(stripe()),
            Mark::Area(stripe()),
            Mark::Patchy,
            Mark::Hatched,
        ];
        for mark in of_kinds.into_iter().flatten().chain(others) {
            let (here, there) = (numbers(mark, (100.0, 200.0)), numbers(mark, (130.0, 240.0)));
            assert_eq!(here.len(), there.len());
            let moved: Vec<f64> = here.iter().zip(&there).map(|(a, b)| b - a).collect();
            let is_of = |way: f64| move |moved: &f64| (moved - way).abs() < 1e-6;
            let is_any = |moved: &f64| [0.0, 30.0, 40.0].iter().any(|way| is_of(*way)(moved));
            assert!(moved.iter().all(is_any), "{mark:?}: {moved:?}");
            assert!(moved.iter().any(is_of(30.0)) && moved.iter().any(is_of(40.0)));
        }
    }

    #[test]
    fn entries_that_do_not_fit_go_to_the_next_row() {
        let entry = |text: &str| (Mark::Lowest, text.to_owned());
        let entries = [entry("one"), entry("two"), entry(&"long ".repeat(12))];
        let lengths: Vec<usize> = rows(&entries, 500.0).iter().map(|row| row.len()).collect();
        assert_eq!(lengths, [2, 1]);
        assert_eq!(rows(&entries, 5000.0).len(), 1);
        assert_eq!(rows(&entries, 1.0).len(), 3);
        assert!(rows(&[], 500.0).is_empty());
    }
}
