//! The transition velocities of a sample: quantiles and distribution.
//!
//! A point whose first transition lies at or below the lowest speed searched, or above the highest, counts as below or
//! above all others. Intervals hold at 95 % for independent points, and at least as well for a Latin hypercube or a
//! Sobol sequence. For quantiles they lie between two points of the sorted sample, whatever the distribution; for
//! cumulative shares they are Wilson's.

use statrs::distribution::{Binomial, DiscreteCDF};
use touchdown_input::documents::column::{Cell, Column, cells};
use touchdown_input::points::levels::rounded;
use touchdown_search::boundary::Boundary;
use touchdown_search::search_range::Search;

use crate::summary::probabilities::wilson;

/// Shares whose quantiles are listed.
pub const SHARES: [f64; 11] = [
    0.005, 0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 0.995,
];

/// Columns of the table of quantiles.
pub const QUANTILE_COLUMNS: [Column<Quantile>; 5] = [
    Column::number(
        "share",
        |one| Some(one.share),
        "share of the points whose transition lies at or below the quantile",
    ),
    Column::number(
        "transition_fps",
        |one| match one.speed {
            Rank::AtOrBelow(speed) | Rank::Speed(speed) | Rank::Above(speed) => Some(speed),
        },
        "the quantile: the least V_H at or below which that share lies",
    ),
    Column::word(
        "certainty",
        |one| match one.speed {
            Rank::AtOrBelow(_) => AT_OR_BELOW.to_owned(),
            Rank::Speed(_) => String::new(),
            Rank::Above(_) => ABOVE.to_owned(),
        },
        "`at-or-below`: the quantile lies at or below `from_fps`; `above`: it lies above `to_fps`; empty: it is a \
         transition",
    ),
    Column::number(
        "low_95_fps",
        |one| speed_of(one.interval[0]),
        "lower end of its interval; empty: unknown",
    ),
    Column::number(
        "high_95_fps",
        |one| speed_of(one.interval[1]),
        "upper end of its interval; empty: unknown",
    ),
];

/// Transition velocities in a bin of their distribution.
#[derive(Debug, Clone, Copy)]
pub struct InBin {
    from: Option<f64>,
    to: Option<f64>,
    /// Number in the bin, in it and all below, and of all points.
    points: u64,
    cumulative: u64,
    all: u64,
}

/// Columns of the table of the distribution.
pub const DISTRIBUTION_COLUMNS: [Column<InBin>; 7] = [
    Column::number(
        "from_fps",
        |bin| bin.from,
        "lower end of the bin, not in it",
    ),
    Column::number("to_fps", |bin| bin.to, "upper end of the bin, in it"),
    Column::count("points", |bin| bin.points, "points in the bin"),
    Column::number(
        "share",
        |bin| Some(bin.points as f64 / bin.all as f64),
        "`points` over all points",
    ),
    Column::number(
        "cumulative_share",
        |bin| Some(bin.cumulative as f64 / bin.all as f64),
        "share of the points at or below `to_fps`",
    ),
    Column::number(
        "cumulative_low_95",
        |bin| Some(wilson(bin.cumulative, bin.all)[0]),
        "lower end of its interval (Wilson, 95 %)",
    ),
    Column::number(
        "cumulative_high_95",
        |bin| Some(wilson(bin.cumulative, bin.all)[1]),
        "upper end of its interval",
    ),
];

/// Word for a transition at or below the lowest speed searched.
pub const AT_OR_BELOW: &str = "at-or-below";
/// Word for no transition up to the highest speed searched.
pub const ABOVE: &str = "above";

/// Probability that a quantile lies below its interval; the same above it.
const TAIL: f64 = 0.025;
/// Approximate number of bins of a distribution.
const BINS: f64 = 20.0;

/// First transitions of the points of a sample.
#[derive(Debug, Clone, PartialEq)]
pub struct TransitionStatistics {
    from: f64,
    to: f64,
    at_or_below: usize,
    above: usize,
    /// Transition velocities in between, ft/s.
    speeds: Vec<f64>,
}

/// A quantile of the transition velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantile {
    /// Share of the points with a transition at or below it.
    pub share: f64,
    /// The velocity.
    pub speed: Rank,
    /// Ends of its interval at 95 %; `None` where the sample has too few points for that end.
    pub interval: [Option<Rank>; 2],
}

/// The velocity of one point of the sorted sample, ft/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rank {
    /// At or below the lowest speed searched.
    AtOrBelow(f64),
    /// A transition.
    Speed(f64),
    /// Above the highest speed searched.
    Above(f64),
}

impl TransitionStatistics {
    /// Empty statistics.
    pub fn none(search: &Search) -> Self {
        Self {
            from: search.from,
            to: search.to,
            at_or_below: 0,
            above: 0,
            speeds: Vec::new(),
        }
    }

    /// Adds a point.
    pub fn add(&mut self, boundary: &Boundary) {
        match boundary.transition {
            None => self.above += 1,
            Some(transition) if transition.low.is_none() => self.at_or_below += 1,
            Some(transition) => self.speeds.push(transition.speed()),
        }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.at_or_below + self.speeds.len() + self.above
    }

    fn sorted(&self) -> Vec<f64> {
        let mut sorted = self.speeds.clone();
        sorted.sort_by(f64::total_cmp);
        sorted
    }

    /// Quantiles at shares between 0 and 1; none without points.
    pub fn quantiles(&self, shares: &[f64]) -> Vec<Quantile> {
        let points = self.points();
        if points == 0 {
            return Vec::new();
        }
        let sorted = self.sorted();
        let rank = |index: usize| match index.checked_sub(self.at_or_below) {
            None => Rank::AtOrBelow(self.from),
            Some(index) => sorted
                .get(index)
                .map_or(Rank::Above(self.to), |speed| Rank::Speed(*speed)),
        };
        let quantile = |share: &f64| {
            let [low, high] = interval_of(*share, points);
            // A billionth forgives the rounding of products such as 0.07 · 100.
            let place = (share * points as f64 - 1e-9).ceil().max(1.0) as usize;
            Quantile {
                share: *share,
                speed: rank(place - 1),
                interval: [low.map(rank), high.map(rank)],
            }
        };
        shares.iter().map(quantile).collect()
    }

    /// Rows of the table of quantiles.
    pub fn quantile_rows(&self) -> Vec<Vec<Cell>> {
        let quantiles = self.quantiles(&SHARES);
        let row = |one| cells(&QUANTILE_COLUMNS, one, 0).collect();
        quantiles.iter().map(row).collect()
    }

    /// Rows of the table of the distribution: points at or below the lowest speed searched; bins of equal width, each
    /// open at its lower end and closed at its upper end; points above the highest speed searched.
    pub fn distribution_rows(&self) -> Vec<Vec<Cell>> {
        let mut cumulative = 0;
        let mut row = |from: Option<f64>, to: Option<f64>, points: usize| {
            let points = points as u64;
            cumulative += points;
            let bin = InBin {
                from,
                to,
                points,
                cumulative,
                all: self.points() as u64,
            };
            cells(&DISTRIBUTION_COLUMNS, &bin, 0).collect()
        };
        let mut rows = Vec::new();
        if self.at_or_below > 0 {
            rows.push(row(None, Some(self.from), self.at_or_below));
        }
        let sorted = self.sorted();
        let mut counted = 0;
        let edges = edges(&sorted);
        for pair in edges.windows(2) {
            let is_last = Some(&pair[1]) == edges.last();
            let upto = match is_last {
                true => sorted.len(),
                false => sorted.partition_point(|speed| *speed <= pair[1]),
            };
            rows.push(row(Some(pair[0]), Some(pair[1]), upto - counted));
            counted = upto;
        }
        if self.above > 0 {
            rows.push(row(Some(self.to), None, self.above));
        }
        rows
    }
}

/// Speed of a rank that is one.
fn speed_of(rank: Option<Rank>) -> Option<f64> {
    match rank {
        Some(Rank::Speed(speed)) => Some(speed),
        _ => None,
    }
}

/// Indices, from 0, of the sorted points that enclose the quantile at a share with a probability of 95 %.
fn interval_of(share: f64, points: usize) -> [Option<usize>; 2] {
    let Ok(below) = Binomial::new(share, points as u64) else {
        return [None, None];
    };
    // The quantile is below point k (from 1) if fewer than k points are below it.
    let low = (below.inverse_cdf(TAIL) as usize).checked_sub(1);
    let high = below.inverse_cdf(1.0 - TAIL) as usize;
    [low, (high < points).then_some(high)]
}

/// Edges of some twenty bins of a round width around sorted numbers, each open at its lower end and closed at its upper end.
pub fn edges(sorted: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (sorted.first(), sorted.last()) else {
        return Vec::new();
    };
    let rough = ((last - first) / BINS).max(1e-6);
    let power = libm::exp10(libm::log10(rough).floor());
    let width = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let width = width
        .into_iter()
        .find(|width| *width >= rough)
        .unwrap_or(10.0 * power);
    // Speeds lie above the lower edge of their bin.
    let from = (first / width).ceil() as i64 - 1;
    let to = (last / width).ceil() as i64;
    (from..=to)
        .map(|edge| rounded(edge as f64 * width))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::text;
    use touchdown_dynamics::outcome::Class;
    use touchdown_search::boundary::Transition;
    use touchdown_search::certainty::Certainty;

    fn statistics(speeds: impl Iterator<Item = f64>) -> TransitionStatistics {
        TransitionStatistics {
            from: 5.0,
            to: 20.0,
            at_or_below: 0,
            above: 0,
            speeds: speeds.collect(),
        }
    }

    /// Conover, Practical Nonparametric Statistics: the interval of the median of ten reaches from the second to the
    /// ninth.
    #[test]
    fn intervals_of_quantiles_are_those_of_the_books() {
        assert_eq!(interval_of(0.5, 10), [Some(1), Some(8)]);
        assert_eq!(interval_of(0.5, 5), [None, None]);
        // 59 points are the fewest whose least is below the 5 % quantile with 95 %, one-sided; two-sided it takes 72.
        assert_eq!(interval_of(0.05, 71)[0], None);
        assert_eq!(interval_of(0.05, 72)[0], Some(0));
    }

    /// For many samples of a known distribution at least 95 % of the intervals contain its quantile.
    #[test]
    fn intervals_hold_what_they_promise() {
        let (count, samples) = (100, 400);
        for share in [0.1, 0.5, 0.9] {
            let mut held = 0;
            for sample in 0..samples {
                let random = |index: usize| {
                    let mixed =
                        ((sample * count + index) as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                    let mixed = (mixed ^ (mixed >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
                    (mixed >> 11) as f64 / (1u64 << 53) as f64
                };
                let speeds = statistics((0..count).map(random));
                let [low, high] = speeds.quantiles(&[share])[0].interval;
                let (Some(Rank::Speed(low)), Some(Rank::Speed(high))) = (low, high) else {
                    panic!("the interval has both ends");
                };
                held += usize::from(low <= share && share <= high);
            }
            // Three standard deviations of the count below 95 %.
            let least = 0.95 - 3.0 * (0.95f64 * 0.05 / samples as f64).sqrt();
            assert!(
                held as f64 >= least * samples as f64,
                "{share}: {held} of {samples}"
            );
        }
    }

    #[test]
    fn points_beyond_the_search_count_below_and_above() {
        let mut all = statistics((1..=96).map(f64::from));
        let open = Boundary {
            transition: Some(Transition {
                to: Class::Bottomed,
                low: None,
                high: 5.0,
                tolerance: 3e-5,
                certainty: Certainty::Untested,
            }),
            ..Boundary::default()
        };
        for _ in 0..2 {
            all.add(&open);
            all.add(&Boundary::default());
        }
        let speeds: Vec<Rank> = all
            .quantiles(&[0.02, 0.03, 0.5, 0.98, 0.99])
            .iter()
            .map(|q| q.speed)
            .collect();
        let expected = [
            Rank::AtOrBelow(5.0),
            Rank::Speed(1.0),
            Rank::Speed(48.0),
            Rank::Speed(96.0),
            Rank::Above(20.0),
        ];
        assert_eq!(speeds, expected);
        let rows = all.distribution_rows();
        assert!(text(rows[0].clone()).starts_with(",5,2,0.02,0.02,"));
        let last = &rows[rows.len() - 1];
        assert!(text(last.clone()).starts_with("20,,2,0.02,1,"));
        let counted: u64 = rows
            .iter()
            .map(|row| match row[2] {
                Cell::Count(count) => count,
                ref other => panic!("{other:?}"),
            })
            .sum();
        assert_eq!(counted, 100);
    }

    #[test]
    fn bins_have_round_edges_around_all_speeds() {
        assert_eq!(edges(&[10.0, 11.3, 14.0])[..3], [9.8, 10.0, 10.2]);
        assert_eq!(edges(&[10.0, 11.3, 14.0]).last(), Some(&14.0));
        assert_eq!(edges(&[2.0]).len(), 2);
        assert!(edges(&[]).is_empty());
    }
}
