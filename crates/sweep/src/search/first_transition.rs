//! The first speed at which a lander does no longer land stably.
//!
//! Outcomes can re-enter: above the speed at which a lander topples it may be stable again. A
//! bisection over the whole range could then settle on any of the changes, so the range is
//! scanned upward in steps first and only the step in which the outcome changes is narrowed down.

use std::cell::Cell;

use crate::boundary::{Boundary, Tested};
use crate::certainty::{self, Doubt, Variation};
use crate::search_range::Search;
use crate::trial::{Sample, Trial, first_unstable};

impl Search {
    /// Searches the first transition with `land`, which lands at a given horizontal speed with a
    /// variation.
    ///
    /// # Errors
    /// Only what `land` gives up with, at once.
    pub async fn first_transition<Stop>(
        &self,
        land: impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        let scan = self.narrowed_scan(true, &land).await?;
        let samples = &scan.samples;
        let mut boundary = Boundary::of_scan(&scan);
        if let Some(index) = first_unstable(samples).filter(|index| *index > 0) {
            let ends = [&samples[index - 1], &samples[index]];
            let tested = self.tested(ends, &land).await?;
            boundary.count(&tested);
            if let Some(found) = &mut boundary.transition {
                found.certainty = tested.certainty;
            }
        }
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
}

#[cfg(test)]
#[path = "first_transition_tests.rs"]
pub(crate) mod tests;
