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
//! * that stayed upright, σ above `UPRIGHT` throughout;
//! * and, if stable, had `STROKE_LEFT` of the stroke of every strut to spare.
//!
//! This is a measured rule and no proof. Of all pairs of landings 0.5, 1, 2 and 4 ft/s apart that end
//! alike, 47 have something else between them, on 623 points (level, tipped, both crush rules,
//! without products of inertia, vertical velocities of 4 to 22 ft/s). Of none did both ends end
//! before 1.84 s, where the rule says 1.5 for the Surveyor, or stay above 0.56 rad, where it says
//! 0.75; but three that bottomed a strut in between stayed above 0.71 rad, with less than 1 % of
//! the stroke left at one end. On all of the points the scan by 0.25 ft/s is reproduced, with
//! 0.18 to 0.48 of its landings and 0.16 to 0.69 of its evaluations (level: 0.39 and 0.54).

use touchdown_dynamics::outcome::Class;

use crate::boundary::{Search, first_unstable};
use crate::trial::Sample;

/// How the range is scanned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scan {
    /// At every step.
    #[default]
    Full,
    /// At every step but between quiet landings.
    Skipping,
}

/// Free-fall times after which a landing has not ended soon.
const SOON: f64 = 1.4;
/// Least stability angle of an upright landing, rad.
const UPRIGHT: f64 = 0.75;
/// Least stroke left at a strut of a quiet landing, in units of the whole stroke.
const STROKE_LEFT: f64 = 0.05;
/// Widest stride, ft/s.
const STRIDE: f64 = 4.0;

impl Search {
    /// Scans the range, or as much of it as lies below the first change away from a stable landing;
    /// returns the landings from below.
    pub(crate) fn scanned<Stop>(
        &self,
        to_first: bool,
        sample: &mut impl FnMut(f64) -> Result<Sample, Stop>,
    ) -> Result<Vec<Sample>, Stop> {
        let steps = self.scan_count() - 1;
        let mut walk = Walk {
            land: |index| sample(self.scan_speed(index)),
            to_first,
            samples: Vec::new(),
        };
        let mut low = walk.to(0)?;
        let mut is_over = to_first && low.class != Class::Stable;
        while !is_over && low.index < steps {
            let high = walk.to((low.index + self.stride()).min(steps))?;
            is_over = walk.between(&low, &high)?;
            low = high;
        }
        let mut samples = walk.samples;
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
    samples: Vec<Sample>,
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
    F: FnMut(u64) -> Result<Sample, Stop>,
{
    fn to(&mut self, index: u64) -> Result<Place, Stop> {
        let sample = (self.land)(index)?;
        let class = sample.class();
        let trial = &sample.trial;
        let has_stroke_left = class != Class::Stable
            || trial
                .margins
                .bottoming
                .is_some_and(|left| left >= STROKE_LEFT);
        let place = Place {
            index,
            class,
            is_soon: has_stroke_left && trial.duration < SOON,
            is_upright: has_stroke_left && trial.least_angle > UPRIGHT,
        };
        self.samples.push(sample);
        Ok(place)
    }

    /// Looks between two landings; whether the first change was all there was to find, and is found.
    fn between(&mut self, low: &Place, high: &Place) -> Result<bool, Stop> {
        if high.index - low.index == 1 {
            return Ok(self.to_first && high.class != Class::Stable);
        }
        let are_quiet = (low.is_soon && high.is_soon) || (low.is_upright && high.is_upright);
        if low.class == high.class && are_quiet {
            return Ok(false);
        }
        let middle = self.to(low.index + (high.index - low.index) / 2)?;
        Ok(self.between(low, &middle)? || self.between(&middle, high)?)
    }
}

#[cfg(test)]
#[path = "scan_tests.rs"]
mod tests;
