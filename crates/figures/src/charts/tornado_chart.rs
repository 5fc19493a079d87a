//! The tornado chart: effect of a change of each parameter on the transition velocity.
//!
//! Bars belong to the point with the lowest transition, with the most effective parameter on top: dark where the
//! parameter grows, pale where it falls. Their ends follow from the derivative, with its estimated error, or from
//! searches where there is none. Rings are the other points of the sweep, for a growing parameter.

use crate::canvas::Canvas;
use crate::caption::Caption;
use crate::frame::{Frame, Scale};
use crate::legend::{Entry, Mark};
use crate::palette;
use crate::sensitivity_table::{Change, SensitivityTable, Slope};
use crate::sheet::{self, Height, Sheet};
use crate::style::{Colour, Style, WHITE};
use crate::text::{Anchor, Font};
use crate::ticks::round_values;
use crate::tornado_words::{name, reason, title};
use crate::words::FigureError;

/// Width of the picture, and heights of its axis and of a bar's row, pixels.
const WIDTH: f64 = 900.0;
const AXIS: f64 = 60.0;
const ROW: f64 = 28.0;
/// Width of the names on the left, pixels.
const NAMES: f64 = 344.0;
/// Part of a row that its bar fills.
const FILLED: f64 = 0.6;
/// Least extent of the axis to either side, if nothing has an effect.
const LEAST_EXTENT: f64 = 1e-3;
/// Colours of a parameter that grows, and of one that falls; they differ in grey.
const GROWS: Colour = Colour(0, 90, 160);
const FALLS: Colour = Colour(206, 223, 240);

/// Draws the chart as SVG.
///
/// # Errors
/// When no point of the table has a known change.
pub fn draw(table: &SensitivityTable, caption: &Caption) -> Result<String, FigureError> {
    let Some(lowest) = table.lowest() else {
        return Err(FigureError::Table(
            "no point has a change to be drawn".to_owned(),
        ));
    };
    let rows = rows(table, lowest);
    let height = Height::Body(AXIS + ROW * rows.len() as f64);
    let entries = legend(table.points.len() - 1);
    let Sheet { mut canvas, body } = sheet::begin(WIDTH, height, caption, &entries);
    let reach = reach(&rows);
    let count = rows.len() as f64;
    let title = title(&table.points[lowest], caption.speed_unit);
    let across = Scale::new(title, (-reach, reach), round_values(-reach, reach, 11));
    let up = Scale::new("", (0.0, count), Vec::new());
    let frame = Frame::with_left(body, NAMES, across, up);
    frame.draw(&mut canvas, Style::stroke(palette::GRID, 1.0));
    let font = Font::new(12.0, palette::TEXT).anchor(Anchor::End);
    let middle = |index: usize| count - 0.5 - index as f64;
    for (index, row) in rows.iter().enumerate() {
        draw_row(&mut canvas, &frame, row, middle(index));
        let (x, y) = frame.place((-reach, middle(index)));
        canvas.text(&name(row.slope), (x - 9.0, y), font);
    }
    let zero = frame.places([(0.0, 0.0), (0.0, count)]);
    canvas.curve(&zero, Style::stroke(palette::TEXT, 1.0));
    for (index, row) in rows.iter().enumerate() {
        if row.slope.change.is_none_or(|change| change.error.is_none()) {
            draw_reason(&mut canvas, &frame, row.slope, middle(index));
        }
    }
    Ok(canvas.into_svg())
}

/// A parameter: its dependence at the lowest point, and its changes at the others.
struct Row<'t> {
    slope: &'t Slope,
    others: Vec<f64>,
}

/// The parameters, the most effective first, those without a known change last.
fn rows(table: &SensitivityTable, lowest: usize) -> Vec<Row<'_>> {
    let others = |parameter: usize| {
        let points = table.points.iter().enumerate();
        let others = points.filter(|(index, _)| *index != lowest);
        let changes = others.filter_map(|(_, point)| point.slopes[parameter].change);
        changes.filter_map(|change| change.grows).collect()
    };
    let slopes = table.points[lowest].slopes.iter().enumerate();
    let mut rows: Vec<Row> = slopes
        .map(|(index, slope)| Row {
            slope,
            others: others(index),
        })
        .collect();
    let size = |row: &Row| row.slope.change.map_or(-1.0, |change| change.size());
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    rows
}

/// Extent of the axis to either side.
fn reach(rows: &[Row]) -> f64 {
    let of_row = |row: &Row| {
        let bar = (row.slope.change).map_or(0.0, |c| c.size() + c.error.unwrap_or(0.0));
        row.others
            .iter()
            .fold(bar, |most, other| most.max(other.abs()))
    };
    1.05 * rows.iter().map(of_row).fold(LEAST_EXTENT, f64::max)
}

/// Bars, whiskers and rings of a row.
fn draw_row(canvas: &mut Canvas, frame: &Frame, row: &Row, middle: f64) {
    let half = 0.5 * FILLED;
    if let Some(Change {
        falls,
        grows,
        error,
        ..
    }) = row.slope.change
    {
        for (end, colour) in [(falls, FALLS), (grows, GROWS)] {
            let Some(end) = end else { continue };
            let [from, to] = [(0.0, middle + half), (end, middle - half)];
            let style = Style::fill(colour).outlined(GROWS, 1.0);
            canvas.rectangle(frame.place(from), frame.place(to), style);
            if let Some(error) = error {
                let whisker = frame.places([(end - error, middle), (end + error, middle)]);
                canvas.curve(&whisker, Style::stroke(palette::TEXT, 2.0));
            }
        }
    }
    for x in &row.others {
        let style = Style::fill(WHITE).outlined(palette::LOWEST, 1.0);
        canvas.circle(frame.place((*x, middle)), palette::SMALL_MARK, style);
    }
}

/// Writes why a parameter has no derivative: beside its bars, on the side with more room.
fn draw_reason(canvas: &mut Canvas, frame: &Frame, slope: &Slope, middle: f64) {
    let ends = slope.change.map_or([None; 2], |one| [one.falls, one.grows]);
    let ends = ends.map(|end| end.unwrap_or(0.0));
    let [left, right] = [ends[0].min(ends[1]).min(0.0), ends[0].max(ends[1]).max(0.0)];
    let (end, anchor, gap) = match right <= -left {
        true => (right, Anchor::Start, 8.0),
        false => (left, Anchor::End, -8.0),
    };
    let (x, y) = frame.place((end, middle));
    let font = Font::new(12.0, palette::STATEMENT).anchor(anchor);
    canvas.text(&reason(slope), (x + gap, y), font);
}

/// Legend of bars, whiskers and rings.
fn legend(others: usize) -> Vec<Entry> {
    let bar = |fill| Mark::Area(Style::fill(fill).outlined(GROWS, 1.0));
    let whisker = Mark::Line(Style::stroke(palette::TEXT, 2.0));
    let mut entries = vec![
        (bar(GROWS), "parameter grows".to_owned()),
        (bar(FALLS), "parameter falls".to_owned()),
        (whisker, "estimated error".to_owned()),
    ];
    if others > 0 {
        let points = if others == 1 { "point" } else { "points" };
        let words = format!("grows, at {others} other {points}");
        entries.push((Mark::Ring(palette::LOWEST), words));
    }
    entries
}

#[cfg(test)]
#[path = "tornado_chart_tests.rs"]
mod tests;
