//! Designs that sample instead of going through a grid.
//!
//! A point follows from its index and the seed alone, so that shards and resumed runs draw the
//! same points.

use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::distribution::Distribution;

/// How points are spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// Each independent of the others.
    MonteCarlo,
    /// As many strata of equal probability as points along every axis, one point in each.
    LatinHypercube,
    /// A low-discrepancy sequence, scrambled after Owen.
    Sobol,
}

impl Spread {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::MonteCarlo, Self::LatinHypercube, Self::Sobol];

    /// Its word in sweep files.
    pub fn name(self) -> &'static str {
        match self {
            Self::MonteCarlo => "monte-carlo",
            Self::LatinHypercube => "latin-hypercube",
            Self::Sobol => "sobol",
        }
    }

    /// Most points that it can spread.
    pub fn most_points(self) -> usize {
        match self {
            Self::MonteCarlo => 1_000_000_000_000,
            // Its strata are shuffled in memory.
            Self::LatinHypercube => 1_000_000,
            // The sequence has no more.
            Self::Sobol => 1 << 16,
        }
    }

    /// Most axes that it can spread points over.
    pub fn most_axes(self) -> usize {
        match self {
            Self::Sobol => sobol_burley::NUM_DIMENSIONS as usize,
            Self::MonteCarlo | Self::LatinHypercube => usize::MAX,
        }
    }
}

/// A distribution, and which of the random numbers of a point it takes: axes that take the same
/// move together.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledAxis {
    /// The distribution.
    pub distribution: Distribution,
    /// Index of the random number.
    pub number: usize,
}

/// Points sampled from distributions.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    axes: Vec<SampledAxis>,
    spread: Spread,
    count: usize,
    seed: u64,
    /// For each random number the stratum of each point, where there are strata.
    strata: Vec<Vec<u32>>,
}

impl Sample {
    /// `count` points, at most as many as the spread allows, over axes in the order of their
    /// parameters.
    pub fn new(axes: Vec<SampledAxis>, spread: Spread, count: usize, seed: u64) -> Self {
        let numbers = axes.iter().map(|axis| axis.number + 1).max().unwrap_or(0);
        let strata = match spread {
            Spread::LatinHypercube => (0..numbers).map(|n| shuffled(count, seed, n)).collect(),
            Spread::MonteCarlo | Spread::Sobol => Vec::new(),
        };
        Self {
            axes,
            spread,
            count,
            seed,
            strata,
        }
    }

    /// The axes, in the order in which they were given.
    pub fn axes(&self) -> &[SampledAxis] {
        &self.axes
    }

    /// How points are spread.
    pub fn spread(&self) -> Spread {
        self.spread
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
        let draw = |axis: &SampledAxis| axis.distribution.quantile(self.number(index, axis.number));
        self.axes.iter().map(draw).collect()
    }

    /// Random number `number` of a point, above 0 and below 1.
    fn number(&self, index: usize, number: usize) -> f64 {
        match self.spread {
            Spread::MonteCarlo => random(self.seed, number, index),
            Spread::LatinHypercube => {
                let stratum = f64::from(self.strata[number][index]);
                (stratum + random(self.seed, number, index)) / self.count as f64
            }
            Spread::Sobol => {
                let seed = (self.seed ^ (self.seed >> 32)) as u32;
                let x = f64::from(sobol_burley::sample(index as u32, number as u32, seed));
                // In the middle of the 2^-24 that the sequence resolves.
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
    // Away from the streams of random().
    generator.set_stream(u64::MAX - stream as u64);
    order.shuffle(&mut generator);
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(number: usize) -> SampledAxis {
        SampledAxis {
            distribution: Distribution::uniform(0.0, 1.0, false).unwrap(),
            number,
        }
    }

    fn sample(spread: Spread, count: usize, seed: u64) -> Vec<Vec<f64>> {
        let sample = Sample::new(
            vec![uniform(0), uniform(1), uniform(0)],
            spread,
            count,
            seed,
        );
        (0..count).map(|index| sample.coordinates(index)).collect()
    }

    #[test]
    fn points_follow_from_index_and_seed() {
        for spread in Spread::ALL {
            let points = sample(spread, 64, 7);
            assert_eq!(points, sample(spread, 64, 7), "{spread:?}");
            assert_ne!(points, sample(spread, 64, 8), "{spread:?}");
            assert!(points.iter().all(|p| p[0] == p[2] && p[0] != p[1]));
            assert!(points.iter().flatten().all(|x| 0.0 < *x && *x < 1.0));
        }
    }

    #[test]
    fn every_stratum_of_a_latin_hypercube_holds_one_point() {
        let points = sample(Spread::LatinHypercube, 100, 1);
        for axis in [0, 1] {
            let mut strata: Vec<usize> =
                points.iter().map(|p| (p[axis] * 100.0) as usize).collect();
            strata.sort_unstable();
            assert!(strata.into_iter().eq(0..100));
        }
    }

    #[test]
    fn sobol_points_fill_every_box_of_a_fine_division() {
        let points = sample(Spread::Sobol, 256, 3);
        let mut boxes = [0; 256];
        for point in points {
            boxes[(point[0] * 16.0) as usize * 16 + (point[1] * 16.0) as usize] += 1;
        }
        assert!(boxes.iter().all(|held| *held == 1), "{boxes:?}");
    }

    #[test]
    fn monte_carlo_means_are_within_their_error() {
        let points = sample(Spread::MonteCarlo, 10_000, 5);
        for axis in [0, 1] {
            let mean = points.iter().map(|p| p[axis]).sum::<f64>() / 1e4;
            // Five standard errors.
            assert!(
                (mean - 0.5).abs() < 5.0 * (1.0f64 / 12.0).sqrt() / 100.0,
                "{mean}"
            );
        }
    }
}
