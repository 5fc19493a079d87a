//! How well a transition is determined.
//!
//! Near a knife edge (an element that just touches, a rate that just grazes zero) the next digit of
//! anything may decide a landing. Both ends of a bracket are landed at again at a tighter and a
//! looser tolerance and with conditions changed by next to nothing; where a landing ends otherwise,
//! the interval is widened until all of them agree.
//!
//! Where a margin runs through zero the transition is as certain as the trajectory. It is doubtful
//! where the margin jumps across the bracket, or where no margin speaks of the change.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::scene::{Conditions, Scene, Settings};

use crate::trial::{Sample, Trial, margin_jumps};

/// Which transitions are landed at again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Doubt {
    /// Those at which no margin runs through zero.
    #[default]
    Doubtful,
    /// All.
    All,
    /// None.
    None,
}

/// How well a transition is determined.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub enum Certainty {
    /// Nobody asked.
    #[default]
    Untested,
    /// Small changes move it by less than its bracket.
    Certain,
    /// Small changes decide between these two speeds, ft/s.
    Disputed([f64; 2]),
}

impl Certainty {
    /// Cells of a result table: a word, and the ends of what is disputed, ft/s.
    pub fn cells(&self) -> [String; 3] {
        let none = String::new;
        match self {
            Self::Untested => [none(), none(), none()],
            Self::Certain => ["certain".to_owned(), none(), none()],
            Self::Disputed([from, to]) => ["disputed".to_owned(), from.to_string(), to.to_string()],
        }
    }
}

/// A change by which a landing is put to the test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Variation {
    /// None.
    Unchanged,
    /// The solver's tolerance times a factor.
    Tolerance(f64),
    /// The solver's tolerance times a factor, for a scan: steady landings end early.
    Scan(f64),
    /// A turn about the x axis of the ground, deg.
    Tilt(f64),
}

/// All changes tested, the dearest last: what one tells the others need not.
const VARIATIONS: [Variation; 3] = [
    Variation::Tilt(1e-6),
    Variation::Tilt(-1e-6),
    Variation::Tolerance(0.1),
];

/// Landings that a test takes at least: all changes at both ends.
pub const LEAST_LANDINGS: u64 = 2 * VARIATIONS.len() as u64;

/// Range of tolerances of the solver.
const TOLERANCES: [f64; 2] = [1e-12, 1e-2];

impl Variation {
    /// A scene and settings, changed.
    ///
    /// # Errors
    /// When the scene does not bear the change.
    pub fn of(self, scene: &Scene, settings: &Settings) -> Result<(Scene, Settings), Invalid> {
        let conditions = *scene.conditions();
        let mut settings = *settings;
        let conditions = match self {
            Self::Unchanged => conditions,
            Self::Tolerance(factor) => {
                settings = at_tolerance(settings, factor)?;
                conditions
            }
            Self::Scan(factor) => {
                settings = at_tolerance(settings, factor)?.ending_early();
                conditions
            }
            Self::Tilt(degrees) => {
                let tilt = Attitude::from_euler(Euler {
                    pitch: degrees.to_radians(),
                    yaw: 0.0,
                    roll: 0.0,
                });
                Conditions {
                    attitude: tilt.after(&conditions.attitude),
                    ..conditions
                }
            }
        };
        Ok((Scene::new(conditions)?, settings))
    }
}

/// Settings with a factor on their tolerance.
fn at_tolerance(settings: Settings, factor: f64) -> Result<Settings, Invalid> {
    let [least, greatest] = TOLERANCES;
    settings.with_tolerance((settings.tolerance() * factor).clamp(least, greatest))
}

/// Puts the change between two neighbouring landings to the test, if it is one that `doubt` means.
/// The interval is widened by `widest` at most (ft/s) to either side.
pub(crate) async fn test<Stop>(
    doubt: Doubt,
    [low, high]: [&Sample; 2],
    widest: f64,
    land: &impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
) -> Result<Certainty, Stop> {
    match doubt {
        Doubt::None => return Ok(Certainty::Untested),
        Doubt::Doubtful if !margin_jumps(low, high) => return Ok(Certainty::Certain),
        Doubt::Doubtful | Doubt::All => {}
    }
    let width = high.speed - low.speed;
    let mut agreed = [low.speed, high.speed];
    for (end, sample, sign) in [(0, low, -1.0), (1, high, 1.0)] {
        let class = sample.class();
        let agree = async |speed: f64, given: bool| -> Result<bool, Stop> {
            let given = given.then_some(Variation::Unchanged);
            for variation in given.into_iter().chain(VARIATIONS) {
                if land(speed, variation).await?.outcome.class() != class {
                    return Ok(false);
                }
            }
            Ok(true)
        };
        let mut reach = 0.0;
        let mut next = width;
        while reach < widest && !agree(agreed[end], reach > 0.0).await? {
            reach = next.min(widest);
            agreed[end] = (sample.speed + sign * reach).max(0.0);
            next *= 2.0;
        }
    }
    Ok(if agreed == [low.speed, high.speed] {
        Certainty::Certain
    } else {
        Certainty::Disputed(agreed)
    })
}

#[cfg(test)]
#[path = "certainty_tests.rs"]
mod tests;
