//! Reads the table `[map]` of a sweep file, which sets the refinement of a map.

use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};
use crate::points::axis_input::AxisEntry;
use crate::points::grid::Grid;
use crate::points::refined_grid::{MapRules, RefinedGrid};

pub(crate) const MAP: [&str; 5] = [
    "edge_width",
    "error_fps",
    "jump_fps",
    "budget_landings",
    "grid_steps",
];
const EDGE_WIDTH: &str = "a table with one or two of the axes and a width in the unit of each, such as { roll_deg = 0.5, friction = 0.01 }";
/// Default of the least jump that makes an edge: in multiples of the error sought, and its minimum, ft/s.
const JUMP_IN_ERRORS: f64 = 4.0;
const JUMP: f64 = 0.5;
/// Steps of the resampled table along a first-level cell: default and greatest.
const GRID_STEPS: usize = 8;
const MOST_GRID_STEPS: u64 = 1000;
/// Greatest budget that TOML keeps exactly.
const GREATEST_BUDGET: u64 = 9_007_199_254_740_992;

/// Reads `[map]` for the axes of a grid; `None` without the table.
pub(crate) fn map(
    root: &Section,
    entries: &[AxisEntry],
    first_level: &Grid,
) -> Result<Option<RefinedGrid>, InputError> {
    let Some(section) = root.optional_section("map", &MAP)? else {
        return Ok(None);
    };
    let edge_width = section.value("edge_width", EDGE_WIDTH)?;
    let mut refined: Vec<(usize, usize)> = edge_width
        .leaves()?
        .iter()
        .map(|(name, width)| refined_axis(name, width, entries, first_level))
        .collect::<Result<_, _>>()?;
    refined.sort_unstable();
    if !(1..=2).contains(&refined.len()) {
        return Err(edge_width.complain_that(&format!("allowed is {EDGE_WIDTH}")));
    }
    if refined.len() == 1
        && let Some(steps) = section.optional("grid_steps")
    {
        return Err(
            steps.complain_that("says nothing of a map over one axis, which has no regular table")
        );
    }
    let rules = rules(&section)?;
    RefinedGrid::new(first_level.clone(), &refined, rules)
        .map(Some)
        .ok_or_else(|| {
            edge_width.complain_that(
                "so fine that the map has more than 2^26 places: allowed are greater widths, or fewer values of axes",
            )
        })
}

/// Finds the axis of a name, and the number of parts of its intervals that makes them half a width or less.
fn refined_axis(
    name: &str,
    width: &LocatedValue,
    entries: &[AxisEntry],
    first_level: &Grid,
) -> Result<(usize, usize), InputError> {
    let named = |entry: &AxisEntry| entry.parameter.name() == name;
    let Some(axis) = entries.iter().position(named) else {
        let axes: Vec<&str> = entries.iter().map(|entry| entry.parameter.name()).collect();
        let axes = axes.join(", ");
        return Err(width.complain_that(&format!("no such axis: allowed are {axes}")));
    };
    let entry = &entries[axis];
    if !entry.parameter.words().is_empty() {
        return Err(width.complain_that("its values are words: allowed are axes of numbers"));
    }
    if !first_level.dimensions().contains(&vec![axis]) {
        return Err(
            width.complain_that("moves together with another axis: allowed are axes without zip")
        );
    }
    let values: Vec<f64> = first_level.axes()[axis].values().collect();
    let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let rises = steps.iter().all(|step| *step > 0.0);
    if steps.is_empty() || !(rises || steps.iter().all(|step| *step < 0.0)) {
        let needed =
            "a refined axis needs two values or more that rise, or fall, from each to the next";
        return Err(entry.found.complain_that(needed));
    }
    let greatest = steps
        .iter()
        .fold(0.0, |most: f64, step| most.max(step.abs()));
    let allowed = format!("0 < value ≤ {greatest}, the greatest step of the axis");
    let number = width.number()?;
    if !(number > 0.0 && number <= greatest) {
        return Err(width.complain(&allowed));
    }
    let mut parts = 2;
    // A division finer than the greatest number of places is useless.
    while greatest / parts as f64 > 0.5 * number && parts < 1 << 26 {
        parts *= 2;
    }
    Ok((axis, parts))
}

fn rules(section: &Section) -> Result<MapRules, InputError> {
    let positive = |key: &str| -> Result<Option<f64>, InputError> {
        match section.optional(key) {
            None => Ok(None),
            Some(found) => match found.number()? {
                number if number > 0.0 && number.is_finite() => Ok(Some(number)),
                _ => Err(found.complain("a number > 0")),
            },
        }
    };
    let (error, budget) = (
        positive("error_fps")?,
        section.optional_whole_number("budget_landings", 1, GREATEST_BUDGET)?,
    );
    if error.is_none() && budget.is_none() {
        let needed = "the error of interpolation that is sought, ft/s, or budget_landings, or both";
        return Err(section.missing("error_fps", needed));
    }
    let jump = match positive("jump_fps")? {
        Some(jump) => jump,
        None => error.map_or(JUMP, |error| JUMP.max(JUMP_IN_ERRORS * error)),
    };
    Ok(MapRules {
        error: error.unwrap_or(0.0),
        jump,
        budget,
        grid_steps: section
            .optional_whole_number("grid_steps", 1, MOST_GRID_STEPS)?
            .map_or(GRID_STEPS, |steps| steps as usize),
    })
}
