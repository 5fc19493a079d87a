//! The distribution of transition velocities of a sample: cumulative curve with its interval, and histogram.

use crate::caption::Caption;
use crate::line_chart::{self, Axis, Curve, LineChart, Panel, Stroke};
use crate::tables::{Table, has_column};
use crate::words::FigureError;

/// A column that other tables do not have.
const CUMULATIVE: &str = "cumulative_share";

/// Returns whether a table is one of a distribution.
pub fn is_one(csv: &str) -> bool {
    has_column(csv, &[CUMULATIVE])
}

/// Draws the table of a distribution as SVG.
///
/// # Errors
/// When a column is missing or a cell is not a number.
pub fn draw(csv: &str, caption: &Caption) -> Result<String, FigureError> {
    let bins = bins(csv)?;
    let ends = |share: fn(&Bin) -> f64| {
        bins.iter()
            .filter_map(|bin| Some((bin.to?, share(bin))))
            .collect()
    };
    let interval = "95 % interval";
    line_chart::draw(&LineChart {
        caption: caption.clone(),
        abscissa: Axis::linear(&format!("Transition velocity V_H, {}", caption.speed_unit)),
        panels: vec![
            Panel {
                ordinate: Axis::linear("Share of points at or below"),
                curves: vec![
                    Curve::new(
                        "cumulative share",
                        Stroke::Marks,
                        ends(|bin| bin.cumulative[0]),
                    ),
                    Curve::new(interval, Stroke::Dashes, ends(|bin| bin.cumulative[1])),
                    Curve::new(interval, Stroke::Dashes, ends(|bin| bin.cumulative[2])),
                ],
            },
            Panel {
                ordinate: Axis::linear("Share of points in bin"),
                curves: vec![Curve::new("histogram", Stroke::Line, steps(&bins))],
            },
        ],
    })
}

/// A row of the table.
struct Bin {
    /// Its ends, if any.
    from: Option<f64>,
    to: Option<f64>,
    share: f64,
    /// Cumulative share up to this bin, and its interval.
    cumulative: [f64; 3],
}

fn bins(csv: &str) -> Result<Vec<Bin>, FigureError> {
    let table = Table::parse(csv)?;
    let [from, to] = [table.column("from_fps")?, table.column("to_fps")?];
    let share = table.column("share")?;
    let cumulative = [
        table.column(CUMULATIVE)?,
        table.column("cumulative_low_95")?,
        table.column("cumulative_high_95")?,
    ];
    let bins = table.nonempty_rows()?.map(|row| {
        let [at, low, high] = cumulative.map(|column| row.number(column));
        Ok(Bin {
            from: row.optional_number(from)?,
            to: row.optional_number(to)?,
            share: row.number(share)?,
            cumulative: [at?, low?, high?],
        })
    });
    bins.collect()
}

/// The outline of the histogram over the bins with two ends.
fn steps(bins: &[Bin]) -> Vec<(f64, f64)> {
    let closed = bins
        .iter()
        .filter_map(|bin| Some((bin.from?, bin.to?, bin.share)));
    let mut outline: Vec<(f64, f64)> = Vec::new();
    for (from, to, share) in closed {
        if outline.is_empty() {
            outline.push((from, 0.0));
        }
        outline.extend([(from, share), (to, share)]);
    }
    outline.extend(outline.last().map(|(to, _)| (*to, 0.0)));
    outline
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "from_fps,to_fps,points,share,cumulative_share,cumulative_low_95,cumulative_high_95\n\
        ,8,1,0.1,0.1,0.02,0.4\n8,9,4,0.4,0.5,0.24,0.76\n9,10,3,0.3,0.8,0.49,0.94\n20,,2,0.2,1,0.72,1\n";

    #[test]
    fn the_curve_has_a_mark_at_the_end_of_each_bin() {
        assert!(is_one(TABLE));
        let svg = draw(TABLE, &Caption::default()).unwrap();
        assert_eq!(svg.matches("<circle").count(), 3);
        assert!(svg.contains("95 % interval") && svg.contains("histogram"));
        let outline = steps(&bins(TABLE).unwrap());
        assert_eq!(
            outline,
            [
                (8.0, 0.0),
                (8.0, 0.4),
                (9.0, 0.4),
                (9.0, 0.3),
                (10.0, 0.3),
                (10.0, 0.0)
            ]
        );
        let broken = draw(&TABLE.replace("0.94", "x"), &Caption::default());
        assert!(
            broken
                .unwrap_err()
                .to_string()
                .contains("cumulative_high_95 = x")
        );
    }
}
