//! A scan whose changes are narrowed down at the solver's tolerance.
//!
//! Landings near a change take long, and landings far from one end alike at any tolerance. So scan landings may be
//! computed at several times the solver's tolerance and end early, while those between the ends of a change are
//! computed at the tolerance itself. If an end of the final bracket is still a scan landing, it is computed again. If
//! it then ends otherwise, the change lies beside it and is narrowed there. If no change remains although the scan
//! ended at one, the range is scanned again at the tolerance itself.

use touchdown_dynamics::outcome::{Class, Outcome};

use crate::certainty::Variation;
use crate::hidden;
use crate::hidden_band_checks::HiddenBandChecks;
use crate::join_all::join_all;
use crate::refine::Narrowed;
use crate::search_range::{Scan, Search};
use crate::skipped::Skipped;
use crate::trial::{Sample, Trial, first_unstable};

/// Rounding error allowed in the greatest bracket width, as a part of it.
const ROUNDING: f64 = 1e-9;

/// A scan with its changes narrowed down.
#[derive(Debug, Default)]
pub(crate) struct NarrowedScan {
    /// Landings, lowest speed first.
    pub(crate) samples: Vec<Sample>,
    /// Checks for hidden bands.
    pub(crate) checks: HiddenBandChecks,
    /// Skipped work.
    pub(crate) skipped: Skipped,
    /// Landings that are not among the samples, and their evaluations.
    pub(crate) spent: [u64; 2],
}

impl Search {
    /// Scans the range, or the part below the first change away from a stable landing, and narrows the changes.
    pub(crate) async fn narrowed_scan<Stop>(
        &self,
        to_first: bool,
        land: &impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<NarrowedScan, Stop> {
        let variation = self.scan_variation();
        let (loose, holds) = self.scan_and_narrow(variation, to_first, land).await?;
        if holds {
            return Ok(loose);
        }
        let tight = self.scan_and_narrow(Variation::Unchanged, to_first, land);
        let (mut tight, _) = tight.await?;
        tight.spent[0] += loose.spent[0];
        tight.spent[1] += loose.spent[1];
        loose.samples.iter().for_each(|sample| tight.spend(sample));
        tight.skipped.loose += loose.skipped.loose;
        tight.skipped.replaced += loose.skipped.loose;
        Ok(tight)
    }

    /// Variation with which scan landings are computed.
    fn scan_variation(&self) -> Variation {
        match self.scan {
            Scan::Full if self.scan_looseness == 1.0 => Variation::Unchanged,
            Scan::Full => Variation::Tolerance(self.scan_looseness),
            Scan::Skipping => Variation::Scan(self.scan_looseness),
        }
    }

    /// Scans with such landings and narrows the changes; also returns whether the result holds at the tolerance itself.
    async fn scan_and_narrow<Stop>(
        &self,
        variation: Variation,
        to_first: bool,
        land: &impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<(NarrowedScan, bool), Stop> {
        let of_scan = async |speed| {
            let sample = Sample::at(speed, land(speed, variation)).await?;
            let is_loose = variation != Variation::Unchanged;
            Ok(Sample { is_loose, ..sample })
        };
        let sample = async |speed| Sample::at(speed, land(speed, Variation::Unchanged)).await;
        let mut scan = NarrowedScan {
            samples: self.scanned(to_first, &of_scan).await?,
            ..NarrowedScan::default()
        };
        scan.skipped.left_out = self.left_out(to_first, &scan.samples);
        scan.skipped.loose = scan.samples.iter().filter(|sample| sample.is_loose).count() as u64;
        if !to_first {
            scan.look_for_hidden_bands(self.scan_step, &sample).await?;
        }
        loop {
            let changes = scan.wide_changes(self.tolerance, to_first);
            let narrowing = self.narrowing(!to_first);
            let narrowed = changes
                .iter()
                .map(|[low, high]| narrowing.between(low, high, &sample));
            for narrowed in join_all(narrowed).await? {
                scan.add(narrowed);
            }
            let unproven = scan.unproven(to_first);
            let again = unproven
                .iter()
                .map(|&index| sample(scan.samples[index].speed));
            for (index, again) in unproven.iter().zip(join_all(again).await?) {
                scan.replace(*index, again);
            }
            if changes.is_empty() && unproven.is_empty() {
                break;
            }
        }
        // The scan ended too soon, at a loose landing that seemed to be a change.
        let is_whole = scan
            .samples
            .last()
            .is_some_and(|last| last.speed >= self.to);
        let holds = !to_first || is_whole || first_unstable(&scan.samples).is_some();
        Ok((scan, holds))
    }
}

impl NarrowedScan {
    fn spend(&mut self, sample: &Sample) {
        self.spent[0] += 1;
        self.spent[1] += sample.trial.evaluations;
    }

    /// Replaces a scan landing by one at the solver's tolerance.
    fn replace(&mut self, index: usize, sample: Sample) {
        let replaced = std::mem::replace(&mut self.samples[index], sample);
        self.spend(&replaced);
        self.skipped.replaced += 1;
    }

    /// Adds landings, keeping the order of speed.
    fn insert(&mut self, more: Vec<Sample>) {
        self.samples.extend(more);
        self.samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    }

    /// Checks the intervals that may hide a band.
    async fn look_for_hidden_bands<Stop>(
        &mut self,
        scan_step: f64,
        sample: &impl AsyncFn(f64) -> Result<Sample, Stop>,
    ) -> Result<(), Stop> {
        let samples = &self.samples;
        let suspects = hidden::suspects(samples, scan_step);
        let looks = suspects.iter().map(|suspect| {
            let ends = [&samples[suspect.index], &samples[suspect.index + 1]];
            hidden::look(ends, suspect.otherwise, sample)
        });
        let looks = join_all(looks).await?;
        let mut landings = Vec::new();
        for (suspect, look) in suspects.iter().zip(looks) {
            let class = samples[suspect.index].class();
            let has_found = look.iter().any(|sample| sample.class() != class);
            self.checks.of(class, suspect.otherwise).count(has_found);
            landings.extend(look);
        }
        self.insert(landings);
        Ok(())
    }

    /// Changes of class between neighbouring landings that are wider than a tolerance (ft/s); with `to_first`, at most
    /// the lowest change.
    fn wide_changes(&self, tolerance: f64, to_first: bool) -> Vec<[Sample; 2]> {
        let changes = self
            .samples
            .windows(2)
            .filter(|pair| pair[0].class() != pair[1].class());
        let most = if to_first { 1 } else { usize::MAX };
        let widest = tolerance * (1.0 + ROUNDING);
        let is_wide = |pair: &&[Sample]| pair[1].speed - pair[0].speed > widest;
        { changes.take(most).filter(is_wide) }
            .map(|pair| [pair[0].clone(), pair[1].clone()])
            .collect()
    }

    /// Adds the result of narrowing a change.
    fn add(&mut self, narrowed: Narrowed) {
        self.checks.gaps += narrowed.checks;
        self.skipped.interpolated += narrowed.interpolated;
        for end in narrowed.ends {
            let is_end = |sample: &Sample| sample.speed == end.speed;
            match self.samples.iter().position(is_end) {
                Some(index) if self.samples[index].is_loose => self.replace(index, end),
                // Two changes share this end.
                _ => self.spend(&end),
            }
        }
        self.insert(narrowed.samples);
    }

    /// Indices of scan landings that alone support a result: the lowest if it is not stable, and one of each band in
    /// which all landings ended early.
    fn unproven(&self, to_first: bool) -> Vec<usize> {
        let samples = &self.samples;
        let first = first_unstable(samples).filter(|index| *index == 0 && samples[0].is_loose);
        let mut unproven: Vec<usize> = first.into_iter().collect();
        if to_first {
            return unproven;
        }
        let mut start = 0;
        for band in samples.chunk_by(|a, b| a.class() == b.class()) {
            let ended_early = |sample: &Sample| sample.trial.outcome == Outcome::StableSteady;
            if band[0].class() == Class::Stable && band.iter().all(ended_early) {
                unproven.push(start + band.len() / 2);
            }
            start += band.len();
        }
        unproven
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;
    use crate::boundary::{Boundary, Extent};
    use crate::first_transition::tests::SEARCH;
    use futures::executor::block_on;

    const LOOSE: Search = Search {
        extent: Extent::All,
        scan_looseness: 10.0,
        ..SEARCH
    };

    /// Searches landings that topple from `true_speed` on, or from `loose_speed` at a looser tolerance.
    fn find(search: Search, true_speed: f64, loose_speed: f64) -> Boundary {
        let found: Result<_, Infallible> = block_on(search.boundary(async |speed, variation| {
            let from = match variation {
                Variation::Tolerance(_) => loose_speed,
                _ => true_speed,
            };
            let class = if speed < from {
                Class::Stable
            } else {
                Class::Unstable
            };
            Ok(Trial::example(
                class,
                if variation == Variation::Unchanged {
                    10
                } else {
                    1
                },
            ))
        }));
        let Ok(boundary) = found;
        boundary
    }

    #[test]
    fn what_is_found_holds_at_the_tolerance_itself() {
        for extent in [Extent::First, Extent::All] {
            let loose = Search { extent, ..LOOSE };
            let tight = Search {
                scan_looseness: 1.0,
                ..loose
            };
            // Alike in the scan; off by less than a step of it; off by more.
            for loose_speed in [11.4, 11.45, 11.55, 11.2, 9.0] {
                let (found, expected) = (find(loose, 11.4, loose_speed), find(tight, 11.4, 11.4));
                assert_eq!(found.transition, expected.transition, "{loose_speed}");
                assert_eq!(found.bands, expected.bands, "{loose_speed}");
            }
        }
    }

    #[test]
    fn loose_landings_are_counted_where_they_are_replaced_too() {
        let tight = Search {
            scan_looseness: 1.0,
            ..LOOSE
        };
        let (found, tight) = (find(LOOSE, 11.4, 11.4), find(tight, 11.4, 11.4));
        assert_eq!(found.landings, tight.landings);
        let saved = 9 * LOOSE.scan_count();
        assert_eq!(found.evaluations, tight.evaluations - saved);
        assert_eq!(
            (found.skipped.loose, found.skipped.replaced),
            (LOOSE.scan_count(), 0)
        );
        // From step to step up to the change, from 9 to 11.25 ft/s; a scan that ended at 9 ft/s is made again.
        assert_eq!(find(LOOSE, 11.4, 9.0).skipped.replaced, 10);
        let first = Search {
            extent: Extent::First,
            ..LOOSE
        };
        let again = find(first, 11.4, 9.0).skipped;
        assert_eq!(again.replaced, again.loose);
    }
}
