//! The lowest speed at which a lander no longer lands stably.
//!
//! Outcomes can re-enter: above the speed at which a lander topples it may be stable again. Bisection over the whole
//! range could settle on any of the changes. So the range is first scanned upward in steps, and only the step in which
//! the outcome changes is narrowed down.

use crate::boundary::Boundary;
use crate::landings_on_request::{Land, Stopped};
use crate::search_range::Search;

impl Search {
    /// Searches the first transition.
    ///
    /// # Errors
    /// Returns at once if a landing stops.
    pub(crate) async fn first_transition(&self, land: &Land<'_>) -> Result<Boundary, Stopped> {
        let scan = self.narrowed_scan(true, land).await?;
        let mut boundary = Boundary::of_scan(&scan);
        let is_bracketed = boundary.transition.is_some_and(|found| found.low.is_some());
        let first = usize::from(is_bracketed);
        let settled = self.settled(&scan.samples, first, land).await?;
        boundary.settle(&settled);
        Ok(boundary)
    }
}

#[cfg(test)]
#[path = "first_transition_tests.rs"]
pub(crate) mod tests;
