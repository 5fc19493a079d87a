//! Result of a boundary search: the first transition, all bands, and the cost.

use std::ops::AddAssign;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::outcome::{Class, Outcome};

pub use crate::search_range::{Extent, Search};

use crate::certainty::Certainty;
use crate::contact_warnings::ContactWarnings;
use crate::hidden_band_checks::HiddenBandChecks;
use crate::trial::{Sample, first_unstable};

/// A range of speeds in which all landings end in the same class.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// Lower end, ft/s: the middle of the bracket below, or the lowest speed searched.
    pub from: f64,
    /// Upper end, ft/s: the middle of the bracket above, or the highest speed searched.
    pub to: f64,
    /// Class of the landings in the band.
    pub class: Class,
    /// Outcome of the computed landing nearest to the middle of the band.
    pub outcome: Outcome,
    /// Bracket of the upper transition; `None` at the end of the range.
    pub bracket: Option<Bracket>,
    /// Certainty of the upper transition.
    pub certainty: Certainty,
}

/// The bracket of a transition between bands.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Bracket {
    /// Width, ft/s.
    pub width: f64,
    /// Solver tolerance of the landings at its ends.
    pub tolerance: f64,
}

/// The first change away from a stable landing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Transition {
    /// Class of the landing at `high`.
    pub to: Class,
    /// Highest speed known to be stable below the change, ft/s; `None` if the lowest speed of the search is not stable,
    /// so that the change lies at or below it.
    pub low: Option<f64>,
    /// Lowest speed known not to be stable, ft/s.
    pub high: f64,
    /// Solver tolerance of the landings at `low` and `high`.
    pub tolerance: f64,
    /// Certainty of the transition.
    pub certainty: Certainty,
}

impl Transition {
    /// Returns the first change away from a stable landing, among landings in order of speed.
    pub(crate) fn first_of(samples: &[Sample]) -> Option<Self> {
        first_unstable(samples).map(|index| Self {
            to: samples[index].class(),
            low: index.checked_sub(1).map(|below| samples[below].speed),
            high: samples[index].speed,
            tolerance: samples[index].trial.tolerance,
            certainty: Certainty::default(),
        })
    }

    /// Middle of the bracket, ft/s; the lowest speed of the search if there is no bracket.
    pub fn speed(&self) -> f64 {
        self.low.map_or(self.high, |low| 0.5 * (low + self.high))
    }
}

/// Speeds above a first transition at which stable landings and others alternate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PatchyStretch {
    /// Upper end, ft/s: whole scan steps above the transition, or the highest speed of the search.
    pub to: f64,
    /// Landings at even parts of it.
    pub landings: u64,
    /// Those of them that are not stable.
    pub not_stable: u64,
}

/// Counts for each skip of a search: the work that skips left out, as far as the search itself knows it.
///
/// The evaluations that a skipped landing would have taken are known only from a search without the skip.
/// `docs/notes/skips.md` has both for the level-vehicle grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Skipped {
    /// Landings a full scan takes in addition; negative if halving strides took more landings above the first change
    /// than were left out below it.
    pub left_out: i64,
    /// Landings at a looser tolerance than the solver's.
    pub loose: u64,
    /// Scan landings computed in vain: loose ones that had to be computed again at the solver's tolerance, and all
    /// landings of a scan that was repeated.
    pub replaced: u64,
    /// Landings that interpolation saved over halving; negative where it led astray.
    pub interpolated: i64,
    /// Transitions not tested because a margin runs through zero there. Each test takes
    /// [`crate::certainty::LEAST_LANDINGS`] or more.
    pub untested: u64,
}

impl AddAssign for Skipped {
    fn add_assign(&mut self, more: Self) {
        self.left_out += more.left_out;
        self.loose += more.loose;
        self.replaced += more.replaced;
        self.interpolated += more.interpolated;
        self.untested += more.untested;
    }
}

/// Number of landings (in order) below the first that is not stable.
fn stable_below(samples: &[Sample]) -> u64 {
    first_unstable(samples).unwrap_or(samples.len()) as u64
}

/// Result and cost of a search.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Boundary {
    /// The first transition, if there is one in the range.
    pub transition: Option<Transition>,
    /// Alternating landings above the first transition; `None` where it is sharp, or where the search did not look.
    pub patchy: Option<PatchyStretch>,
    /// Landings below the first transition, all stable.
    pub stable_below: u64,
    /// Highest speed computed, ft/s; without a transition, landings are stable up to there.
    pub searched_to: f64,
    /// All bands of the range, lowest first; empty if only the first transition was sought.
    pub bands: Vec<Band>,
    /// Intervals between like outcomes that were checked for a hidden band.
    pub checks: HiddenBandChecks,
    /// Work that skips left out.
    pub skipped: Skipped,
    /// Transitions searched again at a tighter tolerance.
    pub searched_again: u64,
    /// Disputed transitions.
    pub disputed: u64,
    /// Landings spent on testing transitions.
    pub tests: u64,
    /// Landings computed, tests included.
    pub landings: u64,
    /// Evaluations of the equations of motion in all of them.
    pub evaluations: u64,
    /// Contact warnings of all these landings.
    pub warnings: ContactWarnings,
}

/// A change after its test.
pub(crate) struct Tested {
    /// Ends of its bracket, if it was searched again at a tighter tolerance.
    pub(crate) ends: Option<[Sample; 2]>,
    /// Result of the test.
    pub(crate) certainty: Certainty,
    /// True if the margins made a test unnecessary.
    pub(crate) is_spared: bool,
    pub(crate) landings: u64,
    pub(crate) evaluations: u64,
}

/// Landings in order, with the tests of the lowest changes between them.
pub(crate) struct Settled {
    /// The landings; brackets searched again replace those found first.
    pub(crate) samples: Vec<Sample>,
    pub(crate) tests: Vec<Tested>,
}

impl Boundary {
    /// Counts a test.
    fn count(&mut self, tested: &Tested) {
        self.landings += tested.landings;
        self.tests += tested.landings;
        self.evaluations += tested.evaluations;
        self.skipped.untested += u64::from(tested.is_spared);
        self.searched_again += u64::from(tested.ends.is_some());
        self.disputed += u64::from(matches!(tested.certainty, Certainty::Disputed(_)));
    }

    /// Records the tests of the changes.
    pub(crate) fn settle(&mut self, settled: &Settled) {
        settled.tests.iter().for_each(|tested| self.count(tested));
        self.transition = Transition::first_of(&settled.samples);
        self.stable_below = stable_below(&settled.samples);
        if let Some(found) = &mut self.transition
            && let (Some(_), Some(tested)) = (found.low, settled.tests.first())
        {
            found.certainty = tested.certainty;
        }
    }

    /// Builds the result of a search from its landings, in order: the first transition and the cost.
    pub(crate) fn of(samples: &[Sample]) -> Self {
        Self {
            transition: Transition::first_of(samples),
            stable_below: stable_below(samples),
            searched_to: samples.last().map_or(0.0, |highest| highest.speed),
            landings: samples.len() as u64,
            evaluations: samples.iter().map(|sample| sample.trial.evaluations).sum(),
            warnings: (samples.iter())
                .map(|sample| sample.trial.warnings)
                .fold(ContactWarnings::default(), ContactWarnings::and),
            ..Self::default()
        }
    }
}
