//! The contour map of a stability surface, in the manner of Figure 4-21.

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::axis_title::axis_title;
use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::isolines::{self, Place};
use crate::legend::{Mark, draw_legend, draw_mark};
use crate::levels::{self, LEVELS};
use crate::map_view::View;
use crate::mesh::{self, Along};
use crate::number;
use crate::sheet::{self, Sheet};
use crate::surface::{Cell, JUMP, Surface};
use crate::{colour_bar, ink, leading_feet};

/// Width and height of the picture, pixels.
pub const SIZE: (u32, u32) = (900, 860);
/// Width of the column for the colours, pixels.
const BAR: u32 = 92;
/// Shortest line that carries a label, and least distance between labels, pixels.
const LABELLED: f64 = 70.0;
const APART: i32 = 46;
/// Width of a label, and distance of its middle from a disc that it must not cover, pixels.
const LABEL_WIDTH: i32 = 28;
const CLEAR: f64 = 18.0;

type Frame = Cartesian2d<RangedCoordf64, RangedCoordf64>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Frame>;

/// Draws the map as SVG.
///
/// # Errors
/// Only those of the drawing library.
pub fn draw(surface: &Surface, view: &View, caption: &Caption) -> Result<String, FigureError> {
    let mut svg = String::new();
    let sheet = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    let (body, foot) = sheet::parts(&sheet, SIZE, caption)?;
    let (map, bar) = body.split_horizontally(SIZE.0 - BAR);
    draw_map(&map, surface, view)?;
    colour_bar::draw(&bar, surface)?;
    draw_legend(&foot, &legend(surface, view))?;
    sheet.present().map_err(drawing)?;
    drop((map, bar, body, foot, sheet));
    // Polygons side by side must not let the paper shine through between them.
    Ok(sheet::with_subscripts(&svg)
        .replace("<polygon ", "<polygon shape-rendering=\"crispEdges\" "))
}

fn draw_map(map: &Sheet, surface: &Surface, view: &View) -> Result<(), FigureError> {
    let [across, up] = view.ranges(surface);
    let mut chart = ChartBuilder::on(map)
        .margin_right(16)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(52)
        .y_label_area_size(62)
        .build_cartesian_2d(across, up)
        .map_err(drawing)?;
    fill(&mut chart, surface, view)?;
    mesh::draw(
        &mut chart,
        ink::TEXT.mix(0.12),
        &Along {
            title: &axis_title(&surface.axes[1]),
            count: 13,
            label: &|x| view.fast_label(*x),
        },
        &Along {
            title: &axis_title(&surface.axes[0]),
            count: 11,
            label: &|y| view.slow_label(*y),
        },
    )?;
    draw_jumps(&mut chart, surface, view)?;
    draw_isolines(map, &mut chart, surface, view)?;
    draw_loci(&mut chart, surface, view)?;
    draw_gaps(map, &chart, surface, view)
}

fn fill(chart: &mut Chart, surface: &Surface, view: &View) -> Result<(), FigureError> {
    let mut polygon = |corners: Vec<Place>, colour: RGBColor| {
        let corners: Vec<(f64, f64)> = corners.into_iter().map(|place| view.at(place)).collect();
        let shape = Polygon::new(corners, colour.filled());
        chart.draw_series([shape]).map(|_| ()).map_err(drawing)
    };
    for ([row, column], cell) in surface.cells() {
        if cell == Cell::Torn {
            let (s, f) = (&surface.slow, &surface.fast);
            let corners = [
                (row, column),
                (row, column + 1),
                (row + 1, column + 1),
                (row + 1, column),
            ];
            polygon(corners.map(|(r, c)| [s[r], f[c]]).to_vec(), ink::TORN)?;
        }
    }
    let ends = [[0.0, LEVELS[0]], [LEVELS[LEVELS.len() - 1], f64::MAX]];
    let between = LEVELS.windows(2).map(|pair| [pair[0], pair[1]]);
    for [low, high] in between.chain(ends) {
        for corners in isolines::band(surface, low, high) {
            polygon(corners, levels::colour(low))?;
        }
    }
    Ok(())
}

/// Draws a bar across every edge of the grid over which the boundary jumps.
fn draw_jumps(chart: &mut Chart, surface: &Surface, view: &View) -> Result<(), FigureError> {
    let bars = surface.jumps().into_iter().map(|ends| {
        PathElement::new(
            ends.map(|place| view.at(place)).to_vec(),
            ink::JUMP.stroke_width(3),
        )
    });
    chart.draw_series(bars).map_err(drawing)?;
    Ok(())
}

fn draw_isolines(
    map: &Sheet,
    chart: &mut Chart,
    surface: &Surface,
    view: &View,
) -> Result<(), FigureError> {
    let mut labels: Vec<((i32, i32), f64)> = Vec::new();
    let pixel = |place| on_sheet(map, chart, place);
    let valley: Vec<(i32, i32)> = surface
        .valley()
        .into_iter()
        .map(|place| pixel(view.at(place)))
        .collect();
    let [across, up] = view.ranges(surface);
    let (left, right) = (
        pixel((across.start, up.start)).0,
        pixel((across.end, up.start)).0,
    );
    for level in LEVELS {
        for line in isolines::lines(surface, level) {
            let places: Vec<(f64, f64)> = line.into_iter().map(|place| view.at(place)).collect();
            let pixels: Vec<(i32, i32)> = places
                .iter()
                .map(|place| on_sheet(map, chart, *place))
                .collect();
            let length: f64 = pixels
                .windows(2)
                .map(|pair| distance(pair[0], pair[1]))
                .sum();
            let width = if level.fract() == 0.0 { 2 } else { 1 };
            let element = PathElement::new(places, ink::TEXT.stroke_width(width));
            chart.draw_series([element]).map_err(drawing)?;
            // The middle, or else what is nearest to it and free.
            let mut order: Vec<usize> = (0..pixels.len()).collect();
            order.sort_by_key(|index| index.abs_diff(pixels.len() / 2));
            let free = order.into_iter().map(|index| pixels[index]).find(|place| {
                let is_apart =
                    |(other, _): &((i32, i32), f64)| distance(*place, *other) > f64::from(APART);
                let is_clear = |disc: &(i32, i32)| distance(*place, *disc) > CLEAR;
                labels.iter().all(is_apart)
                    && valley.iter().all(is_clear)
                    && place.0 - left > LABEL_WIDTH / 2
                    && right - place.0 > LABEL_WIDTH / 2
            });
            if let Some(place) = free
                && length > LABELLED
            {
                labels.push((place, level));
            }
        }
    }
    let centred = Pos::new(HPos::Center, VPos::Center);
    for ((x, y), level) in labels {
        let paper = Rectangle::new(
            [(x - LABEL_WIDTH / 2, y - 8), (x + LABEL_WIDTH / 2, y + 7)],
            WHITE.mix(0.85).filled(),
        );
        map.draw(&paper).map_err(drawing)?;
        let style = ink::text(11, ink::TEXT).pos(centred);
        map.draw(&Text::new(number::label(level), (x, y), style))
            .map_err(drawing)?;
    }
    Ok(())
}

fn draw_loci(chart: &mut Chart, surface: &Surface, view: &View) -> Result<(), FigureError> {
    if view.has_leading_feet(surface) {
        for line in leading_feet::lines(&surface.slow, &surface.fast) {
            let places = line.into_iter().map(|place| view.at(place));
            let dashes = DashedLineSeries::new(places, 9, 6, ink::BISECTOR.stroke_width(2));
            chart.draw_series(dashes).map_err(drawing)?;
        }
    }
    let valley: Vec<(f64, f64)> = surface
        .valley()
        .into_iter()
        .map(|place| view.at(place))
        .collect();
    let circles = valley
        .iter()
        .map(|place| Circle::new(*place, 4, ink::VALLEY.filled()));
    chart.draw_series(circles).map_err(drawing)?;
    Ok(())
}

fn draw_gaps(
    map: &Sheet,
    chart: &Chart,
    surface: &Surface,
    view: &View,
) -> Result<(), FigureError> {
    for (slow, row) in surface.slow.iter().zip(&surface.speeds) {
        for (fast, speed) in surface.fast.iter().zip(row) {
            if speed.is_none() {
                let place = on_sheet(map, chart, view.at([*slow, *fast]));
                draw_mark(map, Mark::NoTransition, place, ink::SMALL_MARK)?;
            }
        }
    }
    Ok(())
}

fn on_sheet(map: &Sheet, chart: &Chart, place: (f64, f64)) -> (i32, i32) {
    let (across, down) = chart.backend_coord(&place);
    let (left, top) = map.get_base_pixel();
    (across - left, down - top)
}

fn distance(a: (i32, i32), b: (i32, i32)) -> f64 {
    f64::from(a.0 - b.0).hypot(f64::from(a.1 - b.1))
}

fn legend(surface: &Surface, view: &View) -> Vec<(Mark, String)> {
    let mut entries = vec![(
        Mark::Valley,
        format!("least of each {}", view.slow_word(surface)),
    )];
    if view.has_leading_feet(surface) {
        entries.push((Mark::Bisector, "AB: V_H bisects leading feet".to_owned()));
    }
    entries.push((Mark::Jump, format!("jumps by more than {JUMP} ft/s")));
    entries.push((Mark::NoTransition, "no transition".to_owned()));
    entries
}

#[cfg(test)]
#[path = "contour_map_tests.rs"]
mod tests;
