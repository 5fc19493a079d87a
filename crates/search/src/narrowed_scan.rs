//! A scan whose changes are narrowed down at the solver's tolerance.
//!
//! Landings near a change take long, and landings far from one end alike at any tolerance. So scan landings may be
//! computed at several times the solver's tolerance and end early, while those between the ends of a change are
//! computed at the tolerance itself. If an end of the final bracket is still a scan landing, it is computed again. If
//! it then ends otherwise, the change lies beside it and is narrowed there. If no change remains although the scan
//! ended at one, the range is scanned again at the tolerance itself.

use std::cell::RefCell;

use futures::future::FutureExt;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use touchdown_dynamics::outcome::{Class, Outcome};

use crate::boundary::{PatchyStretch, Skipped};
use crate::hidden;
use crate::hidden_band_checks::{CheckCounts, HiddenBandChecks};
use crate::landings_on_request::{self, Land, LandAt, Stopped, join_all};
use crate::refine::Narrowed;
use crate::run_out::run_outs;
use crate::search_range::{Scan, Search};
use crate::trial::{Sample, first_unstable};
use crate::variation::Variation;

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
    /// Alternating landings above the first transition.
    pub(crate) patchy: Option<PatchyStretch>,
    /// Landings that are not among the samples, and their evaluations.
    pub(crate) spent: [u64; 2],
}

impl Search {
    /// Scans the range, or the part below the first change away from a stable landing, and narrows the changes.
    pub(crate) async fn narrowed_scan(
        &self,
        to_first: bool,
        land: &Land<'_>,
    ) -> Result<NarrowedScan, Stopped> {
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
    async fn scan_and_narrow(
        &self,
        variation: Variation,
        to_first: bool,
        land: &Land<'_>,
    ) -> Result<(NarrowedScan, bool), Stopped> {
        let of_scan = |speed| {
            async move {
                let sample = landings_on_request::sample(speed, land(speed, variation)).await?;
                let is_loose = variation != Variation::Unchanged;
                Ok(Sample { is_loose, ..sample })
            }
            .boxed_local()
        };
        let sample = |speed| {
            landings_on_request::sample(speed, land(speed, Variation::Unchanged)).boxed_local()
        };
        let mut scan = NarrowedScan {
            samples: self.scanned(to_first, &of_scan).await?,
            ..NarrowedScan::default()
        };
        scan.skipped.left_out = self.left_out(to_first, &scan.samples);
        scan.skipped.loose = scan.samples.iter().filter(|sample| sample.is_loose).count() as u64;
        if !to_first {
            scan.look_for_hidden_bands(self.scan_step, &sample).await?;
        }
        self.narrow_changes(&mut scan, to_first, &sample).await?;
        // The scan ended too soon, at a loose landing that seemed to be a change.
        let is_whole = scan
            .samples
            .last()
            .is_some_and(|last| last.speed >= self.to);
        let holds = !to_first || is_whole || first_unstable(&scan.samples).is_some();
        if holds && self.parts_below > 1 {
            let (landings, first) = (scan.samples.len(), scan.first_change());
            scan.look_closer(self, &of_scan, &sample).await?;
            scan.follow_margins(&sample).await?;
            scan.checks.below = CheckCounts {
                checks: (scan.samples.len() - landings) as u64,
                finds: u64::from(scan.first_change() < first),
            };
            scan.draw_below(self.from, &of_scan, &sample).await?;
            if scan.first_change() < first {
                self.narrow_changes(&mut scan, to_first, &sample).await?;
            }
            if scan.is_first_irregular(self.scan_step) {
                scan.look_just_below(self, &of_scan, &sample).await?;
                self.narrow_changes(&mut scan, to_first, &sample).await?;
                scan.look_just_above(self, &of_scan, &sample).await?;
                self.narrow_changes(&mut scan, to_first, &sample).await?;
            }
        }
        Ok((scan, holds))
    }

    /// Narrows the changes between the landings of a scan.
    async fn narrow_changes(
        &self,
        scan: &mut NarrowedScan,
        to_first: bool,
        sample: &LandAt<'_>,
    ) -> Result<(), Stopped> {
        loop {
            let changes = scan.wide_changes(self.tolerance, to_first);
            let narrowing = self.narrowing(!to_first);
            let narrowed = changes
                .iter()
                .map(|[low, high]| narrowing.between(low, high, sample));
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
                return Ok(());
            }
        }
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

    /// Lowest speed that is not stable, ft/s; infinite if there is none.
    pub(crate) fn first_change(&self) -> f64 {
        first_unstable(&self.samples).map_or(f64::INFINITY, |index| self.samples[index].speed)
    }

    /// Landings below the first change.
    fn below_first(&self) -> &[Sample] {
        &self.samples[..first_unstable(&self.samples).unwrap_or(self.samples.len())]
    }

    /// Lands where margins run out below the first change.
    async fn follow_margins(&mut self, sample: &LandAt<'_>) -> Result<(), Stopped> {
        let run_outs = run_outs(self.below_first()).into_iter();
        let landings = join_all(run_outs.map(|run_out| run_out.follow(sample))).await?;
        self.insert(landings.into_iter().flatten().collect());
        Ok(())
    }

    /// Scans closer below the first change. What is not stable there is landed at the solver's tolerance at once: a
    /// change that is only there at a looser one would hide those above it.
    async fn look_closer(
        &mut self,
        search: &Search,
        of_scan: &LandAt<'_>,
        sample: &LandAt<'_>,
    ) -> Result<(), Stopped> {
        let dropped = RefCell::new(Vec::new());
        let closer =
            |speed| confirmed(speed, Class::Stable, of_scan, sample, &dropped).boxed_local();
        let closer = search.scanned_closer(&self.samples, &closer).await?;
        self.keep(closer, dropped);
        Ok(())
    }

    /// Lands at a speed drawn at random below the first change. The lowest landing seeds it, so that a place has the
    /// same speed in any sweep.
    async fn draw_below(
        &mut self,
        from: f64,
        of_scan: &LandAt<'_>,
        sample: &LandAt<'_>,
    ) -> Result<(), Stopped> {
        let [lowest, .., highest] = self.below_first() else {
            return Ok(());
        };
        let seed = lowest.trial.least_angle.to_bits() ^ lowest.trial.duration.to_bits();
        let part: f64 = ChaCha8Rng::seed_from_u64(seed).random();
        let speed = from + part * (highest.speed - from);
        let dropped = RefCell::new(Vec::new());
        let drawn = confirmed(speed, Class::Stable, of_scan, sample, &dropped).await?;
        self.checks.drawn.count(drawn.class() != Class::Stable);
        self.keep(vec![drawn], dropped);
        Ok(())
    }

    /// Adds landings, and counts the loose ones that they replace.
    pub(crate) fn keep(&mut self, landings: Vec<Sample>, dropped: RefCell<Vec<Sample>>) {
        self.skipped.loose += landings.iter().filter(|sample| sample.is_loose).count() as u64;
        self.insert(landings);
        for loose in dropped.into_inner() {
            self.spend(&loose);
            self.skipped.loose += 1;
            self.skipped.replaced += 1;
        }
    }

    /// Checks the intervals that may hide a band.
    async fn look_for_hidden_bands(
        &mut self,
        scan_step: f64,
        sample: &LandAt<'_>,
    ) -> Result<(), Stopped> {
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

/// A loose landing if it is stable, or is not, as a landing of class `expected`; else one at the solver's tolerance, the
/// loose one going to `dropped`.
pub(crate) async fn confirmed(
    speed: f64,
    expected: Class,
    of_scan: &LandAt<'_>,
    sample: &LandAt<'_>,
    dropped: &RefCell<Vec<Sample>>,
) -> Result<Sample, Stopped> {
    let loose = of_scan(speed).await?;
    let is_stable = |class| class == Class::Stable;
    if !loose.is_loose || is_stable(loose.class()) == is_stable(expected) {
        return Ok(loose);
    }
    dropped.borrow_mut().push(loose);
    sample(speed).await
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;
    use crate::bands::first_transition_tests::SEARCH;
    use crate::boundary::{Boundary, Extent};
    use crate::trial::Trial;
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

    const CLOSER: Search = Search {
        parts_below: 5,
        ..SEARCH
    };

    /// The first transition among landings that topple in a band and from 11.4 ft/s on.
    fn first(search: Search, band: [f64; 2], loose_band: [f64; 2]) -> Boundary {
        let found: Result<_, Infallible> = block_on(search.boundary(async |speed, variation| {
            let [from, to] = match variation {
                Variation::Tolerance(_) => loose_band,
                _ => band,
            };
            let topples = (from..to).contains(&speed) || speed >= 11.4;
            let class = if topples {
                Class::Unstable
            } else {
                Class::Stable
            };
            Ok(Trial::example(class, 1))
        }));
        let Ok(boundary) = found;
        boundary
    }

    #[test]
    fn a_band_below_the_transition_is_found_at_parts_of_a_step() {
        let step = SEARCH.scan_step;
        let band = [9.0 + 0.55 * step, 9.0 + 0.7 * step];
        for extent in [Extent::First, Extent::All] {
            let found = |parts_below| {
                let search = Search {
                    extent,
                    parts_below,
                    ..SEARCH
                };
                first(search, band, band)
            };
            let [coarse, close] = [1, 5].map(found);
            assert!((coarse.transition.unwrap().speed() - 11.4).abs() < SEARCH.tolerance);
            assert_eq!(coarse.checks.below, CheckCounts::default());
            assert!((close.transition.unwrap().speed() - band[0]).abs() < SEARCH.tolerance);
            assert_eq!(close.checks.below.finds, 1);
            if extent == Extent::All {
                assert_eq!(close.bands.len(), 4);
            }
        }
    }

    #[test]
    fn a_band_that_is_there_only_at_a_looser_tolerance_hides_none_above_it() {
        let step = SEARCH.scan_step;
        let at = |speed: f64| [speed + 0.55 * step, speed + 0.7 * step];
        let loose = Search {
            scan_looseness: 10.0,
            ..CLOSER
        };
        let (low, high) = (at(9.0), at(10.0));
        // Both are there at the looser tolerance, the upper one alone at the tolerance itself.
        let found = first(loose, high, [low[0], high[1]]);
        assert!((found.transition.unwrap().speed() - high[0]).abs() < SEARCH.tolerance);
    }
}
