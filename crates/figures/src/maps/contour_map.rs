//! The contour map of a stability surface, in the manner of Figure 4-21.

use crate::axis_title::axis_title;
use crate::canvas::{Canvas, Point};
use crate::caption::Caption;
use crate::frame::{Area, Frame, Scale};
use crate::heights::Heights;
use crate::isolines::{self, Place};
use crate::legend::{Mark, draw_mark};
use crate::levels::Levels;
use crate::map_legend;
use crate::map_view::View;
use crate::sheet::{self, Height, Sheet};
use crate::style::{Style, WHITE};
use crate::surface::{Cell, Surface};
use crate::text::{Font, text_width};
use crate::words::label;
use crate::{colour_bar, leading_feet, palette};
use libm::hypot;

/// Width and height of the picture, pixels.
pub const SIZE: (f64, f64) = (900.0, 860.0);
/// Shortest line that carries a label, and least distance between labels, pixels.
const LABELLED: f64 = 70.0;
const APART: f64 = 46.0;
/// Distance of the middle of a label from a disc that it must not cover, pixels.
const CLEAR: f64 = 18.0;
/// Distance of points above which their marks have full size, pixels.
const ROOMY: f64 = 24.0;
/// Size of the labels, and height of the paper under them.
const LABEL: f64 = 11.0;
const PAPER: f64 = 15.0;

/// Draws the map as SVG.
pub fn draw(surface: &Surface, view: &View, heights: &Heights, caption: &Caption) -> String {
    let levels = &heights.levels;
    let entries = map_legend::of_map(surface, caption);
    let (width, height) = SIZE;
    let Sheet { mut canvas, body } = sheet::begin(width, Height::Whole(height), caption, &entries);
    let [left, right] = colour_bar::beside(body, colour_bar::OVERLAP);
    let map = Map {
        frame: frame(left, surface, view),
        surface,
        view,
    };
    map.fill(&mut canvas, levels);
    map.frame
        .draw(&mut canvas, Style::stroke(palette::TEXT, 1.0).opacity(0.12));
    map.draw_jumps(&mut canvas);
    map.draw_isolines(&mut canvas, levels);
    if map_legend::has_leading_feet(surface, caption) {
        map.draw_leading_feet(&mut canvas);
    }
    map.draw_lone_points(&mut canvas, levels);
    map.draw_marks(&mut canvas);
    colour_bar::draw(&mut canvas, right, heights, caption.speed_unit);
    canvas.into_svg()
}

/// The frame of a map with its scales.
pub fn frame(area: Area, surface: &Surface, view: &View) -> Frame {
    let [across, up] = view.ranges(surface);
    let scale = |axis: usize, ends: (f64, f64), count| Scale {
        title: axis_title(&surface.axes[axis]),
        ends,
        ticks: view.ticks(surface, axis, ends, count),
    };
    Frame::new(area, scale(1, across, 13), scale(0, up, 11))
}

/// A surface and its frame on the picture.
struct Map<'m> {
    frame: Frame,
    surface: &'m Surface,
    view: &'m View,
}

impl Map<'_> {
    fn place(&self, place: Place) -> Point {
        self.frame.place(self.view.at(place))
    }

    fn places(&self, places: impl IntoIterator<Item = Place>) -> Vec<Point> {
        places.into_iter().map(|place| self.place(place)).collect()
    }

    fn fill(&self, canvas: &mut Canvas, levels: &Levels) {
        let (s, f) = (&self.surface.slow, &self.surface.fast);
        let jump_cells = self.surface.cells().filter(|(_, cell)| *cell == Cell::Jump);
        let jump_cells: Vec<Vec<Point>> = jump_cells
            .map(|([row, column], _)| {
                let corners = [(0, 0), (0, 1), (1, 1), (1, 0)];
                self.places(corners.map(|(r, c)| [s[row + r], f[column + c]]))
            })
            .collect();
        canvas.fill_tiles(&jump_cells, palette::JUMP_CELL);
        for [low, high] in levels.bands() {
            let polygons = isolines::band(self.surface, low, high).into_iter();
            let polygons: Vec<Vec<Point>> = polygons.map(|polygon| self.places(polygon)).collect();
            canvas.fill_tiles(&polygons, levels.colour(low));
        }
    }

    /// Draws a bar across every edge of the grid over which the boundary jumps.
    fn draw_jumps(&self, canvas: &mut Canvas) {
        for ends in self.surface.jump_bars() {
            let style = Style::stroke(palette::JUMP, palette::JUMP_WIDTH);
            canvas.curve(&self.places(ends), style);
        }
    }

    fn draw_isolines(&self, canvas: &mut Canvas, levels: &Levels) {
        let discs = self.places(self.surface.lowest_in_rows());
        let lines = levels.values().iter().map(|level| {
            let lines = isolines::lines(self.surface, *level).into_iter();
            (*level, lines.map(|line| self.places(line)).collect())
        });
        draw_lines(canvas, &self.frame.area, &discs, lines);
    }

    fn draw_leading_feet(&self, canvas: &mut Canvas) {
        for line in leading_feet::lines(&self.surface.slow, &self.surface.fast) {
            canvas.curve(&self.places(line), map_legend::bisector());
        }
    }

    fn draw_lone_points(&self, canvas: &mut Canvas, levels: &Levels) {
        for (place, speed) in self.surface.lone() {
            let mark = Mark::Lone(levels.colour(speed));
            draw_mark(canvas, mark, self.place(place), palette::MARK);
        }
    }

    fn draw_marks(&self, canvas: &mut Canvas) {
        for place in self.surface.lowest_in_rows() {
            draw_mark(canvas, Mark::Lowest, self.place(place), palette::MARK);
        }
        let (rows, columns) = (self.surface.slow.len(), self.surface.fast.len());
        let area = &self.frame.area;
        let room = (area.width() / columns as f64).min(area.height() / rows as f64);
        let side = if room > ROOMY {
            palette::MARK
        } else {
            palette::SMALL_MARK
        };
        for place in self.surface.gaps() {
            draw_mark(canvas, Mark::NoTransition, self.place(place), side);
        }
        for (place, mark) in &self.surface.doubtful {
            draw_mark(canvas, *mark, self.place(*place), palette::MARK);
        }
    }
}

/// Draws lines of equal height with their levels. Labels keep clear of discs and of each other.
pub fn draw_lines(
    canvas: &mut Canvas,
    area: &Area,
    discs: &[Point],
    lines: impl Iterator<Item = (f64, Vec<Vec<Point>>)>,
) {
    let mut labels: Vec<(Point, String)> = Vec::new();
    for (level, lines) in lines {
        let label = label(level);
        let room = 0.5 * text_width(&label, LABEL) + 4.0;
        for line in lines {
            canvas.curve(&line, Style::stroke(palette::TEXT, 1.3));
            let lengths = line.windows(2).map(|ends| distance(ends[0], ends[1]));
            if lengths.sum::<f64>() < LABELLED {
                continue;
            }
            // The middle, or else the nearest free place to it.
            let mut order: Vec<usize> = (0..line.len()).collect();
            order.sort_by_key(|index| index.abs_diff(line.len() / 2));
            let is_free = |place: &Point| {
                labels
                    .iter()
                    .all(|(other, _)| distance(*place, *other) > APART)
                    && discs.iter().all(|disc| distance(*place, *disc) > CLEAR)
                    && (area.left + room..area.right - room).contains(&place.0)
                    && (area.top + PAPER..area.bottom - PAPER).contains(&place.1)
            };
            let places = order.into_iter().map(|index| line[index]);
            if let Some(place) = places.into_iter().find(is_free) {
                labels.push((place, label.clone()));
            }
        }
    }
    for ((x, y), label) in labels {
        let [half, up] = [0.5 * text_width(&label, LABEL) + 3.0, 0.5 * PAPER];
        let paper = Style::fill(WHITE).opacity(0.85);
        canvas.rectangle((x - half, y - up), (x + half, y + up), paper);
        canvas.text(&label, (x, y), Font::new(LABEL, palette::TEXT));
    }
}

fn distance(a: Point, b: Point) -> f64 {
    hypot(a.0 - b.0, a.1 - b.1)
}

#[cfg(test)]
#[path = "contour_map_tests.rs"]
mod tests;
