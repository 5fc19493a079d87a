//! The stability surface in perspective, in the manner of Figure 4-20.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::axis_title::axis_title;
use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::legend::{Mark, draw_legend, draw_mark};
use crate::number;
use crate::sheet::{self, Sheet};
use crate::surface::{Cell, JUMP, Surface};
use crate::view_point::ViewPoint;
use crate::{colour_bar, ink, levels};

/// Width and height of the picture, pixels.
pub const SIZE: (u32, u32) = (900, 700);
/// Width of the column for the colours, pixels.
const BAR: u32 = 92;
/// Distance between lines of equal height on the walls, ft/s.
const RUNG: f64 = 2.0;

/// Draws the surface as SVG: only cells whose corners all have a transition and between which the
/// boundary does not jump, so that gaps stay gaps.
///
/// # Errors
/// Only those of the drawing library.
pub fn draw(surface: &Surface, caption: &Caption) -> Result<String, FigureError> {
    let mut svg = String::new();
    let sheet = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    let (body, foot) = sheet::parts(&sheet, SIZE, caption)?;
    let (view, bar) = body.split_horizontally(SIZE.0 - BAR);
    if let Some((least, greatest)) = surface.range() {
        let heights = [
            RUNG * (least / RUNG).floor(),
            RUNG * (greatest / RUNG).ceil(),
        ];
        let point = ViewPoint::on(view.dim_in_pixel(), surface, heights);
        draw_box(&view, surface, &point, heights)?;
        draw_floor_marks(&view, surface, &point, heights[0])?;
        draw_cells(&view, surface, &point)?;
    }
    colour_bar::draw(&bar, surface)?;
    let entries = [
        (Mark::NoTransition, "no transition".to_owned()),
        (
            Mark::Jump,
            format!("open where it jumps by more than {JUMP} ft/s"),
        ),
    ];
    draw_legend(&foot, &entries)?;
    sheet.present().map_err(drawing)?;
    drop((view, bar, body, foot, sheet));
    Ok(sheet::with_subscripts(&svg))
}

/// Draws whole cells from back to front, so that what is in front hides what is behind.
fn draw_cells(view: &Sheet, surface: &Surface, point: &ViewPoint) -> Result<(), FigureError> {
    let (s, f) = (&surface.slow, &surface.fast);
    let mut cells: Vec<([usize; 2], [f64; 4])> = surface
        .cells()
        .filter_map(|(place, cell)| match cell {
            Cell::Whole(heights) => Some((place, heights)),
            Cell::Torn | Cell::Open => None,
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
        let colour = levels::colour(heights.iter().sum::<f64>() / 4.0);
        view.draw(&Polygon::new(corners, colour.filled()))
            .map_err(drawing)?;
        let outline = [corners[0], corners[1], corners[2], corners[3], corners[0]];
        view.draw(&PathElement::new(
            outline,
            ink::TEXT.mix(0.7).stroke_width(1),
        ))
        .map_err(drawing)?;
    }
    // The bars of jumps stand between the two heights.
    for [a, b] in surface.torn_edges() {
        let ends = vec![
            point.pixel(a.0[0], a.0[1], a.1),
            point.pixel(b.0[0], b.0[1], b.1),
        ];
        view.draw(&PathElement::new(ends, ink::JUMP.mix(0.6).stroke_width(1)))
            .map_err(drawing)?;
    }
    Ok(())
}

/// Marks points without a transition on the floor.
fn draw_floor_marks(
    view: &Sheet,
    surface: &Surface,
    point: &ViewPoint,
    floor: f64,
) -> Result<(), FigureError> {
    for (slow, row) in surface.slow.iter().zip(&surface.speeds) {
        for (fast, speed) in surface.fast.iter().zip(row) {
            if speed.is_none() {
                let place = point.pixel(*slow, *fast, floor);
                draw_mark(view, Mark::NoTransition, place, ink::SMALL_MARK)?;
            }
        }
    }
    Ok(())
}

/// Draws floor and back walls with their grid, and writes what runs along them.
fn draw_box(
    view: &Sheet,
    surface: &Surface,
    point: &ViewPoint,
    [floor, top]: [f64; 2],
) -> Result<(), FigureError> {
    let line = |ends: [(i32, i32); 2]| {
        view.draw(&PathElement::new(ends, ink::GRID.stroke_width(1)))
            .map_err(drawing)
    };
    let write = |text: String, place: (i32, i32), pos: Pos, size: u32| {
        let style = ink::text(size, ink::TEXT).pos(pos);
        view.draw(&Text::new(text, place, style)).map_err(drawing)
    };
    let ends = |values: &[f64]| [values[0], values[values.len() - 1]];
    let ([s0, s1], [f0, f1]) = (ends(&surface.slow), ends(&surface.fast));
    let ([back_s, front_s], [back_f, front_f]) = point.back_and_front([s0, s1], [f0, f1]);
    let beside = Pos::new(HPos::Center, VPos::Center);
    for slow in sheet::round_values(s0, s1) {
        line([point.pixel(slow, f0, floor), point.pixel(slow, f1, floor)])?;
        line([
            point.pixel(slow, back_f, floor),
            point.pixel(slow, back_f, top),
        ])?;
        let place = point.outside(slow, front_f, floor, [0.0, 0.05]);
        write(number::label(slow), place, beside, 12)?;
    }
    for fast in sheet::round_values(f0, f1) {
        line([point.pixel(s0, fast, floor), point.pixel(s1, fast, floor)])?;
        line([
            point.pixel(back_s, fast, floor),
            point.pixel(back_s, fast, top),
        ])?;
        let place = point.outside(front_s, fast, floor, [0.07, 0.0]);
        write(number::label(fast), place, beside, 12)?;
    }
    for rung in 0..=((top - floor) / RUNG).round() as usize {
        let height = floor + RUNG * rung as f64;
        line([
            point.pixel(s0, back_f, height),
            point.pixel(s1, back_f, height),
        ])?;
        line([
            point.pixel(back_s, f0, height),
            point.pixel(back_s, f1, height),
        ])?;
        let (x, y) = point.pixel(front_s, back_f, height);
        write(number::label(height), (x - 16, y), beside, 12)?;
    }
    let (x, y) = point.pixel(front_s, back_f, top);
    write("V_H, ft/s".to_owned(), (x, y - 18), beside, 13)?;
    // Titles begin, or end, beyond the numbers, however long they are.
    let [begins, ends] = [HPos::Left, HPos::Right].map(|side| Pos::new(side, VPos::Center));
    let place = point.outside(0.5 * (s0 + s1), front_f, floor, [0.0, 0.14]);
    write(axis_title(&surface.axes[0]), place, begins, 14)?;
    let place = point.outside(front_s, 0.5 * (f0 + f1), floor, [0.16, 0.0]);
    write(axis_title(&surface.axes[1]), place, ends, 14)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::example;

    #[test]
    fn only_whole_cells_are_drawn() {
        let svg = draw(&example(), &Caption::default()).unwrap();
        assert!(svg.starts_with("<svg width=\"900\" height=\"700\""));
        let whole = example()
            .cells()
            .filter(|(_, cell)| matches!(cell, Cell::Whole(_)))
            .count();
        let quadrilaterals = svg.lines().filter(|line| {
            line.starts_with("<polygon")
                && line
                    .split("points=\"")
                    .nth(1)
                    .unwrap_or("")
                    .matches(',')
                    .count()
                    == 4
        });
        assert_eq!(quadrilaterals.count(), whole);
        assert!(svg.contains("Roll angle"));
    }
}
