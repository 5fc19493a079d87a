//! Counts of the work that skips left out of a search, as far as the search itself knows them.
//!
//! The evaluations that a skipped landing would have taken are known only from a search without the skip.
//! `docs/notes/skips.md` has both for the level-vehicle grid.

use std::ops::AddAssign;

use serde::{Deserialize, Serialize};

/// Counts for each skip of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Skipped {
    /// Landings a full scan takes in addition; negative if halving strides took more landings above the first change
    /// than were left out below it.
    pub left_out: i64,
    /// Landings at a looser tolerance than the solver's.
    pub loose: u64,
    /// Scan landings computed in vain: loose ones that had to be computed again at the solver's tolerance, and all
    /// landings of a scan that was repeated.
    pub replaced: u64,
    /// Landings that interpolation saved over halving; negative where it led astray.
    pub interpolated: i64,
    /// Transitions not tested because a margin runs through zero there. Each test takes
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
