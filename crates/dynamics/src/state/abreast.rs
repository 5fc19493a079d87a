//! States of several landings side by side.

use num_traits::Zero;

use super::{BODY_NUMBERS, LEG, LEG_MOTION, State, scaled};
use crate::registers::Lanes;
use crate::scalar::Real;
use crate::wide::Wide;

impl<const N: usize, const LEGS: usize> State<Wide<N>, LEGS> {
    /// [`State::error_norm`] of each lane, for a tolerance of 1.
    #[inline(always)]
    pub fn error_norms(&self, before: &Self, after: &Self) -> [f64; N] {
        let mut worst = Wide::zero();
        let mut sum = Wide::zero();
        for i in 0..BODY_NUMBERS {
            let scaled = scaled(self.body[i], before.body[i], after.body[i]);
            worst = worst.max(scaled);
            sum += scaled;
        }
        for i in 0..LEG_MOTION {
            for j in 0..LEGS {
                let scaled = scaled(self.legs[i][j], before.legs[i][j], after.legs[i][j]);
                worst = worst.max(scaled);
                sum += scaled;
            }
        }
        std::array::from_fn(|lane| {
            if sum.0[lane].is_nan() {
                f64::INFINITY
            } else {
                worst.0[lane]
            }
        })
    }

    /// [`State::greatest_work`] of each lane.
    #[inline(always)]
    pub fn greatest_works(&self) -> Wide<N> {
        let mut greatest = Wide::zero();
        for row in &self.legs[LEG_MOTION..] {
            for work in &row[..LEGS] {
                greatest = greatest.max(work.abs());
            }
        }
        greatest
    }

    /// Writes the state in each lane.
    #[inline(always)]
    pub fn deal<R: Lanes<N>>(&self, registers: R, states: [&mut State<f64, LEGS>; N]) {
        let mut states = states.map(|state| (state.legs.as_flattened_mut(), &mut state.body[..]));
        registers.deal(
            self.legs.as_flattened(),
            states.each_mut().map(|(legs, _)| &mut **legs),
        );
        registers.deal(&self.body, states.map(|(_, body)| body));
    }

    /// In lanes whose `mark` is zero, the numbers of another.
    #[inline(always)]
    pub fn replace(&mut self, mark: Wide<N>, other: &Self) {
        for i in 0..BODY_NUMBERS {
            self.body[i] = mark.where_zero(other.body[i], self.body[i]);
        }
        for i in 0..LEG {
            for leg in 0..LEGS {
                self.legs[i][leg] = mark.where_zero(other.legs[i][leg], self.legs[i][leg]);
            }
        }
    }

    /// Puts a state into a lane.
    #[inline(always)]
    pub fn set_lane(&mut self, lane: usize, state: &State<f64, LEGS>) {
        for (wide, one) in self.body[..BODY_NUMBERS].iter_mut().zip(&state.body) {
            wide.0[lane] = *one;
        }
        for (wide, row) in self.legs.iter_mut().zip(&state.legs) {
            for leg in 0..LEGS {
                wide[leg].0[lane] = row[leg];
            }
        }
    }
}
