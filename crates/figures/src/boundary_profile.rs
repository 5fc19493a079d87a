//! The stability profile: first transition velocity against one touchdown condition.

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::axis_title::axis_title;
use crate::boundary_table::{BoundaryTable, Kind, Transition};
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::legend::{Mark, draw_legend, draw_mark};
use crate::stations::{self, Station};

/// Width and height of the picture, pixels.
pub const SIZE: (u32, u32) = (900, 560);

/// More points than this would touch each other at the common size of marks.
const CROWD: usize = 70;

/// What the result table does not tell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Caption {
    /// Title of the picture.
    pub title: String,
    /// Fixed conditions, in a smaller second line.
    pub conditions: String,
    /// Highest speed searched, ft/s, if known: the upper end of the picture.
    pub searched_to: Option<f64>,
}

type Frame = Cartesian2d<RangedCoordf64, RangedCoordf64>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Frame>;
type Sheet<'b> = DrawingArea<SVGBackend<'b>, Shift>;

/// Draws the profile of a sweep over one axis as SVG.
///
/// # Errors
/// When the table is not one of a sweep over one axis.
pub fn draw(csv: &str, caption: &Caption) -> Result<String, FigureError> {
    let table = BoundaryTable::parse(csv)?;
    let [axis] = table.axes.as_slice() else {
        let axes = table.axes.join(", ");
        return Err(FigureError::Table(format!(
            "a profile has one axis, not {axes}"
        )));
    };
    let stations = stations::along(&table);
    let mut svg = String::new();
    let sheet = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    draw_sheet(sheet, axis, &stations, caption)?;
    Ok(svg)
}

fn draw_sheet(
    sheet: Sheet,
    axis: &str,
    stations: &[Station],
    caption: &Caption,
) -> Result<(), FigureError> {
    sheet.fill(&WHITE).map_err(drawing)?;
    let (head, rest) = sheet.split_vertically(64);
    let (body, foot) = rest.split_vertically(SIZE.1 - 64 - 34);
    draw_head(&head, caption)?;
    draw_body(&body, axis, stations, caption.searched_to)?;
    draw_legend(&foot, &legend(stations, caption.searched_to))?;
    sheet.present().map_err(drawing)
}

fn draw_head(head: &Sheet, caption: &Caption) -> Result<(), FigureError> {
    let middle = SIZE.0 as i32 / 2;
    let centred = Pos::new(HPos::Center, VPos::Center);
    let lines = [
        (&caption.title, 26, ink::text(18, ink::TEXT)),
        (&caption.conditions, 50, ink::text(12, ink::PALE_TEXT)),
    ];
    for (text, y, style) in lines {
        head.draw(&Text::new(text.clone(), (middle, y), style.pos(centred)))
            .map_err(drawing)?;
    }
    Ok(())
}

fn draw_body(
    body: &Sheet,
    axis: &str,
    stations: &[Station],
    searched_to: Option<f64>,
) -> Result<(), FigureError> {
    let (left, right) = stations::horizontal_range(stations);
    let (low, high) = stations::vertical_range(stations, searched_to);
    let mut chart = ChartBuilder::on(body)
        .margin_right(28)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(52)
        .y_label_area_size(62)
        .build_cartesian_2d(left..right, low..high)
        .map_err(drawing)?;
    shade(&mut chart, stations, high)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(ink::GRID)
        .axis_style(ink::TEXT)
        .x_labels(13)
        .y_labels(11)
        .x_label_formatter(&|x| label(*x))
        .y_label_formatter(&|y| label(*y))
        .label_style(ink::text(12, ink::TEXT))
        .axis_desc_style(ink::text(14, ink::TEXT))
        .x_desc(axis_title(axis))
        .y_desc(axis_title("horizontal_velocity_fps"))
        .draw()
        .map_err(drawing)?;
    draw_line(&mut chart, stations)?;
    draw_marks(body, &chart, stations, high)?;
    draw_words(body, &chart, stations, (low, high))
}

/// A number of an axis, with a true minus sign.
fn label(number: f64) -> String {
    let rounded = (number * 1e6).round() / 1e6 + 0.0;
    rounded.to_string().replace('-', "\u{2212}")
}

/// Shades what lies above the transitions, each half of a segment in the colour of its own point.
fn shade(chart: &mut Chart, stations: &[Station], high: f64) -> Result<(), FigureError> {
    for (start, end, from, to) in stations::segments(stations) {
        let middle = [0.5 * (start.x + end.x), 0.5 * (from.speed + to.speed)];
        let halves = if from.kind == to.kind {
            vec![(from.kind, [start.x, from.speed], [end.x, to.speed])]
        } else {
            vec![
                (from.kind, [start.x, from.speed], middle),
                (to.kind, middle, [end.x, to.speed]),
            ]
        };
        for (kind, [x0, y0], [x1, y1]) in halves {
            let corners = [(x0, y0), (x1, y1), (x1, high), (x0, high)];
            let region = Polygon::new(corners, ink::region(kind).filled());
            chart.draw_series([region]).map_err(drawing)?;
        }
    }
    // A transition between points without one has no region, but what begins there must show.
    for (index, station) in stations.iter().enumerate() {
        let neighbours = [index.wrapping_sub(1), index + 1];
        let has = |at: usize| {
            stations
                .get(at)
                .is_some_and(|near| near.transition.is_some())
        };
        if let Some(Transition { kind, speed, .. }) = station.transition
            && !neighbours.into_iter().any(has)
        {
            let line = vec![(station.x, speed), (station.x, high)];
            let style = ink::region(kind).stroke_width(4);
            chart
                .draw_series([PathElement::new(line, style)])
                .map_err(drawing)?;
        }
    }
    Ok(())
}

fn draw_line(chart: &mut Chart, stations: &[Station]) -> Result<(), FigureError> {
    let style = ink::LINE.stroke_width(2);
    let lines = stations::segments(stations).map(|(start, end, from, to)| {
        PathElement::new(vec![(start.x, from.speed), (end.x, to.speed)], style)
    });
    chart.draw_series(lines).map_err(drawing)?;
    let brackets = stations.iter().filter_map(|station| {
        let [low, high] = station.transition?.bracket;
        Some(PathElement::new(
            vec![(station.x, low), (station.x, high)],
            ink::LINE,
        ))
    });
    chart.draw_series(brackets).map_err(drawing)?;
    Ok(())
}

fn draw_marks(
    body: &Sheet,
    chart: &Chart,
    stations: &[Station],
    high: f64,
) -> Result<(), FigureError> {
    let side = if stations.len() > CROWD {
        ink::SMALL_MARK
    } else {
        ink::MARK
    };
    for station in stations {
        let (mark, speed) = match station.transition {
            Some(found) => (Mark::Transition(found.kind), found.speed),
            None => (Mark::NoTransition, high),
        };
        draw_mark(body, mark, on_sheet(body, chart, station.x, speed), side)?;
    }
    Ok(())
}

fn on_sheet(body: &Sheet, chart: &Chart, x: f64, y: f64) -> (i32, i32) {
    let (across, down) = chart.backend_coord(&(x, y));
    let (left, top) = body.get_base_pixel();
    (across - left, down - top)
}

/// Writes into each region what happens there, where it is broadest.
fn draw_words(
    body: &Sheet,
    chart: &Chart,
    stations: &[Station],
    (low, high): (f64, f64),
) -> Result<(), FigureError> {
    let centred = Pos::new(HPos::Center, VPos::Center);
    let write = |word: &str, x: f64, y: f64, colour: RGBColor| {
        let style = ink::text(16, colour).pos(centred);
        let place = on_sheet(body, chart, x, y);
        body.draw(&Text::new(word.to_owned(), place, style))
            .map_err(drawing)
    };
    for kind in [Kind::Unstable, Kind::Bottomed, Kind::Failure] {
        if let Some((x, speed)) = stations::broadest(stations, kind) {
            write(ink::word(kind), x, 0.5 * (speed + high), ink::mark(kind))?;
        }
    }
    let (first, last) = (stations.first(), stations.last());
    let middle = 0.5 * (first.map_or(0.0, |s| s.x) + last.map_or(0.0, |s| s.x));
    let least = stations
        .iter()
        .filter_map(|station| Some(station.transition?.speed))
        .fold(high, f64::min);
    write("stable", middle, 0.5 * (low + least), ink::NONE)
}

fn legend(stations: &[Station], searched_to: Option<f64>) -> Vec<(Mark, String)> {
    let meanings = [
        (Kind::Unstable, "first transition: topples"),
        (Kind::Bottomed, "first transition: a strut bottoms"),
        (Kind::Failure, "landing cannot be computed"),
    ];
    let mut entries: Vec<(Mark, String)> = meanings
        .into_iter()
        .filter(|(kind, _)| {
            let found = |station: &Station| station.transition.is_some_and(|t| t.kind == *kind);
            stations.iter().any(found)
        })
        .map(|(kind, meaning)| (Mark::Transition(kind), meaning.to_owned()))
        .collect();
    if stations.iter().any(|station| station.transition.is_none()) {
        let meaning = match searched_to {
            Some(speed) => format!("stable up to {speed} ft/s"),
            None => "no transition".to_owned(),
        };
        entries.push((Mark::NoTransition, meaning));
    }
    entries
}

#[cfg(test)]
#[path = "boundary_profile_tests.rs"]
mod tests;
