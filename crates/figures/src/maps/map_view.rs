//! Directions of a map's axes, and their labels.

use crate::isolines::Place;
use crate::number;
use crate::surface::Surface;

/// Directions of the axes of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Sign with which values of the slow axis increase upward, and of the fast one to the right.
    signs: [f64; 2],
    /// Sign of the labels.
    written: f64,
}

impl View {
    /// The report's view of cross-slope and roll: downhill below, negative rolls to the right. Other
    /// axes run upward and to the right.
    pub fn of(surface: &Surface) -> Self {
        let report = surface.axes == ["cross_slope_deg", "roll_deg"];
        let sign = if report { -1.0 } else { 1.0 };
        Self {
            signs: [sign, sign],
            written: 1.0,
        }
    }

    /// The same view of a surface mirrored in both axes, labelled with the true values.
    pub fn mirrored(self) -> Self {
        Self {
            written: -self.written,
            ..self
        }
    }

    /// Chart coordinates of a place: across and up.
    pub fn at(&self, [slow, fast]: Place) -> (f64, f64) {
        (self.signs[1] * fast, self.signs[0] * slow)
    }

    /// Ends of the chart across and up, with a margin of half a mark.
    pub fn ranges(&self, surface: &Surface) -> [(f64, f64); 2] {
        let range = |values: &[f64], sign: f64| {
            let ends = [sign * values[0], sign * values[values.len() - 1]];
            let margin = 0.012 * (ends[1] - ends[0]).abs();
            (ends[0].min(ends[1]) - margin, ends[0].max(ends[1]) + margin)
        };
        [
            range(&surface.fast, self.signs[1]),
            range(&surface.slow, self.signs[0]),
        ]
    }

    /// Label at a chart coordinate of the fast axis.
    pub fn fast_label(&self, x: f64) -> String {
        number::label(self.written * self.signs[1] * x)
    }

    /// Label at a chart coordinate of the slow axis. Straight downhill has no sign.
    pub fn slow_label(&self, y: f64) -> String {
        let value = self.signs[0] * y;
        if value == 180.0 {
            return number::label(value);
        }
        number::label(self.written * value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::example;

    #[test]
    fn the_reports_map_has_downhill_below_and_negative_roll_to_the_right() {
        let view = View::of(&example());
        let (baseline, across) = (view.at([180.0, 0.0]), view.at([80.0, -30.0]));
        assert!(baseline.1 < across.1 && baseline.0 < across.0);
        assert_eq!(
            (view.fast_label(30.0), view.slow_label(-80.0)),
            ("\u{2212}30".into(), "80".into())
        );
        let mirrored = view.mirrored();
        assert_eq!(
            (mirrored.fast_label(30.0), mirrored.slow_label(-80.0)),
            ("30".into(), "\u{2212}80".into())
        );
        assert_eq!(mirrored.slow_label(-180.0), "180");
    }
}
