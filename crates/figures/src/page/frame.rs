//! The rectangle that two axes span, with its grid, numbers and titles.

use crate::axis_title::axis_title;
use crate::canvas::{Canvas, Point};
use crate::division::Division;
use crate::palette;
use crate::style::Style;
use crate::text::{Anchor, Font, text_width};
use crate::words::label;

/// Part of a picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Area {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Area {
    /// Extent to the right, pixels.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Extent downward, pixels.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Equal parts, one above the other.
    pub fn rows(&self, count: usize) -> Vec<Self> {
        self.parts(1, count)
    }

    /// Equal parts in columns, row by row.
    pub fn parts(&self, columns: usize, count: usize) -> Vec<Self> {
        let width = self.width() / columns as f64;
        let height = self.height() / count.div_ceil(columns) as f64;
        let left = |index: usize| self.left + width * index as f64;
        let top = |index: usize| self.top + height * index as f64;
        let part = |index: usize| {
            let (row, column) = (index / columns, index % columns);
            Self {
                left: left(column),
                top: top(row),
                right: left(column + 1),
                bottom: top(row + 1),
            }
        };
        (0..count).map(part).collect()
    }
}

/// One axis: its title, its ends, and its values with a number and a grid line.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// Quantity and unit; empty for none.
    pub title: String,
    /// Values at its two ends.
    pub ends: (f64, f64),
    /// Values with a grid line, and their labels.
    pub ticks: Vec<(f64, String)>,
}

impl Scale {
    /// An axis with numbers at these values.
    pub fn new(title: impl Into<String>, ends: (f64, f64), values: Vec<f64>) -> Self {
        Self {
            title: title.into(),
            ends,
            ticks: (values.into_iter())
                .map(|value| (value, label(value)))
                .collect(),
        }
    }

    /// The axis of a condition, with about `count` numbers. Its ends are positions in its division.
    pub fn of_condition(
        condition: &str,
        division: Division,
        ends: (f64, f64),
        count: usize,
    ) -> Self {
        Self {
            title: axis_title(condition),
            ends,
            ticks: division.ticks(condition, ends.0, ends.1, count),
        }
    }

    /// Space for its numbers and its title beside a frame, pixels.
    pub fn room(&self) -> f64 {
        let widths = self.ticks.iter().map(|(_, text)| text_width(text, NUMBER));
        LEFT.max(BESIDE_NUMBERS + widths.fold(0.0, f64::max))
    }
}

/// The rectangle that two axes span.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Its area on the picture.
    pub area: Area,
    /// Its area with numbers and titles.
    outside: Area,
    across: Scale,
    up: Scale,
}

/// Sizes of the numbers and of the titles.
const NUMBER: f64 = 12.0;
const TITLE: f64 = 14.0;
/// Length of the marks at the numbers, pixels.
const TICK: f64 = 6.0;
/// Space around a frame for numbers and titles, pixels.
const LEFT: f64 = 76.0;
const RIGHT: f64 = 28.0;
const TOP: f64 = 8.0;
const BOTTOM: f64 = 52.0;
/// Space below a frame without a title, pixels.
const BOTTOM_UNTITLED: f64 = 26.0;
/// Space for title and marks of the vertical axis beside its numbers, pixels.
const BESIDE_NUMBERS: f64 = 48.0;

impl Frame {
    /// The frame of a chart that fills a part of a picture with its numbers and titles.
    pub fn new(outside: Area, across: Scale, up: Scale) -> Self {
        let left = up.room();
        Self::with_left(outside, left, across, up)
    }

    /// The same with its left edge `left` pixels to the right of that of its part.
    pub fn with_left(outside: Area, left: f64, across: Scale, up: Scale) -> Self {
        let bottom = if across.title.is_empty() {
            BOTTOM_UNTITLED
        } else {
            BOTTOM
        };
        let area = Area {
            left: outside.left + left,
            right: outside.right - RIGHT,
            top: outside.top + TOP,
            bottom: outside.bottom - bottom,
        };
        Self {
            area,
            outside,
            across,
            up,
        }
    }

    /// Draws grid, axes, numbers and titles.
    pub fn draw(&self, canvas: &mut Canvas, grid: Style) {
        let Area {
            left,
            top,
            right,
            bottom,
        } = self.area;
        let axis = Style::stroke(palette::TEXT, 1.0);
        let numbers = Font::new(NUMBER, palette::TEXT);
        for (value, text) in &self.across.ticks {
            let (x, _) = self.place((*value, self.up.ends.0));
            canvas.curve(&[(x, top), (x, bottom)], grid);
            canvas.curve(&[(x, bottom), (x, bottom + TICK)], axis);
            canvas.text(text, (x, bottom + TICK + 9.0), numbers);
        }
        for (value, text) in &self.up.ticks {
            let (_, y) = self.place((self.across.ends.0, *value));
            canvas.curve(&[(left, y), (right, y)], grid);
            canvas.curve(&[(left - TICK, y), (left, y)], axis);
            let place = (left - TICK - 4.0, y);
            canvas.text(text, place, numbers.anchor(Anchor::End));
        }
        canvas.curve(&[(left, top), (left, bottom), (right, bottom)], axis);
        let titles = Font::new(TITLE, palette::TEXT);
        if !self.across.title.is_empty() {
            let place = (0.5 * (left + right), self.outside.bottom - 12.0);
            canvas.text(&self.across.title, place, titles);
        }
        if !self.up.title.is_empty() {
            let place = (self.outside.left + 20.0, 0.5 * (top + bottom));
            canvas.text(&self.up.title, place, titles.upright());
        }
    }

    /// Place of a point on the picture, pixels.
    pub fn place(&self, (x, y): Point) -> Point {
        let part = |value: f64, (from, to): (f64, f64)| (value - from) / (to - from);
        (
            self.area.left + part(x, self.across.ends) * self.area.width(),
            self.area.bottom - part(y, self.up.ends) * self.area.height(),
        )
    }

    /// Places of several points on the picture, pixels.
    pub fn places(&self, points: impl IntoIterator<Item = Point>) -> Vec<Point> {
        points.into_iter().map(|point| self.place(point)).collect()
    }
}
