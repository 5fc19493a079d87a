//! The tornado chart: what a change of each parameter does to the transition velocity.
//!
//! Bars belong to the point with the lowest transition, the parameter that does most on top: dark where
//! the parameter grows, pale where it falls. Rings are the other points of the sweep, for a parameter
//! that grows.

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::mesh::{self, Along};
use crate::number::label;
use crate::sensitivity_table::{Change, Point, SensitivityTable, Slope};
use crate::sheet::{self, Sheet};
use crate::tornado_words::{name, said, title};

/// Width of the picture, and heights of its frame and of a bar's row, pixels.
const WIDTH: u32 = 900;
const FRAME: u32 = 170;
const ROW: u32 = 28;
/// Width of the names on the left, pixels.
const NAMES: u32 = 330;
/// Part of a row that its bar fills.
const FILLED: f64 = 0.6;
/// Where nothing changes anything, the axis reaches so far to either side, ft/s.
const LEAST_EXTENT: f64 = 1e-3;
/// A parameter that grows, and one that falls; they differ in grey.
const GROWS: RGBColor = RGBColor(0, 90, 160);
const FALLS: RGBColor = RGBColor(206, 223, 240);

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Draws the chart as SVG.
///
/// # Errors
/// When no point of the table has a derivative.
pub fn draw(table: &SensitivityTable, caption: &Caption) -> Result<String, FigureError> {
    let Some(lowest) = table.lowest() else {
        return Err(FigureError::Table(
            "no point has a derivative to be drawn".to_owned(),
        ));
    };
    let rows = rows(table, lowest);
    let size = (WIDTH, FRAME + ROW * rows.len() as u32);
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    draw_sheet(area, size, table, &table.points[lowest], &rows, caption)?;
    Ok(sheet::with_subscripts(&svg))
}

/// A parameter: its dependence at the lowest point, and its changes at the others, ft/s.
struct Row<'t> {
    slope: &'t Slope,
    others: Vec<f64>,
}

/// The parameters, that which does most first, those without a derivative last.
fn rows(table: &SensitivityTable, lowest: usize) -> Vec<Row<'_>> {
    let others = |parameter: usize| {
        let points = table.points.iter().enumerate();
        let others = points.filter(|(index, _)| *index != lowest);
        let changes = others.filter_map(|(_, point)| point.slopes[parameter].change);
        changes.map(|change| change.speed).collect()
    };
    let slopes = table.points[lowest].slopes.iter().enumerate();
    let mut rows: Vec<Row> = slopes
        .map(|(index, slope)| Row {
            slope,
            others: others(index),
        })
        .collect();
    let size = |row: &Row| row.slope.change.map_or(-1.0, |change| change.speed.abs());
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    rows
}

fn draw_sheet(
    sheet: Sheet,
    size: (u32, u32),
    table: &SensitivityTable,
    lowest: &Point,
    rows: &[Row],
    caption: &Caption,
) -> Result<(), FigureError> {
    let (body, foot) = sheet::parts(&sheet, size, caption)?;
    let reach = reach(rows);
    let count = rows.len() as f64;
    let mut chart = ChartBuilder::on(&body)
        .margin_right(28)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(52)
        .y_label_area_size(NAMES)
        .build_cartesian_2d(-reach..reach, 0.0..count)
        .map_err(drawing)?;
    let across = Along {
        title: &title(lowest),
        count: 11,
        label: &|x| label(*x),
    };
    let up = Along {
        title: "",
        count: 0,
        label: &|_| String::new(),
    };
    mesh::draw(&mut chart, ink::GRID, &across, &up)?;
    for (index, row) in rows.iter().enumerate() {
        let middle = count - 0.5 - index as f64;
        draw_row(&mut chart, row, middle)?;
        let place = place(&body, &chart, (-reach, middle));
        let right = Pos::new(HPos::Right, VPos::Center);
        let style = ink::text(12, ink::TEXT).pos(right);
        let name = Text::new(name(row.slope), (place.0 - 9, place.1), style);
        body.draw(&name).map_err(drawing)?;
    }
    let zero = PathElement::new([(0.0, 0.0), (0.0, count)], ink::TEXT);
    chart.draw_series([zero]).map_err(drawing)?;
    for (index, row) in rows.iter().enumerate() {
        if row.slope.change.is_none() {
            let middle = count - 0.5 - index as f64;
            let (x, y) = place(&body, &chart, (0.0, middle));
            let style = ink::text(12, ink::STATEMENT).pos(Pos::new(HPos::Left, VPos::Center));
            let said = Text::new(said(row.slope), (x + 8, y), style);
            body.draw(&said).map_err(drawing)?;
        }
    }
    draw_legend(&foot, table.points.len() - 1)?;
    sheet.present().map_err(drawing)
}

/// How far the axis reaches to either side, ft/s.
fn reach(rows: &[Row]) -> f64 {
    let of_row = |row: &Row| {
        let bar = row.slope.change.map_or(0.0, |c| c.speed.abs() + c.error);
        row.others
            .iter()
            .fold(bar, |most, other| most.max(other.abs()))
    };
    1.05 * rows.iter().map(of_row).fold(LEAST_EXTENT, f64::max)
}

fn place(body: &Sheet, chart: &Chart, point: (f64, f64)) -> (i32, i32) {
    let (across, down) = chart.backend_coord(&point);
    let (left, top) = body.get_base_pixel();
    (across - left, down - top)
}

/// Bars, whiskers and rings of a row.
fn draw_row(chart: &mut Chart, row: &Row, middle: f64) -> Result<(), FigureError> {
    let half = 0.5 * FILLED;
    if let Some(Change { speed, error, .. }) = row.slope.change {
        for (end, colour) in [(-speed, FALLS), (speed, GROWS)] {
            let corners = [(0.0, middle + half), (end, middle - half)];
            let outline = Rectangle::new(corners, GROWS.stroke_width(1));
            let bar = Rectangle::new(corners, colour.filled());
            chart.draw_series([bar, outline]).map_err(drawing)?;
            let whisker = [(end - error, middle), (end + error, middle)];
            let whisker = PathElement::new(whisker, ink::TEXT.stroke_width(2));
            chart.draw_series([whisker]).map_err(drawing)?;
        }
    }
    let discs = row.others.iter();
    let discs = discs.map(|x| Circle::new((*x, middle), ink::SMALL_MARK, WHITE.filled()));
    chart.draw_series(discs).map_err(drawing)?;
    let rings = row.others.iter();
    let rings = rings.map(|x| Circle::new((*x, middle), ink::SMALL_MARK, ink::VALLEY));
    chart.draw_series(rings).map_err(drawing)?;
    Ok(())
}

/// What bars, whiskers and rings mean, in one centred line.
fn draw_legend(foot: &Sheet, others: usize) -> Result<(), FigureError> {
    const GAP: i32 = 30;
    const SWATCH: i32 = 20;
    let mut words = vec!["parameter grows", "parameter falls", "estimated error"];
    let rings = format!("grows, at {others} other points");
    if others > 0 {
        words.push(&rings);
    }
    // There is no font to measure texts with.
    let width = |text: &str| SWATCH + 6 + (text.chars().count() as f64 * 6.6) as i32;
    let used = words.iter().map(|text| width(text)).sum::<i32>() + GAP * (words.len() as i32 - 1);
    let mut x = (foot.dim_in_pixel().0 as i32 - used) / 2;
    for (index, text) in words.iter().enumerate() {
        let corners = [(x, 6), (x + SWATCH, 18)];
        let fill = if index == 0 { GROWS } else { FALLS };
        match index {
            0 | 1 => {
                foot.draw(&Rectangle::new(corners, fill.filled()))
                    .map_err(drawing)?;
                foot.draw(&Rectangle::new(corners, GROWS.stroke_width(1)))
                    .map_err(drawing)?;
            }
            2 => {
                let line = [(x, 12), (x + SWATCH, 12)];
                foot.draw(&PathElement::new(line, ink::TEXT.stroke_width(2)))
                    .map_err(drawing)?;
            }
            _ => {
                let ring = Circle::new((x + SWATCH - 6, 12), ink::SMALL_MARK, ink::VALLEY);
                foot.draw(&ring).map_err(drawing)?;
            }
        }
        let text_place = (x + SWATCH + 6, 7);
        let style = ink::text(12, ink::TEXT);
        foot.draw(&Text::new((*text).to_owned(), text_place, style))
            .map_err(drawing)?;
        x += width(text) + GAP;
    }
    Ok(())
}

#[cfg(test)]
#[path = "tornado_chart_tests.rs"]
mod tests;
