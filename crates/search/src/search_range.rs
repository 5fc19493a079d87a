//! Range and resolution of a boundary search.

use crate::certainty::Doubt;
use crate::refine::{Narrowing, Refinement};

/// Range of speeds to search, ft/s, and resolution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Search {
    /// Lowest speed, ft/s.
    pub from: f64,
    /// Highest speed, ft/s.
    pub to: f64,
    /// Step of the scan, ft/s.
    pub scan_step: f64,
    /// Parts of a scan step at which landings below the first transition are computed where they are not quiet; 1 for
    /// none.
    pub parts_below: u32,
    /// Greatest width of the final bracket, ft/s.
    pub tolerance: f64,
    /// Part of the range to search.
    pub extent: Extent,
    /// Kind of scan.
    pub scan: Scan,
    /// Factor on the solver's tolerance for the scan.
    pub scan_looseness: f64,
    /// Method of narrowing brackets.
    pub refinement: Refinement,
    /// Transitions to test.
    pub doubt: Doubt,
    /// Stability angle that a landing has to keep in order to count as stable, rad.
    pub kept: f64,
}

/// Part of the speed range that a search covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Extent {
    /// Up to the first transition.
    #[default]
    First,
    /// The whole range: every band between transitions.
    All,
}

/// Kind of scan over the range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Scan {
    /// Lands at every step.
    #[default]
    Full,
    /// Lands at every step except between quiet landings.
    Skipping,
}

impl Search {
    /// Parts of a scan step at which a search looks closer below the first transition, unless told otherwise.
    pub const PARTS_BELOW: u32 = 8;

    /// Number of speeds in the scan.
    pub fn scan_count(&self) -> u64 {
        ((self.to - self.from) / self.scan_step - 1e-9).ceil() as u64 + 1
    }

    /// The `index`-th speed of the scan, ft/s: full steps from below, clipped at the upper end.
    pub fn scan_speed(&self, index: u64) -> f64 {
        (self.from + index as f64 * self.scan_step).min(self.to)
    }

    /// Most landings of a full scan and one bisection.
    pub fn most_landings(&self) -> u64 {
        let halvings = libm::log2(self.scan_step / self.tolerance).ceil().max(0.0);
        self.scan_count() + halvings as u64
    }

    pub(crate) fn narrowing(&self, to_all: bool) -> Narrowing {
        Narrowing {
            refinement: self.refinement,
            tolerance: self.tolerance,
            to_all,
        }
    }

    /// Number of scan steps below a speed of the scan.
    pub(crate) fn steps_to(&self, speed: f64) -> u64 {
        ((speed - self.from) / self.scan_step - 1e-9)
            .ceil()
            .max(0.0) as u64
    }
}
