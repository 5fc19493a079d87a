//! The stability profile: first transition velocity against one touchdown condition.

use crate::bands_table::BandsTable;
use crate::boundary_table::{BoundaryTable, Kind, Transition};
use crate::canvas::Canvas;
use crate::caption::Caption;
use crate::division::Division;
use crate::frame::{Area, Frame, Scale};
use crate::legend::{Mark, draw_mark, stripe};
use crate::profile_points::{self, ProfilePoint};
use crate::sheet::{self, Height, Sheet};
use crate::style::{Colour, Style};
use crate::text::Font;
use crate::words::FigureError;
use crate::{palette, shading};

/// Width and height of the picture, pixels.
pub const SIZE: (f64, f64) = (900.0, 560.0);

/// Number of points above which marks of the common size would touch.
const CROWD: usize = 70;

/// Draws the profile of a sweep over one axis as SVG. Its regions come from the table of `bands` if there is one.
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
    let points = profile_points::along(table, bands, caption.division(axis));
    let entries = legend(&points, caption);
    let (width, height) = SIZE;
    let Sheet { mut canvas, body } = sheet::begin(width, Height::Whole(height), caption, &entries);
    draw_body(&mut canvas, body, axis, &points, caption);
    Ok(canvas.into_svg())
}

fn draw_body(
    canvas: &mut Canvas,
    body: Area,
    axis: &str,
    points: &[ProfilePoint],
    caption: &Caption,
) {
    let across = profile_points::horizontal_range(points);
    let (low, high) = profile_points::vertical_range(points, caption.searched_to);
    let speed = format!("horizontal_velocity{}", caption.speed_unit.ending());
    let speeds = Scale::of_condition(&speed, Division::Linear, (low, high), 11);
    let across = Scale::of_condition(axis, caption.division(axis), across, 13);
    let frame = Frame::new(body, across, speeds);
    // Regions of landings that are not stable.
    let regions = shading::regions(points, high);
    for kind in Kind::ALL {
        let same = regions.iter().filter(|region| region.kind == kind);
        let same: Vec<_> = same.map(|region| frame.places(region.corners)).collect();
        canvas.fill_areas(&same, palette::region(kind));
    }
    draw_stripes(canvas, &frame, &shading::patchy(points, high));
    frame.draw(canvas, Style::stroke(palette::GRID, 1.0));
    draw_line(canvas, &frame, points);
    draw_marks(canvas, &frame, points, high);
    draw_words(canvas, &frame, points, (low, high));
}

/// Upright stripes where stable landings and others alternate, at even distances over the whole picture.
fn draw_stripes(canvas: &mut Canvas, frame: &Frame, areas: &[[(f64, f64); 4]]) {
    for corners in areas {
        let corners = frame.places(*corners);
        let [(a, low), (b, other_low), (_, other_high), (_, high)] = corners[..] else {
            continue;
        };
        let at = |x: f64, [y, z]: [f64; 2]| y + (z - y) * (x - a) / (b - a);
        let apart = palette::STRIPES_APART;
        let [first, end] = [a.min(b), a.max(b)].map(|x| (x / apart).ceil() as i64);
        for x in (first..end).map(|index| apart * index as f64) {
            let ends = [(x, at(x, [low, other_low])), (x, at(x, [high, other_high]))];
            canvas.curve(&ends, stripe());
        }
    }
}

/// Joins the transitions of neighbours, and draws the bracket of each.
fn draw_line(canvas: &mut Canvas, frame: &Frame, points: &[ProfilePoint]) {
    for (start, end, from, to) in profile_points::segments(points) {
        let ends = frame.places([(start.x, from.speed), (end.x, to.speed)]);
        canvas.curve(&ends, Style::stroke(palette::LINE, 2.0));
    }
    for point in points {
        if let Some(found) = point.transition
            && let Some(low) = found.low
        {
            let ends = frame.places([(point.x, low), (point.x, found.high)]);
            canvas.curve(&ends, Style::stroke(palette::LINE, 1.0));
        }
    }
}

fn draw_marks(canvas: &mut Canvas, frame: &Frame, points: &[ProfilePoint], high: f64) {
    let side = if points.len() > CROWD {
        palette::SMALL_MARK
    } else {
        palette::MARK
    };
    for point in points {
        let (mark, speed) = match point.transition {
            Some(found) if found.low.is_none() => (Mark::AtOrBelow(found.kind), found.speed),
            Some(found) => (Mark::Transition(found.kind), found.speed),
            None => (Mark::NoTransition, high),
        };
        draw_mark(canvas, mark, frame.place((point.x, speed)), side);
    }
}

/// Writes the outcome into each region, where it is broadest.
fn draw_words(
    canvas: &mut Canvas,
    frame: &Frame,
    points: &[ProfilePoint],
    (low, high): (f64, f64),
) {
    let mut write = |word: &str, x: f64, y: f64, colour: Colour| {
        canvas.text(word, frame.place((x, y)), Font::new(16.0, colour));
    };
    for kind in Kind::ALL {
        if let Some((x, speed)) = shading::broadest(points, kind, high) {
            write(palette::word(kind), x, speed, palette::mark(kind));
        }
    }
    let (first, last) = (points.first(), points.last());
    let middle = 0.5 * (first.map_or(0.0, |s| s.x) + last.map_or(0.0, |s| s.x));
    let least = points
        .iter()
        .filter_map(|point| Some(point.transition?.speed))
        .fold(high, f64::min);
    // Nothing was computed below the lowest speed searched.
    let is_stable_below = |point: &ProfilePoint| point.transition.is_none_or(|t| t.low.is_some());
    if points.iter().all(is_stable_below) {
        write("stable", middle, 0.5 * (low + least), palette::NONE);
    }
}

fn legend(points: &[ProfilePoint], caption: &Caption) -> Vec<(Mark, String)> {
    let meanings = [
        (Kind::Unstable, "first transition: topples"),
        (Kind::Bottomed, "first transition: a strut bottoms"),
        (Kind::Failure, "landing cannot be computed"),
        (Kind::Undecided, "undecided at the time limit"),
    ];
    let mut entries: Vec<(Mark, String)> = meanings
        .into_iter()
        .filter(|(kind, _)| {
            let found = |point: &ProfilePoint| {
                (point.transition).is_some_and(|t| t.kind == *kind && t.low.is_some())
            };
            points.iter().any(found)
        })
        .map(|(kind, meaning)| (Mark::Transition(kind), meaning.to_owned()))
        .collect();
    let open = Kind::ALL.into_iter().filter(|kind| {
        let is_open = |t: Transition| t.kind == *kind && t.low.is_none();
        (points.iter()).any(|point| point.transition.is_some_and(is_open))
    });
    entries.extend(open.map(|kind| (Mark::AtOrBelow(kind), palette::word_at_or_below(kind))));
    let high = profile_points::vertical_range(points, caption.searched_to).1;
    let regions = shading::regions(points, high);
    // Regions too narrow for their word.
    let wordless = Kind::ALL.into_iter().filter(|kind| {
        regions.iter().any(|region| region.kind == *kind)
            && shading::broadest(points, *kind, high).is_none()
    });
    entries.extend(wordless.map(|kind| {
        let region = Mark::Area(Style::fill(palette::region(kind)));
        (region, palette::word(kind).to_owned())
    }));
    if !shading::patchy(points, high).is_empty() {
        entries.push((Mark::Patchy, palette::PATCHY_WORDS.to_owned()));
    }
    if points.iter().any(|point| point.transition.is_none()) {
        entries.push((Mark::NoTransition, caption.without_transition()));
    }
    entries
}

#[cfg(test)]
#[path = "boundary_profile_tests.rs"]
mod tests;
