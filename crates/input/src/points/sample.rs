//! Sampling designs.
//!
//! A point follows from its index and the seed alone, so shards and resumed runs draw the same points.

use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::points::distribution::{Distribution, standard_quantile};
use crate::points::grid::MOST_POINTS;
use crate::points::levels::rounded;

/// Method of drawing the points of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SampleDesign {
    /// Independent points.
    MonteCarlo,
    /// As many strata of equal probability as points along every axis, with one point each.
    LatinHypercube,
    /// A low-discrepancy sequence, scrambled after Owen.
    Sobol,
}

impl SampleDesign {
    /// All designs.
    pub const ALL: [Self; 3] = [Self::MonteCarlo, Self::LatinHypercube, Self::Sobol];

    /// Word in sweep files.
    pub fn name(self) -> &'static str {
        match self {
            Self::MonteCarlo => "monte-carlo",
            Self::LatinHypercube => "latin-hypercube",
            Self::Sobol => "sobol",
        }
    }

    /// True if the first points are the same for any number of points, so that a sample can grow.
    pub fn is_nested(self) -> bool {
        match self {
            Self::MonteCarlo | Self::Sobol => true,
            Self::LatinHypercube => false,
        }
    }

    /// Greatest number of points.
    pub fn most_points(self) -> usize {
        match self {
            Self::MonteCarlo => MOST_POINTS,
            // Its strata are shuffled in memory.
            Self::LatinHypercube => 1_000_000,
            // The sequence has no more.
            Self::Sobol => 1 << 16,
        }
    }

    /// Greatest number of axes.
    pub fn most_axes(self) -> usize {
        match self {
            Self::Sobol => sobol_burley::NUM_DIMENSIONS as usize,
            Self::MonteCarlo | Self::LatinHypercube => usize::MAX,
        }
    }
}

/// Rule by which an axis draws its value from the random numbers of a point.
#[derive(Debug, Clone, PartialEq)]
pub enum SampledAxis {
    /// From a distribution, by one random number. Axes with the same number move together.
    Single {
        /// The distribution.
        distribution: Distribution,
        /// Index of the random number.
        number: usize,
    },
    /// One of several jointly normal axes: mean + Σ factor · z, with a standard normal z for each random number.
    Joint {
        /// The mean.
        mean: f64,
        /// Indices of random numbers, and their factors.
        factors: Vec<(usize, f64)>,
        /// Indices of the jointly normal axes, itself included, and the covariance with each.
        covariances: Vec<(usize, f64)>,
    },
}

impl SampledAxis {
    /// Marginal distribution of this axis.
    pub fn marginal(&self) -> Distribution {
        match self {
            Self::Single { distribution, .. } => distribution.clone(),
            Self::Joint { mean, factors, .. } => Distribution::Normal {
                mean: *mean,
                deviation: factors.iter().map(|(_, f)| f * f).sum::<f64>().sqrt(),
            },
        }
    }

    /// Greatest index of the random numbers that it uses.
    fn last_number(&self) -> usize {
        match self {
            Self::Single { number, .. } => *number,
            Self::Joint { factors, .. } => factors.iter().map(|(n, _)| *n).max().unwrap_or(0),
        }
    }

    /// Value of the axis for the random numbers of a point.
    fn value(&self, random: impl Fn(usize) -> f64) -> f64 {
        match self {
            Self::Single {
                distribution,
                number,
            } => distribution.quantile(random(*number)),
            Self::Joint { mean, factors, .. } => {
                let deviation =
                    |(number, factor): &(usize, f64)| factor * standard_quantile(random(*number));
                rounded(mean + factors.iter().map(deviation).sum::<f64>())
            }
        }
    }
}

/// Points sampled from distributions.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    axes: Vec<SampledAxis>,
    design: SampleDesign,
    count: usize,
    seed: u64,
    /// For each random number, the stratum of each point, if there are strata.
    strata: Vec<Vec<u32>>,
}

impl Sample {
    /// Draws `count` points, at most as many as the design allows, over axes in the order of their parameters.
    pub fn new(axes: Vec<SampledAxis>, design: SampleDesign, count: usize, seed: u64) -> Self {
        let numbers = axes
            .iter()
            .map(|axis| axis.last_number() + 1)
            .max()
            .unwrap_or(0);
        let strata = match design {
            SampleDesign::LatinHypercube => {
                (0..numbers).map(|n| shuffled(count, seed, n)).collect()
            }
            SampleDesign::MonteCarlo | SampleDesign::Sobol => Vec::new(),
        };
        Self {
            axes,
            design,
            count,
            seed,
            strata,
        }
    }

    /// The axes, in the given order.
    pub fn axes(&self) -> &[SampledAxis] {
        &self.axes
    }

    /// Method of drawing the points.
    pub fn design(&self) -> SampleDesign {
        self.design
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The seed.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Coordinates of the `index`-th point, from 0, one for each axis.
    pub fn coordinates(&self, index: usize) -> Vec<f64> {
        let draw = |axis: &SampledAxis| axis.value(|number| self.number(index, number));
        self.axes.iter().map(draw).collect()
    }

    /// Random number `number` of a point, above 0 and below 1.
    fn number(&self, index: usize, number: usize) -> f64 {
        match self.design {
            SampleDesign::MonteCarlo => random(self.seed, number, index),
            SampleDesign::LatinHypercube => {
                let stratum = f64::from(self.strata[number][index]);
                (stratum + random(self.seed, number, index)) / self.count as f64
            }
            SampleDesign::Sobol => {
                let seed = (self.seed ^ (self.seed >> 32)) as u32;
                let x = f64::from(sobol_burley::sample(index as u32, number as u32, seed));
                // The middle of the 2^-24 that the sequence resolves.
                x + f64::from(f32::EPSILON) / 4.0
            }
        }
    }
}

/// The `index`-th number, above 0 and below 1, of a stream of random numbers.
fn random(seed: u64, stream: usize, index: usize) -> f64 {
    const WORDS: u128 = 2;
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    generator.set_stream(stream as u64);
    generator.set_word_pos(index as u128 * WORDS);
    let bits = generator.next_u64() >> 11;
    (bits as f64 + 0.5) / (1u64 << 53) as f64
}

/// The numbers below `count` in random order.
fn shuffled(count: usize, seed: u64, stream: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    // Apart from the streams of random().
    generator.set_stream(u64::MAX - stream as u64);
    order.shuffle(&mut generator);
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(number: usize) -> SampledAxis {
        SampledAxis::Single {
            distribution: Distribution::uniform(0.0, 1.0, false).unwrap(),
            number,
        }
    }

    fn sample(design: SampleDesign, count: usize, seed: u64) -> Vec<Vec<f64>> {
        let sample = Sample::new(
            vec![uniform(0), uniform(1), uniform(0)],
            design,
            count,
            seed,
        );
        (0..count).map(|index| sample.coordinates(index)).collect()
    }

    #[test]
    fn points_follow_from_index_and_seed() {
        for design in SampleDesign::ALL {
            let points = sample(design, 64, 7);
            assert_eq!(points, sample(design, 64, 7), "{design:?}");
            assert_ne!(points, sample(design, 64, 8), "{design:?}");
            assert!(points.iter().all(|p| p[0] == p[2] && p[0] != p[1]));
            assert!(points.iter().flatten().all(|x| 0.0 < *x && *x < 1.0));
        }
    }

    /// Ranks of numbers, from −1 to 1.
    fn ranks(numbers: &[f64]) -> Vec<f64> {
        let mut order: Vec<usize> = (0..numbers.len()).collect();
        order.sort_by(|a, b| numbers[*a].total_cmp(&numbers[*b]));
        let mut ranks = vec![0.0; numbers.len()];
        for (rank, index) in order.into_iter().enumerate() {
            ranks[index] = 2.0 * (rank as f64 + 0.5) / numbers.len() as f64 - 1.0;
        }
        ranks
    }

    /// Spearman's rank correlation in its standard deviations for independent numbers.
    fn correlation(one: &[f64], other: &[f64]) -> f64 {
        let (one, other) = (ranks(one), ranks(other));
        let products = one.iter().zip(&other).map(|(a, b)| a * b);
        3.0 * products.sum::<f64>() / (one.len() as f64).sqrt()
    }

    fn axis(points: &[Vec<f64>], number: usize) -> Vec<f64> {
        points.iter().map(|point| point[number]).collect()
    }

    #[test]
    fn axes_are_independent_of_one_another_and_points_of_those_before() {
        for design in SampleDesign::ALL {
            let axes = (0..6).map(uniform).collect();
            let sample = Sample::new(axes, design, 2000, 11);
            let points: Vec<Vec<f64>> = (0..2000).map(|index| sample.coordinates(index)).collect();
            for first in 0..6 {
                let one = axis(&points, first);
                for second in 0..first {
                    let chance = correlation(&one, &axis(&points, second));
                    assert!(
                        chance.abs() < 4.0,
                        "{design:?}, {first} and {second}: {chance}"
                    );
                }
                if design != SampleDesign::Sobol {
                    let chance = correlation(&one[1..], &one[..1999]);
                    assert!(chance.abs() < 4.0, "{design:?}, {first}: {chance}");
                }
            }
        }
    }

    #[test]
    fn no_random_bits_are_used_twice() {
        // What numbers have of the two words of 32 bits that each is made of: the first 21 bits of both.
        let mut words: Vec<u64> = Vec::new();
        for number in 0..3 {
            for index in 0..500 {
                let drawn = random(9, number, index);
                let second = (drawn * 32f64.exp2()).fract();
                words.extend([drawn, second].map(|word| (word * 21f64.exp2()) as u64));
            }
        }
        let all = words.len();
        words.sort_unstable();
        words.dedup();
        // By chance two pairs are alike.
        assert!(
            all - words.len() <= 8,
            "{} of {all} twice",
            all - words.len()
        );
    }

    #[test]
    fn marginals_are_uniform_by_kolmogorov_and_smirnov() {
        for design in SampleDesign::ALL {
            let points = sample(design, 2000, 13);
            for number in 0..2 {
                let mut values = axis(&points, number);
                values.sort_by(f64::total_cmp);
                let off = |(index, value): (usize, &f64)| {
                    let share = index as f64 / 2000.0;
                    (value - share)
                        .abs()
                        .max((value - share - 1.0 / 2000.0).abs())
                };
                let greatest = values.iter().enumerate().map(off).fold(0.0, f64::max);
                // Exceeded by one sample in a thousand; strata and sequences are far more even.
                let most = match design {
                    SampleDesign::MonteCarlo => 1.95 / 2000f64.sqrt(),
                    SampleDesign::LatinHypercube => 1.0 / 2000.0,
                    SampleDesign::Sobol => 0.005,
                };
                assert!(greatest <= most, "{design:?}, {number}: {greatest}");
            }
        }
    }

    #[test]
    fn every_stratum_of_a_latin_hypercube_holds_one_point_of_each_axis() {
        let points = sample(SampleDesign::LatinHypercube, 100, 1);
        for axis in [0, 1] {
            let mut strata: Vec<usize> =
                points.iter().map(|p| (p[axis] * 100.0) as usize).collect();
            strata.sort_unstable();
            assert!(strata.into_iter().eq(0..100));
        }
    }

    #[test]
    fn sobol_points_fill_every_box_of_a_fine_division() {
        let points = sample(SampleDesign::Sobol, 256, 3);
        let mut boxes = [0; 256];
        for point in points {
            boxes[(point[0] * 16.0) as usize * 16 + (point[1] * 16.0) as usize] += 1;
        }
        assert!(boxes.iter().all(|held| *held == 1), "{boxes:?}");
    }

    #[test]
    fn monte_carlo_means_are_within_their_error() {
        let points = sample(SampleDesign::MonteCarlo, 10_000, 5);
        for axis in [0, 1] {
            let mean = points.iter().map(|p| p[axis]).sum::<f64>() / 1e4;
            // Five standard errors.
            assert!(
                (mean - 0.5).abs() < 5.0 * (1.0f64 / 12.0).sqrt() / 100.0,
                "{mean}"
            );
        }
    }

    #[test]
    fn jointly_normal_axes_have_their_means_and_covariances() {
        let joint = |mean: f64, factors: &[(usize, f64)]| SampledAxis::Joint {
            mean,
            factors: factors.to_vec(),
            covariances: Vec::new(),
        };
        // Variances 4 and 1, covariance −1.2.
        let axes = vec![joint(10.0, &[(0, 2.0)]), joint(1.0, &[(0, -0.6), (1, 0.8)])];
        let Distribution::Normal { deviation, .. } = axes[1].marginal() else {
            panic!("a marginal is normal");
        };
        assert!((deviation - 1.0).abs() < 1e-15);
        let count = 1 << 14;
        let sample = Sample::new(axes, SampleDesign::Sobol, count, 1);
        let points: Vec<Vec<f64>> = (0..count).map(|index| sample.coordinates(index)).collect();
        let mean = |of: &dyn Fn(&[f64]) -> f64| {
            points.iter().map(|point| of(point)).sum::<f64>() / count as f64
        };
        for (measured, expected) in [
            (mean(&|p| p[0]), 10.0),
            (mean(&|p| p[1]), 1.0),
            (mean(&|p| (p[0] - 10.0).powi(2)), 4.0),
            (mean(&|p| (p[1] - 1.0).powi(2)), 1.0),
            (mean(&|p| (p[0] - 10.0) * (p[1] - 1.0)), -1.2),
        ] {
            assert!(
                (measured - expected).abs() < 0.01,
                "{measured} is not {expected}"
            );
        }
    }
}
