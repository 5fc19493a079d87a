//! The first speed at which a lander does no longer land stably.
//!
//! Outcomes can re-enter: above the speed at which a lander topples it may be stable again. A
//! bisection over the whole range could then settle on any of the changes, so the range is
//! scanned upward in steps first and only the step in which the outcome changes is narrowed down.

use std::cell::Cell;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::outcome::Class;

use crate::bands::Band;
use crate::certainty::{self, Certainty, Doubt, Variation};
use crate::looks::Looks;
use crate::loose_scan::Scanned;
use crate::refine::{Narrowed, Narrowing, Refinement};
use crate::scan::Scan;
use crate::spared::Spared;
use crate::trial::{Sample, Trial};

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

/// The first change away from a stable landing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Transition {
    /// How landings end at `high`.
    pub to: Class,
    /// Highest speed known to be stable below the change, ft/s; equal to `high` when the lowest
    /// speed of the search was not stable already.
    pub low: f64,
    /// Lowest speed known not to be stable, ft/s.
    pub high: f64,
    /// How well it is determined.
    pub certainty: Certainty,
}

impl Transition {
    /// Middle of the bracket, ft/s.
    pub fn speed(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// What a search found, and what it cost.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Boundary {
    /// The first transition, if there is one in the range.
    pub transition: Option<Transition>,
    /// All bands of the range from below; none when only the first transition was asked for.
    pub bands: Vec<Band>,
    /// Intervals between like outcomes that were looked into for a hidden band.
    pub looks: Looks,
    /// What skips spared.
    pub spared: Spared,
    /// Landings that put transitions to the test.
    pub tests: u64,
    /// Landings computed, tests included.
    pub landings: u64,
    /// Evaluations of the equations of motion in all of them.
    pub evaluations: u64,
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

    /// Searches as much of the range as [`Search::extent`] says with `land`, which lands at a given
    /// horizontal speed with a variation. Asks for several landings at a time where all of them are needed.
    ///
    /// # Errors
    /// Only what `land` gives up with, at once.
    pub async fn boundary<Stop>(
        &self,
        land: impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        match self.extent {
            Extent::First => self.first_transition(land).await,
            Extent::All => self.all_bands(land).await,
        }
    }

    /// Searches the first transition with `land`, which lands at a given horizontal speed with a
    /// variation.
    ///
    /// # Errors
    /// Only what `land` gives up with, at once.
    pub async fn first_transition<Stop>(
        &self,
        land: impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        let Scanned {
            mut samples,
            spent: replaced,
            loose,
        } = self.confirmed_scan(true, &land).await?;
        let sample = async |speed| Sample::at(speed, land(speed, Variation::Given)).await;
        let left_out = self.left_out(true, &samples);
        let mut narrowed = Narrowed::default();
        if let Some(index) = first_unstable(&samples).filter(|index| *index > 0) {
            let (low, high) = (&samples[index - 1], &samples[index]);
            narrowed = self.narrowing(false).between(low, high, &sample).await?;
            samples.append(&mut narrowed.samples);
            samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        }
        let mut boundary = Boundary::of(&samples);
        if let Some(index) = first_unstable(&samples).filter(|index| *index > 0) {
            let ends = [&samples[index - 1], &samples[index]];
            let tested = self.tested(ends, &land).await?;
            boundary.count(&tested);
            if let Some(found) = &mut boundary.transition {
                found.certainty = tested.certainty;
            }
        }
        boundary.looks.gaps = narrowed.looks;
        boundary.spared += Spared {
            left_out,
            loose,
            replaced: replaced[0],
            interpolated: narrowed.interpolated,
            untested: 0,
        };
        boundary.landings += narrowed.spent[0] + replaced[0];
        boundary.evaluations += narrowed.spent[1] + replaced[1];
        Ok(boundary)
    }

    /// Puts a change to the test.
    pub(crate) async fn tested<Stop>(
        &self,
        ends: [&Sample; 2],
        land: &impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Tested, Stop> {
        let spent = Cell::new([0, 0]);
        let counted = async |speed, variation| {
            let trial = land(speed, variation).await?;
            let [landings, evaluations] = spent.get();
            spent.set([landings + 1, evaluations + trial.evaluations]);
            Ok(trial)
        };
        let certainty = certainty::test(self.doubt, ends, self.scan_step, &counted).await?;
        let [landings, evaluations] = spent.get();
        Ok(Tested {
            certainty,
            is_spared: self.doubt == Doubt::Doubtful && landings == 0,
            landings,
            evaluations,
        })
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

/// A change that was put to the test.
pub(crate) struct Tested {
    /// What came of it.
    pub(crate) certainty: Certainty,
    /// Whether its margins told that there was no need to.
    is_spared: bool,
    landings: u64,
    evaluations: u64,
}

impl Boundary {
    /// Counts what a test took.
    pub(crate) fn count(&mut self, tested: &Tested) {
        self.landings += tested.landings;
        self.tests += tested.landings;
        self.evaluations += tested.evaluations;
        self.spared.untested += u64::from(tested.is_spared);
    }

    /// What a search found that took these landings, in order: the first transition and the cost.
    pub(crate) fn of(samples: &[Sample]) -> Self {
        let transition = first_unstable(samples).map(|index| Transition {
            to: samples[index].class(),
            low: samples[index.saturating_sub(1)].speed,
            high: samples[index].speed,
            certainty: Certainty::default(),
        });
        Self {
            transition,
            landings: samples.len() as u64,
            evaluations: samples.iter().map(|sample| sample.trial.evaluations).sum(),
            ..Self::default()
        }
    }
}

/// Index of the first landing that is not stable.
pub(crate) fn first_unstable(samples: &[Sample]) -> Option<usize> {
    samples
        .iter()
        .position(|sample| sample.class() != Class::Stable)
}

#[cfg(test)]
#[path = "boundary_tests.rs"]
pub(crate) mod tests;
