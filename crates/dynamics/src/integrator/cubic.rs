//! Exits of signals whose rates are known. Values and rates at both ends of a step define a cubic, which shows where a
//! signal leaves its range, or that it stays, before anything in between is evaluated.

use super::event::{CAUTION, Exit, Guard, Sample, SignalValues, locate};
use crate::extremes::{self, least};

/// Signals, some with known rates.
pub trait Rated: SignalValues {
    /// Returns whether the rate of signal `index` is known.
    fn has_rate(index: usize) -> bool;

    /// Rate of signal `index`, which must be known.
    fn rate(&self, index: usize) -> f64;
}

/// Prediction for the signals within a step, from its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Prediction {
    /// All stay in their ranges.
    Stays,
    /// One leaves its range for good, and none before it for a while.
    Leaves,
    /// Only an evaluation within the step can decide.
    Doubtful,
}

/// A step with only its ends evaluated, all signals being inside at its start.
#[derive(Debug, Clone, Copy)]
pub struct StepEnds<'a, V> {
    length: f64,
    start: &'a V,
    end: &'a V,
    /// Signals that may have left their ranges.
    guards: &'a [Guard],
}

impl<'a, V: Rated> StepEnds<'a, V> {
    /// A step of `length` s with these signals at its start and end.
    pub fn new([start, end]: [&'a V; 2], length: f64, guards: &'a [Guard]) -> Self {
        Self {
            length,
            start,
            end,
            guards,
        }
    }

    /// Prediction from the ends of the step.
    pub fn prediction(&self) -> Prediction {
        let mut exit = f64::INFINITY;
        let mut doubt = f64::INFINITY;
        for guard in self.guards {
            if !V::has_rate(guard.signal) {
                return Prediction::Doubtful;
            }
            let cubic = Cubic::of(guard.signal, [self.start, self.end], self.length);
            exit = exit.min(cubic.exit(guard));
            doubt = doubt.min(cubic.doubt(guard));
        }
        if doubt < exit {
            Prediction::Doubtful
        } else if exit <= 1.0 {
            Prediction::Leaves
        } else {
            Prediction::Stays
        }
    }

    /// The first exit of any signal, if one is predicted to leave: the fraction just outside, within `resolution` of
    /// the exit, and the one of `buffers` with the signals there. `evaluate` writes the signals at a fraction of the
    /// step.
    pub fn exit(
        &self,
        resolution: f64,
        buffers: &mut [V; 3],
        evaluate: impl FnMut(f64, &mut V),
    ) -> (f64, usize) {
        let seen = |theta, signals| Sample { theta, signals };
        let end = seen(1.0, self.end);
        let nodes = [seen(0.0, self.start), end, end];
        let predict = |[inside, outside, _]: [Sample<'_, V>; 3]| {
            let width = outside.theta - inside.theta;
            let ends = [inside.signals, outside.signals];
            let cubic = |guard: &Guard| Cubic::of(guard.signal, ends, width * self.length);
            let exits = self.guards.iter().map(|guard| cubic(guard).exit(guard));
            inside.theta + width * least(exits).min(1.0)
        };
        locate(nodes, self.guards, resolution, predict, buffers, evaluate)
    }
}

/// Greatest value of signal `index`, whose rate is known, over a stretch of `length` s between two samples.
pub fn greatest<V: Rated>(index: usize, ends: [&V; 2], length: f64) -> f64 {
    let cubic = Cubic::of(index, ends, length);
    let turns = cubic.turns().map(|turn| cubic.at(turn));
    extremes::greatest(turns.chain([cubic.start, cubic.end]))
}

/// A cubic over the unit interval, start + slope u + bend u² + twist u³.
#[derive(Debug, Clone, Copy)]
struct Cubic {
    start: f64,
    end: f64,
    slope: f64,
    bend: f64,
    twist: f64,
}

/// Most rounds that narrow the bracket of an exit: halvings at worst.
const MOST_ROUNDS: usize = 50;
/// Fraction of the interval below which a Newton step is the last: the next would be about its square.
const NEAR_ENOUGH: f64 = 1e-4;

impl Cubic {
    /// The cubic with the values and rates of a signal at the ends of an interval of `length` s.
    fn of<V: Rated>(signal: usize, ends: [&V; 2], length: f64) -> Self {
        let [start, end] = ends.map(|signals| signals.get(signal));
        let [slope, last] = ends.map(|signals| length * signals.rate(signal));
        let change = end - start;
        Self {
            start,
            end,
            slope,
            bend: 3.0 * change - 2.0 * slope - last,
            twist: slope + last - 2.0 * change,
        }
    }

    fn at(&self, u: f64) -> f64 {
        self.start + u * (self.slope + u * (self.bend + u * self.twist))
    }

    fn slope_at(&self, u: f64) -> f64 {
        self.slope + u * (2.0 * self.bend + 3.0 * u * self.twist)
    }

    /// First turning point so near to the end of a range that only an evaluation can decide; infinite if there is none.
    fn doubt(&self, guard: &Guard) -> f64 {
        let [least, greatest] = [self.start.min(self.end), self.start.max(self.end)];
        let is_doubtful = |turn: &f64| {
            let value = self.at(*turn);
            let beyond = (value - greatest).max(0.0) + (value - least).min(0.0);
            guard.range.exit(value + CAUTION * beyond).is_some()
        };
        self.turns().find(is_doubtful).unwrap_or(f64::INFINITY)
    }

    /// Turning points within the interval, in order.
    fn turns(&self) -> impl Iterator<Item = f64> {
        let turns = if self.is_plainly_monotone() {
            [f64::NAN; 2]
        } else {
            // Zeros of slope + 2 bend u + 3 twist u², without a difference of nearly equal numbers.
            let root = (self.bend * self.bend - 3.0 * self.slope * self.twist).sqrt();
            let sum = -(self.bend + root.copysign(self.bend));
            let [a, b] = [self.slope / sum, sum / (3.0 * self.twist)];
            [a.min(b), a.max(b)]
        };
        (turns.into_iter()).filter(|turn| *turn > 0.0 && *turn < 1.0)
    }

    /// Returns whether it is monotone for certain: neither end is steeper than three times the change. F. N. Fritsch
    /// and R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246.
    fn is_plainly_monotone(&self) -> bool {
        let change = self.end - self.start;
        let goes_along = |slope: f64| slope * change >= 0.0 && slope.abs() <= 3.0 * change.abs();
        goes_along(self.slope) && goes_along(self.slope_at(1.0))
    }

    /// First exit from a range in which it starts, if it ends outside; infinite if it does not.
    fn exit(&self, guard: &Guard) -> f64 {
        let range = guard.range;
        let Some(mut side) = range.exit(self.end) else {
            return f64::INFINITY;
        };
        let (mut inside, mut outside) = (0.0, 1.0);
        for turn in self.turns() {
            if let Some(turned) = range.exit(self.at(turn)) {
                (side, outside) = (turned, turn);
                break;
            }
            inside = turn;
        }
        let border = match side {
            Exit::Below => range.lower,
            Exit::Above => range.upper,
        };
        // It is monotone in between: Newton steps, and halvings where they leave the bracket.
        let mut u = (border - self.start) / (self.end - self.start);
        for _ in 0..MOST_ROUNDS {
            let next = u - (self.at(u) - border) / self.slope_at(u);
            let next = if next > inside && next < outside {
                next
            } else {
                0.5 * (inside + outside)
            };
            if range.exit(self.at(next)).is_some() {
                outside = next;
            } else {
                inside = next;
            }
            let is_near = (next - u).abs() < NEAR_ENOUGH;
            u = next;
            if is_near {
                break;
            }
        }
        u
    }
}

#[cfg(test)]
mod tests {
    use super::super::event::{Bounds, Node};
    use super::*;

    /// Two values and their rates.
    type FourSignals = [f64; 4];

    impl Rated for FourSignals {
        fn has_rate(index: usize) -> bool {
            index < 2
        }

        fn rate(&self, index: usize) -> f64 {
            self[index + 2]
        }
    }

    const LENGTH: f64 = 0.1;

    /// A wave and a line, at a fraction of a step that begins at phase `from`.
    fn signals_at(from: f64, theta: f64) -> FourSignals {
        let phase = from + 20.0 * LENGTH * theta;
        [
            phase.sin(),
            0.5 - 4.0 * theta * LENGTH,
            20.0 * phase.cos(),
            -4.0,
        ]
    }

    fn guard(signal: usize, range: Bounds) -> Guard {
        Guard { signal, range }
    }

    fn predicted(from: f64, guards: &[Guard]) -> Prediction {
        let [start, end] = [signals_at(from, 0.0), signals_at(from, 1.0)];
        StepEnds::new([&start, &end], LENGTH, guards).prediction()
    }

    /// The exit, and the evaluations it took.
    fn exit(from: f64, guards: &[Guard], resolution: f64) -> (Node<FourSignals>, usize) {
        let ends = [signals_at(from, 0.0), signals_at(from, 1.0)];
        let [start, end] = &ends;
        let ends = StepEnds::new([start, end], LENGTH, guards);
        let mut looks = 0;
        let mut buffers = [[0.0; 4]; 3];
        let (theta, buffer) = ends.exit(resolution, &mut buffers, |theta, signals| {
            looks += 1;
            *signals = signals_at(from, theta);
        });
        let exit = Node {
            theta,
            signals: buffers[buffer],
        };
        (exit, looks)
    }

    #[test]
    fn values_and_rates_at_both_ends_tell_what_happens_between() {
        // From −1 rad to 1 rad the wave rises, from 1 to 3 rad it turns at 1.
        assert_eq!(
            predicted(-1.0, &[guard(0, Bounds::between(-0.85, 0.85))]),
            Prediction::Stays
        );
        assert_eq!(
            predicted(-1.0, &[guard(0, Bounds::below(0.8))]),
            Prediction::Leaves
        );
        assert_eq!(
            predicted(1.0, &[guard(0, Bounds::below(1.2))]),
            Prediction::Stays
        );
        for doubtful in [0.9, 0.99, 1.01] {
            let range = Bounds::below(doubtful);
            assert_eq!(predicted(1.0, &[guard(0, range)]), Prediction::Doubtful);
        }
        // The line falls to 0.1; where it leaves at once, what the wave does later does not matter.
        let low = guard(1, Bounds::above(0.45));
        let grazed = guard(0, Bounds::below(0.99));
        assert_eq!(predicted(1.0, &[low, grazed]), Prediction::Leaves);
        let late = guard(1, Bounds::above(0.15));
        assert_eq!(predicted(1.0, &[late, grazed]), Prediction::Doubtful);
        // A signal without a rate needs an evaluation.
        assert_eq!(
            predicted(1.0, &[guard(2, Bounds::FREE)]),
            Prediction::Doubtful
        );
    }

    #[test]
    fn exits_are_found_just_outside_in_a_few_looks() {
        for resolution in [1e-4, 1e-7] {
            for k in 0..40 {
                let border = -0.8 + 0.04 * f64::from(k);
                let range = Bounds::below(border);
                let (found, looks) = exit(-1.0, &[guard(0, range)], resolution);
                let exact = (border.asin() + 1.0) / (20.0 * LENGTH);
                let beyond = found.theta - exact;
                assert!(beyond > 0.0 && beyond <= resolution, "{beyond} at {border}");
                assert!(range.exit(found.signals[0]).is_some());
                assert!(looks <= 3, "{looks} at {border}");
            }
        }
    }

    #[test]
    fn of_several_exits_the_first_is_found() {
        // The wave passes 0 in the middle of the step.
        let wave = guard(0, Bounds::below(0.0));
        for (border, first) in [(0.42, 0.2), (0.18, 0.5)] {
            let line = guard(1, Bounds::above(border));
            for guards in [[wave, line], [line, wave]] {
                let (found, _) = exit(-1.0, &guards, 1e-9);
                assert!((found.theta - first).abs() < 2e-9, "{}", found.theta);
            }
        }
    }

    #[test]
    fn a_cubic_that_leaves_and_returns_before_it_leaves_for_good_is_met_where_it_first_leaves() {
        // Falls to −0.5 at u = 1/2 and rises to 1 again.
        let cubic = Cubic {
            start: 1.0,
            end: 1.0,
            slope: -6.0,
            bend: 6.0,
            twist: 0.0,
        };
        let exit = cubic.exit(&guard(0, Bounds::between(0.0, 0.9)));
        let first = 0.5 * (1.0 - (1.0f64 / 3.0).sqrt());
        assert!((exit - first).abs() < 1e-8, "{exit}");
    }
}
