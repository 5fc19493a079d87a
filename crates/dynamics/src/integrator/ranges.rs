//! Ranges of many numbers at once, four at a time.

use num_traits::Zero;

use crate::integrator::event::{Bounds, stray};
use crate::lanes::Lanes;
use crate::scalar::Real;

/// Four numbers side by side.
pub type Quad = Lanes<LANES>;
/// Numbers in a [`Quad`].
pub const LANES: usize = 4;

/// Ranges of numbers that lie side by side in quads.
#[derive(Debug, Clone, Copy)]
pub struct Ranges<const QUADS: usize> {
    lower: [Quad; QUADS],
    upper: [Quad; QUADS],
}

impl<const QUADS: usize> Ranges<QUADS> {
    /// No restriction.
    pub fn free() -> Self {
        Self {
            lower: [Quad::constant(Bounds::FREE.lower); QUADS],
            upper: [Quad::constant(Bounds::FREE.upper); QUADS],
        }
    }

    /// Range of the number at an index.
    #[inline(always)]
    pub fn get(&self, index: usize) -> Bounds {
        Bounds {
            lower: self.lower[index / LANES].0[index % LANES],
            upper: self.upper[index / LANES].0[index % LANES],
        }
    }

    /// Sets the range of the number at an index.
    #[inline(always)]
    pub fn set(&mut self, index: usize, range: Bounds) {
        self.lower[index / LANES].0[index % LANES] = range.lower;
        self.upper[index / LANES].0[index % LANES] = range.upper;
    }

    /// Returns whether every number is in its range; NaN is not.
    #[inline(always)]
    pub fn hold(&self, numbers: &[[f64; LANES]]) -> bool {
        let mut farthest = Farthest::new();
        for ((number, &lower), &upper) in quads(numbers).zip(&self.lower).zip(&self.upper) {
            farthest.note(greater(lower - number, number - upper));
        }
        farthest.all(|beyond| beyond <= 0.0)
    }

    /// Returns whether no number can have left its range within a step, judged from its values at the start of the
    /// previous step and at the start and end of this one: at both ends of the step it is farther inside than it can
    /// stray (`event::stray`). `ratio` is this step's length over the previous one's. Writes how far each can get
    /// beyond its range to `reach`; negative where it stays inside.
    #[inline(always)]
    pub fn keep(&self, looks: [&[[f64; LANES]]; 3], ratio: f64, reach: &mut [Quad; QUADS]) -> bool {
        let mut farthest = Farthest::new();
        self.stray(0, looks, ratio, reach, &mut farthest);
        farthest.all(|beyond| beyond < 0.0)
    }

    /// Checks numbers whose first `rated` quads are followed by as many of their rates. Those numbers stay
    /// between the corners of the cubics through their values and rates at both ends of the step of `length`.
    #[inline(always)]
    pub fn keep_by_rates(
        &self,
        [before, start, end]: [&[[f64; LANES]]; 3],
        ratio: f64,
        length: f64,
        rated: usize,
        reach: &mut [Quad; QUADS],
    ) -> bool {
        let mut farthest = Farthest::new();
        let third = Quad::constant(length / 3.0);
        let starts = quads(&start[..rated]).zip(quads(&start[rated..]));
        let ends = quads(&end[..rated]).zip(quads(&end[rated..]));
        let ranges = self.lower[..rated].iter().zip(&self.upper);
        let told = starts.zip(ends).zip(ranges).zip(&mut *reach);
        for ((((start, at_start), (end, at_end)), (&lower, &upper)), reach) in told {
            let [early, late] = [start + third * at_start, end - third * at_end];
            let beyond = |number: Quad| greater(lower - number, number - upper);
            let ends = greater(beyond(start), beyond(end));
            *reach = greater(ends, greater(beyond(early), beyond(late)));
            farthest.note(*reach);
            farthest.check(early + late);
        }
        self.stray(rated, [before, start, end], ratio, reach, &mut farthest);
        farthest.all(|beyond| beyond < 0.0)
    }

    /// Finds how far all numbers but the first `from` quads can stray.
    #[inline(always)]
    fn stray(
        &self,
        from: usize,
        [before, start, end]: [&[[f64; LANES]]; 3],
        ratio: f64,
        reach: &mut [Quad; QUADS],
        farthest: &mut Farthest,
    ) {
        let ratio = Quad::constant(ratio);
        let [before, start, end] = [before, start, end].map(|numbers| quads(&numbers[from..]));
        let ranges = self.lower[from..].iter().zip(&self.upper[from..]);
        let told = before.zip(start).zip(end).zip(ranges);
        for ((((before, start), end), (&lower, &upper)), reach) in told.zip(&mut reach[from..]) {
            let below = greater(lower - start, lower - end);
            let above = greater(start - upper, end - upper);
            *reach = greater(below, above) + stray(before, start, end, ratio);
            farthest.note(*reach);
        }
    }
}

/// The greatest of some numbers, lane by lane.
struct Farthest {
    greatest: Quad,
    /// A maximum drops NaN, a sum keeps it.
    sum: Quad,
}

impl Farthest {
    #[inline(always)]
    fn new() -> Self {
        Self {
            greatest: Quad::constant(f64::NEG_INFINITY),
            sum: Quad::zero(),
        }
    }

    #[inline(always)]
    fn note(&mut self, numbers: Quad) {
        self.greatest = greater(self.greatest, numbers);
        self.check(numbers);
    }

    /// Notes whether these are numbers.
    #[inline(always)]
    fn check(&mut self, numbers: Quad) {
        self.sum += numbers;
    }

    /// Returns whether none is NaN and `holds` is true for all.
    #[inline(always)]
    fn all(&self, holds: impl Fn(f64) -> bool) -> bool {
        self.greatest.0.into_iter().all(holds) && self.sum.0.iter().all(|sum| !sum.is_nan())
    }
}

/// The greater of two numbers, or the second if either is NaN: one processor instruction.
#[inline(always)]
fn greater(a: Quad, b: Quad) -> Quad {
    Lanes(std::array::from_fn(|i| {
        if a.0[i] > b.0[i] { a.0[i] } else { b.0[i] }
    }))
}

#[inline(always)]
fn quads(numbers: &[[f64; LANES]]) -> impl Iterator<Item = Quad> {
    numbers.iter().map(|&four| Lanes(four))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from 1 to 2 but for the last, which is free.
    fn ranges() -> Ranges<1> {
        let mut ranges = Ranges::free();
        for index in 0..3 {
            ranges.set(index, Bounds::between(1.0, 2.0));
        }
        ranges
    }

    fn keep(before: f64, start: f64, end: f64, ratio: f64) -> bool {
        let look = |number| [[1.5, number, 1.5, 7.0]];
        let [before, start, end] = [before, start, end].map(look);
        ranges().keep([&before, &start, &end], ratio, &mut [Quad::zero()])
    }

    #[test]
    fn what_is_farther_inside_than_it_can_stray_keeps_its_range() {
        assert!(keep(1.5, 1.5, 1.5, 1.0));
        assert!(keep(1.4, 1.5, 1.6, 1.0));
        // Room 0.4; strays 0.1 + 0.1 ratio.
        assert!(keep(1.4, 1.5, 1.6, 2.9));
        assert!(!keep(1.4, 1.5, 1.6, 3.1));
        assert!(!keep(1.5, 1.5, 1.8, 1.0));
        assert!(!keep(1.5, 1.2, 1.5, 0.0));
        assert!(!keep(1.5, 0.9, 0.9, 0.0));
    }

    /// A number with a rate at the start and at the end of a step of 3 s, all others in the middle of their ranges.
    fn keep_by_rates([start, end]: [[f64; 2]; 2]) -> bool {
        let look = |[number, rate]: [f64; 2]| [[1.5, number, 1.5, 7.0], [0.0, rate, 0.0, 0.0]];
        let mut ranges = Ranges::<2>::free();
        for index in 0..3 {
            ranges.set(index, Bounds::between(1.0, 2.0));
        }
        let [before, start, end] = [[1.5, 0.0], start, end].map(look);
        let mut reach = [Quad::zero(); 2];
        ranges.keep_by_rates([&before, &start, &end], 1.0, 3.0, 1, &mut reach)
    }

    #[test]
    fn what_has_a_rate_keeps_its_range_where_the_corners_of_its_cubic_do() {
        // Corners are a rate from either end.
        assert!(keep_by_rates([[1.5, 0.4], [1.5, -0.4]]));
        assert!(keep_by_rates([[1.01, 0.9], [1.99, 0.9]]));
        assert!(!keep_by_rates([[1.5, 0.6], [1.5, 0.0]]));
        assert!(!keep_by_rates([[1.5, -0.6], [1.5, 0.0]]));
        assert!(!keep_by_rates([[1.5, 0.0], [1.5, -0.6]]));
        assert!(!keep_by_rates([[1.5, 0.0], [1.5, 0.6]]));
        assert!(!keep_by_rates([[1.5, 0.0], [2.01, 0.4]]));
        for told in [[f64::NAN, 0.0], [1.5, f64::NAN]] {
            assert!(!keep_by_rates([told, [1.5, 0.0]]));
            assert!(!keep_by_rates([[1.5, 0.0], told]));
        }
    }

    #[test]
    fn what_is_no_number_keeps_no_range() {
        assert!(!keep(1.5, 1.5, f64::NAN, 1.0));
        assert!(!keep(f64::NAN, 1.5, 1.5, 1.0));
        for index in 0..4 {
            let mut numbers = [[1.5; LANES]];
            assert!(ranges().hold(&numbers));
            numbers[0][index] = f64::NAN;
            assert!(!ranges().hold(&numbers), "{index}");
        }
    }

    #[test]
    fn ranges_hold_to_their_ends() {
        for (number, is_inside) in [(1.0, true), (2.0, true), (0.999, false), (2.001, false)] {
            for index in 0..3 {
                let mut numbers = [[1.5, 1.5, 1.5, -1e9]];
                numbers[0][index] = number;
                assert_eq!(ranges().hold(&numbers), is_inside);
                assert_eq!(ranges().get(index).exit(number).is_none(), is_inside);
            }
        }
        assert!(ranges().get(3).is_free());
    }
}
