//! The stability profile: first transition velocity against one touchdown condition.

use crate::axis_title::axis_title;
use crate::bands_table::BandsTable;
use crate::boundary_table::{BoundaryTable, Kind, Transition};
use crate::canvas::{Canvas, Colour, Font, Style};
use crate::caption::Caption;
use crate::figure_error::FigureError;
use crate::frame::{Area, Frame, Scale};
use crate::legend::{Mark, draw_mark};
use crate::number::label;
use crate::sheet::{self, Height, Sheet};
use crate::stations::{self, Station};
use crate::{ink, shading, ticks};

/// Width and height of the picture, pixels.
pub const SIZE: (f64, f64) = (900.0, 560.0);

/// More points than this would touch each other at the common size of marks.
const CROWD: usize = 70;

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
    let entries = legend(&stations, caption.searched_to);
    let (width, height) = SIZE;
    let Sheet { mut canvas, body } = sheet::begin(width, Height::Whole(height), caption, &entries);
    draw_body(&mut canvas, body, axis, &stations, caption.searched_to);
    Ok(canvas.into_svg())
}

fn draw_body(
    canvas: &mut Canvas,
    body: Area,
    axis: &str,
    stations: &[Station],
    searched_to: Option<f64>,
) {
    let across = stations::horizontal_range(stations);
    let (low, high) = stations::vertical_range(stations, searched_to);
    let scale = |column: &str, (from, to): (f64, f64), count| Scale {
        title: axis_title(column),
        ends: (from, to),
        ticks: ticks::of_condition(column, from, to, count)
            .into_iter()
            .map(|value| (value, label(value)))
            .collect(),
    };
    let speeds = scale("horizontal_velocity_fps", (low, high), 11);
    let frame = Frame::new(body, scale(axis, across, 13), speeds);
    // Regions in which landings are not stable.
    let regions = shading::regions(stations, high);
    for kind in Kind::ALL {
        let same = regions.iter().filter(|region| region.kind == kind);
        let same: Vec<_> = same.map(|region| frame.places(region.corners)).collect();
        canvas.areas(&same, ink::region(kind));
    }
    frame.draw(canvas, Style::stroke(ink::GRID, 1.0));
    draw_line(canvas, &frame, stations);
    draw_marks(canvas, &frame, stations, high);
    draw_words(canvas, &frame, stations, (low, high));
}

/// Joins the transitions of neighbours, and draws the bracket of each.
fn draw_line(canvas: &mut Canvas, frame: &Frame, stations: &[Station]) {
    for (start, end, from, to) in stations::segments(stations) {
        let ends = frame.places([(start.x, from.speed), (end.x, to.speed)]);
        canvas.curve(&ends, Style::stroke(ink::LINE, 2.0));
    }
    for station in stations {
        if let Some(found) = station.transition
            && let Some(low) = found.low
        {
            let ends = frame.places([(station.x, low), (station.x, found.high)]);
            canvas.curve(&ends, Style::stroke(ink::LINE, 1.0));
        }
    }
}

fn draw_marks(canvas: &mut Canvas, frame: &Frame, stations: &[Station], high: f64) {
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
        draw_mark(canvas, mark, frame.place((station.x, speed)), side);
    }
}

/// Writes into each region what happens there, where it is broadest.
fn draw_words(canvas: &mut Canvas, frame: &Frame, stations: &[Station], (low, high): (f64, f64)) {
    let mut write = |word: &str, x: f64, y: f64, colour: Colour| {
        canvas.text(word, frame.place((x, y)), Font::new(16.0, colour));
    };
    for kind in Kind::ALL {
        if let Some((x, speed)) = shading::broadest(stations, kind, high) {
            write(ink::word(kind), x, speed, ink::mark(kind));
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
        write("stable", middle, 0.5 * (low + least), ink::NONE);
    }
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
    entries.extend(wordless.map(|kind| {
        let region = Mark::Area(Style::fill(ink::region(kind)));
        (region, ink::word(kind).to_owned())
    }));
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
