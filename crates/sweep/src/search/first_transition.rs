//! The first speed at which a lander does no longer land stably.
//!
//! Outcomes can re-enter: above the speed at which a lander topples it may be stable again. A
//! bisection over the whole range could then settle on any of the changes, so the range is
//! scanned upward in steps first and only the step in which the outcome changes is narrowed down.

use crate::boundary::Boundary;
use crate::certainty::Variation;
use crate::search_range::Search;
use crate::trial::Trial;

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
        let mut boundary = Boundary::of_scan(&scan);
        let is_bracketed = boundary.transition.is_some_and(|found| found.low.is_some());
        let first = usize::from(is_bracketed);
        let settled = self.settled(&scan.samples, first, &land).await?;
        boundary.settle(&settled);
        Ok(boundary)
    }
}

#[cfg(test)]
#[path = "first_transition_tests.rs"]
pub(crate) mod tests;
