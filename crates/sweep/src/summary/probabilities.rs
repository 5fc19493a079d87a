//! Counts of outcomes, with probabilities for a sample.
//!
//! Intervals are Wilson's score intervals at 95 %. They hold for independent landings, and at least as well for a Latin
//! hypercube or a Sobol sequence.

use touchdown_dynamics::outcome::Class;
use touchdown_input::documents::column::{Cell, Column, Heading, Kind, cells, headings};
use touchdown_input::points::distribution::Distribution;
use touchdown_input::points::sample::Sample;
use touchdown_input::sweeps::sweep_file::Sweep;

/// Normal quantile of 97.5 %.
const Z: f64 = 1.959_963_984_540_054;
/// Number of bins of an axis.
const BINS: usize = 10;
/// Landings between two checks of whether the intervals are narrow enough.
const PACE: u64 = 100;

/// Landings in a bin of an axis.
#[derive(Debug, Clone)]
pub struct InBin {
    /// Name of the axis in the units of results.
    axis: String,
    /// Lower and upper end in the units of results.
    ends: [Cell; 2],
    count: Count,
}

/// Columns of the table of probabilities: number, share and interval of each class of landings, and last of all that
/// were not stable.
pub fn columns() -> Vec<Column<InBin>> {
    let mut columns = vec![
        Column::word(
            "axis",
            |bin: &InBin| bin.axis.clone(),
            "`all`, or the name of the parameter",
        ),
        Column::either(
            "from",
            |bin: &InBin| bin.ends[0].clone(),
            "lower end of the bin; empty: unbounded",
        )
        .in_unit("of the axis"),
        Column::either(
            "to",
            |bin: &InBin| bin.ends[1].clone(),
            "upper end of the bin; empty: unbounded",
        )
        .in_unit("of the axis"),
        Column::count("landings", |bin| bin.count.landings, "landings in the bin"),
    ];
    columns.extend(of_class::<TOPPLED>(
        [
            "toppled",
            "topple_probability",
            "topple_low_95",
            "topple_high_95",
        ],
        [
            "of these, toppled in pitch or yaw",
            "`toppled` over `landings`",
        ],
    ));
    columns.extend(of_class::<BOTTOMED>(
        [
            "bottomed",
            "bottom_probability",
            "bottom_low_95",
            "bottom_high_95",
        ],
        [
            "of the landings, those that bottomed a strut, or crushed a footpad or block by its whole height",
            "`bottomed` over `landings`",
        ],
    ));
    columns.extend(of_class::<UNDECIDED>(
        [
            "undecided",
            "undecided_probability",
            "undecided_low_95",
            "undecided_high_95",
        ],
        [
            "of the landings, those that slide or still move at the time limit",
            "`undecided` over `landings`",
        ],
    ));
    columns.extend(of_class::<FAILED>(
        [
            "failed",
            "failure_probability",
            "failure_low_95",
            "failure_high_95",
        ],
        [
            "of the landings, those that could not be computed",
            "`failed` over `landings`",
        ],
    ));
    columns.extend(of_class::<NOT_STABLE>(
        [
            "not_stable",
            "not_stable_probability",
            "not_stable_low_95",
            "not_stable_high_95",
        ],
        [
            "all landings that did not end stable: the four classes before together",
            "`not_stable` over `landings`",
        ],
    ));
    columns
}

/// Classes of landings, as indices of [`Count::hits`].
const TOPPLED: usize = 0;
const BOTTOMED: usize = 1;
const UNDECIDED: usize = 2;
const FAILED: usize = 3;
const NOT_STABLE: usize = 4;

/// Columns of a class of landings: number, share, and interval.
fn of_class<const CLASS: usize>(
    [number, share, low, high]: [&'static str; 4],
    [about_number, about_share]: [&'static str; 2],
) -> [Column<InBin>; 4] {
    [
        Column::count(number, |bin| bin.count.hits()[CLASS], about_number),
        Column::number(share, |bin| bin.count.share(CLASS), about_share),
        Column::number(
            low,
            |bin| Some(bin.count.interval(CLASS)[0]),
            "lower end of its interval",
        ),
        Column::number(
            high,
            |bin| Some(bin.count.interval(CLASS)[1]),
            "upper end of its interval",
        ),
    ]
}

/// Headings of the table of probabilities.
pub fn heading(sweep: &Sweep) -> Vec<Heading> {
    let mut all: Vec<Heading> = headings(&columns(), sweep.leg_count()).collect();
    // Ends of bins are words for an axis with words.
    if sweep.axes.iter().any(|axis| !axis.words().is_empty()) {
        for end in &mut all[1..=2] {
            end.kind = Kind::Word;
        }
    }
    all
}

/// Landings counted by class.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Count {
    /// All landings.
    pub landings: u64,
    /// Toppled.
    pub toppled: u64,
    /// Bottomed.
    pub bottomed: u64,
    /// Still moving at the time limit.
    pub undecided: u64,
    /// Could not be computed.
    pub failed: u64,
}

impl Count {
    /// Adds a landing.
    pub fn add(&mut self, class: Class) {
        self.landings += 1;
        match class {
            Class::Stable => {}
            Class::Unstable => self.toppled += 1,
            Class::Bottomed => self.bottomed += 1,
            Class::Failure => self.failed += 1,
            Class::Undecided => self.undecided += 1,
        }
    }

    /// Number of stable landings.
    pub fn stable(&self) -> u64 {
        self.landings - self.toppled - self.bottomed - self.undecided - self.failed
    }

    /// True if the intervals of the probabilities of toppling and bottoming are no wider than `width`.
    pub fn is_enough(&self, width: f64) -> bool {
        let narrow = |hits| {
            let [low, high] = wilson(hits, self.landings);
            high - low <= width
        };
        self.landings > 0
            && self.landings.is_multiple_of(PACE)
            && narrow(self.toppled)
            && narrow(self.bottomed)
    }

    /// Landings of each class but the stable ones, and of these together.
    fn hits(&self) -> [u64; 5] {
        [
            self.toppled,
            self.bottomed,
            self.undecided,
            self.failed,
            self.landings - self.stable(),
        ]
    }

    /// Share of a class; `None` without landings.
    fn share(&self, class: usize) -> Option<f64> {
        let hits = self.hits()[class] as f64;
        (self.landings > 0).then(|| hits / self.landings as f64)
    }

    /// Interval of the probability of a class.
    fn interval(&self, class: usize) -> [f64; 2] {
        wilson(self.hits()[class], self.landings)
    }
}

/// Wilson's score interval at 95 % of the probability of `hits` in `trials`.
pub fn wilson(hits: u64, trials: u64) -> [f64; 2] {
    if trials == 0 {
        return [0.0, 1.0];
    }
    let (n, p) = (trials as f64, hits as f64 / trials as f64);
    let middle = p + Z * Z / (2.0 * n);
    let half = Z * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + Z * Z / n;
    // Without hits, or with hits only, rounding must not move the ends from 0 and 1.
    let low = if hits == 0 {
        0.0
    } else {
        (middle - half) / scale
    };
    let high = if hits == trials {
        1.0
    } else {
        (middle + half) / scale
    };
    [low, high]
}

/// Landings of a sample counted over bins of each axis.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Probabilities {
    axes: Vec<Bins>,
}

/// Counts over bins of one axis.
#[derive(Debug, Clone, PartialEq)]
struct Bins {
    /// Lower and upper ends as cells of tables.
    ends: Vec<[Cell; 2]>,
    /// Lower ends of all bins but the first.
    edges: Vec<f64>,
    counts: Vec<Count>,
}

impl Probabilities {
    /// Empty counts for the bins of a sample.
    pub fn none(sweep: &Sweep, sample: &Sample) -> Self {
        let axes = sweep.axes.iter().zip(sample.axes());
        Self {
            axes: axes
                .map(|(axis, sampled)| {
                    Bins::of_distribution(&sampled.marginal(), |value| axis.cell(value))
                })
                .collect(),
        }
    }

    /// Adds a landing at coordinates, one for each axis.
    pub fn add(&mut self, coordinates: &[f64], class: Class) {
        for (bins, value) in self.axes.iter_mut().zip(coordinates) {
            let bin = bins.edges.partition_point(|edge| edge <= value);
            bins.counts[bin].add(class);
        }
    }

    /// Rows of their table: all landings, counted separately, then each bin of every axis.
    pub fn rows(&self, sweep: &Sweep, overall: &Count) -> Vec<Vec<Cell>> {
        let columns = columns();
        let row = |axis: &str, ends: [Cell; 2], count: &Count| {
            let bin = InBin {
                axis: axis.to_owned(),
                ends,
                count: *count,
            };
            cells(&columns, &bin, sweep.leg_count()).collect()
        };
        let mut rows = vec![row("all", [Cell::Empty, Cell::Empty], overall)];
        for (axis, bins) in sweep.axes.iter().zip(&self.axes) {
            let axis = sweep.units.quantity(axis.name());
            for (ends, count) in bins.ends.iter().zip(&bins.counts) {
                let ends = ends.clone().map(|end| axis.cell(end));
                rows.push(row(axis.name(), ends, count));
            }
        }
        rows
    }
}

impl Bins {
    fn of_distribution(distribution: &Distribution, written: impl Fn(f64) -> Cell) -> Self {
        if let Distribution::Column(values) = distribution {
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            return Self::between(least, most, written);
        }
        let edges = (1..BINS).map(|bin| distribution.quantile(bin as f64 / BINS as f64));
        let outer = match *distribution {
            Distribution::Uniform { from, to }
            | Distribution::LogUniform { from, to }
            | Distribution::Truncated { from, to, .. }
            | Distribution::Triangular { from, to, .. } => [written(from), written(to)],
            Distribution::Lognormal { .. } | Distribution::Rayleigh { .. } => {
                [written(0.0), Cell::Empty]
            }
            Distribution::Normal { .. } | Distribution::Column(_) => [Cell::Empty, Cell::Empty],
        };
        Self::by_edges(edges.collect(), outer, written)
    }

    /// Bins of equal width.
    fn between(from: f64, to: f64, written: impl Fn(f64) -> Cell) -> Self {
        let width = (to - from) / BINS as f64;
        let edges = (1..BINS).map(|bin| from + bin as f64 * width).collect();
        Self::by_edges(edges, [written(from), written(to)], written)
    }

    fn by_edges(edges: Vec<f64>, [from, to]: [Cell; 2], written: impl Fn(f64) -> Cell) -> Self {
        let inner: Vec<Cell> = edges.iter().map(|edge| written(*edge)).collect();
        let lower = std::iter::once(from).chain(inner.iter().cloned());
        let upper = inner.iter().cloned().chain([to]);
        Self::with(lower.zip(upper).map(|(a, b)| [a, b]).collect(), edges)
    }

    fn with(ends: Vec<[Cell; 2]>, edges: Vec<f64>) -> Self {
        let counts = vec![Count::default(); ends.len()];
        Self {
            ends,
            edges,
            counts,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::distribution::{Binomial, Discrete};

    #[test]
    fn intervals_are_those_of_the_books() {
        // Newcombe (1998), table I, method 3.
        for (hits, trials, expected) in [
            (81, 263, [0.2553, 0.3662]),
            (15, 148, [0.0624, 0.1605]),
            (0, 20, [0.0, 0.1611]),
            (1, 29, [0.0061, 0.1718]),
        ] {
            for (end, expected) in wilson(hits, trials).iter().zip(expected) {
                assert!((end - expected).abs() < 5e-5, "{hits}/{trials}: {end}");
            }
        }
        assert_eq!(wilson(20, 20)[1], 1.0);
        assert_eq!(wilson(0, 0), [0.0, 1.0]);
    }

    /// The exact share of all samples whose interval contains the probability; for Wilson's intervals it is 95 % on
    /// average over probabilities.
    #[test]
    fn intervals_hold_the_probability_in_95_of_100_samples() {
        for trials in [50, 400] {
            let coverage = |probability: f64| -> f64 {
                let drawn = Binomial::new(probability, trials).unwrap();
                (0..=trials)
                    .filter(|hits| {
                        let [low, high] = wilson(*hits, trials);
                        low <= probability && probability <= high
                    })
                    .map(|hits| drawn.pmf(hits))
                    .sum()
            };
            let coverages: Vec<f64> = (1..100).map(|k| coverage(0.01 * f64::from(k))).collect();
            let mean = coverages.iter().sum::<f64>() / coverages.len() as f64;
            assert!((0.945..0.96).contains(&mean), "{trials}: {mean}");
            let is_close = |coverage: &&f64| (0.93..0.97).contains(*coverage);
            let close = coverages.iter().filter(is_close).count();
            assert!(close > 80, "{trials}: {close} of 99");
        }
    }

    #[test]
    fn enough_is_asked_for_every_hundred_landings_of_toppling_and_of_bottoming() {
        let landed = |class: Class| {
            let mut count = Count::default();
            let mut landings = 0;
            while !count.is_enough(0.1) {
                count.add(if landings % 10 == 0 {
                    class
                } else {
                    Class::Stable
                });
                landings += 1;
            }
            landings
        };
        // Without a hit the interval is narrow enough after the first hundred.
        assert_eq!(landed(Class::Stable), 100);
        assert_eq!(landed(Class::Unstable), 200);
        assert_eq!(landed(Class::Bottomed), 200);
    }

    /// Ends of the bin that counts a value.
    fn bin_of(bins: &Bins, value: f64) -> [Cell; 2] {
        let mut probabilities = Probabilities {
            axes: vec![bins.clone()],
        };
        probabilities.add(&[value], Class::Unstable);
        let counts = probabilities.axes[0].counts.iter();
        let hit: Vec<usize> = (counts.enumerate())
            .filter(|(_, count)| count.toppled == 1)
            .map(|(bin, _)| bin)
            .collect();
        assert_eq!(hit.len(), 1, "{value}");
        bins.ends[hit[0]].clone()
    }

    #[test]
    fn every_value_falls_in_the_bin_that_names_it() {
        let written = Cell::Number;
        let even = Distribution::uniform(0.0, 100.0, false).unwrap();
        let tenths = Bins::of_distribution(&even, written);
        let normal = Distribution::normal(0.0, 1.0, None).unwrap();
        let normal = Bins::of_distribution(&normal, written);
        let column = Distribution::Column(vec![3.0, -2.0, 8.0]);
        let column = Bins::of_distribution(&column, written);
        for (bins, values) in [
            (&tenths, vec![0.0, 9.5, 10.0, 55.0, 99.0, 100.0]),
            (&normal, vec![-9.0, -1.0, 0.0, 0.3, 9.0]),
            (&column, vec![-2.0, 0.1, 3.0, 8.0]),
        ] {
            assert_eq!(bins.ends.len(), 10);
            for value in values {
                let number = |end: &Cell| match end {
                    Cell::Number(number) => Some(*number),
                    _ => None,
                };
                let [from, to] = bin_of(bins, value).each_ref().map(number);
                let is_last = number(&bins.ends.last().unwrap()[1]) == to;
                assert!(from.is_none_or(|from| from <= value), "{value}: {from:?}");
                assert!(
                    to.is_none_or(|to| value < to || is_last && value <= to),
                    "{value}: {to:?}"
                );
            }
        }
        assert_eq!(tenths.ends[9], [90.0, 100.0].map(Cell::Number));
        assert_eq!((&normal.ends[0][0], normal.edges[4]), (&Cell::Empty, 0.0));
    }
}
