//! Instants of a landing that the caller asked for.

use super::record::Instant;

/// Times and receiver of reports.
pub(crate) struct History<'o> {
    interval: f64,
    reported: u64,
    /// Time last reported, s.
    pub(super) last: f64,
    observe: &'o mut dyn FnMut(&Instant),
}

impl<'o> History<'o> {
    /// Reports every `interval` seconds.
    pub(super) fn new(interval: f64, observe: &'o mut dyn FnMut(&Instant)) -> Self {
        Self {
            interval,
            reported: 0,
            last: f64::NEG_INFINITY,
            observe,
        }
    }

    /// Next time to report at, s.
    pub(super) fn next(&self) -> f64 {
        if self.reported == 0 {
            0.0
        } else {
            self.interval * self.reported as f64
        }
    }

    pub(super) fn report(&mut self, instant: &Instant) {
        (self.observe)(instant);
        self.last = instant.time;
        self.reported += 1;
    }
}
