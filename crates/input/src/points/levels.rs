//! The values of an axis, computed on demand.

/// Values of one axis of a grid, in order.
#[derive(Debug, Clone, PartialEq)]
pub enum Levels {
    /// `from`, `from + step`, …
    Range {
        /// First value.
        from: f64,
        /// Step; may be negative.
        step: f64,
        /// Number of values.
        count: usize,
    },
    /// `count` values from `from` to `to` at equal steps.
    Even {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Number of values, at least two.
        count: usize,
    },
    /// `count` values from `from` to `to` at equal ratios.
    Logarithmic {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Number of values, at least two.
        count: usize,
    },
    /// Explicit values.
    List(Vec<f64>),
}

/// Most values of one axis.
const MOST_VALUES: f64 = 1e7;

/// Key of a wrong number of an axis, and the allowed values.
pub type Fault = (&'static str, &'static str);

impl Levels {
    /// `from`, `from + step`, … up (or, with a negative step, down) to and including `to`.
    ///
    /// # Errors
    /// Names the wrong number (`from`, `to` or `step`) and the allowed values.
    pub fn range(from: f64, to: f64, step: f64) -> Result<Self, Fault> {
        ends_differ(from, to)?;
        if step == 0.0 || (step > 0.0) != (to > from) {
            return Err(("step", "a number with the sign of to - from, not 0"));
        }
        // A billionth of a step forgives the rounding of decimals such as 0.1.
        let steps = ((to - from) / step + 1e-9).floor();
        if steps < 1.0 {
            return Err(("step", "a number no larger than to - from"));
        }
        if steps >= MOST_VALUES {
            return Err(("step", "a number that gives at most 1e7 values"));
        }
        let count = steps as usize + 1;
        Ok(Self::Range { from, step, count })
    }

    /// `count` values from `from` to and including `to` at equal steps, rounded to decimals of a billionth of the step.
    ///
    /// # Errors
    /// As [`Levels::range`].
    pub fn even(from: f64, to: f64, count: f64) -> Result<Self, Fault> {
        ends_differ(from, to)?;
        let count = whole_count(count)?;
        Ok(Self::Even { from, to, count })
    }

    /// `count` values from `from` to and including `to`, at equal ratios.
    ///
    /// # Errors
    /// As [`Levels::range`]; both ends must be positive.
    pub fn logarithmic(from: f64, to: f64, count: f64) -> Result<Self, Fault> {
        ends_differ(from, to)?;
        for (key, end) in [("from", from), ("to", to)] {
            if end <= 0.0 {
                return Err((key, "a number > 0 where the spacing is \"log\""));
            }
        }
        let count = whole_count(count)?;
        Ok(Self::Logarithmic { from, to, count })
    }

    /// The values of a list, in its order; `None` for an empty list.
    pub fn list(values: Vec<f64>) -> Option<Self> {
        (!values.is_empty()).then_some(Self::List(values))
    }

    /// Number of values, at least one.
    pub fn count(&self) -> usize {
        match self {
            Self::Range { count, .. }
            | Self::Even { count, .. }
            | Self::Logarithmic { count, .. } => *count,
            Self::List(values) => values.len(),
        }
    }

    /// The `index`-th value, from 0.
    pub fn value(&self, index: usize) -> f64 {
        match *self {
            Self::Range { from, step, .. } => snapped(from + index as f64 * step, step),
            Self::Even { from, to, count } => {
                let step = (to - from) / (count - 1) as f64;
                match index {
                    0 => from,
                    last if last + 1 == count => to,
                    _ => snapped(from + index as f64 * step, step),
                }
            }
            Self::Logarithmic { from, to, count } => match index {
                0 => from,
                last if last + 1 == count => to,
                _ => rounded(from * libm::pow(to / from, index as f64 / (count - 1) as f64)),
            },
            Self::List(ref values) => values[index],
        }
    }

    /// These values with each interval divided into equal `parts`; `None` if there are more than `most`.
    pub fn divided(&self, parts: usize, most: usize) -> Option<Self> {
        let count = (self.count() - 1).checked_mul(parts)?.checked_add(1)?;
        if count > most {
            return None;
        }
        let value = |index: usize| {
            let (below, part) = (self.value(index / parts), index % parts);
            match part {
                0 => below,
                _ => {
                    let step = (self.value(index / parts + 1) - below) / parts as f64;
                    snapped(below + part as f64 * step, step)
                }
            }
        };
        Some(Self::List((0..count).map(value).collect()))
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        (0..self.count()).map(|index| self.value(index))
    }
}

fn ends_differ(from: f64, to: f64) -> Result<(), Fault> {
    if from == to {
        let allowed = "a number other than to (a single value is a list: [x])";
        return Err(("from", allowed));
    }
    Ok(())
}

fn whole_count(count: f64) -> Result<usize, Fault> {
    if count.fract() != 0.0 || !(2.0..=MOST_VALUES).contains(&count) {
        return Err(("count", "a whole number from 2 to 1e7"));
    }
    Ok(count as usize)
}

/// The decimal nearest to `value` at a resolution far below `step`, so that 0.1 + 2 · 0.1 is 0.3.
fn snapped(value: f64, step: f64) -> f64 {
    let digits = (9.0 - libm::log10(step.abs()).floor()).clamp(0.0, 300.0) as usize;
    let decimal = format!("{value:.digits$}").parse().unwrap_or(value);
    // Takes the sign off a negative zero.
    decimal + 0.0
}

/// `value` rounded to twelve digits, to which the power functions and logarithms of all platforms agree.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(levels: Result<Levels, Fault>) -> Vec<f64> {
        levels.unwrap().values().collect()
    }

    #[test]
    fn ranges_include_their_end_in_spite_of_rounding() {
        assert_eq!(
            values(Levels::range(0.1, 0.7, 0.1)),
            [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
        );
        let rolls = Levels::range(-0.3, 0.35, 0.1).unwrap();
        let written: Vec<String> = rolls.values().map(|v| v.to_string()).collect();
        assert_eq!(written, ["-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"]);
        assert_eq!(Levels::range(-60.0, 60.0, 5.0).unwrap().count(), 25);
        assert_eq!(Levels::range(0.0, 1.0, 1.0 / 3.0).unwrap().count(), 4);
    }

    #[test]
    fn ranges_run_down_too() {
        let down = Levels::range(180.0, 80.0, -10.0).unwrap();
        assert_eq!(
            (down.count(), down.value(0), down.value(10)),
            (11, 180.0, 80.0)
        );
    }

    #[test]
    fn counted_values_reach_both_ends_exactly() {
        assert_eq!(
            values(Levels::even(0.1, 0.7, 4.0)),
            [0.1, 0.3, 0.5, 0.7],
            "equal differences"
        );
        assert_eq!(
            values(Levels::even(1.0, 0.0, 4.0)),
            [1.0, 0.6666666667, 0.3333333333, 0.0]
        );
        assert_eq!(
            values(Levels::logarithmic(1e-8, 1e-4, 5.0)),
            [1e-8, 1e-7, 1e-6, 1e-5, 1e-4],
            "equal ratios"
        );
        assert_eq!(
            values(Levels::logarithmic(54.0, 216.0, 3.0)),
            [54.0, 108.0, 216.0]
        );
    }

    #[test]
    fn intervals_are_divided_into_equal_parts() {
        let levels = Levels::list(vec![0.0, 0.3, 1.3]).unwrap();
        assert_eq!(
            values(Ok(levels.divided(2, 9).unwrap())),
            [0.0, 0.15, 0.3, 0.8, 1.3]
        );
        assert_eq!(levels.divided(5, 9), None);
    }

    #[test]
    fn wrong_numbers_are_named() {
        let fault = |from, to, step| Levels::range(from, to, step).unwrap_err().0;
        assert_eq!(fault(1.0, 1.0, 0.1), "from");
        assert_eq!(fault(2.0, 1.0, 0.1), "step");
        assert_eq!(fault(0.0, 1.0, -0.1), "step");
        assert_eq!(fault(0.0, 1.0, 0.0), "step");
        assert_eq!(fault(0.0, 1.0, 2.0), "step");
        assert_eq!(fault(0.0, 1.0, 1e-12), "step");
        assert_eq!(Levels::even(0.0, 1.0, 1.0).unwrap_err().0, "count");
        assert_eq!(Levels::even(0.0, 1.0, 2.5).unwrap_err().0, "count");
        assert_eq!(Levels::even(1.0, 1.0, 3.0).unwrap_err().0, "from");
        assert_eq!(Levels::logarithmic(0.0, 1.0, 3.0).unwrap_err().0, "from");
        assert_eq!(Levels::logarithmic(1.0, -1.0, 3.0).unwrap_err().0, "to");
        assert_eq!(Levels::list(vec![]), None);
    }
}
