//! The work-precision diagram: error against time, both on logarithmic scales.

use crate::caption::Caption;
use crate::figure_error::FigureError;
use crate::line_chart::{self, Axis, Curve, LineChart, Panel, Stroke};
use crate::table::Table;

const COST: &str = "mean_us_per_landing";
/// First column of the table.
const TOLERANCE: &str = "tolerance";
/// Errors drawn: column and words.
const ERRORS: [(&str, &str); 4] = [
    (
        "worst_transition_error_fps",
        "transition velocity V_H, ft/s",
    ),
    ("worst_least_angle_error_deg", "least stability angle, deg"),
    ("worst_pitch_error_at_1s_deg", "pitch at 1 s, deg"),
    ("worst_position_error_at_1s_ft", "position at 1 s, ft"),
];
/// Errors below this are not told apart: transitions are narrowed to 1e-6 ft/s.
const LEAST: f64 = 1e-10;

/// Whether a table is one of work and precision.
pub fn is_one(csv: &str) -> bool {
    csv.starts_with(&format!("{TOLERANCE},"))
}

/// Draws a table of `touchdown work-precision` as SVG.
///
/// # Errors
/// When a column is missing or a cell is not a number.
pub fn draw(csv: &str) -> Result<String, FigureError> {
    line_chart::draw(&LineChart {
        caption: Caption {
            title: "Work and precision: worst error against run time".to_owned(),
            conditions:
                "level landings around the toppling boundary, slope 15 deg, V_V 14 ft/s; one \
                         thread; numbers at points: tolerance"
                    .to_owned(),
            ..Caption::default()
        },
        abscissa: Axis::doublings("Time of a landing, mean, ms"),
        panels: vec![Panel {
            ordinate: Axis::logarithmic("Worst error"),
            curves: curves(csv)?,
        }],
    })
}

/// The errors against time, ms, the tolerances beside the first of them.
fn curves(csv: &str) -> Result<Vec<Curve>, FigureError> {
    let table = Table::parse(csv)?;
    let cost = table.column(COST)?;
    let mut remarks: Vec<String> = table
        .some_rows()?
        .map(|row| row.text(0).to_owned())
        .collect();
    let curves = ERRORS.into_iter().map(|(name, words)| {
        let column = table.column(name)?;
        let points = table.rows().map(|row| {
            let error = row.number(column)?;
            if error < 0.0 {
                return Err(row.complain(column, "a number that is not negative"));
            }
            Ok((1e-3 * row.number(cost)?, error.max(LEAST)))
        });
        Ok(Curve {
            name: words.to_owned(),
            stroke: Stroke::Marks,
            points: points.collect::<Result<_, FigureError>>()?,
            remarks: std::mem::take(&mut remarks),
        })
    });
    curves.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "tolerance,mean_us_per_landing,worst_transition_error_fps,\
        worst_least_angle_error_deg,worst_pitch_error_at_1s_deg,worst_position_error_at_1s_ft\n\
        1e-4,2000,1e-4,1e-2,1e-3,1e-5\n1e-6,6000,0e0,1e-4,1e-5,1e-7\n";

    #[test]
    fn every_error_of_every_tolerance_has_a_mark() {
        assert!(is_one(TABLE));
        let svg = draw(TABLE).unwrap();
        // Four curves of two points.
        assert_eq!(svg.matches("<circle").count(), 8);
        assert!(svg.contains("1e-4") && svg.contains("1e-6"));
        let broken = draw(&TABLE.replace("1e-2", "NaN")).unwrap_err().to_string();
        assert!(broken.contains("row 1: worst_least_angle_error_deg = NaN"));
        assert!(draw(&TABLE.replace("worst_pitch", "pitch")).is_err());
    }
}
