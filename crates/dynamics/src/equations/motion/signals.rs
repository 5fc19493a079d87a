//! The signals of all legs, at one instant and at the ends of two steps.

use super::{LegSignals, Signal};
use crate::integrator::cubic::Rated;
use crate::integrator::event::SignalValues;
use crate::integrator::ranges::LANES;
use crate::lanes::Lanes;
use crate::per_leg::PerLeg;
use crate::registers::Transpose;
use crate::scalar::Real;

/// Signals of all legs at one instant, leg by leg.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Signals<S> {
    legs: PerLeg<LegSignals<S>>,
}

/// Number of leading signals of a leg, in whole quads, that hold all with ranges.
const RANGED: usize = Signal::RANGED.next_multiple_of(LANES);

impl<S: Real> Signals<S> {
    /// Zero signals of this many legs.
    pub fn blank(legs: usize) -> Self {
        Self {
            legs: PerLeg::same(legs, [S::zero(); Signal::COUNT]),
        }
    }

    /// Number of legs.
    #[inline(always)]
    pub fn leg_count(&self) -> usize {
        self.legs.len()
    }

    /// Takes over other signals of as many legs.
    #[inline(always)]
    pub fn assign(&mut self, other: &Self) {
        self.legs.copy_from_slice(&other.legs);
    }

    /// A signal of leg `leg`.
    #[inline(always)]
    pub fn of(&self, leg: usize, signal: Signal) -> S {
        self.legs[leg][signal as usize]
    }

    /// All signals of leg `leg`.
    #[inline(always)]
    pub fn leg(&self, leg: usize) -> &LegSignals<S> {
        &self.legs[leg]
    }

    /// Writes a signal of leg `leg`.
    #[inline(always)]
    pub fn set(&mut self, leg: usize, signal: Signal, value: S) {
        self.legs[leg][signal as usize] = value;
    }

    /// Writes all signals of leg `leg`.
    #[inline(always)]
    pub(super) fn set_leg(&mut self, leg: usize, signals: &LegSignals<S>) {
        self.legs[leg] = *signals;
    }
}

impl Signals<f64> {
    /// Number of quads that hold all signals of a leg with ranges.
    pub const RANGED_QUADS: usize = RANGED / LANES;
    /// Number of leading quads whose signals have rates among the signals.
    pub const RATED_QUADS: usize = Signal::RATED / LANES;

    /// The signals of leg `leg` with ranges, four at a time.
    #[inline(always)]
    pub fn ranged(&self, leg: usize) -> &[[f64; LANES]] {
        self.legs[leg][..RANGED].as_chunks().0
    }

    /// Index of a signal of leg `leg` among all legs' signals.
    #[inline(always)]
    pub fn index(leg: usize, signal: Signal) -> usize {
        leg * Signal::COUNT + signal as usize
    }
}

impl<const N: usize> Signals<Lanes<N>> {
    /// Writes the signals of each landing.
    #[inline(always)]
    pub fn deal<R: Transpose<N>>(&self, registers: R, signals: [&mut Signals<f64>; N]) {
        registers.deal(
            self.legs.as_flattened(),
            signals.map(|signals| signals.legs.as_flattened_mut()),
        );
    }
}

impl Rated for Signals<f64> {
    #[inline(always)]
    fn has_rate(index: usize) -> bool {
        index % Signal::COUNT < Signal::RATED
    }

    #[inline(always)]
    fn rate(&self, index: usize) -> f64 {
        self.get(index + Signal::RATED)
    }
}

impl SignalValues for Signals<f64> {
    #[inline(always)]
    fn get(&self, index: usize) -> f64 {
        self.legs.as_flattened()[index]
    }
}

/// The signals at three instants: start of the previous step, start and end of the present one. The three buffers
/// rotate, so that nothing is copied from step to step.
pub(crate) struct SignalHistory {
    signals: [Signals<f64>; 3],
    now: usize,
}

impl SignalHistory {
    pub(crate) fn new(legs: usize) -> Self {
        Self {
            signals: [Signals::blank(legs); 3],
            now: 0,
        }
    }

    /// Signals at the start of the previous step.
    #[inline(always)]
    pub(crate) fn previous(&self) -> &Signals<f64> {
        &self.signals[(self.now + 2) % 3]
    }

    /// Signals at the start of the step.
    #[inline(always)]
    pub(crate) fn start(&self) -> &Signals<f64> {
        &self.signals[self.now]
    }

    /// Start signals, to be written.
    #[inline(always)]
    pub(crate) fn start_mut(&mut self) -> &mut Signals<f64> {
        &mut self.signals[self.now]
    }

    /// Signals at the end of the step.
    #[inline(always)]
    pub(crate) fn end(&self) -> &Signals<f64> {
        &self.signals[(self.now + 1) % 3]
    }

    /// End signals, to be written.
    #[inline(always)]
    pub(crate) fn end_mut(&mut self) -> &mut Signals<f64> {
        &mut self.signals[(self.now + 1) % 3]
    }

    /// Advances to the end of the step.
    #[inline(always)]
    pub(crate) fn advance(&mut self) {
        self.now = (self.now + 1) % 3;
    }
}
