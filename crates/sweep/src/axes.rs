//! Axes and the grid that they span, the first axis varying slowest.
//!
//! A grid is never written out: the coordinates of a point follow from its index.

/// Values of a condition that a sweep goes through.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    name: String,
    values: Values,
}

#[derive(Debug, Clone, PartialEq)]
enum Values {
    Range { from: f64, step: f64, count: usize },
    List(Vec<f64>),
}

/// Most values of one axis.
const MOST_VALUES: f64 = 1e7;

impl Axis {
    /// `from`, `from + step`, … up (or, with a negative step, down) to and including `to`.
    ///
    /// # Errors
    /// Names the number that is wrong (`from`, `to` or `step`) and what is allowed.
    pub fn range(
        name: &str,
        from: f64,
        to: f64,
        step: f64,
    ) -> Result<Self, (&'static str, &'static str)> {
        if from == to {
            return Err((
                "from",
                "a number other than to; a list, [x], holds one value",
            ));
        }
        if step == 0.0 || (step > 0.0) != (to > from) {
            return Err(("step", "a number with the sign of to - from, not 0"));
        }
        // A billionth of a step forgives the rounding of decimals such as 0.1.
        let steps = ((to - from) / step + 1e-9).floor();
        if steps < 1.0 {
            return Err(("step", "a number not beyond to - from"));
        }
        if steps >= MOST_VALUES {
            return Err(("step", "so large that the axis has at most 1e7 values"));
        }
        Ok(Self {
            name: name.to_owned(),
            values: Values::Range {
                from,
                step,
                count: steps as usize + 1,
            },
        })
    }

    /// The values of a list, in its order; `None` for an empty list.
    pub fn list(name: &str, values: Vec<f64>) -> Option<Self> {
        let name = name.to_owned();
        (!values.is_empty()).then_some(Self {
            name,
            values: Values::List(values),
        })
    }

    /// The condition that varies.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Number of values, at least one.
    pub fn count(&self) -> usize {
        match &self.values {
            Values::Range { count, .. } => *count,
            Values::List(values) => values.len(),
        }
    }

    /// The `index`-th value, from 0.
    pub fn value(&self, index: usize) -> f64 {
        match &self.values {
            Values::Range { from, step, .. } => snapped(from + index as f64 * step, *step),
            Values::List(values) => values[index],
        }
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        (0..self.count()).map(|index| self.value(index))
    }
}

/// Nearest decimal to `value` at a resolution far below `step`, so that 0.1 + 2 · 0.1 is 0.3.
fn snapped(value: f64, step: f64) -> f64 {
    let digits = (9.0 - step.abs().log10().floor()).clamp(0.0, 300.0) as usize;
    let decimal = format!("{value:.digits$}").parse().unwrap_or(value);
    // Takes the sign off a negative zero.
    decimal + 0.0
}

/// The outer product of axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    axes: Vec<Axis>,
    count: usize,
}

impl Grid {
    /// The grid over `axes`; `None` without axes or with more points than can be counted.
    pub fn new(axes: Vec<Axis>) -> Option<Self> {
        let count = axes
            .iter()
            .try_fold(1usize, |count, axis| count.checked_mul(axis.count()))?;
        (!axes.is_empty()).then_some(Self { axes, count })
    }

    /// The axes, slowest first.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Coordinates of the `index`-th point, from 0, one for each axis.
    pub fn coordinates(&self, index: usize) -> Vec<f64> {
        let mut rest = index;
        let mut coordinates: Vec<f64> = self
            .axes
            .iter()
            .rev()
            .map(|axis| {
                let value = axis.value(rest % axis.count());
                rest /= axis.count();
                value
            })
            .collect();
        coordinates.reverse();
        coordinates
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_include_their_end_in_spite_of_rounding() {
        let axis = Axis::range("friction", 0.1, 0.7, 0.1).unwrap();
        let values: Vec<f64> = axis.values().collect();
        assert_eq!(values, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
        let axis = Axis::range("roll_deg", -0.3, 0.35, 0.1).unwrap();
        let values: Vec<String> = axis.values().map(|v| v.to_string()).collect();
        assert_eq!(values, ["-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"]);
        assert_eq!(
            Axis::range("roll_deg", -60.0, 60.0, 5.0).unwrap().count(),
            25
        );
        assert_eq!(Axis::range("x", 0.0, 1.0, 1.0 / 3.0).unwrap().count(), 4);
    }

    #[test]
    fn ranges_run_down_too() {
        let axis = Axis::range("cross_slope_deg", 180.0, 80.0, -10.0).unwrap();
        assert_eq!(
            (axis.count(), axis.value(0), axis.value(10)),
            (11, 180.0, 80.0)
        );
    }

    #[test]
    fn wrong_ranges_name_their_number() {
        let fault = |from, to, step| Axis::range("x", from, to, step).unwrap_err().0;
        assert_eq!(fault(1.0, 1.0, 0.1), "from");
        assert_eq!(fault(2.0, 1.0, 0.1), "step");
        assert_eq!(fault(0.0, 1.0, -0.1), "step");
        assert_eq!(fault(0.0, 1.0, 0.0), "step");
        assert_eq!(fault(0.0, 1.0, 2.0), "step");
        assert_eq!(fault(0.0, 1.0, 1e-12), "step");
    }

    #[test]
    fn first_axis_is_slowest() {
        let slow = Axis::list("cross_slope_deg", vec![180.0, 170.0]).unwrap();
        let fast = Axis::range("roll_deg", 0.0, 2.0, 1.0).unwrap();
        let grid = Grid::new(vec![slow, fast]).unwrap();
        let points: Vec<_> = (0..grid.count()).map(|i| grid.coordinates(i)).collect();
        assert_eq!(points[1], [180.0, 1.0]);
        assert_eq!(points[3], [170.0, 0.0]);
        assert_eq!(points.len(), 6);
    }

    #[test]
    fn empty_and_uncountable_grids_are_none() {
        assert_eq!(Axis::list("x", vec![]), None);
        assert_eq!(Grid::new(vec![]), None);
        let wide = Axis::range("x", 0.0, 9e6, 1.0).unwrap();
        assert_eq!(Grid::new(vec![wide.clone(), wide.clone(), wide]), None);
    }
}
