//! What the legs' signals were, are and will be: before the last step, at the start of the present one and
//! at its end. They take turns, so that nothing is copied as steps go on.

use crate::motion::Glance;

/// Three glances at the signals.
pub(super) struct Trail<const LEGS: usize> {
    glances: [Glance<LEGS>; 3],
    now: usize,
    /// Time between the first two, s.
    since_before: f64,
}

impl<const LEGS: usize> Trail<LEGS> {
    pub(super) fn new() -> Self {
        Self {
            glances: [Glance::blank(); 3],
            now: 0,
            since_before: 0.0,
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

    /// Time from the one before the last step to the one at the start of the step, s.
    #[inline(always)]
    pub(super) fn since_before(&self) -> f64 {
        self.since_before
    }

    /// Goes on to the end of the step, which took `time` s.
    #[inline(always)]
    pub(super) fn go_on(&mut self, time: f64) {
        self.now = (self.now + 1) % 3;
        self.since_before = time;
    }

    /// Goes on to an event within the step, after `time` s, with these signals. What was before stays.
    #[inline(always)]
    pub(super) fn go_to(&mut self, signals: Glance<LEGS>, time: f64) {
        self.glances[self.now] = signals;
        self.since_before += time;
    }
}
