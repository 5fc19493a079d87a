//! Meanings of the marks of maps and perspectives.

use crate::axis_title::parameter_words;
use crate::boundary_table::Kind;
use crate::caption::Caption;
use crate::legend::{Entry, Mark};
use crate::map_view;
use crate::palette;
use crate::style::{Style, WHITE};
use crate::surface::{Cell, Surface};
use crate::words::label;

/// The legend of a contour map: an entry for every mark on the map.
pub fn of_map(surface: &Surface, caption: &Caption) -> Vec<Entry> {
    let slow = parameter_words(&surface.axes[0]);
    let mut entries = Vec::new();
    if !surface.lowest_in_rows().is_empty() {
        entries.push((Mark::Lowest, format!("lowest V_H at each {slow}")));
    }
    if has_leading_feet(surface, caption) {
        entries.push((Mark::Line(bisector()), BISECTOR_WORDS.to_owned()));
    }
    if !surface.jump_edges().is_empty() {
        entries.push((Mark::Jump, jump_words(surface, caption)));
    }
    if surface.cells().any(|(_, cell)| cell == Cell::Jump) {
        let jump_cells = Mark::Area(Style::fill(palette::JUMP_CELL));
        entries.push((jump_cells, "not interpolated across a jump".to_owned()));
    }
    entries.extend(of_points(surface, caption.without_transition()));
    entries
}

/// The legend of a perspective.
pub fn of_perspective(surface: &Surface, caption: &Caption) -> Vec<Entry> {
    let mut entries = Vec::new();
    if !surface.jump_edges().is_empty() {
        let words = format!("{}; left open", jump_words(surface, caption));
        entries.push((Mark::Line(jump()), words));
    }
    let on_the_floor = format!("{}; marked on the floor", caption.without_transition());
    entries.extend(of_points(surface, on_the_floor));
    entries
}

/// Words for the line AB of Figure 4-21.
pub const BISECTOR_WORDS: &str = "AB: V_H bisects the leading feet";

/// The line AB of Figure 4-21.
pub fn bisector() -> Style {
    Style::stroke(palette::BISECTOR, 2.0).dashed(Some((9.0, 6.0)))
}

/// The line between two neighbours of a perspective across which the boundary jumps.
pub fn jump() -> Style {
    Style::stroke(palette::JUMP, 1.0).opacity(0.6)
}

/// Returns whether the line AB belongs on a map: one like the report's, for feet like those of its vehicle.
pub fn has_leading_feet(surface: &Surface, caption: &Caption) -> bool {
    map_view::is_of_report(surface, caption) && caption.has_report_feet
}

fn jump_words(surface: &Surface, caption: &Caption) -> String {
    let (least, unit) = (label(surface.jump), caption.speed_unit);
    format!("V_H jumps by more than {least} {unit} between points")
}

/// Marks of single points, with words for those without a transition.
fn of_points(surface: &Surface, without_transition: String) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    if !surface.lone().is_empty() {
        let words = "V_H of a point beside gaps, by its colour";
        entries.push((Mark::Lone(WHITE), words.to_owned()));
    }
    if surface.gaps().next().is_some() {
        entries.push((Mark::NoTransition, without_transition));
    }
    let known = Kind::ALL.map(|kind| {
        [
            (Mark::Transition(kind), palette::word(kind).to_owned()),
            (Mark::AtOrBelow(kind), palette::word_at_or_below(kind)),
        ]
    });
    for (mark, words) in known.into_iter().flatten() {
        if surface.doubtful.iter().any(|(_, found)| *found == mark) {
            entries.push((mark, words));
        }
    }
    let patchy = Mark::Ring(palette::PATCHY);
    if surface.doubtful.iter().any(|(_, found)| *found == patchy) {
        entries.push((patchy, palette::PATCHY_WORDS.to_owned()));
    }
    entries
}
