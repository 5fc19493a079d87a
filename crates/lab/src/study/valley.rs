//! The valley of the stability surface against the line AB of Figure 4-21.

use std::fmt::Write;

use touchdown_figures::leading_feet;
use touchdown_input::documents::input_error::InputError;

use super::answer::signed;
use super::results::{Results, Transitions};

/// Extent of the rolls of the map, deg.
const ROLLS: (f64, f64) = (-60.0, 60.0);

/// Critical roll and line AB for every tenth degree of cross-slope, with its mirror image.
///
/// # Errors
/// When the surface is missing.
pub fn section(results: &Results) -> Result<String, InputError> {
    let surface = results.transitions("surface-4-20")?;
    let mut text = "\
## The valley and the line AB

Along AB the velocity at touchdown bisects the line that joins the two leading feet: with feet every 120
deg, roll = cross-slope − 180 up to whole turns of 120 deg. The report's own example (150, −30) lies on
it, and so does its end B at (90, 30), but as a turn of (90, −90): the straight line of its map from (180,
0) to (90, 30) is not this locus. The valley runs beside AB, as the report says: at half of its roll.

| cross-slope, deg | AB, roll | critical roll | V_H | mirror image: critical roll | V_H |
|---:|---|---:|---:|---:|---:|
"
    .to_owned();
    for step in 0..=10 {
        let cross_slope = 180.0 - 10.0 * f64::from(step);
        let line = leading_feet::rolls(cross_slope, ROLLS.0, ROLLS.1);
        let line: Vec<String> = line.into_iter().map(signed).collect();
        let here = critical(&surface, cross_slope);
        let mirrored = match step {
            0 => None,
            _ => critical(&surface, -cross_slope),
        };
        let cells = [here, mirrored].map(|transition| match transition {
            Some((roll, speed)) => format!("{} | {speed:.2}", signed(roll)),
            None => " | ".to_owned(),
        });
        let _ = writeln!(
            text,
            "| {} | {} | {} |",
            signed(cross_slope),
            line.join(" and "),
            cells.join(" | ")
        );
    }
    Ok(text)
}

/// Roll with the lowest transition at a cross-slope, and that transition, ft/s.
fn critical(surface: &Transitions, cross_slope: f64) -> Option<(f64, f64)> {
    surface
        .points()
        .filter(|(place, _)| place[0] == cross_slope)
        .filter_map(|(place, first)| Some((place[1], first?.speed)))
        .min_by(|(_, a), (_, b)| a.total_cmp(b))
}
