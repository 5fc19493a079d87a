//! The numbers of a state one like another: weighted sums and their errors, for integrators, and states of several landings,
//! one per lane.

use super::{BODY_NUMBERS, LEG, LEG_MOTION, State};
use crate::integrator::step::StateVector;
use crate::lanes::Lanes;
use crate::per_leg::MOST_LEGS;
use crate::registers::Transpose;
use crate::scalar::Real;

impl<S: Real> StateVector<S> for State<S> {
    #[inline(always)]
    fn advance_motion<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        self.advance_through::<LEG_MOTION, TERMS>(weights, slopes, result);
    }

    #[inline(always)]
    fn advance<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        self.advance_through::<LEG, TERMS>(weights, slopes, result);
    }

    #[inline(always)]
    fn midway(&self, end: &Self, eighth: S, [first, last]: [&Self; 2], middle: &mut Self) {
        let half = S::constant(0.5);
        let weights = [half, half, eighth, -eighth];
        for i in 0..BODY_NUMBERS {
            S::keep_rounds_apart();
            middle.body[i] = sum(
                weights,
                [self.body[i], end.body[i], first.body[i], last.body[i]],
            );
        }
        for j in 0..self.legs.len() {
            let [start, end, first, last] = [self, end, first, last].map(|state| &state.legs[j]);
            for i in 0..LEG_MOTION {
                S::keep_rounds_apart();
                middle.legs[j][i] = sum(weights, [start[i], end[i], first[i], last[i]]);
            }
        }
    }

    #[inline(always)]
    fn set_mean_rate(&mut self, start: &Self, end: &Self, length: S) {
        let per_length = S::one() / length;
        for i in 0..BODY_NUMBERS {
            S::keep_rounds_apart();
            self.body[i] = (end.body[i] - start.body[i]) * per_length;
        }
        for j in 0..self.legs.len() {
            for i in 0..LEG {
                S::keep_rounds_apart();
                self.legs[j][i] = (end.legs[j][i] - start.legs[j][i]) * per_length;
            }
        }
    }

    #[inline(always)]
    fn set_motion_over(&mut self, change: &Self, length: S) {
        let per_length = S::one() / length;
        for i in 0..BODY_NUMBERS {
            S::keep_rounds_apart();
            self.body[i] = change.body[i] * per_length;
        }
        for j in 0..self.legs.len() {
            for i in 0..LEG_MOTION {
                S::keep_rounds_apart();
                self.legs[j][i] = change.legs[j][i] * per_length;
            }
        }
    }

    /// The motion is weighed by its own magnitude or one, whichever is greater. Works are in ft·lb and follow from the
    /// motion, so they do not count in the first error.
    #[inline(always)]
    fn greatest_error<const TERMS: usize>(
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        before: &Self,
        after: &Self,
    ) -> [S; 2] {
        let mut worst = S::zero();
        // A maximum drops NaN, a sum keeps it.
        let mut all = S::zero();
        for i in 0..BODY_NUMBERS {
            S::keep_rounds_apart();
            let mut error = S::zero();
            for k in 0..TERMS {
                error += weights[k] * slopes[k].body[i];
            }
            let scaled = scaled(error, before.body[i], after.body[i]);
            worst = worst.max(scaled);
            all += scaled;
        }
        let mut work = S::zero();
        for j in 0..before.legs.len() {
            let (before, after) = (&before.legs[j], &after.legs[j]);
            for i in 0..LEG_MOTION {
                S::keep_rounds_apart();
                let mut error = S::zero();
                for k in 0..TERMS {
                    error += weights[k] * slopes[k].legs[j][i];
                }
                let scaled = scaled(error, before[i], after[i]);
                worst = worst.max(scaled);
                all += scaled;
            }
            for i in LEG_MOTION..LEG {
                S::keep_rounds_apart();
                let mut error = S::zero();
                for k in 0..TERMS {
                    error += weights[k] * slopes[k].legs[j][i];
                }
                work = work.max(error.abs());
            }
        }
        [worst + S::zero() * all, work]
    }
}

/// Σ weight · number.
#[inline(always)]
fn sum<S: Real, const TERMS: usize>(weights: [S; TERMS], numbers: [S; TERMS]) -> S {
    let mut sum = S::zero();
    for k in 0..TERMS {
        sum += weights[k] * numbers[k];
    }
    sum
}

/// An error over its weight: the number before or after, or one.
#[inline(always)]
fn scaled<S: Real>(error: S, before: S, after: S) -> S {
    error.abs() / before.abs().max(after.abs()).max(S::one())
}

impl<S: Real> State<S> {
    #[inline(always)]
    fn advance_through<const LAST: usize, const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        for i in 0..BODY_NUMBERS {
            S::keep_rounds_apart();
            let mut sum = self.body[i];
            for k in 0..TERMS {
                sum += weights[k] * slopes[k].body[i];
            }
            result.body[i] = sum;
        }
        // Within the available room, no index has to be checked.
        for j in 0..self.legs.len().min(MOST_LEGS) {
            for i in 0..LAST {
                S::keep_rounds_apart();
                let mut sum = self.legs.room()[j][i];
                for k in 0..TERMS {
                    sum += weights[k] * slopes[k].legs.room()[j][i];
                }
                result.legs.room_mut()[j][i] = sum;
            }
        }
    }
}

impl<const N: usize> State<Lanes<N>> {
    /// Writes the state in each lane.
    #[inline(always)]
    pub fn deal<R: Transpose<N>>(&self, registers: R, mut states: [&mut State<f64>; N]) {
        registers.deal(
            &self.body,
            states.each_mut().map(|state| &mut state.body[..]),
        );
        // As many whole blocks as the legs' numbers take.
        let numbers = (self.legs.len() * LEG).next_multiple_of(N);
        registers.deal(
            &self.legs.room().as_flattened()[..numbers],
            states.map(|state| &mut state.legs.room_mut().as_flattened_mut()[..numbers]),
        );
    }

    /// Takes over the numbers of another in lanes whose `mark` is zero.
    #[inline(always)]
    pub fn replace(&mut self, mark: Lanes<N>, other: &Self) {
        for i in 0..BODY_NUMBERS {
            self.body[i] = mark.where_zero(other.body[i], self.body[i]);
        }
        for j in 0..self.legs.len() {
            for i in 0..LEG {
                self.legs[j][i] = mark.where_zero(other.legs[j][i], self.legs[j][i]);
            }
        }
    }

    /// Puts a state into a lane.
    #[inline(always)]
    pub fn set_lane(&mut self, lane: usize, state: &State<f64>) {
        for (wide, one) in self.body[..BODY_NUMBERS].iter_mut().zip(&state.body) {
            wide.0[lane] = *one;
        }
        for (wide, one) in self.legs.iter_mut().zip(&state.legs) {
            for (wide, one) in wide.iter_mut().zip(one) {
                wide.0[lane] = *one;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whichever is the worst, and whatever its sign.
    #[test]
    fn the_greatest_error_is_that_of_the_worst_number() {
        let legs = 3;
        let still = State::<f64>::zero(legs);
        for (leg, number) in (0..legs).flat_map(|leg| (0..LEG).map(move |number| (leg, number))) {
            for worst in [2.0, -2.0] {
                let mut slopes = [still; 6];
                for others in 0..legs {
                    slopes[3].legs[others] =
                        [0.5, -1.0, 1.0, -0.5, 0.25, -1.0, 1.0, 0.0, -0.0, 1e-16];
                }
                slopes[3].legs[leg][number] = worst;
                let weights = std::hint::black_box([0.0, 0.0, 0.0, 0.25, 0.0, 0.0]);
                let found = State::greatest_error(weights, slopes.each_ref(), &still, &still);
                let expected = if number < LEG_MOTION {
                    [0.5, 0.25]
                } else {
                    [0.25, 0.5]
                };
                assert_eq!(found, expected, "leg {leg}, number {number}, {worst}");
            }
        }
    }
}
