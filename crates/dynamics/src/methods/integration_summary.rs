//! The account of an integration that the program of 1966 printed at the end of a run (3.4.4.3).

use libm::log10;

/// Classes of the distributions.
pub const CLASSES: usize = 8;

/// Intervals, cuts, and truncation errors.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct IntegrationSummary {
    /// Accepted intervals.
    pub intervals: u64,
    /// Time covered by them, s.
    pub time: f64,
    /// Number of intervals of 0.1 to 1 s (and above), of 0.01 to 0.1 s, and so on (and below).
    pub by_decade: [u64; CLASSES],
    /// Number of intervals accepted without a cut, after one, after two, and so on (and more).
    pub by_cuts: [u64; CLASSES],
    /// Intervals accepted in spite of their error because they were the least.
    pub bypassed: u64,
    /// Number of times that each variable had the greatest error as a share of the allowed one.
    pub critical: Vec<u64>,
    /// Sum of the truncation errors of each variable.
    pub arithmetic: Vec<f64>,
    /// Sum of their absolute values.
    pub absolute: Vec<f64>,
}

impl IntegrationSummary {
    /// Mean interval, s.
    pub fn mean_interval(&self) -> f64 {
        self.time / self.intervals as f64
    }

    /// Enters an interval of `length` seconds accepted after `cuts` cuts.
    pub fn enter(&mut self, length: f64, cuts: usize) {
        self.intervals += 1;
        self.time += length;
        let decade = (-log10(length)).ceil().max(1.0) as usize;
        self.by_decade[decade.min(CLASSES) - 1] += 1;
        self.by_cuts[cuts.min(CLASSES - 1)] += 1;
    }

    /// Enters the truncation errors of an interval and its critical variable.
    pub fn enter_errors(&mut self, errors: &[f64], critical: Option<usize>) {
        self.critical.resize(errors.len(), 0);
        self.arithmetic.resize(errors.len(), 0.0);
        self.absolute.resize(errors.len(), 0.0);
        for (sums, error) in self
            .arithmetic
            .iter_mut()
            .zip(&mut self.absolute)
            .zip(errors)
        {
            *sums.0 += error;
            *sums.1 += error.abs();
        }
        if let Some(variable) = critical {
            self.critical[variable] += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_fall_into_their_decades() {
        let mut summary = IntegrationSummary::default();
        for length in [0.3, 0.05, 0.011, 0.005, 2e-6, 3e-12, 4.0] {
            summary.enter(length, 1);
        }
        assert_eq!(summary.by_decade, [2, 2, 1, 0, 0, 1, 0, 1]);
        assert_eq!(summary.by_cuts, [0, 7, 0, 0, 0, 0, 0, 0]);
        assert!((summary.time - 4.366002).abs() < 1e-9);
    }
}
