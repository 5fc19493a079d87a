//! The scan over the range of speeds that finds where outcomes change.
//!
//! A full scan lands at every step. A skipping scan lands at strides of several steps first and
//! leaves out what lies between two landings that ended alike, when both were *quiet*: the one kind
//! of landing that keeps away from another outcome. All else is halved down to the step, so that a
//! change that either scan finds is found in the same step.
//!
//! A landing is quiet
//! * that ended before `SOON`: it settled or went over on its first feet. Narrow bands lie among
//!   landings that bounce and rock for long;
//! * or that stayed upright, σ above `UPRIGHT` throughout;
//! * if, in either case, it did not fail, and its strut nearest to a stop had `CLEAR` of its stroke to
//!   spare or would have needed as much more. Whether a strut just bottoms changes back and forth with the speed.
//!
//! This is a measured rule and no proof. Of all pairs of landings 0.5, 1, 2 and 4 ft/s apart that end
//! alike and are clear of their stops, 2077 have another band between them, failures apart, on 4185 points (those of the
//! figures, every fourth of the surface of Figure 4-20, every fifth of the trade, slopes of 5 to 25 deg, friction of 0.5 to 1.3, vertical
//! velocities of 4 to 22 ft/s, both crush rules, and 1500 tipped, spinning vehicles of other mass, height,
//! strength and damping). Of none did both ends stay above 0.741 rad, of none with the report's vehicle above 0.617. Of
//! nine, at three of the 1500, both ended before 1.4 free-fall times, of none with the report's vehicle before 1.74. On all
//! of the points the scan by 0.25 ft/s is reproduced but for three bands of failures between stable landings, with 0.46 of its
//! landings and 0.69 of its evaluations (figures 0.53, level grid 0.52).

use std::cell::RefCell;

use futures::future::try_join;
use touchdown_dynamics::outcome::Class;

use crate::join_all::join_all;
pub use crate::search_range::Scan;

use crate::search_range::Search;
use crate::trial::Sample;
use crate::trial::first_unstable;

/// Free-fall times after which a landing has not ended soon.
const SOON: f64 = 1.4;
/// Least stability angle of an upright landing, rad.
const UPRIGHT: f64 = 0.75;
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
    samples: RefCell<Vec<Sample>>,
}

/// A place of the scan that was landed at.
struct Place {
    index: u64,
    class: Class,
    is_soon: bool,
    is_upright: bool,
}

impl<F, Stop> Walk<F>
where
    F: AsyncFn(u64) -> Result<Sample, Stop>,
{
    async fn to(&self, index: u64) -> Result<Place, Stop> {
        let sample = (self.land)(index).await?;
        let class = sample.class();
        let trial = &sample.trial;
        let margin = trial.margins.bottoming;
        let is_clear = class != Class::Failure && margin.is_some_and(|m| m.abs() >= CLEAR);
        let place = Place {
            index,
            class,
            is_soon: is_clear && class != Class::Undecided && trial.duration < SOON,
            is_upright: is_clear && trial.least_angle > UPRIGHT,
        };
        self.samples.borrow_mut().push(sample);
        Ok(place)
    }

    /// Lands between two landings; whether the first change was all there was to find, and is found.
    async fn between(&self, low: &Place, high: &Place) -> Result<bool, Stop> {
        if high.index - low.index == 1 {
            return Ok(self.to_first && high.class != Class::Stable);
        }
        let are_quiet = (low.is_soon && high.is_soon) || (low.is_upright && high.is_upright);
        if low.class == high.class && are_quiet {
            return Ok(false);
        }
        let middle = self.to(low.index + (high.index - low.index) / 2).await?;
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

#[cfg(test)]
#[path = "scan_tests.rs"]
mod tests;
