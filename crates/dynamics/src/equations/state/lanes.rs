//! States of several landings, one per lane.

use super::{BODY_NUMBERS, LEG, State};
use crate::lanes::Lanes;
use crate::registers::Transpose;
use crate::scalar::Real;

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
