//! The signals of all legs at one instant.

use super::{LegSignals, Signal};
use crate::integrator::cubic::Rated;
use crate::integrator::event::Signals;
use crate::quad::{LANES, MOST_LEGS, Quad};

/// Signals of all legs at one instant. The legs' numbers of one kind lie side by side, as in a state.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Glance<const LEGS: usize> {
    rows: [[f64; MOST_LEGS]; Signal::COUNT],
}

impl<const LEGS: usize> Glance<LEGS> {
    /// Nothing seen yet: all signals zero.
    pub fn blank() -> Self {
        Self {
            rows: [[0.0; MOST_LEGS]; Signal::COUNT],
        }
    }

    /// A signal of leg `leg`.
    #[inline(always)]
    pub fn of(&self, leg: usize, signal: Signal) -> f64 {
        self.rows[signal as usize][leg]
    }

    /// All signals of leg `leg`.
    #[inline(always)]
    pub fn leg(&self, leg: usize) -> LegSignals<f64> {
        self.rows.map(|row| row[leg])
    }

    /// The signals that have ranges, four at a time.
    #[inline(always)]
    pub(crate) fn ranged(&self) -> &[[f64; LANES]] {
        self.rows[..Signal::RANGED].as_flattened().as_chunks().0
    }

    /// Writes a signal of leg `leg`.
    #[inline(always)]
    pub(crate) fn set(&mut self, leg: usize, signal: Signal, value: f64) {
        self.rows[signal as usize][leg] = value;
    }

    /// All its numbers.
    #[inline(always)]
    pub(super) fn numbers_mut(&mut self) -> &mut [f64] {
        self.rows.as_flattened_mut()
    }

    /// Writes the signals of a group of four.
    #[inline(always)]
    pub(super) fn set_abreast(&mut self, group: usize, legs: &LegSignals<Quad>) {
        for (row, signal) in self.rows.iter_mut().zip(legs) {
            row[group * LANES..][..LANES].copy_from_slice(&signal.0);
        }
    }

    /// Index of a signal of leg `leg` among all.
    #[inline(always)]
    pub fn index(leg: usize, signal: Signal) -> usize {
        signal as usize * MOST_LEGS + leg
    }
}

impl<const LEGS: usize> Rated for Glance<LEGS> {
    #[inline(always)]
    fn has_rate(index: usize) -> bool {
        index < Signal::RATED * MOST_LEGS
    }

    #[inline(always)]
    fn rate(&self, index: usize) -> f64 {
        self.get(index + Signal::RATED * MOST_LEGS)
    }
}

impl<const LEGS: usize> Signals for Glance<LEGS> {
    #[inline(always)]
    fn get(&self, index: usize) -> f64 {
        self.rows.as_flattened()[index]
    }
}
