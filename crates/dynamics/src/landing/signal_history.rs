//! The legs' signals at three instants: start of the previous step, start and end of the present one. The three buffers
//! rotate, so that nothing is copied from step to step.

use crate::motion::Signals;

/// The signals at three instants.
pub(crate) struct SignalHistory {
    signals: [Signals<f64>; 3],
    now: usize,
}

impl SignalHistory {
    pub(super) fn new(legs: usize) -> Self {
        Self {
            signals: [Signals::blank(legs); 3],
            now: 0,
        }
    }

    /// Signals at the start of the previous step.
    #[inline(always)]
    pub(super) fn previous(&self) -> &Signals<f64> {
        &self.signals[(self.now + 2) % 3]
    }

    /// Signals at the start of the step.
    #[inline(always)]
    pub(super) fn start(&self) -> &Signals<f64> {
        &self.signals[self.now]
    }

    /// Start signals, to be written.
    #[inline(always)]
    pub(super) fn start_mut(&mut self) -> &mut Signals<f64> {
        &mut self.signals[self.now]
    }

    /// Signals at the end of the step.
    #[inline(always)]
    pub(super) fn end(&self) -> &Signals<f64> {
        &self.signals[(self.now + 1) % 3]
    }

    /// End signals, to be written.
    #[inline(always)]
    pub(crate) fn end_mut(&mut self) -> &mut Signals<f64> {
        &mut self.signals[(self.now + 1) % 3]
    }

    /// Advances to the end of the step.
    #[inline(always)]
    pub(super) fn advance(&mut self) {
        self.now = (self.now + 1) % 3;
    }
}
