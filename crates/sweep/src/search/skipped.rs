//! Work that skips left out of a search, as counts that the search itself knows.
//!
//! How many evaluations of the equations of motion a landing would have taken that was not computed, only
//! a search without the skip tells: `docs/notes/skips.md` has both for the level-vehicle grid.

use std::ops::AddAssign;

use serde::{Deserialize, Serialize};

/// What each skip of a search came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Skipped {
    /// Landings that a full scan takes more; negative where halving strides down took more
    /// landings above the first change than were left out below it.
    pub left_out: i64,
    /// Landings at a looser tolerance than the solver's own.
    pub loose: u64,
    /// Landings of scans that were computed in vain: those at a looser tolerance that took another at
    /// the solver's own, and all of a scan that was made again.
    pub replaced: u64,
    /// Landings that halving takes more than interpolating did; negative where it led astray.
    pub interpolated: i64,
    /// Transitions not put to the test, because a margin runs through zero there. Each test takes
    /// [`crate::certainty::LEAST_LANDINGS`] or more.
    pub untested: u64,
}

impl AddAssign for Skipped {
    fn add_assign(&mut self, more: Self) {
        self.left_out += more.left_out;
        self.loose += more.loose;
        self.replaced += more.replaced;
        self.interpolated += more.interpolated;
        self.untested += more.untested;
    }
}
