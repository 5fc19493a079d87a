//! The stability profile: first transition velocity against one touchdown condition.

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::axis_range::AxisRange;
use crate::axis_title::axis_title;
use crate::bands_table::BandsTable;
use crate::boundary_table::{BoundaryTable, Kind, Transition};
use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::legend::{Mark, draw_legend, draw_mark};
use crate::mesh::{self, Along};
use crate::number::label;
use crate::shading;
use crate::sheet::{self, Sheet};
use crate::stations::{self, Station};

/// Width and height of the picture, pixels.
pub const SIZE: (u32, u32) = (900, 560);

/// More points than this would touch each other at the common size of marks.
const CROWD: usize = 70;

type Frame = Cartesian2d<AxisRange, RangedCoordf64>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Frame>;

/// Draws the profile of a sweep over one axis as SVG, its regions from the table of `bands` where
/// there is one.
///
/// # Errors
/// When the table is not one of a sweep over one axis.
pub fn draw(
    table: &BoundaryTable,
    bands: Option<&BandsTable>,
    caption: &Caption,
) -> Result<String, FigureError> {
    let [axis] = table.axes.as_slice() else {
        let axes = table.axes.join(", ");
        return Err(FigureError::Table(format!(
            "a profile has one axis, not {axes}"
        )));
    };
    let stations = stations::along(table, bands);
    let mut svg = String::new();
    let sheet = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    draw_sheet(sheet, axis, &stations, caption)?;
    Ok(sheet::with_subscripts(&svg))
}

fn draw_sheet(
    sheet: Sheet,
    axis: &str,
    stations: &[Station],
    caption: &Caption,
) -> Result<(), FigureError> {
    let (body, foot) = sheet::parts(&sheet, SIZE, caption)?;
    draw_body(&body, axis, stations, caption.searched_to)?;
    draw_legend(&foot, &legend(stations, caption.searched_to))?;
    sheet.present().map_err(drawing)
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
        .build_cartesian_2d(AxisRange::of(axis, left, right), low..high)
        .map_err(drawing)?;
    shade(&mut chart, stations, high)?;
    mesh::draw(
        &mut chart,
        ink::GRID,
        &Along {
            title: &axis_title(axis),
            count: 13,
            label: &|x| label(*x),
        },
        &Along {
            title: &axis_title("horizontal_velocity_fps"),
            count: 11,
            label: &|y| label(*y),
        },
    )?;
    draw_line(&mut chart, stations)?;
    draw_marks(body, &chart, stations, high)?;
    draw_words(body, &chart, stations, (low, high))
}

/// Shades the regions in which landings are not stable.
fn shade(chart: &mut Chart, stations: &[Station], high: f64) -> Result<(), FigureError> {
    for region in shading::regions(stations, high) {
        let shape = Polygon::new(region.corners, ink::region(region.kind).filled());
        chart.draw_series([shape]).map_err(drawing)?;
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
        let found = station.transition?;
        Some(PathElement::new(
            vec![(station.x, found.low?), (station.x, found.high)],
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
            Some(found) if found.low.is_none() => (Mark::AtOrBelow(found.kind), found.speed),
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
    for kind in Kind::ALL {
        if let Some((x, speed)) = shading::broadest(stations, kind, high) {
            write(ink::word(kind), x, speed, ink::mark(kind))?;
        }
    }
    let (first, last) = (stations.first(), stations.last());
    let middle = 0.5 * (first.map_or(0.0, |s| s.x) + last.map_or(0.0, |s| s.x));
    let least = stations
        .iter()
        .filter_map(|station| Some(station.transition?.speed))
        .fold(high, f64::min);
    // Below the lowest speed searched nothing was computed.
    let is_stable_below = |station: &Station| station.transition.is_none_or(|t| t.low.is_some());
    if stations.iter().all(is_stable_below) {
        write("stable", middle, 0.5 * (low + least), ink::NONE)?;
    }
    Ok(())
}

fn legend(stations: &[Station], searched_to: Option<f64>) -> Vec<(Mark, String)> {
    let meanings = [
        (Kind::Unstable, "first transition: topples"),
        (Kind::Bottomed, "first transition: a strut bottoms"),
        (Kind::Failure, "landing cannot be computed"),
        (Kind::Undecided, "undecided at the time limit"),
    ];
    let mut entries: Vec<(Mark, String)> = meanings
        .into_iter()
        .filter(|(kind, _)| {
            let found = |station: &Station| {
                (station.transition).is_some_and(|t| t.kind == *kind && t.low.is_some())
            };
            stations.iter().any(found)
        })
        .map(|(kind, meaning)| (Mark::Transition(kind), meaning.to_owned()))
        .collect();
    let open = Kind::ALL.into_iter().filter(|kind| {
        let is_open = |t: Transition| t.kind == *kind && t.low.is_none();
        (stations.iter()).any(|station| station.transition.is_some_and(is_open))
    });
    entries.extend(open.map(|kind| {
        let meaning = format!("{}, at or below the lowest speed searched", ink::word(kind));
        (Mark::AtOrBelow(kind), meaning)
    }));
    let high = stations::vertical_range(stations, searched_to).1;
    let regions = shading::regions(stations, high);
    // Regions too narrow for their word.
    let wordless = Kind::ALL.into_iter().filter(|kind| {
        regions.iter().any(|region| region.kind == *kind)
            && shading::broadest(stations, *kind, high).is_none()
    });
    entries.extend(wordless.map(|kind| (Mark::Region(kind), ink::word(kind).to_owned())));
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
