//! What the legs' signals were, are and will be: before the last step, at the start of the present one and
//! at its end. They take turns, so that nothing is copied as steps go on.

use crate::motion::Glance;

/// Three glances at the signals.
pub(crate) struct Trail {
    glances: [Glance<f64>; 3],
    now: usize,
}

impl Trail {
    pub(super) fn new(legs: usize) -> Self {
        Self {
            glances: [Glance::blank(legs); 3],
            now: 0,
        }
    }

    /// At the start of the step before.
    #[inline(always)]
    pub(super) fn before(&self) -> &Glance<f64> {
        &self.glances[(self.now + 2) % 3]
    }

    /// At the start of the step.
    #[inline(always)]
    pub(super) fn now(&self) -> &Glance<f64> {
        &self.glances[self.now]
    }

    /// The same, to be written.
    #[inline(always)]
    pub(super) fn now_mut(&mut self) -> &mut Glance<f64> {
        &mut self.glances[self.now]
    }

    /// At the end of the step.
    #[inline(always)]
    pub(super) fn ahead(&self) -> &Glance<f64> {
        &self.glances[(self.now + 1) % 3]
    }

    /// The same, to be written.
    #[inline(always)]
    pub(crate) fn ahead_mut(&mut self) -> &mut Glance<f64> {
        &mut self.glances[(self.now + 1) % 3]
    }

    /// Goes on to the end of the step.
    #[inline(always)]
    pub(super) fn go_on(&mut self) {
        self.now = (self.now + 1) % 3;
    }
}
