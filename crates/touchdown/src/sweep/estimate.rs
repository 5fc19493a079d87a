//! What a sweep will take, from points that were computed as a sample.

use std::collections::HashSet;
use std::ops::AddAssign;

/// Points that were computed of those that a run has to compute.
#[derive(Debug)]
pub struct Sample {
    /// Points that a run has to compute.
    pub points: usize,
    /// What each of the sample took that was finished.
    pub taken: Vec<Taken>,
    /// Points that were begun.
    pub begun: usize,
    /// Landings of the sample and of points that were not finished, and the time for all of them, s.
    pub landings: u64,
    /// See `landings`.
    pub seconds: f64,
}

/// What a point took.
#[derive(Debug, Clone, Copy)]
pub struct Taken {
    /// Landings.
    pub landings: u64,
    /// Bytes of its record in the journal.
    pub journal: usize,
    /// Bytes of its row in the table.
    pub table: usize,
}

/// What a run will take.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Estimate {
    /// Landings, and the square of their standard error.
    landings: f64,
    variance: f64,
    seconds: f64,
    /// Bytes.
    journal: f64,
    table: f64,
}

impl Sample {
    /// What all points will take; `None` where none of the sample was finished.
    pub fn estimate(&self) -> Option<Estimate> {
        if self.points == 0 {
            return Some(Estimate::default());
        }
        let count = self.taken.len() as f64;
        if self.taken.is_empty() {
            return None;
        }
        let points = self.points as f64;
        let mean = |of: fn(&Taken) -> f64| self.taken.iter().map(of).sum::<f64>() / count;
        // Points that take few landings are finished first. Those that were begun only are half done on average.
        let unfinished = self.begun.saturating_sub(self.taken.len()) as f64;
        let each = self.landings as f64 / (count + 0.5 * unfinished);
        let squares = (self.taken.iter()).map(|taken| (taken.landings as f64 - each).powi(2));
        let variance = squares.sum::<f64>() / (count - 1.0).max(1.0);
        let landings = points * each;
        Some(Estimate {
            landings,
            // None where the sample is all points.
            variance: points * points * variance / count * (1.0 - count / points),
            seconds: landings * self.seconds / self.landings.max(1) as f64,
            journal: points * mean(|taken| taken.journal as f64),
            table: points * mean(|taken| taken.table as f64),
        })
    }
}

impl AddAssign for Estimate {
    fn add_assign(&mut self, other: Self) {
        self.landings += other.landings;
        self.variance += other.variance;
        self.seconds += other.seconds;
        self.journal += other.journal;
        self.table += other.table;
    }
}

impl Estimate {
    /// In words.
    pub fn text(&self, threads: usize) -> String {
        let error = self.variance.sqrt();
        let landings = match error.round() {
            0.0 => format!("{:.0} landings", self.landings),
            error => format!(
                "about {:.0} landings (standard error {error:.0})",
                self.landings
            ),
        };
        let threads = match threads {
            1 => "one thread".to_owned(),
            many => format!("{many} threads"),
        };
        format!(
            "{landings}, about {} on {threads}, {} of journal, {} of table",
            duration(self.seconds),
            bytes(self.journal),
            bytes(self.table)
        )
    }
}

/// The numbers below `count`, at most `most` of them, so that the first ones, however many, are spread evenly over all.
pub fn evenly(count: usize, most: usize) -> Vec<usize> {
    let mut chosen = Vec::with_capacity(most.min(count));
    let mut seen = HashSet::new();
    // Van der Corput's sequence: halves, quarters, eighths ...
    for part in (1..).map(u64::reverse_bits) {
        if chosen.len() == most.min(count) {
            break;
        }
        let number = ((u128::from(part) * count as u128) >> u64::BITS) as usize;
        if seen.insert(number) {
            chosen.push(number);
        }
    }
    chosen
}

fn duration(seconds: f64) -> String {
    match seconds {
        short if short < 120.0 => format!("{short:.0} s"),
        long if long < 2.0 * 3600.0 => format!("{:.0} min", long / 60.0),
        night if night < 48.0 * 3600.0 => format!("{:.1} h", night / 3600.0),
        days => format!("{:.1} days", days / 86_400.0),
    }
}

fn bytes(count: f64) -> String {
    match count {
        few if few < 1e6 => format!("{:.0} kB", (few / 1e3).ceil()),
        some if some < 1e9 => format!("{:.0} MB", some / 1e6),
        many => format!("{:.1} GB", many / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_a_choice_are_spread_over_all() {
        assert_eq!(evenly(8, 10), [4, 2, 6, 1, 5, 3, 7, 0]);
        assert_eq!(evenly(1000, 3), [500, 250, 750]);
        assert_eq!(evenly(usize::MAX, 1).len(), 1);
        assert_eq!(evenly(0, 5), [0; 0]);
        for count in [1, 3, 25, 100] {
            let mut all = evenly(count, count);
            all.sort_unstable();
            assert_eq!(all, (0..count).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_sample_of_all_points_has_no_error_and_others_have() {
        let taken = |landings| Taken {
            landings,
            journal: 100,
            table: 20,
        };
        let mut sample = Sample {
            points: 2,
            taken: vec![taken(10), taken(30)],
            begun: 2,
            landings: 40,
            seconds: 2.0,
        };
        let exact = sample.estimate().unwrap();
        assert_eq!(
            (exact.landings, exact.variance, exact.seconds),
            (40.0, 0.0, 2.0)
        );
        assert!(
            exact
                .text(1)
                .starts_with("40 landings, about 2 s on one thread")
        );
        sample.points = 200;
        let mut more = sample.estimate().unwrap();
        assert_eq!((more.landings, more.journal), (4000.0, 20_000.0));
        assert!((more.variance.sqrt() - 2000.0 * 0.99f64.sqrt()).abs() < 1e-6);
        more += exact;
        assert!(
            more.text(2)
                .starts_with("about 4040 landings (standard error 1990)")
        );
        sample.begun = 6;
        sample.landings = 120;
        assert_eq!(sample.estimate().unwrap().landings, 200.0 * 30.0);
        sample.taken.clear();
        assert_eq!(sample.estimate(), None);
    }

    #[test]
    fn long_times_and_sizes_are_told_in_long_units() {
        assert_eq!(duration(30.0), "30 s");
        assert_eq!(duration(36_000.0), "10.0 h");
        assert_eq!(bytes(1234.0), "2 kB");
        assert_eq!(bytes(2.5e9), "2.5 GB");
    }
}
