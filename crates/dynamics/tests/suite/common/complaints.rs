//! What disagrees over a long table, collected so that one failing row does not hide the next.

/// Disagreements found, and the greatest deviation of each compared quantity.
#[derive(Default)]
pub struct Complaints {
    lines: Vec<String>,
    worst: Vec<(String, f64, f64, String)>,
}

impl Complaints {
    /// Complains about `row` unless `value` is within `limit` of `expected`.
    pub fn near(&mut self, row: &str, quantity: &str, value: f64, expected: f64, limit: f64) {
        let deviation = (value - expected).abs();
        let place = self.worst.iter().position(|w| w.0 == quantity);
        let place = place.unwrap_or_else(|| {
            let fresh = (quantity.into(), 0.0, limit, String::new());
            self.worst.push(fresh);
            self.worst.len() - 1
        });
        let worst = &mut self.worst[place];
        if deviation > worst.1 {
            (worst.1, worst.2, worst.3) = (deviation, limit, row.into());
        }
        if deviation > limit || deviation.is_nan() {
            self.lines.push(format!(
                "{row}: {quantity} {value} instead of {expected} (off {deviation:.2e}, allowed {limit:.0e})"
            ));
        }
    }

    /// Complains about `row` unless both are the same.
    pub fn same<T: PartialEq + std::fmt::Debug>(
        &mut self,
        row: &str,
        quantity: &str,
        value: T,
        expected: T,
    ) {
        if value != expected {
            self.lines.push(format!(
                "{row}: {quantity} {value:?} instead of {expected:?}"
            ));
        }
    }

    /// Adds those of another table or row.
    pub fn extend(&mut self, other: Self) {
        self.lines.extend(other.lines);
        for theirs in other.worst {
            match self.worst.iter_mut().find(|ours| ours.0 == theirs.0) {
                Some(ours) if ours.1 < theirs.1 => *ours = theirs,
                Some(_) => {}
                None => self.worst.push(theirs),
            }
        }
    }

    /// Prints the greatest deviations.
    ///
    /// # Panics
    /// When anything was complained about.
    pub fn settle(self) {
        for (quantity, deviation, limit, row) in &self.worst {
            println!("{quantity}: at most {deviation:.2e} ({row}; allowed {limit:.0e})");
        }
        assert!(
            self.lines.is_empty(),
            "{} disagreements:\n{}",
            self.lines.len(),
            self.lines.join("\n")
        );
    }
}

impl FromIterator<Self> for Complaints {
    fn from_iter<I: IntoIterator<Item = Self>>(all: I) -> Self {
        let mut sum = Self::default();
        for one in all {
            sum.extend(one);
        }
        sum
    }
}
