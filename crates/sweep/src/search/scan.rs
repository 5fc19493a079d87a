//! The scan over the range of speeds that finds where outcomes change.
//!
//! A full scan lands at every step. A skipping scan lands at strides of several steps first. Between two landings that
//! ended otherwise it lands where their margins say that the outcome changes, else in the middle, down to the step. What
//! lies between two landings that ended alike is left out when both are quiet and far from ending otherwise:
//!
//! * Both ended within `SOON`, or both stayed upright with σ above `UPRIGHT`. Narrow bands lie among landings that
//!   bounce and rock for long.
//! * Neither failed nor was undecided, and the strut nearest to a stop had `CLEAR` of its stroke to spare or would have
//!   needed as much more: whether a strut just bottoms changes back and forth with the speed.
//! * The mean of their margins against toppling is more than the steepest margin seen would lose over half their distance.
//!
//! This is a measured rule and no proof (`docs/notes/skips.md`).

use std::cell::RefCell;

use futures::future::try_join;
use touchdown_dynamics::outcome::Class;

use crate::join_all::join_all;
use crate::refine::{aim, place};
pub use crate::search_range::Scan;

use crate::search_range::Search;
use crate::trial::{Sample, Trial, first_unstable};

/// Free-fall times after which a landing has not ended soon.
const SOON: f64 = 2.2;
/// Least stability angle of an upright landing, rad.
const UPRIGHT: f64 = 0.6;
/// Change of a margin against toppling with the speed that is not expected to be exceeded, rad² per ft/s.
const STEEPEST: f64 = 0.2;
/// How far the struts of a quiet landing are from just meeting a stop, in units of the whole stroke.
const CLEAR: f64 = 0.05;
/// Widest stride, ft/s.
const STRIDE: f64 = 4.0;

impl Search {
    /// Scans the range, or as much of it as lies below the first change away from a stable landing;
    /// returns the landings from below. Asks for many landings at a time where all of them are needed.
    pub(crate) async fn scanned<Stop>(
        &self,
        to_first: bool,
        sample: &impl AsyncFn(f64) -> Result<Sample, Stop>,
    ) -> Result<Vec<Sample>, Stop> {
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
                is_over = walk.between(&low, &high).await?;
                low = high;
            }
        } else {
            let strides = (0..steps).step_by(walk.stride as usize).chain([steps]);
            let places = join_all(strides.map(|index| walk.to(index))).await?;
            let pairs = places.windows(2);
            join_all(pairs.map(|pair| walk.between(&pair[0], &pair[1]))).await?;
        }
        let mut samples = walk.samples.into_inner();
        samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        Ok(samples)
    }

    /// Landings that a full scan takes more than these of a scan, in order; up to the first change where
    /// that is all that is sought.
    pub(crate) fn left_out(&self, to_first: bool, samples: &[Sample]) -> i64 {
        let end = first_unstable(samples).filter(|_| to_first);
        let full = match end {
            Some(index) => self.steps_to(samples[index].speed) + 1,
            None => self.scan_count(),
        };
        full as i64 - samples.len() as i64
    }

    /// Steps from one landing to the next, before any between them is looked at.
    fn stride(&self) -> u64 {
        match self.scan {
            Scan::Full => 1,
            Scan::Skipping => 1 << libm::log2(STRIDE / self.scan_step).max(0.0) as u32,
        }
    }
}

/// A scan under way.
struct Walk<F> {
    land: F,
    to_first: bool,
    /// Steps from one landing to the next, before any between them is looked at.
    stride: u64,
    /// Width of a step, ft/s.
    step: f64,
    samples: RefCell<Vec<Sample>>,
}

/// Whether a landing ended for sure, its struts clear of their stops.
fn is_clear(trial: &Trial) -> bool {
    let is_decided = !matches!(trial.outcome.class(), Class::Failure | Class::Undecided);
    is_decided && (trial.margins.bottoming).is_some_and(|margin| margin.abs() >= CLEAR)
}

/// A place of the scan that was landed at.
struct Place {
    index: u64,
    class: Class,
    trial: Trial,
}

impl<F, Stop> Walk<F>
where
    F: AsyncFn(u64) -> Result<Sample, Stop>,
{
    async fn to(&self, index: u64) -> Result<Place, Stop> {
        let sample = (self.land)(index).await?;
        let place = Place {
            index,
            class: sample.class(),
            trial: sample.trial.clone(),
        };
        self.samples.borrow_mut().push(sample);
        Ok(place)
    }

    /// Whether nothing between two landings that ended alike can be expected to end otherwise.
    fn is_quiet(&self, low: &Place, high: &Place) -> bool {
        let ends = [&low.trial, &high.trial];
        let are = |quiet: fn(&Trial) -> bool| ends.iter().all(|trial| quiet(trial));
        let half_width = 0.5 * (high.index - low.index) as f64 * self.step;
        let margins = low.trial.margins.toppling.zip(high.trial.margins.toppling);
        let mean = margins.map(|(a, b)| 0.5 * (a + b));
        are(is_clear)
            && (are(|trial| trial.duration < SOON) || are(|trial| trial.least_angle > UPRIGHT))
            && mean.is_some_and(|mean| mean.abs() > STEEPEST * half_width)
    }

    /// Lands between two landings; whether the first change was all there was to find, and is found.
    async fn between(&self, low: &Place, high: &Place) -> Result<bool, Stop> {
        if high.index - low.index == 1 {
            return Ok(self.to_first && high.class != Class::Stable);
        }
        if low.class == high.class && self.is_quiet(low, high) {
            return Ok(false);
        }
        let middle = self.to(next_place(low, high)).await?;
        let below = Box::pin(self.between(low, &middle));
        let above = Box::pin(self.between(&middle, high));
        if !self.to_first && high.index - low.index > self.stride / 4 {
            // Quarters of a stride at once, and not more however many steps there are in it.
            try_join(below, above).await?;
            return Ok(false);
        }
        Ok(below.await? || above.await?)
    }
}

/// Where to land between two places: where their margins say that the outcome changes, else in the middle.
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
