//! Where a boundary is searched, and how closely.

use crate::certainty::Doubt;
use crate::refine::{Narrowing, Refinement};

/// Where to search, ft/s, and how closely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Search {
    /// Lowest speed, ft/s.
    pub from: f64,
    /// Highest speed, ft/s.
    pub to: f64,
    /// Step of the scan, ft/s.
    pub scan_step: f64,
    /// Greatest width of the final bracket, ft/s.
    pub tolerance: f64,
    /// How much of the range is searched.
    pub extent: Extent,
    /// How it is scanned.
    pub scan: Scan,
    /// What the solver's tolerance is multiplied by for the scan.
    pub scan_looseness: f64,
    /// How brackets are narrowed.
    pub refinement: Refinement,
    /// Which transitions are put to the test.
    pub doubt: Doubt,
    /// Stability angle that a landing has to keep in order to count as stable, rad.
    pub kept: f64,
}

/// How much of the range of speeds a search goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// Up to the first transition.
    #[default]
    First,
    /// All of it: every band between transitions.
    All,
}

/// How the range is scanned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scan {
    /// At every step.
    #[default]
    Full,
    /// At every step but between quiet landings.
    Skipping,
}

impl Search {
    /// Number of speeds in the scan.
    pub fn scan_count(&self) -> u64 {
        ((self.to - self.from) / self.scan_step - 1e-9).ceil() as u64 + 1
    }

    /// The `index`-th speed of the scan, ft/s: full steps from below, and the upper end.
    pub fn scan_speed(&self, index: u64) -> f64 {
        (self.from + index as f64 * self.scan_step).min(self.to)
    }

    /// Landings that one search is expected to take at most.
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

    /// Number of steps of the scan below a speed of it.
    pub(crate) fn steps_to(&self, speed: f64) -> u64 {
        ((speed - self.from) / self.scan_step - 1e-9)
            .ceil()
            .max(0.0) as u64
    }
}
