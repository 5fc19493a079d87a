//! Landings close to a first transition that is not regular.
//!
//! A lander whose margin runs through zero topples ever sooner above the transition, as a rule. Where margins jump,
//! landings may change back and forth more finely than is worth resolving: turn stable again above it, and topple in
//! slivers below. So the search lands at even parts of the scan steps beside such a transition, and beside one with a
//! stable landing within a scan step above it.

use std::cell::RefCell;

use touchdown_dynamics::outcome::Class;

use crate::boundary::PatchyStretch;
use crate::landings_on_request::{LandAt, Stopped, join_all};
use crate::narrowed_scan::{NarrowedScan, confirmed};
use crate::search_range::Search;
use crate::trial::{Sample, first_unstable, margin_jumps};

/// Landings in a scan step.
const LANDINGS: u32 = 16;

impl NarrowedScan {
    /// The landings at either end of the first transition.
    fn first_transition(&self) -> Option<[&Sample; 2]> {
        let high = first_unstable(&self.samples)?;
        Some([&self.samples[high.checked_sub(1)?], &self.samples[high]])
    }

    /// True if margins jump at the first transition, or if a landing within a scan step above it is stable.
    pub(crate) fn is_first_irregular(&self, scan_step: f64) -> bool {
        let Some([low, high]) = self.first_transition() else {
            return false;
        };
        let is_beside =
            |above: &&Sample| above.speed > high.speed && above.speed <= high.speed + scan_step;
        let mut beside = self.samples.iter().filter(is_beside);
        margin_jumps(low, high) || beside.any(|above| above.class() == Class::Stable)
    }

    /// Lands below the first transition, a scan step at a time, until all landings there are stable.
    pub(crate) async fn look_just_below(
        &mut self,
        search: &Search,
        of_scan: &LandAt<'_>,
        sample: &LandAt<'_>,
    ) -> Result<(), Stopped> {
        let mut not_stable = 1;
        while not_stable > 0
            && let Some([low, _]) = self.first_transition()
        {
            let range = [(low.speed - search.scan_step).max(search.from), low.speed];
            not_stable = (self.look(range, Class::Stable, of_scan, sample)).await?;
        }
        Ok(())
    }

    /// Lands above the first transition, a scan step at a time, until landings there are all stable, or none is.
    pub(crate) async fn look_just_above(
        &mut self,
        search: &Search,
        of_scan: &LandAt<'_>,
        sample: &LandAt<'_>,
    ) -> Result<(), Stopped> {
        let all = u64::from(LANDINGS);
        let mut from = self.first_change();
        let mut is_mixed = true;
        while is_mixed && from < search.to {
            let to = (from + search.scan_step).min(search.to);
            let look = self.look([from, to], Class::Unstable, of_scan, sample);
            let not_stable = look.await?;
            is_mixed = (1..all).contains(&not_stable);
            if is_mixed || (not_stable == 0 && self.patchy.is_none()) {
                let (landings, before) =
                    (self.patchy).map_or((0, 0), |below| (below.landings, below.not_stable));
                self.patchy = Some(PatchyStretch {
                    to,
                    landings: landings + all,
                    not_stable: before + not_stable,
                });
            }
            from = to;
        }
        Ok(())
    }

    /// Lands in the middle of even parts of a range (ft/s), where there is no landing yet; returns the number of those
    /// that are not stable.
    async fn look(
        &mut self,
        [from, to]: [f64; 2],
        expected: Class,
        of_scan: &LandAt<'_>,
        sample: &LandAt<'_>,
    ) -> Result<u64, Stopped> {
        let part = (to - from) / f64::from(LANDINGS);
        let middles: Vec<f64> = (0..LANDINGS)
            .map(|index| from + part * (f64::from(index) + 0.5))
            .collect();
        let dropped = RefCell::new(Vec::new());
        let known: Vec<f64> = self.samples.iter().map(|known| known.speed).collect();
        let new = middles.iter().filter(|speed| !known.contains(speed));
        let landings = new.map(|speed| confirmed(*speed, expected, of_scan, sample, &dropped));
        let landings = join_all(landings).await?;
        self.keep(landings, dropped);
        let is_one =
            |sample: &&Sample| middles.contains(&sample.speed) && sample.class() != Class::Stable;
        Ok(self.samples.iter().filter(is_one).count() as u64)
    }
}

#[cfg(test)]
#[path = "look_beside_tests.rs"]
mod tests;
