//! Scans the range of speeds for changes of outcome.
//!
//! A full scan lands at every step. A skipping scan first lands at strides of several steps. Between two landings of
//! different class it lands at the aim of their margins, else in the middle, down to single steps. The range between
//! two landings of the same class is left out if both are quiet and far from ending otherwise:
//!
//! * Both ended within `SOON`, or both stayed upright with σ above `UPRIGHT`. Narrow bands lie among landings that
//!   bounce and rock for long. Below the first transition there are hardly any, so when only that is sought it also
//!   suffices that the σ of a third landing is on a line with theirs (`LINE`).
//! * Neither failed nor was undecided, and the strut nearest to a stop had `CLEAR` of its stroke to spare or would have
//!   needed as much more: whether a strut just bottoms changes back and forth with the speed. Less is enough between
//!   landings that lie close together.
//! * The mean of their toppling margins exceeds what the steepest margin seen would lose over half their distance.
//!
//! This rule is measured, not proven (`docs/notes/skips.md`).
//!
//! Below the first change the scan is made closer: between two landings that are not quiet, at parts of a step
//! ([`Search::parts_below`]). Most narrow bands that hide below a transition are found so, at a quarter more cost.

use std::cell::RefCell;

use futures::future::try_join;
use touchdown_dynamics::outcome::Class;

use crate::landings_on_request::{LandAt, Stopped, join_all};
use crate::refine::{aim, place};
pub use crate::search_range::Scan;

use crate::search_range::Search;
use crate::trial::{Sample, Trial, first_unstable};

/// Free-fall times within which a landing has ended soon.
const SOON: f64 = 2.2;
/// Least stability angle of an upright landing, rad.
const UPRIGHT: f64 = 0.6;
/// Assumed greatest change of a toppling margin with speed, rad² per ft/s.
const STEEPEST: f64 = 0.2;
/// Least distance of the struts of quiet landings from just meeting a stop, in units of the whole stroke, at any
/// distance of the landings.
const CLEAR: f64 = 0.05;
/// The same per ft/s between the landings, where that is less, in units of the whole stroke per ft/s.
const CLEAR_PER_SPEED: f64 = 0.03;
/// The same if only the first transition is sought.
const CLEAR_PER_SPEED_TO_FIRST: f64 = 0.02;
/// Tolerance on the least stability angle of a stable landing for lying on the line between two others, rad.
const LINE: f64 = 0.01;
/// Widest stride, ft/s.
const STRIDE: f64 = 4.0;

impl Search {
    /// Scans the range, or the part below the first change away from a stable landing; returns the landings, lowest
    /// speed first. Asks for many landings at a time where all of them are needed.
    pub(crate) async fn scanned(
        &self,
        to_first: bool,
        sample: &LandAt<'_>,
    ) -> Result<Vec<Sample>, Stopped> {
        let steps = self.scan_count() - 1;
        let walk = Walk {
            land: async |index| sample(self.scan_speed(index)).await,
            to_first,
            stride: self.stride(),
            step: self.scan_step,
            samples: RefCell::default(),
        };
        if to_first {
            let mut low = walk.to(0).await?;
            let mut is_over = low.class != Class::Stable;
            while !is_over && low.index < steps {
                let high = walk.to((low.index + walk.stride).min(steps)).await?;
                is_over = walk.between(&low, &high, false).await?;
                low = high;
            }
        } else {
            let strides = (0..steps).step_by(walk.stride as usize).chain([steps]);
            let places = join_all(strides.map(|index| walk.to(index))).await?;
            let pairs = places.windows(2);
            join_all(pairs.map(|pair| walk.between(&pair[0], &pair[1], false))).await?;
        }
        let mut samples = walk.samples.into_inner();
        samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        Ok(samples)
    }

    /// Lands at parts of a scan step between the scan landings (in order) up to the first change, where they are not
    /// quiet; returns the new landings.
    pub(crate) async fn scanned_closer(
        &self,
        samples: &[Sample],
        sample: &LandAt<'_>,
    ) -> Result<Vec<Sample>, Stopped> {
        let step = self.scan_step / f64::from(self.parts_below);
        let speed = |index: u64| (self.from + index as f64 * step).min(self.to);
        let walk = Walk {
            land: async |index| sample(speed(index)).await,
            to_first: true,
            stride: 1,
            step,
            samples: RefCell::default(),
        };
        let last = ((self.to - self.from) / step - 1e-9).ceil();
        let place = |sample: &Sample| Place {
            index: match sample.speed < self.to {
                true => ((sample.speed - self.from) / step).round() as u64,
                false => last as u64,
            },
            class: sample.class(),
            trial: sample.trial.clone(),
        };
        let places: Vec<Place> = samples.iter().map(place).collect();
        for (low, pair) in places.windows(2).enumerate() {
            let around = [
                low.checked_sub(1).map(|below| below..low + 2),
                Some(low..low + 3),
            ];
            let mut threes = around
                .into_iter()
                .flatten()
                .filter_map(|three| places.get(three));
            let on_line = threes.any(|three| are_on_line(&three[0], &three[1], &three[2]));
            if pair[0].class != Class::Stable || walk.between(&pair[0], &pair[1], on_line).await? {
                break;
            }
        }
        Ok(walk.samples.into_inner())
    }

    /// Landings that a full scan takes beyond these scan landings, given in order; counted up to the first change if
    /// only that is sought.
    pub(crate) fn left_out(&self, to_first: bool, samples: &[Sample]) -> i64 {
        let end = first_unstable(samples).filter(|_| to_first);
        let full = match end {
            Some(index) => self.steps_to(samples[index].speed) + 1,
            None => self.scan_count(),
        };
        full as i64 - samples.len() as i64
    }

    /// Steps from one landing to the next on the first pass.
    fn stride(&self) -> u64 {
        match self.scan {
            Scan::Full => 1,
            Scan::Skipping => 1 << libm::log2(STRIDE / self.scan_step).max(0.0) as u32,
        }
    }
}

/// A scan in progress.
struct Walk<F> {
    land: F,
    to_first: bool,
    /// Steps from one landing to the next on the first pass.
    stride: u64,
    /// Width of a step, ft/s.
    step: f64,
    samples: RefCell<Vec<Sample>>,
}

/// True if both landings are decided and their struts are clear of the stops, by `CLEAR`, or by `least` on the same
/// side.
fn are_clear(ends: [&Trial; 2], least: f64) -> bool {
    let is_decided = |trial: &Trial| !matches!(trial.class, Class::Failure | Class::Undecided);
    let [Some(a), Some(b)] = ends.map(|trial| trial.margins.bottoming) else {
        return false;
    };
    let nearest = a.abs().min(b.abs());
    let is_near_enough = (a > 0.0) == (b > 0.0) && nearest >= least;
    ends.into_iter().all(is_decided) && (nearest >= CLEAR || is_near_enough)
}

/// A computed place of the scan.
struct Place {
    index: u64,
    class: Class,
    trial: Trial,
}

impl<F> Walk<F>
where
    F: AsyncFn(u64) -> Result<Sample, Stopped>,
{
    async fn to(&self, index: u64) -> Result<Place, Stopped> {
        let sample = (self.land)(index).await?;
        let place = Place {
            index,
            class: sample.class(),
            trial: sample.trial.clone(),
        };
        self.samples.borrow_mut().push(sample);
        Ok(place)
    }

    /// True if no other outcome is expected between two like landings; `on_line` if a third lies on a line with them.
    fn is_quiet(&self, low: &Place, high: &Place, on_line: bool) -> bool {
        let ends = [&low.trial, &high.trial];
        let are = |quiet: fn(&Trial) -> bool| ends.iter().all(|trial| quiet(trial));
        let width = (high.index - low.index) as f64 * self.step;
        let margins = low.trial.margins.toppling.zip(high.trial.margins.toppling);
        let mean = margins.map(|(a, b)| 0.5 * (a + b));
        let clear_per_speed = match self.to_first {
            true => CLEAR_PER_SPEED_TO_FIRST,
            false => CLEAR_PER_SPEED,
        };
        are_clear(ends, clear_per_speed * width)
            && (on_line
                || are(|trial| trial.duration < SOON)
                || are(|trial| trial.least_angle > UPRIGHT))
            && mean.is_some_and(|mean| mean.abs() > STEEPEST * 0.5 * width)
    }

    /// Lands between two landings, which may lie on a line with a third. Returns true once the first change is found,
    /// if only that is sought.
    async fn between(&self, low: &Place, high: &Place, on_line: bool) -> Result<bool, Stopped> {
        if high.index - low.index <= 1 {
            return Ok(self.to_first && high.class != Class::Stable);
        }
        if low.class == high.class && self.is_quiet(low, high, on_line) {
            return Ok(false);
        }
        let middle = self.to(next_place(low, high)).await?;
        let on_line = self.to_first && are_on_line(low, &middle, high);
        let below = Box::pin(self.between(low, &middle, on_line));
        let above = Box::pin(self.between(&middle, high, on_line));
        if !self.to_first && high.index - low.index > self.stride / 4 {
            // Quarters of a stride run concurrently, no finer parts: that bounds their number.
            try_join(below, above).await?;
            return Ok(false);
        }
        Ok(below.await? || above.await?)
    }
}

/// True if the least stability angles of three stable landings lie on a line.
fn are_on_line(low: &Place, middle: &Place, high: &Place) -> bool {
    let places = [low, middle, high];
    let [a, b, c] = places.map(|place| place.trial.least_angle);
    let part = (middle.index - low.index) as f64 / (high.index - low.index) as f64;
    let are_stable = places.iter().all(|place| place.class == Class::Stable);
    are_stable && (b - (a + part * (c - a))).abs() < LINE
}

/// The next place between two places: the aim of their margins, else the middle.
fn next_place(low: &Place, high: &Place) -> u64 {
    let classes = [low.class, high.class];
    let point = |place: &Place| Some([place.index as f64, place.trial.margin(classes)?]);
    let aim = point(low)
        .zip(point(high))
        .and_then(|(a, b)| aim(a, b, None));
    place(aim, low.index, high.index, f64::INFINITY)
}

#[cfg(test)]
#[path = "scan_tests.rs"]
mod tests;
