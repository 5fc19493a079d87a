//! Steady standing or sliding, from which the outcome is known. It ends landings in the scan of a search, and slides
//! that friction cannot stop.
//!
//! The rules are measured, not proven (`docs/notes/early-end.md` has the evidence): a stability angle well above zero
//! that has stayed within a few degrees for a while has never been seen to fall to zero.

use super::rest::free_fall;
use crate::outcome::Outcome;
use crate::rules::RestRule;
use crate::scene::{Scene, Settings};
use crate::state::Body;
use crate::vehicle::Vehicle;

/// Least stability angle of a vehicle far from toppling, and of one that slides upright, rad.
const UPRIGHT: f64 = 0.7;
const SLIDES_UPRIGHT: f64 = 0.1;
/// Band within which a steady stability angle stays, rad.
const RANGE: f64 = 0.05;
/// Time that it stays there before a landing of a scan ends, and the earliest end, in free falls of the CG from its
/// height at touchdown.
const STEADY: f64 = 0.4;
const EARLIEST: f64 = 0.5;
/// Time that it stays there before a slide counts as endless, in the same free falls.
const ENDLESS: f64 = 2.0;
/// Downhill speed above which no foot sticks, ft/s: that above which motion has not subsided.
const SLIDING: f64 = 2.0;

/// A stretch of time over which the stability angle has stayed within a band.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// Least angle that counts, rad.
    least: f64,
    since: f64,
    lowest: f64,
    highest: f64,
}

impl Stretch {
    fn above(least: f64) -> Self {
        Self {
            least,
            since: 0.0,
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
        }
    }

    #[inline(always)]
    fn note(&mut self, time: f64, angle: f64) {
        self.lowest = self.lowest.min(angle);
        self.highest = self.highest.max(angle);
        if self.lowest < self.least || self.highest - self.lowest > RANGE {
            (self.since, self.lowest, self.highest) = (time, angle, angle);
        }
    }
}

/// Tracks how long the stability angle is steady.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steadiness {
    /// Time of a free fall of the CG from its height at touchdown, s.
    fall_time: f64,
    /// True if landings of a scan may end early; where supports tell when a vehicle is at rest, that is soon enough.
    may_end_early: bool,
    /// Slope (sine, cosine) on which sliding friction cannot hold the vehicle.
    slippery: Option<(f64, f64)>,
    /// Downhill speed above which a slide on it counts, ft/s.
    sliding_speed: f64,
    upright: Stretch,
    sliding: Stretch,
}

impl Steadiness {
    pub(super) fn new(
        vehicle: &Vehicle,
        scene: &Scene,
        settings: &Settings,
        rule: RestRule,
    ) -> Self {
        let conditions = scene.conditions();
        let (sine, cosine) = libm::sincos(conditions.slope);
        let friction = conditions.pad_friction.max(conditions.block_friction);
        Self {
            fall_time: free_fall(vehicle.standing_height(), scene.gravity(vehicle)),
            slippery: (sine.abs() > friction * cosine).then_some((sine, cosine)),
            may_end_early: rule == RestRule::Limits,
            sliding_speed: match rule {
                RestRule::Limits => SLIDING,
                // Static friction may hold a vehicle there that creeps.
                RestRule::Energy => (conditions.static_friction_ratio)
                    .map_or(0.0, |_| scene.friction_law(settings).viscous_limit()),
            },
            upright: Stretch::above(UPRIGHT),
            sliding: Stretch::above(SLIDES_UPRIGHT),
        }
    }

    /// Notes the stability angle (rad) at a time (s).
    #[inline(always)]
    pub(super) fn note(&mut self, time: f64, angle: f64) {
        self.upright.note(time, angle);
        self.sliding.note(time, angle);
    }

    /// Outcome of the landing at a time (s) with this motion of the body, if it is known: for slides that friction
    /// cannot stop and, where it `ends_early`, for all steady landings.
    #[inline(always)]
    pub(super) fn end(&self, time: f64, body: &Body<f64>, ends_early: bool) -> Option<Outcome> {
        let steady = |stretch: &Stretch| (time - stretch.since) / self.fall_time;
        let ends_early = ends_early && self.may_end_early;
        if ends_early && steady(&self.upright) >= STEADY && time >= EARLIEST * self.fall_time {
            return Some(Outcome::StableSteady);
        }
        let (sine, cosine) = self.slippery?;
        // On a negative slope Y points downhill.
        let downhill = (sine * body.velocity.z - cosine * body.velocity.y) * sine.signum();
        (downhill > self.sliding_speed && steady(&self.sliding) >= ENDLESS)
            .then_some(Outcome::Sliding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_starts_anew_where_it_is_left() {
        let mut stretch = Stretch::above(UPRIGHT);
        let angles = [0.8, 0.9, 0.94, 0.91, 0.99, 0.97, 0.6, 0.95];
        let since = angles.iter().enumerate().map(|(second, &angle)| {
            stretch.note(second as f64, angle);
            stretch.since
        });
        assert_eq!(
            since.collect::<Vec<_>>(),
            [0.0, 1.0, 1.0, 1.0, 4.0, 4.0, 6.0, 7.0]
        );
    }
}
