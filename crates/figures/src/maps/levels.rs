//! Levels of a map and the colours between them.

use crate::style::Colour;
use crate::surface::Surface;
use crate::ticks::round_step;
use libm::{exp10, log10};

/// Borders between bands of colour, rising. There are at most [`Levels::MOST`].
#[derive(Debug, Clone, PartialEq)]
pub struct Levels(Vec<f64>);

/// Approximate number of intervals into which the range of a surface is divided at first.
const INTERVALS: f64 = 10.0;
/// An interval is halved if it holds more than this part of a surface and more than `FEW` of its points, or what they weigh on
/// average, and if its halves are round.
const CROWDED: f64 = 0.125;
const FEW: f64 = 8.0;

/// Dark blue to pale yellow, even in lightness, so that grey prints and all readers keep the order (after the colour
/// map cividis).
const ENDS: [(f64, [f64; 3]); 4] = [
    (0.0, [32.0, 52.0, 96.0]),
    (0.35, [92.0, 99.0, 116.0]),
    (0.7, [164.0, 155.0, 119.0]),
    (1.0, [250.0, 232.0, 140.0]),
];

impl Levels {
    /// Greatest number of levels.
    pub const MOST: usize = 30;

    /// Round levels between the lowest and the highest transition of a surface, closer where more of its points lie.
    pub fn of(surface: &Surface) -> Self {
        Self::through(&surface.heights().collect::<Vec<f64>>())
    }

    /// Round levels between the least and the greatest of these velocities, closer where more of them lie.
    pub fn through(heights: &[f64]) -> Self {
        let of_one_weight = heights.iter().map(|height| (*height, 1.0));
        Self::through_weighted(&of_one_weight.collect::<Vec<_>>())
    }

    /// The same through velocities of different weights, closer where more of the weight lies.
    pub fn through_weighted(heights: &[(f64, f64)]) -> Self {
        let ends = heights.iter().map(|(height, _)| *height);
        let (Some(least), Some(greatest)) = (ends.clone().reduce(f64::min), ends.reduce(f64::max))
        else {
            return Self(Vec::new());
        };
        let step = round_step((greatest - least) / INTERVALS);
        let first = (least / step).floor();
        let count = ((greatest / step).ceil() - first).clamp(1.0, 2.0 * INTERVALS) as usize;
        let crowded = Crowded {
            heights,
            share: CROWDED.max(FEW / heights.len() as f64),
            total: heights.iter().map(|(_, weight)| weight).sum(),
        };
        let mut levels = Vec::new();
        for index in 0..count {
            let low = first + index as f64;
            levels.extend((index > 0).then_some(low * step));
            crowded.halve(low * step, step, &mut levels);
        }
        levels.retain(|level| least < *level && *level < greatest);
        if levels.is_empty() {
            levels.push(first * step + step);
        }
        Self(levels)
    }

    /// Takes a list of levels.
    ///
    /// # Errors
    /// When there are none or too many, or when they do not rise from one to the next.
    pub fn listed(levels: &[f64]) -> Result<Self, String> {
        let rise = levels.windows(2).all(|pair| pair[0] < pair[1]);
        let are_finite = levels.iter().all(|level| level.is_finite());
        if rise && are_finite && (1..=Self::MOST).contains(&levels.len()) {
            return Ok(Self(levels.to_vec()));
        }
        Err(format!(
            "expected 1 to {} velocities, each greater than the one before",
            Self::MOST
        ))
    }

    /// The levels, rising.
    pub fn values(&self) -> &[f64] {
        &self.0
    }

    /// Lower and upper end of every band of colour.
    pub fn bands(&self) -> Vec<[f64; 2]> {
        let ends = || self.0.iter().copied();
        let lows = std::iter::once(f64::NEG_INFINITY).chain(ends());
        let highs = ends().chain([f64::INFINITY]);
        lows.zip(highs).map(|(low, high)| [low, high]).collect()
    }

    /// Colour of a velocity, that of its band.
    pub fn colour(&self, speed: f64) -> Colour {
        let below = self.0.partition_point(|level| *level <= speed);
        let part = below as f64 / self.0.len().max(1) as f64;
        let upper = ENDS
            .partition_point(|(end, _)| *end < part)
            .clamp(1, ENDS.len() - 1);
        let ((a, low), (b, high)) = (ENDS[upper - 1], ENDS[upper]);
        let weight = (part - a) / (b - a);
        let [r, g, b] = [0, 1, 2].map(|i| (low[i] + weight * (high[i] - low[i])).round() as u8);
        Colour(r, g, b)
    }
}

/// Velocities with their weights, and the share of the total beyond which an interval is crowded.
struct Crowded<'h> {
    heights: &'h [(f64, f64)],
    share: f64,
    total: f64,
}

impl Crowded<'_> {
    /// Adds levels within an interval while its parts are crowded and their width is round.
    fn halve(&self, low: f64, width: f64, levels: &mut Vec<f64>) {
        let inside = |(height, _): &&(f64, f64)| (low..low + width).contains(height);
        let weights = self.heights.iter().filter(inside).map(|(_, weight)| weight);
        if weights.sum::<f64>() / self.total > self.share && is_round(0.5 * width) {
            let middle = low + 0.5 * width;
            self.halve(low, 0.5 * width, levels);
            levels.push(middle);
            self.halve(middle, 0.5 * width, levels);
        }
    }
}

/// Returns whether a width is 1, 2, 2.5 or 5 times a power of ten.
fn is_round(width: f64) -> bool {
    let digits = width / exp10(log10(width).floor());
    [1.0, 2.0, 2.5, 5.0, 10.0]
        .iter()
        .any(|round| (digits - round).abs() < 1e-6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::{example, grid};

    #[test]
    fn no_level_is_that_of_an_end_however_crowded_it_is() {
        for turn in [0.0, 11.0] {
            let crowd = (0..200).map(|index| 10.0 + 0.0025 * f64::from(index));
            let heights = (0..=21).map(|index| 0.5 * f64::from(index)).chain(crowd);
            let heights: Vec<f64> = heights.map(|height| (turn - height).abs()).collect();
            let ends = heights.iter().copied();
            let ends = ends.clone().reduce(f64::min).zip(ends.reduce(f64::max));
            let (least, greatest) = ends.unwrap();
            let levels = Levels::through(&heights);
            let is_inside = |level: &f64| least < *level && *level < greatest;
            assert!(levels.values().iter().all(is_inside), "{levels:?}");
        }
    }

    #[test]
    fn levels_are_round_lie_between_the_ends_and_are_closer_where_the_points_are() {
        assert_eq!(
            Levels::of(&example()).values(),
            [12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0, 20.0]
        );
        // A map of other vehicles, and one of small differences.
        let spread = |low: f64, high: f64| {
            let at = |index: usize| low + (high - low) * index as f64 / 35.0;
            Levels::of(&grid(6, |row, column| Some(at(6 * row + column))))
        };
        assert_eq!(
            spread(6.9, 11.3).values(),
            [7.0, 7.5, 8.0, 8.5, 9.0, 9.5, 10.0, 10.5, 11.0]
        );
        let crowded = grid(10, |row, column| {
            let index = (10 * row + column) as f64;
            Some(if row < 8 {
                10.0 + index / 80.0
            } else {
                index / 4.0
            })
        });
        assert_eq!(
            Levels::of(&crowded).values(),
            [
                10.25, 10.5, 10.75, 11.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 24.0
            ]
        );
        assert!((5..=12).contains(&spread(3.01, 3.02).values().len()));
        assert_eq!(spread(12.0, 12.0).values().len(), 1);
    }

    #[test]
    fn levels_are_few_whatever_the_points_are() {
        for outlier in [13.0, 50.0, 1e3, 1e9, 1e300] {
            let height = |row, column| {
                let speed = 11.0 + 0.1 * (row + column) as f64;
                Some(if row + column == 0 { outlier } else { speed })
            };
            let levels = Levels::of(&grid(8, height));
            assert!((1..=Levels::MOST).contains(&levels.values().len()));
        }
    }

    #[test]
    fn lightness_rises_with_speed() {
        let levels = Levels::listed(&[1.0, 2.0, 3.0, 5.0]).unwrap();
        let light = |speed: f64| {
            let Colour(r, g, b) = levels.colour(speed);
            0.3 * f64::from(r) + 0.59 * f64::from(g) + 0.11 * f64::from(b)
        };
        let lights = [0.5, 1.5, 2.5, 4.0, 6.0].map(light);
        assert!(lights.windows(2).all(|pair| pair[0] < pair[1]));
        for refused in [&[][..], &[2.0, 1.0], &[1.0, 1.0], &[f64::NAN], &[0.5; 31]] {
            assert!(Levels::listed(refused).unwrap_err().contains("1 to 30"));
        }
    }
}
