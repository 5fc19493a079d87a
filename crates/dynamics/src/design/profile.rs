//! Piecewise-linear tables: crush pressure against interference, strut multipliers against stroke.

use crate::invalid::{Invalid, require};
use crate::quantity::Range;

/// A continuous piecewise-linear function given by knots.
///
/// Beyond its last knot the last segment is extended. Below its first knot the function is up to the law that uses it
/// (all tables of the report start at zero abscissa).
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    knots: Vec<[f64; 2]>,
}

/// The straight line `offset + slope · x` that holds up to (and not beyond) `upper`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Value of the line at x = 0.
    pub offset: f64,
    /// Slope of the line.
    pub slope: f64,
    /// Abscissa at which the next segment takes over; infinite for the last one.
    pub upper: f64,
}

/// The constant 1.
impl Default for Profile {
    fn default() -> Self {
        Self {
            knots: vec![[0.0, 1.0], [1.0, 1.0]],
        }
    }
}

impl Profile {
    /// Builds a table from `[x, y]` knots.
    ///
    /// # Errors
    /// At least two knots, starting at x = 0, strictly increasing in x, finite and with y ≥ 0.
    pub fn new(knots: Vec<[f64; 2]>) -> Result<Self, Invalid> {
        if knots.len() < 2 {
            return Err(Invalid::new(
                "table",
                knots.len() as f64,
                "at least two knots",
            ));
        }
        for knot in &knots {
            if !knot[0].is_finite() || !knot[1].is_finite() || knot[1] < 0.0 {
                let bad = if knot[0].is_finite() {
                    knot[1]
                } else {
                    knot[0]
                };
                return Err(Invalid::new("table", bad, "finite numbers, ordinates ≥ 0"));
            }
        }
        if knots[0][0] != 0.0 {
            return Err(Invalid::new("table", knots[0][0], "first abscissa 0"));
        }
        for pair in knots.windows(2) {
            if pair[1][0] <= pair[0][0] {
                return Err(Invalid::new(
                    "table",
                    pair[1][0],
                    "abscissas in increasing order",
                ));
            }
        }
        Ok(Self { knots })
    }

    /// The knots, `[x, y]` each.
    pub fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// Checks that the table is a crush profile: it starts at zero pressure, and no later segment is steeper than the first,
    /// the elastic line. Otherwise crushing would heal.
    ///
    /// # Errors
    /// Names what is wrong by the `quantity` that the table is.
    pub(crate) fn check_crush(&self, quantity: &str) -> Result<(), Invalid> {
        require(
            quantity,
            self.knots[0][1],
            "zero pressure at zero interference",
            |p| p == 0.0,
        )?;
        let segments = self.segments();
        let elastic = require(
            &format!("{quantity} (slope of segment 1, 1/ft)"),
            segments[0].slope,
            &Range::POSITIVE.to_string(),
            |slope| Range::POSITIVE.contains(slope),
        )?;
        for (index, segment) in segments.iter().enumerate().skip(1) {
            require(
                &format!("{quantity} (slope of segment {}, 1/ft)", index + 1),
                segment.slope,
                &format!("0 to that of the first segment, {elastic:.6}"),
                |slope| slope >= 0.0 && slope <= elastic * (1.0 + 1e-6),
            )?;
        }
        Ok(())
    }

    /// Slope of the first segment.
    pub fn first_slope(&self) -> f64 {
        let [[x0, y0], [x1, y1]] = [self.knots[0], self.knots[1]];
        (y1 - y0) / (x1 - x0)
    }

    /// The segments from left to right.
    pub fn segments(&self) -> Vec<Segment> {
        lines(&self.knots)
    }

    /// The segment that holds just above `x`.
    pub fn segment_at(&self, x: f64) -> Segment {
        let segments = self.segments();
        let index = segments
            .iter()
            .position(|s| x < s.upper)
            .unwrap_or(segments.len() - 1);
        segments[index]
    }
}

/// The lines through two or more knots, `[x, y]` each, from left to right.
pub(crate) fn lines(knots: &[[f64; 2]]) -> Vec<Segment> {
    let last = knots.len() - 2;
    knots
        .windows(2)
        .enumerate()
        .map(|(index, pair)| {
            let [[x0, y0], [x1, y1]] = [pair[0], pair[1]];
            let slope = (y1 - y0) / (x1 - x0);
            Segment {
                offset: y0 - slope * x0,
                slope,
                upper: if index == last { f64::INFINITY } else { x1 },
            }
        })
        .collect()
}
