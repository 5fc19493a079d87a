//! The table of a crushable cartridge: crush load against stroke, with steps.

use crate::invalid::Invalid;
use crate::profile::Segment;

/// Crush load against stroke: linear between its knots, with a step where two of them have the same stroke. Beyond the
/// last knot the load is constant.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushLoad {
    knots: Vec<[f64; 2]>,
}

impl CrushLoad {
    /// Builds a table from knots of stroke (ft) and load (lb).
    ///
    /// # Errors
    /// Strokes start at 0 and do not decrease, and at most two knots have one stroke. Loads are finite, that of the
    /// first knot is positive and none is negative.
    pub fn new(knots: Vec<[f64; 2]>) -> Result<Self, Invalid> {
        let complain = |value, allowed| Err(Invalid::new("strut.crush_load", value, allowed));
        let Some(&[first, load]) = knots.first() else {
            return complain(0.0, "at least one knot");
        };
        if first != 0.0 {
            return complain(first, "first stroke 0");
        }
        if load <= 0.0 {
            return complain(load, "a load > 0 at stroke 0");
        }
        for &[stroke, load] in &knots {
            if !stroke.is_finite() {
                return complain(stroke, "finite strokes");
            }
            if !load.is_finite() || load < 0.0 {
                return complain(load, "loads ≥ 0");
            }
        }
        for pair in knots.windows(2) {
            if pair[1][0] < pair[0][0] {
                return complain(pair[1][0], "strokes that do not decrease");
            }
        }
        for three in knots.windows(3) {
            if three[0][0] == three[2][0] {
                return complain(three[2][0], "at most two knots at one stroke");
            }
        }
        Ok(Self { knots })
    }

    /// The knots: stroke, ft, and load, lb.
    pub fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// The load of a cartridge whose stroke only grows, as straight lines from left to right. It rises no steeper than
    /// at its elastic stiffness (lb/ft): from no load to the first of the table, at steps up and wherever else the
    /// table is steeper. Otherwise crushing would heal. It falls as the table does.
    pub fn front(&self, stiffness: f64) -> Vec<Segment> {
        let mut segments: Vec<Segment> = Vec::new();
        // Adds a line through a point up to a stroke; lines without length are left out.
        let mut add = |[x, y]: [f64; 2], slope: f64, upper: f64| {
            if segments.last().is_none_or(|last| last.upper < upper) {
                segments.push(Segment {
                    offset: y - slope * x,
                    slope,
                    upper,
                });
            }
        };
        let mut at: [f64; 2] = [0.0; 2];
        let beyond = self.knots[self.knots.len() - 1];
        let ends = self.knots[1..].iter().copied();
        let ends = ends.chain([[f64::INFINITY, beyond[1]]]);
        for (&[x, y], end) in self.knots.iter().zip(ends) {
            if end[0] == x {
                // A step down is taken at once; a step up is climbed within the next line.
                at[1] = at[1].min(end[1]);
                continue;
            }
            let slope = if end[0].is_finite() {
                (end[1] - y) / (end[0] - x)
            } else {
                0.0
            };
            at[1] = at[1].min(y + slope * (at[0] - x));
            let table = |stroke: f64| y + slope * (stroke - x);
            let short = table(at[0]) - at[1];
            if short > 0.0 || slope > stiffness {
                let meets = if slope < stiffness {
                    at[0] + short / (stiffness - slope)
                } else {
                    f64::INFINITY
                };
                let reached = meets.min(end[0]);
                add(at, stiffness, reached);
                if reached == end[0] {
                    at = [reached, at[1] + stiffness * (reached - at[0])];
                    continue;
                }
                at = [reached, table(reached)];
            }
            add(at, slope, end[0]);
            at = end;
        }
        segments
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn front(knots: &[[f64; 2]]) -> Vec<Segment> {
        CrushLoad::new(knots.to_vec()).unwrap().front(1000.0)
    }

    fn line(offset: f64, slope: f64, upper: f64) -> Segment {
        Segment {
            offset,
            slope,
            upper,
        }
    }

    #[test]
    fn steps_up_are_climbed_at_the_elastic_stiffness_and_steps_down_are_taken_at_once() {
        let table = [
            [0.0, 100.0],
            [1.0, 100.0],
            [1.0, 200.0],
            [2.0, 200.0],
            [2.0, 50.0],
        ];
        let expected = [
            line(0.0, 1000.0, 0.1),
            line(100.0, 0.0, 1.0),
            line(-900.0, 1000.0, 1.1),
            line(200.0, 0.0, 2.0),
            line(50.0, 0.0, f64::INFINITY),
        ];
        assert_eq!(front(&table), expected);
    }

    #[test]
    fn nothing_rises_steeper_than_the_elastic_line() {
        // Steeper than elastic from 0.5 on, up to 2000 lb at 1; the ramp meets the plateau after it.
        let table = [[0.0, 100.0], [0.5, 100.0], [1.0, 2000.0]];
        let found = front(&table);
        assert!(found.iter().all(|segment| segment.slope <= 1000.0));
        assert_eq!(found[0], line(0.0, 1000.0, 0.1));
        let last = found[found.len() - 1];
        assert_eq!((last.slope, last.offset), (0.0, 2000.0));
        // 100 + 1000 (δ − 0.5) = 2000 at δ = 2.4.
        assert!((found[found.len() - 2].upper - 2.4).abs() < 1e-12);
        // Lines join without a step, but for those down.
        for pair in found.windows(2) {
            let [left, right] = [0, 1].map(|k| pair[k].offset + pair[k].slope * pair[0].upper);
            assert!((left - right).abs() < 1e-9, "{pair:?}");
        }
    }

    #[test]
    fn tables_that_mean_nothing_are_refused() {
        for (knots, allowed) in [
            (vec![], "at least one knot"),
            (vec![[0.1, 1.0]], "first stroke 0"),
            (vec![[0.0, 0.0]], "a load > 0 at stroke 0"),
            (vec![[0.0, 1.0], [1.0, -1.0]], "loads ≥ 0"),
            (vec![[0.0, 1.0], [1.0, f64::NAN]], "loads ≥ 0"),
            (
                vec![[0.0, 1.0], [1.0, 1.0], [0.5, 1.0]],
                "strokes that do not decrease",
            ),
            (
                vec![[0.0, 1.0], [0.0, 2.0], [0.0, 3.0]],
                "at most two knots at one stroke",
            ),
        ] {
            assert_eq!(CrushLoad::new(knots).unwrap_err().allowed, allowed);
        }
    }
}
