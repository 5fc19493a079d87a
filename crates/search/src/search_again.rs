//! Searches disputed transitions again at tighter tolerances.
//!
//! A bracket found at the solver's tolerance may lie beside the true transition: the trajectory sits on a knife edge of
//! contact, and its error decides. The interval of disagreement found by the test is then narrowed down at 1e-6, 1e-7,
//! ... until the bracket holds at a tenth of its tolerance and for landings with a minute tilt. A transition still
//! disputed at the last tolerance is chaotic: no tolerance settles it.

use std::cell::Cell;

use futures::future::FutureExt;
use touchdown_dynamics::outcome::Class;

use crate::boundary::{Settled, Tested};
use crate::certainty::{self, Certainty, Doubt, is_doubtful};
use crate::landings_on_request::{self, Land, LandAt, Stopped, join_all};
use crate::search_range::Search;
use crate::trial::Sample;
use crate::variation::Variation;

/// Solver tolerances at which a disputed transition is searched again, in turn. The last bracket is compared with
/// landings at 1e-10.
const TOLERANCES: [f64; 4] = [1e-6, 1e-7, 1e-8, 1e-9];

/// Cut of the interval around an earlier bracket, as a part of its width: beside its middle, where that bracket may
/// have ended, next to the transition.
const BESIDE: f64 = 0.45;

impl Search {
    /// Tests the lowest `most` changes between landings in order.
    pub(crate) async fn settled(
        &self,
        samples: &[Sample],
        most: usize,
        land: &Land<'_>,
    ) -> Result<Settled, Stopped> {
        let runs: Vec<&[Sample]> = samples.chunk_by(|a, b| a.class() == b.class()).collect();
        let middle = |run: &[Sample]| 0.5 * (run[0].speed + run[run.len() - 1].speed);
        let tests = (1..runs.len()).take(most).map(|above| {
            let [lower, upper] = [runs[above - 1], runs[above]];
            // Two changes share the landings between them: half each.
            let from = if above == 1 { self.from } else { middle(lower) };
            let to = if above + 1 == runs.len() {
                self.to
            } else {
                middle(upper)
            };
            self.tested([lower, upper], [from, to], land)
        });
        let tests = join_all(tests).await?;
        Ok(Settled {
            samples: with_brackets(&runs, &tests),
            tests,
        })
    }

    /// Tests the change between two runs of landings, if required, and searches it again if disputed. Other changes lie
    /// beyond the `limits` (ft/s).
    async fn tested(
        &self,
        [below, above]: [&[Sample]; 2],
        limits: [f64; 2],
        land: &Land<'_>,
    ) -> Result<Tested, Stopped> {
        let ends = [&below[below.len() - 1], &above[0]];
        let spent = Cell::new([0, 0]);
        let counts = &spent;
        let counted = |speed, variation| {
            async move {
                let trial = land(speed, variation).await?;
                let [landings, evaluations] = counts.get();
                counts.set([landings + 1, evaluations + trial.evaluations]);
                Ok(trial)
            }
            .boxed_local()
        };
        let mut certainty = match self.doubt {
            Doubt::None => Certainty::Untested,
            Doubt::Doubtful if !is_doubtful(below, above) => Certainty::Certain,
            Doubt::Doubtful | Doubt::All => {
                certainty::test(Variation::Unchanged, ends, self.scan_step, &counted).await?
            }
        };
        let is_spared = self.doubt == Doubt::Doubtful && spent.get()[0] == 0;
        let mut found: Option<[Sample; 2]> = None;
        let is_tighter = |tolerance: &f64| *tolerance < ends[0].trial.tolerance;
        for tolerance in TOLERANCES.into_iter().filter(is_tighter) {
            let Certainty::Disputed(interval) = certainty else {
                break;
            };
            let tighter = Variation::At {
                tolerance,
                tilt: 0.0,
            };
            let sample =
                |speed| landings_on_request::sample(speed, counted(speed, tighter)).boxed_local();
            let classes = ends.map(Sample::class);
            let cut = if found.is_none() { 0.5 } else { BESIDE };
            let bracket = self.bracket_of(interval, limits, classes, cut, &sample);
            let Some(again) = bracket.await? else {
                continue;
            };
            let pair = [&again[0], &again[1]];
            certainty = certainty::test(tighter, pair, self.scan_step, &counted).await?;
            if let Certainty::Disputed([low, high]) = &mut certainty {
                *low = low.min(interval[0]);
                *high = high.max(interval[1]);
            }
            found = Some(again);
        }
        let [landings, evaluations] = spent.get();
        Ok(Tested {
            ends: found,
            certainty,
            is_spared,
            landings,
            evaluations,
        })
    }

    /// Narrows an interval to a bracket of a change between two classes. If its ends are of other classes, it is
    /// widened by a scan step at most; `None` if no such change lies alone between the limits.
    async fn bracket_of(
        &self,
        [from, to]: [f64; 2],
        limits: [f64; 2],
        classes: [Class; 2],
        cut: f64,
        sample: &LandAt<'_>,
    ) -> Result<Option<[Sample; 2]>, Stopped> {
        let bounded = |speed: f64| speed.clamp(limits[0], limits[1]);
        let mut reach = to - from;
        let (mut low, mut high) = (sample(bounded(from)).await?, sample(bounded(to)).await?);
        while low.class() != classes[0] || high.class() != classes[1] {
            if reach > self.scan_step {
                return Ok(None);
            }
            if low.class() != classes[0] {
                low = sample(bounded(from - reach)).await?;
            }
            if high.class() != classes[1] {
                high = sample(bounded(to + reach)).await?;
            }
            reach *= 2.0;
        }
        while high.speed - low.speed > self.tolerance {
            let between = sample(low.speed + cut * (high.speed - low.speed)).await?;
            match between.class() {
                class if class == classes[0] => low = between,
                class if class == classes[1] => high = between,
                _ => return Ok(None),
            }
        }
        Ok(Some([low, high]))
    }
}

/// Runs of like landings; brackets searched again replace those found first.
fn with_brackets(runs: &[&[Sample]], tests: &[Tested]) -> Vec<Sample> {
    let bracket = |change: Option<usize>| tests.get(change?)?.ends.as_ref();
    let mut kept = Vec::new();
    for (index, run) in runs.iter().enumerate() {
        let (below, above) = (bracket(index.checked_sub(1)), bracket(Some(index)));
        let first = below.map(|[_, high]| high);
        let last = above.map(|[low, _]| low);
        let is_beyond = |sample: &&Sample| {
            first.is_none_or(|first| sample.speed > first.speed)
                && last.is_none_or(|last| sample.speed < last.speed)
        };
        kept.extend(first.cloned());
        kept.extend(run.iter().filter(is_beyond).cloned());
        kept.extend(last.cloned());
    }
    kept
}

#[cfg(test)]
#[path = "search_again_tests.rs"]
mod tests;
