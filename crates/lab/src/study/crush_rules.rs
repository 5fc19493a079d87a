//! First transitions of every figure under both crush rules.

use std::fmt::Write;

use touchdown_figures::boundary_table::Transition;
use touchdown_input::documents::input_error::InputError;

use super::answer::{signed, speed};
use super::results::Results;

/// Folder of the results under the section rule.
pub const SECTION_RULE: &str = "section-rule";

/// Figures that are sweeps over one axis.
const FIGURES: [&str; 18] = [
    "figure-4-05",
    "figure-4-06",
    "figure-4-07",
    "figure-4-08",
    "figure-4-09",
    "figure-4-10",
    "figure-4-11",
    "figure-4-12",
    "figure-4-13",
    "figure-4-14",
    "figure-4-15",
    "figure-4-16",
    "figure-4-17",
    "figure-4-18",
    "figure-4-19",
    "figure-4-23",
    "figure-4-24",
    "figure-4-25",
];

/// One row a figure, and the points whose verdict changes.
///
/// # Errors
/// When a result is missing or was made on another grid.
pub fn section(results: &Results) -> Result<String, InputError> {
    let other = results.variant(SECTION_RULE);
    let mut text = "\
## Crush rules

Under the pivot-rate rule of the listing an element crushes only while its pivot moves into the ground;
under the section rule of Section II wherever its penetration is greatest so far. The verdict of a point
changes where one rule has no transition or one of another kind.

| figure | points | lowest, pivot-rate | lowest, section | greatest difference | verdict changes at |
|---|---:|---|---|---|---|
"
    .to_owned();
    for stem in FIGURES {
        let (pivot, section) = (results.transitions(stem)?, other.transitions(stem)?);
        let mut greatest: Option<(f64, f64)> = None;
        let mut changes = Vec::new();
        for (place, here) in pivot.points() {
            let there = section.at(place)?;
            match (here, there) {
                (Some(a), Some(b)) if a.kind == b.kind => {
                    let apart = b.speed - a.speed;
                    if greatest.is_none_or(|(_, most)| apart.abs() > most.abs()) {
                        greatest = Some((place[0], apart));
                    }
                }
                (None, None) => {}
                _ => changes.push(format!(
                    "{} ({} → {})",
                    signed(place[0]),
                    in_words(here),
                    in_words(there)
                )),
            }
        }
        let (pivot_place, pivot_lowest) = pivot.lowest()?;
        let (section_place, section_lowest) = section.lowest()?;
        let greatest = greatest.map_or(String::new(), |(place, apart)| {
            format!("{apart:+.2} at {}", signed(place)).replacen('-', "\u{2212}", 1)
        });
        let _ = writeln!(
            text,
            "| {stem} | {} | {pivot_lowest:.2} at {} | {section_lowest:.2} at {} | {greatest} | {} |",
            pivot.points().count(),
            signed(pivot_place[0]),
            signed(section_place[0]),
            changes.join(", ")
        );
    }
    Ok(text)
}

fn in_words(first: Option<Transition>) -> String {
    match first {
        Some(transition) => format!("{} {}", transition.kind.name(), speed(first)),
        None => "none".to_owned(),
    }
}
