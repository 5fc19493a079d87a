//! The work-precision diagram: error against time, both on logarithmic scales.

use crate::caption::Caption;
use crate::line_chart::{self, Axis, Curve, LineChart, Panel, Stroke};
use crate::tables::Table;
use crate::words::FigureError;

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
/// Errors below this are not distinguished: transitions are narrowed to 1e-6 ft/s.
const LEAST: f64 = 1e-10;

/// Returns whether a table is one of work and precision.
pub fn is_one(csv: &str) -> bool {
    csv.starts_with(&format!("{TOLERANCE},"))
}

/// Cost against which errors are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cost {
    /// Run time of a landing.
    Time,
    /// Evaluations of the equations of motion in a landing, the same on any machine.
    Evaluations,
}

/// Draws a table of `touchdown-lab work-precision` as SVG.
///
/// # Errors
/// When a column is missing or a cell is not a number.
pub fn draw(csv: &str, cost: Cost) -> Result<String, FigureError> {
    let (title, remark, abscissa, column) = match cost {
        Cost::Time => (
            "run time",
            "; one thread",
            Axis::doublings("Time of a landing, mean, ms"),
            "mean_us_per_landing",
        ),
        Cost::Evaluations => (
            "evaluations",
            "",
            Axis::doublings("Evaluations of the equations of motion in a landing, mean, thousands"),
            "mean_derivative_evaluations",
        ),
    };
    line_chart::draw(&LineChart {
        caption: Caption {
            title: format!("Work and precision: worst error against {title}"),
            conditions: format!(
                "level landings around the toppling boundary, slope 15 deg, V_V 14 ft/s{remark}; \
                 numbers at points: tolerance"
            ),
            ..Caption::default()
        },
        abscissa,
        panels: vec![Panel {
            ordinate: Axis::logarithmic("Worst error"),
            curves: curves(csv, column)?,
        }],
    })
}

/// The errors against a thousandth of a column, with the tolerances at the last error, which mostly is the least.
fn curves(csv: &str, cost: &str) -> Result<Vec<Curve>, FigureError> {
    let table = Table::parse(csv)?;
    let cost = table.column(cost)?;
    let tolerances = table
        .nonempty_rows()?
        .map(|row| row.text(0).replace('-', "\u{2212}"));
    let tolerances: Vec<String> = tolerances.collect();
    let curves = ERRORS
        .into_iter()
        .enumerate()
        .map(|(index, (name, words))| {
            let is_lowest = index + 1 == ERRORS.len();
            let column = table.column(name)?;
            let points = table.rows().map(|row| {
                let error = row.number(column)?;
                if error < 0.0 {
                    return Err(row.error(column, "a number that is not negative"));
                }
                Ok((1e-3 * row.number(cost)?, error.max(LEAST)))
            });
            Ok(Curve {
                name: words.to_owned(),
                stroke: Stroke::Marks,
                points: points.collect::<Result<_, FigureError>>()?,
                remarks: if is_lowest {
                    tolerances.clone()
                } else {
                    Vec::new()
                },
            })
        });
    curves.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "tolerance,mean_us_per_landing,mean_derivative_evaluations,\
        worst_transition_error_fps,worst_least_angle_error_deg,worst_pitch_error_at_1s_deg,\
        worst_position_error_at_1s_ft\n\
        1e-4,2000,5950,1e-4,1e-2,1e-3,1e-5\n1e-6,6000,12000,0e0,1e-4,1e-5,1e-7\n";

    #[test]
    fn every_error_of_every_tolerance_has_a_mark() {
        assert!(is_one(TABLE));
        for (cost, words) in [
            (Cost::Time, "ms"),
            (Cost::Evaluations, "equations of motion"),
        ] {
            let draw = |table: &str| draw(table, cost);
            let svg = draw(TABLE).unwrap();
            assert!(svg.contains(words));
            // Four curves of two points.
            assert_eq!(svg.matches("<circle").count(), 8);
            assert!(svg.contains(">1e\u{2212}4</text>") && svg.contains(">1e\u{2212}6</text>"));
            let broken = draw(&TABLE.replace("1e-2", "NaN")).unwrap_err().to_string();
            assert!(broken.contains("row 1: worst_least_angle_error_deg = NaN"));
            assert!(draw(&TABLE.replace("worst_pitch", "pitch")).is_err());
        }
    }
}
