//! What the legs' signals were, are and will be: before the last step, at the start of the present one and
//! at its end. They take turns, so that nothing is copied as steps go on.

use crate::motion::Glance;

/// Three glances at the signals.
pub(super) struct Trail<const LEGS: usize> {
    glances: [Glance<LEGS>; 3],
    now: usize,
}

impl<const LEGS: usize> Trail<LEGS> {
    pub(super) fn new() -> Self {
        Self {
            glances: [Glance::blank(); 3],
            now: 0,
        }
    }

    /// At the start of the step before.
    #[inline(always)]
    pub(super) fn before(&self) -> &Glance<LEGS> {
        &self.glances[(self.now + 2) % 3]
    }

    /// At the start of the step.
    #[inline(always)]
    pub(super) fn now(&self) -> &Glance<LEGS> {
        &self.glances[self.now]
    }

    /// The same, to be written.
    #[inline(always)]
    pub(super) fn now_mut(&mut self) -> &mut Glance<LEGS> {
        &mut self.glances[self.now]
    }

    /// At the end of the step.
    #[inline(always)]
    pub(super) fn ahead(&self) -> &Glance<LEGS> {
        &self.glances[(self.now + 1) % 3]
    }

    /// The same, to be written.
    #[inline(always)]
    pub(super) fn ahead_mut(&mut self) -> &mut Glance<LEGS> {
        &mut self.glances[(self.now + 1) % 3]
    }

    /// Goes on to the end of the step.
    #[inline(always)]
    pub(super) fn go_on(&mut self) {
        self.now = (self.now + 1) % 3;
    }
}
