//! An axis whose numbers stand where a reader expects them.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::coord::types::RangedCoordf64;

/// Azimuths are numbered every eighth of a turn, deg.
const EIGHTH: f64 = 45.0;

/// Extent of an axis and the values at which it is numbered.
#[derive(Clone)]
pub struct AxisRange {
    extent: RangedCoordf64,
    /// Multiples of this, or whatever values the drawing library finds round.
    step: Option<f64>,
}

impl AxisRange {
    /// The axis of a condition between two values.
    pub fn of(condition: &str, from: f64, to: f64) -> Self {
        let is_azimuth = condition.ends_with("azimuth_deg") && to - from > 4.0 * EIGHTH;
        Self {
            extent: (from..to).into(),
            step: is_azimuth.then_some(EIGHTH),
        }
    }
}

impl Ranged for AxisRange {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limits: (i32, i32)) -> i32 {
        self.extent.map(value, limits)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let Some(step) = self.step else {
            return self.extent.key_points(hint);
        };
        let Range { start, end } = self.range();
        let [first, last] = [(start / step).ceil(), (end / step).floor()];
        (first as i64..=last as i64)
            .map(|index| index as f64 * step)
            .collect()
    }

    fn range(&self) -> Range<f64> {
        self.extent.range()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plotters::coord::ranged1d::BoldPoints;

    #[test]
    fn azimuths_go_by_eighths_of_a_turn_and_others_by_round_values() {
        let azimuths = AxisRange::of("tip_azimuth_deg", -189.0, 189.0).key_points(BoldPoints(13));
        assert_eq!((azimuths[0], azimuths.len()), (-180.0, 9));
        let rolls = AxisRange::of("roll_deg", -63.0, 63.0).key_points(BoldPoints(13));
        assert_eq!((rolls[0], rolls.len()), (-60.0, 13));
    }
}
