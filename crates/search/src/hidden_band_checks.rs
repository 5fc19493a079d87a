//! Counts of the checks for bands narrower than the scan step, by the sign that led to them.

use std::fmt;
use std::ops::AddAssign;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::outcome::Class;

/// Intervals checked, and those that held another outcome.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct CheckCounts {
    /// Intervals checked.
    pub checks: u64,
    /// Intervals with another outcome inside.
    pub finds: u64,
}

impl CheckCounts {
    pub(crate) fn count(&mut self, has_found: bool) {
        self.checks += 1;
        self.finds += u64::from(has_found);
    }
}

impl AddAssign for CheckCounts {
    fn add_assign(&mut self, more: Self) {
        self.checks += more.checks;
        self.finds += more.finds;
    }
}

impl fmt::Display for CheckCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.finds, self.checks)
    }
}

/// Checks for hidden bands, by the sign that led to them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct HiddenBandChecks {
    /// The stability angle of stable landings falls toward zero.
    pub toppling: CheckCounts,
    /// The excess of toppling landings falls toward zero.
    pub righting: CheckCounts,
    /// The stroke that a strut has left, or lacks, falls toward zero.
    pub stroke: CheckCounts,
    /// Margins are irregular where an outcome changes ([`crate::refine`]).
    pub gaps: CheckCounts,
    /// Landings below the first change of the scan, closer than its steps; searches whose first change they lowered.
    pub below: CheckCounts,
    /// Landings at a speed drawn at random below the first transition; those that are not stable, and lower it.
    pub drawn: CheckCounts,
}

impl HiddenBandChecks {
    /// Sum of all counts of intervals.
    pub fn all(&self) -> CheckCounts {
        let mut all = self.toppling;
        for tried in [self.righting, self.stroke, self.gaps] {
            all += tried;
        }
        all
    }

    /// Counts for a suspected band of class `otherwise` among landings of `class`, by the margin between the two.
    pub(crate) fn of(&mut self, class: Class, otherwise: Class) -> &mut CheckCounts {
        match (class, otherwise) {
            (Class::Bottomed, _) | (_, Class::Bottomed) => &mut self.stroke,
            (Class::Unstable, _) => &mut self.righting,
            _ => &mut self.toppling,
        }
    }
}

impl AddAssign for HiddenBandChecks {
    fn add_assign(&mut self, more: Self) {
        self.toppling += more.toppling;
        self.righting += more.righting;
        self.stroke += more.stroke;
        self.gaps += more.gaps;
        self.below += more.below;
        self.drawn += more.drawn;
    }
}
