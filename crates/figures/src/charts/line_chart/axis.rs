//! An axis of a chart: evenly divided, or by powers.

use crate::division::Division;
use crate::frame::Scale;

/// Extent given to a curve of two equal values.
const LEAST_EXTENT: f64 = 1e-9;
/// Space beyond the values of an axis of doublings, in doublings.
const DOUBLINGS_BEYOND: f64 = 0.68;

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity and unit.
    pub title: String,
    division: Division,
}

impl Axis {
    fn new(title: &str, division: Division) -> Self {
        Self {
            title: title.to_owned(),
            division,
        }
    }

    /// An evenly divided axis.
    pub fn linear(title: &str) -> Self {
        Self::new(title, Division::Linear)
    }

    /// An axis divided by powers of ten, for values greater than zero.
    pub fn logarithmic(title: &str) -> Self {
        Self::new(title, Division::Decades)
    }

    /// An axis divided by powers of two, for values greater than zero within a decade or two.
    pub fn doublings(title: &str) -> Self {
        Self::new(title, Division::Doublings)
    }

    /// Position of a value along the axis.
    pub(super) fn place(&self, value: f64) -> f64 {
        self.division.place(value)
    }

    /// Ends of the axis around its values.
    fn extent(&self, values: impl Iterator<Item = f64>) -> (f64, f64) {
        let (low, high) = values
            .map(|value| self.place(value))
            .filter(|place| place.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
                (low.min(place), high.max(place))
            });
        if low > high {
            return (0.0, 1.0);
        }
        match self.division {
            Division::Linear => {
                let margin = 0.03 * (high - low).max(LEAST_EXTENT);
                (low - margin, high + margin)
            }
            Division::Decades => (low.floor(), high.ceil().max(low.floor() + 1.0)),
            Division::Doublings => (low - DOUBLINGS_BEYOND, high + DOUBLINGS_BEYOND),
        }
    }

    /// The axis around its values, with or without a title.
    pub(super) fn scale(&self, values: impl Iterator<Item = f64>, is_titled: bool) -> Scale {
        let (from, to) = self.extent(values);
        let count = match self.division {
            Division::Linear => 7,
            Division::Decades | Division::Doublings => 12,
        };
        Scale {
            title: if is_titled {
                self.title.clone()
            } else {
                String::new()
            },
            ends: (from, to),
            ticks: self.division.ticks(&self.title, from, to, count),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_placed_does_not_stretch_the_axis() {
        let axis = Axis::logarithmic("error");
        assert_eq!(axis.extent([1e-3, 0.5, f64::NAN].into_iter()), (-3.0, 0.0));
        let (low, high) = Axis::linear("pitch").extent([2.0, 2.0].into_iter());
        assert!(low < 2.0 && high > 2.0);
    }

    #[test]
    fn an_axis_of_doublings_has_room_beyond_its_values() {
        let axis = Axis::doublings("time, ms");
        let (low, high) = axis.extent([3.0, 12.0].into_iter());
        assert!(low < 1.0 && high > 4.0 && high < 5.0);
    }
}
