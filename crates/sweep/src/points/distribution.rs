//! Distributions over which a parameter is sampled, by their quantiles.
//!
//! Every design draws numbers between 0 and 1 and asks for their quantiles, so that any
//! distribution goes with any design.

use statrs::distribution::{ContinuousCDF, Normal};

use crate::levels::{Fault, rounded};

/// How a parameter is distributed.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Everything between two ends alike.
    Uniform {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// Every ratio between two positive ends alike.
    LogUniform {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// Normal.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Normal, given that it lies between two ends.
    Truncated {
        /// Mean of the normal distribution.
        mean: f64,
        /// Standard deviation of the normal distribution.
        deviation: f64,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// The values of a column, each alike, in the order of its rows.
    Column(Vec<f64>),
}

/// Farthest a truncated normal distribution may lie from its mean, standard deviations: beyond it
/// nothing of it is left to draw from.
const FARTHEST: f64 = 6.0;

impl Distribution {
    /// A uniform distribution, of the number or of its logarithm.
    ///
    /// # Errors
    /// Names the number that is wrong and what is allowed.
    pub fn uniform(from: f64, to: f64, is_logarithmic: bool) -> Result<Self, Fault> {
        if from >= to {
            return Err(("from", "a number below to"));
        }
        match (is_logarithmic, from > 0.0) {
            (true, false) => Err(("from", "a number > 0 where the spacing is \"log\"")),
            (true, true) => Ok(Self::LogUniform { from, to }),
            (false, _) => Ok(Self::Uniform { from, to }),
        }
    }

    /// A normal distribution, between ends if they are given.
    ///
    /// # Errors
    /// Names the number that is wrong and what is allowed.
    pub fn normal(mean: f64, deviation: f64, ends: Option<[f64; 2]>) -> Result<Self, Fault> {
        if deviation <= 0.0 {
            return Err(("sd", "a number > 0"));
        }
        let Some([from, to]) = ends else {
            return Ok(Self::Normal { mean, deviation });
        };
        if from >= to {
            return Err(("from", "a number below to"));
        }
        if from > mean + FARTHEST * deviation || to < mean - FARTHEST * deviation {
            return Err(("mean", "at most 6 sd from the range"));
        }
        Ok(Self::Truncated {
            mean,
            deviation,
            from,
            to,
        })
    }

    /// The number that a share `u` of the distribution, 0 < u < 1, lies below; to twelve digits,
    /// on which every platform's functions agree.
    pub fn quantile(&self, u: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => rounded(from + u * (to - from)).clamp(from, to),
            Self::LogUniform { from, to } => {
                rounded(from * libm::pow(to / from, u)).clamp(from, to)
            }
            Self::Normal { mean, deviation } => {
                rounded(mean + deviation * standard().inverse_cdf(u))
            }
            Self::Truncated {
                mean,
                deviation,
                from,
                to,
            } => {
                let [low, high] = [from, to].map(|end| standard().cdf((end - mean) / deviation));
                let share = low + u * (high - low);
                rounded(mean + deviation * standard().inverse_cdf(share)).clamp(from, to)
            }
            Self::Column(ref values) => {
                let row = (u * values.len() as f64) as usize;
                values[row.min(values.len() - 1)]
            }
        }
    }
}

fn standard() -> Normal {
    Normal::standard()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and standard deviation over even shares.
    fn moments(distribution: &Distribution) -> [f64; 2] {
        let count = 20_000;
        let draw = |index| distribution.quantile((f64::from(index) + 0.5) / f64::from(count));
        let values: Vec<f64> = (0..count).map(draw).collect();
        let mean = values.iter().sum::<f64>() / f64::from(count);
        let square = |value: &f64| (value - mean).powi(2);
        let variance = values.iter().map(square).sum::<f64>() / f64::from(count);
        [mean, variance.sqrt()]
    }

    fn agree(found: [f64; 2], expected: [f64; 2], within: f64) {
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found - expected).abs() < within,
                "{found} is not {expected}"
            );
        }
    }

    #[test]
    fn moments_are_those_of_the_books() {
        let uniform = Distribution::uniform(1.0, 3.0, false).unwrap();
        agree(moments(&uniform), [2.0, (1.0f64 / 3.0).sqrt()], 1e-6);
        let log = Distribution::uniform(1.0, std::f64::consts::E, true).unwrap();
        agree(
            moments(&log)[..1]
                .try_into()
                .map(|[m]: [f64; 1]| [m, 0.0])
                .unwrap(),
            [std::f64::consts::E - 1.0, 0.0],
            1e-6,
        );
        let normal = Distribution::normal(5.0, 0.5, None).unwrap();
        agree(moments(&normal), [5.0, 0.5], 1e-3);
        // Between -1 and 1 the standard deviation is sqrt(1 - 2 φ(1) / (2 Φ(1) - 1)).
        let truncated = Distribution::normal(0.0, 1.0, Some([-1.0, 1.0])).unwrap();
        agree(moments(&truncated), [0.0, 0.539_56], 1e-4);
    }

    #[test]
    fn draws_stay_in_their_range_and_columns_keep_their_rows() {
        let tail = Distribution::normal(0.0, 1.0, Some([3.0, 4.0])).unwrap();
        for u in [1e-16, 0.5, 1.0 - 1e-16] {
            assert!((3.0..=4.0).contains(&tail.quantile(u)));
        }
        let column = Distribution::Column(vec![5.0, 3.0, 4.0]);
        let drawn = [0.1, 0.4, 0.9, 1.0].map(|u| column.quantile(u));
        assert_eq!(drawn, [5.0, 3.0, 4.0, 4.0]);
    }

    #[test]
    fn wrong_numbers_are_named() {
        assert_eq!(
            Distribution::uniform(1.0, 1.0, false).unwrap_err().0,
            "from"
        );
        assert_eq!(Distribution::uniform(0.0, 1.0, true).unwrap_err().0, "from");
        assert_eq!(Distribution::normal(0.0, 0.0, None).unwrap_err().0, "sd");
        let far = Distribution::normal(0.0, 1.0, Some([7.0, 8.0]));
        assert_eq!(far.unwrap_err().0, "mean");
    }
}
