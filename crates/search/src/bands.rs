//! The first transition of a search, or all bands of equal outcome between its lowest and its highest speed.
//!
//! For all bands the whole range is scanned, intervals that may hide a band are checked, and every change between neighbouring
//! landings of different class is narrowed down. A third class met on the way becomes a band of its own.

use futures::future::FutureExt;
use touchdown_dynamics::outcome::Outcome;

use crate::boundary::{Band, Boundary, Bracket};
use crate::certainty::Certainty;
use crate::landings_on_request::{FirstError, Land, Stopped};
use crate::narrowed_scan::NarrowedScan;
use crate::search_range::{Extent, Search};
use crate::trial::{Sample, Trial};
use crate::variation::Variation;

impl Search {
    /// Searches the part of the range given by [`Search::extent`]. `land` computes the landing at a horizontal speed,
    /// with a variation. It is called for several landings at a time where all of them are needed.
    ///
    /// # Errors
    /// Returns at once with the first error of `land`.
    pub async fn boundary<Stop>(
        &self,
        land: impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        let first_error = FirstError::default();
        let (land, kept) = (&land, &first_error);
        let land =
            |speed, variation| async move { kept.keep(land(speed, variation).await) }.boxed_local();
        let found = match self.extent {
            Extent::First => self.first_transition(&land).await,
            Extent::All => self.all_bands(&land).await,
        };
        first_error.result(found)
    }

    /// Searches the first transition. Outcomes can re-enter: above the speed at which a lander topples it may be stable
    /// again, and bisection over the whole range could settle on any of the changes. So the range is first scanned upward
    /// in steps, and only the step in which the outcome changes is narrowed down.
    ///
    /// # Errors
    /// Returns at once if a landing stops.
    async fn first_transition(&self, land: &Land<'_>) -> Result<Boundary, Stopped> {
        let scan = self.narrowed_scan(true, land).await?;
        let mut boundary = boundary(&scan);
        let is_bracketed = boundary.transition.is_some_and(|found| found.low.is_some());
        let first = usize::from(is_bracketed);
        let settled = self.settled(&scan.samples, first, land).await?;
        boundary.settle(&settled);
        Ok(boundary)
    }

    /// Searches all bands. The first transition is that of [`Search::first_transition`], unless a hidden band lies below
    /// it.
    ///
    /// # Errors
    /// Returns at once if a landing stops.
    async fn all_bands(&self, land: &Land<'_>) -> Result<Boundary, Stopped> {
        let scan = self.narrowed_scan(false, land).await?;
        let mut boundary = boundary(&scan);
        let settled = self.settled(&scan.samples, usize::MAX, land).await?;
        boundary.settle(&settled);
        boundary.bands = bands(&settled.samples);
        for (band, tested) in boundary.bands.iter_mut().zip(&settled.tests) {
            band.certainty = tested.certainty;
        }
        Ok(boundary)
    }
}

/// The result of a narrowed scan.
fn boundary(scan: &NarrowedScan) -> Boundary {
    let mut boundary = Boundary {
        checks: scan.checks,
        skipped: scan.skipped,
        patchy: scan.patchy,
        ..Boundary::of(&scan.samples)
    };
    boundary.landings += scan.spent[0];
    boundary.evaluations += scan.spent[1];
    boundary
}

/// Groups landings of the same class into bands, from end to end.
fn bands(samples: &[Sample]) -> Vec<Band> {
    let mut bands: Vec<Band> = Vec::new();
    let runs: Vec<&[Sample]> = samples.chunk_by(|a, b| a.class() == b.class()).collect();
    for (index, run) in runs.iter().enumerate() {
        let [first, last] = [&run[0], &run[run.len() - 1]];
        let next = runs.get(index + 1).map(|run| &run[0]);
        let from = bands.last().map_or(first.speed, |below| below.to);
        let to = next.map_or(last.speed, |next| 0.5 * (last.speed + next.speed));
        let middle = 0.5 * (from + to);
        let distance = |sample: &&Sample| (sample.speed - middle).abs();
        // The outcome of a landing that ended early is not final.
        let told = run
            .iter()
            .filter(|sample| sample.trial.outcome != Outcome::StableSteady);
        let nearest = told
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(first);
        bands.push(Band {
            from,
            to,
            class: first.class(),
            outcome: nearest.trial.outcome.clone(),
            bracket: next.map(|next| Bracket {
                width: next.speed - last.speed,
                tolerance: next.trial.tolerance,
            }),
            certainty: Certainty::default(),
        });
    }
    bands
}

#[cfg(test)]
#[path = "bands_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "first_transition_tests.rs"]
pub(crate) mod first_transition_tests;
