//! Distributions of sampled parameters, by their quantiles.
//!
//! Every design draws numbers between 0 and 1 and takes their quantiles, so any distribution works with any design.

use statrs::distribution::{ContinuousCDF, Normal};

use crate::points::levels::{Fault, rounded};

/// Distribution of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Uniform between two ends.
    Uniform {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// Uniform in the logarithm, between two positive ends.
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
    /// Normal, truncated to two ends.
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
    /// Lognormal.
    Lognormal {
        /// Mean of the number itself.
        mean: f64,
        /// Standard deviation of the number itself.
        deviation: f64,
    },
    /// Rayleigh: the length of a vector with two independent normal components of mean 0.
    Rayleigh {
        /// Standard deviation of either component.
        sigma: f64,
    },
    /// Triangular.
    Triangular {
        /// Lower end.
        from: f64,
        /// Place of the greatest density.
        mode: f64,
        /// Upper end.
        to: f64,
    },
    /// Values of a column, equally likely, in row order.
    Column(Vec<f64>),
}

/// Greatest distance of a truncation range from the mean, in standard deviations: nothing is left to draw beyond it.
const FARTHEST: f64 = 6.0;

impl Distribution {
    /// A uniform distribution, of the number or of its logarithm.
    ///
    /// # Errors
    /// Names the wrong number and the allowed values.
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

    /// A normal distribution, truncated to ends if given.
    ///
    /// # Errors
    /// Names the wrong number and the allowed values.
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

    /// A lognormal distribution by the mean and the standard deviation of the number itself.
    ///
    /// # Errors
    /// Names the wrong number and the allowed values.
    pub fn lognormal(mean: f64, deviation: f64) -> Result<Self, Fault> {
        for (key, value) in [("mean", mean), ("sd", deviation)] {
            if value <= 0.0 {
                return Err((key, "a number > 0"));
            }
        }
        Ok(Self::Lognormal { mean, deviation })
    }

    /// A Rayleigh distribution.
    ///
    /// # Errors
    /// Names the wrong number and the allowed values.
    pub fn rayleigh(sigma: f64) -> Result<Self, Fault> {
        match sigma > 0.0 {
            true => Ok(Self::Rayleigh { sigma }),
            false => Err(("sigma", "a number > 0")),
        }
    }

    /// A triangular distribution.
    ///
    /// # Errors
    /// Names the wrong number and the allowed values.
    pub fn triangular(from: f64, mode: f64, to: f64) -> Result<Self, Fault> {
        if from >= to {
            return Err(("from", "a number below to"));
        }
        match (from..=to).contains(&mode) {
            true => Ok(Self::Triangular { from, mode, to }),
            false => Err(("mode", "a number between from and to")),
        }
    }

    /// The quantile of `u`, 0 < u < 1, rounded to twelve digits, to which the functions of all platforms agree.
    pub fn quantile(&self, u: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => rounded(from + u * (to - from)).clamp(from, to),
            Self::LogUniform { from, to } => {
                rounded(from * libm::pow(to / from, u)).clamp(from, to)
            }
            Self::Normal { mean, deviation } => rounded(mean + deviation * standard_quantile(u)),
            Self::Truncated {
                mean,
                deviation,
                from,
                to,
            } => {
                let [low, high] = [from, to].map(|end| (end - mean) / deviation);
                // In the upper tail shares near 1 lose precision: there they are counted from above.
                let z = if low > 0.0 {
                    let [above, beyond] = [low, high].map(|end| standard().cdf(-end));
                    -standard_quantile(above - u * (above - beyond))
                } else {
                    let [below, within] = [low, high].map(|end| standard().cdf(end));
                    standard_quantile(below + u * (within - below))
                };
                rounded(mean + deviation * z).clamp(from, to)
            }
            Self::Lognormal { mean, deviation } => {
                let ratio = deviation / mean;
                let variance = libm::log1p(ratio * ratio);
                let exponent = variance.sqrt() * standard_quantile(u) - 0.5 * variance;
                rounded(mean * libm::exp(exponent))
            }
            Self::Rayleigh { sigma } => rounded(sigma * (-2.0 * libm::log1p(-u)).sqrt()),
            Self::Triangular { from, mode, to } => {
                let width = to - from;
                let value = if u * width <= mode - from {
                    from + (u * width * (mode - from)).sqrt()
                } else {
                    to - ((1.0 - u) * width * (to - mode)).sqrt()
                };
                rounded(value).clamp(from, to)
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

/// Quantile of `u` in the standard normal distribution.
pub(crate) fn standard_quantile(u: f64) -> f64 {
    standard().inverse_cdf(u)
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

    fn agree(measured: [f64; 2], expected: [f64; 2], within: f64) {
        for (measured, expected) in measured.iter().zip(expected) {
            assert!(
                (measured - expected).abs() < within,
                "{measured} is not {expected}"
            );
        }
    }

    #[test]
    fn moments_are_those_of_the_books() {
        let uniform = Distribution::uniform(1.0, 3.0, false).unwrap();
        agree(moments(&uniform), [2.0, (1.0f64 / 3.0).sqrt()], 1e-6);
        let e = std::f64::consts::E;
        let log = Distribution::uniform(1.0, e, true).unwrap();
        let deviation = (0.5 * (e - 1.0) * (3.0 - e)).sqrt();
        agree(moments(&log), [e - 1.0, deviation], 1e-6);
        let normal = Distribution::normal(5.0, 0.5, None).unwrap();
        agree(moments(&normal), [5.0, 0.5], 1e-3);
        let lognormal = Distribution::lognormal(2.0, 0.5).unwrap();
        agree(moments(&lognormal), [2.0, 0.5], 1e-3);
        let rayleigh = Distribution::rayleigh(2.0).unwrap();
        let pi = std::f64::consts::PI;
        agree(
            moments(&rayleigh),
            [(2.0 * pi).sqrt(), (8.0 - 2.0 * pi).sqrt()],
            1e-3,
        );
        let triangular = Distribution::triangular(1.0, 2.0, 6.0).unwrap();
        // (a + b + c)/3 and (a² + b² + c² − ab − ac − bc)/18.
        agree(moments(&triangular), [3.0, (21.0f64 / 18.0).sqrt()], 1e-5);
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
        // Each of many strata has a value of its own, on either side.
        for [from, to] in [[5.99, 6.01], [-6.01, -5.99]] {
            let far = Distribution::normal(0.0, 1.0, Some([from, to])).unwrap();
            let strata: Vec<f64> = (0..1000)
                .map(|k| far.quantile((f64::from(k) + 0.5) * 1e-3))
                .collect();
            assert!(strata.windows(2).all(|pair| pair[0] < pair[1]));
            // Within it the density falls by a factor of e to the 0.12.
            let middle = strata[500].abs();
            assert!((5.999..6.0).contains(&middle), "{middle}");
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
        let wrong = [
            Distribution::lognormal(-1.0, 1.0),
            Distribution::lognormal(1.0, 0.0),
            Distribution::rayleigh(0.0),
            Distribution::triangular(2.0, 2.0, 2.0),
            Distribution::triangular(0.0, 3.0, 2.0),
        ];
        let named = wrong.map(|wrong| wrong.unwrap_err().0);
        assert_eq!(named, ["mean", "sd", "sigma", "from", "mode"]);
        let far = Distribution::normal(0.0, 1.0, Some([7.0, 8.0]));
        assert_eq!(far.unwrap_err().0, "mean");
    }
}
