//! Directions of a map's axes, and their labels.

use crate::caption::Caption;
use crate::division::Division;
use crate::isolines::Place;
use crate::surface::Surface;
use crate::words::label;

/// Directions of the axes of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Sign with which values of the slow axis increase upward, and of the fast one to the right.
    signs: [f64; 2],
    /// Sign of the labels.
    written: f64,
    /// Divisions of the slow and of the fast axis.
    divisions: [Division; 2],
}

/// Returns whether a map has the axes of the report's: cross-slope and roll, on even scales.
pub fn is_of_report(surface: &Surface, caption: &Caption) -> bool {
    surface.axes == ["cross_slope_deg", "roll_deg"]
        && divisions(surface, caption) == [Division::Linear; 2]
}

fn divisions(surface: &Surface, caption: &Caption) -> [Division; 2] {
    surface.axes.each_ref().map(|axis| caption.division(axis))
}

impl View {
    /// The report's view of cross-slope and roll: downhill below, negative rolls to the right. Other
    /// axes run upward and to the right.
    pub fn of(surface: &Surface, caption: &Caption) -> Self {
        let sign = if is_of_report(surface, caption) {
            -1.0
        } else {
            1.0
        };
        Self {
            signs: [sign, sign],
            written: 1.0,
            divisions: divisions(surface, caption),
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

    /// Chart coordinates between two others at which the slow (0) or the fast (1) axis is numbered, about `count` of
    /// them, and the numbers. Straight downhill has no sign.
    pub fn ticks(
        &self,
        surface: &Surface,
        axis: usize,
        (from, to): (f64, f64),
        count: usize,
    ) -> Vec<(f64, String)> {
        let sign = self.written * self.signs[axis];
        let (least, most) = ((sign * from).min(sign * to), (sign * from).max(sign * to));
        let ticks = self.divisions[axis].ticks(&surface.axes[axis], least, most, count);
        let ticks = ticks.into_iter().map(|(place, number)| {
            let is_downhill = axis == 0 && self.written < 0.0 && place == -180.0;
            let number = if is_downhill { label(180.0) } else { number };
            (sign * place, number)
        });
        let mut ticks: Vec<_> = ticks.collect();
        ticks.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        ticks
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::example;

    #[test]
    fn the_reports_map_has_downhill_below_and_negative_roll_to_the_right() {
        let surface = example();
        let view = View::of(&surface, &Caption::default());
        let (baseline, across) = (view.at([180.0, 0.0]), view.at([80.0, -30.0]));
        assert!(baseline.1 < across.1 && baseline.0 < across.0);
        let number = |view: &View, axis: usize, at: f64| {
            let ticks = view.ticks(&surface, axis, (-180.0, 180.0), 36);
            let found = ticks.into_iter().find(|(place, _)| *place == at);
            found.map(|(_, number)| number).unwrap_or_default()
        };
        assert_eq!(number(&view, 1, 30.0), "\u{2212}30");
        assert_eq!(number(&view, 0, -80.0), "80");
        let mirrored = view.mirrored();
        assert_eq!(number(&mirrored, 1, 30.0), "30");
        assert_eq!(number(&mirrored, 0, -80.0), "\u{2212}80");
        assert_eq!(number(&mirrored, 0, -180.0), "180");
    }
}
