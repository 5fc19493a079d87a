//! The stability surface in perspective, in the manner of Figure 4-20.

use crate::axis_title::axis_title;
use crate::canvas::{Canvas, Point};
use crate::caption::Caption;
use crate::heights::Heights;
use crate::legend::{Mark, draw_mark};
use crate::levels::Levels;
use crate::sheet::{self, Height, Sheet};
use crate::style::Style;
use crate::surface::{Cell, Surface};
use crate::text::{Anchor, Font};
use crate::ticks::{multiples, round_step};
use crate::view_point::ViewPoint;
use crate::words::label;
use crate::{colour_bar, map_legend, palette};

/// Width and height of the picture, pixels.
pub const SIZE: (f64, f64) = (900.0, 700.0);
/// Approximate number of lines of equal height along the walls, and along floor and walls to either side.
const HEIGHT_LINES: f64 = 8.0;
const LINES: usize = 6;

/// Draws the surface as SVG. Only cells are drawn whose corners all have a transition and between which the boundary
/// does not jump, so that gaps stay gaps.
pub fn draw(surface: &Surface, heights: &Heights, caption: &Caption) -> String {
    let entries = map_legend::of_perspective(surface, caption);
    let (width, height) = SIZE;
    let Sheet { mut canvas, body } = sheet::begin(width, Height::Whole(height), caption, &entries);
    let [left, right] = colour_bar::beside(body, 0.0);
    if let Some((ends, step)) = floor_and_top(heights) {
        let point = ViewPoint::on(left, surface, ends);
        draw_box(&mut canvas, surface, &point, (ends, step), caption);
        draw_floor_marks(&mut canvas, surface, &point, ends[0]);
        draw_cells(&mut canvas, surface, &heights.levels, &point);
    }
    colour_bar::draw(&mut canvas, right, heights, caption.speed_unit);
    canvas.into_svg()
}

/// Heights of floor and top of the box around a surface, and the step between the lines on its walls.
pub fn floor_and_top(heights: &Heights) -> Option<([f64; 2], f64)> {
    let (least, greatest) = heights.range?;
    let step = round_step((greatest - least) / HEIGHT_LINES);
    let floor = step * (least / step).floor();
    let top = (step * (greatest / step).ceil()).max(floor + step);
    Some(([floor, top], step))
}

/// Draws whole cells from back to front, so that those in front hide those behind.
fn draw_cells(canvas: &mut Canvas, surface: &Surface, levels: &Levels, point: &ViewPoint) {
    let (s, f) = (&surface.slow, &surface.fast);
    let mut cells: Vec<([usize; 2], [f64; 4])> = surface
        .cells()
        .filter_map(|(place, cell)| match cell {
            Cell::Whole(heights) => Some((place, heights)),
            Cell::Jump | Cell::Open => None,
        })
        .collect();
    let depth =
        |[row, column]: [usize; 2]| point.depth(s[row] + s[row + 1], f[column] + f[column + 1]);
    cells.sort_by(|(a, _), (b, _)| depth(*b).total_cmp(&depth(*a)));
    for ([r, c], heights) in cells {
        let [a, b, d, e] = heights;
        let corners = [
            point.pixel(s[r], f[c], a),
            point.pixel(s[r], f[c + 1], b),
            point.pixel(s[r + 1], f[c + 1], d),
            point.pixel(s[r + 1], f[c], e),
        ];
        let colour = levels.colour(heights.iter().sum::<f64>() / 4.0);
        canvas.polygon(
            &corners,
            Style::fill(colour).outlined(palette::SURFACE, 0.8),
        );
    }
    // Where the boundary jumps, a line joins the two heights.
    for [a, b] in surface.jump_edges() {
        let ends = [a, b].map(|([slow, fast], height)| point.pixel(slow, fast, height));
        canvas.curve(&ends, map_legend::jump());
    }
    for (place, height) in surface.lone() {
        let mark = Mark::Lone(levels.colour(height));
        let at = point.pixel(place[0], place[1], height);
        draw_mark(canvas, mark, at, palette::SMALL_MARK);
    }
    for (place, mark) in &surface.doubtful {
        let row = s.partition_point(|slow| *slow < place[0]);
        let column = f.partition_point(|fast| *fast < place[1]);
        if let Some(height) = surface.speeds[row][column] {
            let place = point.pixel(place[0], place[1], height);
            draw_mark(canvas, *mark, place, palette::SMALL_MARK);
        }
    }
}

/// Marks points without a transition on the floor.
fn draw_floor_marks(canvas: &mut Canvas, surface: &Surface, point: &ViewPoint, floor: f64) {
    for [slow, fast] in surface.gaps() {
        let place = point.pixel(slow, fast, floor);
        draw_mark(canvas, Mark::NoTransition, place, palette::SMALL_MARK);
    }
}

/// Draws floor and back walls with their grid and labels.
pub fn draw_box(
    canvas: &mut Canvas,
    surface: &Surface,
    point: &ViewPoint,
    ([floor, top], step): ([f64; 2], f64),
    caption: &Caption,
) {
    let line = |canvas: &mut Canvas, ends: [Point; 2]| {
        canvas.curve(&ends, Style::stroke(palette::GRID, 1.0));
    };
    let ends = |values: &[f64]| [values[0], values[values.len() - 1]];
    let ([s0, s1], [f0, f1]) = (ends(&surface.slow), ends(&surface.fast));
    let ([back_s, front_s], [back_f, front_f]) = point.back_and_front([s0, s1], [f0, f1]);
    let small = Font::new(12.0, palette::TEXT);
    let ticks = |axis: usize, from: f64, to: f64| {
        let name = &surface.axes[axis];
        caption.division(name).ticks(name, from, to, LINES)
    };
    for (slow, number) in ticks(0, s0, s1) {
        line(canvas, [f0, f1].map(|fast| point.pixel(slow, fast, floor)));
        line(canvas, [floor, top].map(|up| point.pixel(slow, back_f, up)));
        let place = point.outside(slow, front_f, floor, [0.0, 0.05]);
        canvas.text(&number, place, small);
    }
    for (fast, number) in ticks(1, f0, f1) {
        line(canvas, [s0, s1].map(|slow| point.pixel(slow, fast, floor)));
        line(canvas, [floor, top].map(|up| point.pixel(back_s, fast, up)));
        let place = point.outside(front_s, fast, floor, [0.07, 0.0]);
        canvas.text(&number, place, small);
    }
    for height in multiples(floor, top, step) {
        line(
            canvas,
            [s0, s1].map(|slow| point.pixel(slow, back_f, height)),
        );
        line(
            canvas,
            [f0, f1].map(|fast| point.pixel(back_s, fast, height)),
        );
        let (x, y) = point.pixel(front_s, back_f, height);
        canvas.text(&label(height), (x - 8.0, y), small.anchor(Anchor::End));
    }
    let (x, y) = point.pixel(front_s, back_f, top);
    let speed = format!("V_H, {}", caption.speed_unit);
    canvas.text(&speed, (x, y - 18.0), Font::new(13.0, palette::TEXT));
    // Titles begin, or end, beyond the numbers, however long they are.
    let title = Font::new(14.0, palette::TEXT);
    let place = point.outside(0.5 * (s0 + s1), front_f, floor, [0.0, 0.14]);
    canvas.text(
        &axis_title(&surface.axes[0]),
        place,
        title.anchor(Anchor::Start),
    );
    let place = point.outside(front_s, 0.5 * (f0 + f1), floor, [0.16, 0.0]);
    canvas.text(
        &axis_title(&surface.axes[1]),
        place,
        title.anchor(Anchor::End),
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::example;

    #[test]
    fn only_whole_cells_are_drawn() {
        let surface = example();
        let svg = draw(
            &surface,
            &Heights::of_surfaces([&surface], None),
            &Caption::default(),
        );
        assert!(svg.starts_with("<svg width=\"900\" height=\"700\""));
        let cells = surface.cells();
        let whole = cells.filter(|(_, cell)| matches!(cell, Cell::Whole(_)));
        let polygons = svg.lines().filter(|line| line.starts_with("<polygon"));
        let corners = |line: &&str| line.split('"').nth(1).unwrap_or("").matches(',').count();
        assert_eq!(
            polygons.filter(|line| corners(line) == 4).count(),
            whole.count()
        );
        assert!(svg.contains("Roll angle"));
        assert!(svg.contains("jumps by more than 5 ft/s"));
        // Triangles lie on the floor, which is no V_H of theirs.
        assert!(svg.contains("no transition; marked on the floor"));
    }
}
