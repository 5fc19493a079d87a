//! Certainty of a transition.
//!
//! Near a knife edge (an element that just touches, a rate that just grazes zero) the next digit of anything may decide
//! a landing. A test computes both ends of a bracket again at a tighter tolerance and with a minute tilt. If a landing
//! ends otherwise, the interval is widened until all agree, and searched again (`search_again`).
//!
//! Where a margin runs through zero the transition is as certain as the trajectory. It is doubtful where the margin
//! jumps across the bracket, or where no margin decides the change. A margin that changes as fast on either side of the
//! bracket as within it is steep and does not jump.
//!
//! Across 280 brackets of Phase II, the level grid and `crates/lab/sweeps/strut-stops.toml` a margin changes by more than
//! `LEAST_JUMP`; at 106 of them it changes at most four times as fast as on either side. Tests moved 11 of these, none
//! by more than a bracket, and 54 of the 174 others.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::quantities::TOLERANCE;

use crate::landings_on_request::{Land, Stopped};
use crate::trial::{LEAST_JUMP, Sample};
use crate::variation::Variation;

/// Transitions that are tested.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Doubt {
    /// Those where no margin runs through zero.
    #[default]
    Doubtful,
    /// All.
    All,
    /// None.
    None,
}

/// Certainty of a transition.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub enum Certainty {
    /// Not tested.
    #[default]
    Untested,
    /// Small changes move it by less than its bracket.
    Certain,
    /// Small changes decide between these two speeds (ft/s), even at the tightest tolerance searched.
    Disputed([f64; 2]),
}

impl Certainty {
    /// Word in results; none if not tested.
    pub fn word(self) -> &'static str {
        match self {
            Self::Untested => "",
            Self::Certain => "certain",
            Self::Disputed(_) => "disputed",
        }
    }

    /// Ends of the disputed interval, ft/s, if it is.
    pub fn disputed(self) -> [Option<f64>; 2] {
        match self {
            Self::Disputed(ends) => ends.map(Some),
            Self::Untested | Self::Certain => [None, None],
        }
    }
}

/// Least number of landings of a test: one at either end.
pub const LEAST_LANDINGS: u64 = 2;

/// Factor from the tolerance of a landing to that of its test.
const TIGHTER: f64 = 0.1;

/// Tilt of a test landing, deg.
const TILT: f64 = 1e-6;

/// The variation that tests a landing computed at a solver tolerance.
fn testing(tolerance: f64) -> Variation {
    Variation::At {
        tolerance: (TIGHTER * tolerance).max(TOLERANCE.range.lower),
        tilt: TILT,
    }
}

/// Greatest rate of change of a steep margin across a bracket, as a multiple of that on either side.
const STEEPEST: f64 = 4.0;

/// True if no margin decides the change between two runs of like landings, or if that margin jumps.
pub(crate) fn is_doubtful(below: &[Sample], above: &[Sample]) -> bool {
    let ([.., low], [high, ..]) = (below, above) else {
        return true;
    };
    let classes = [low.class(), high.class()];
    let change = |a: &Sample, b: &Sample| {
        let margins = [a, b].map(|sample| sample.trial.margin(classes));
        let [Some(a), Some(b)] = margins else {
            return None;
        };
        Some((b - a).abs())
    };
    let Some(jump) = change(low, high) else {
        return true;
    };
    let rate = |a, b| Some(change(a, b)? / (b.speed - a.speed));
    let is_as_steep = |beside: Option<f64>| {
        beside.is_some_and(|rate| jump <= STEEPEST * rate * (high.speed - low.speed))
    };
    let is_steep = match (below, above) {
        ([.., before, _], [_, after, ..]) => {
            is_as_steep(rate(before, low)) && is_as_steep(rate(high, after))
        }
        _ => false,
    };
    jump > LEAST_JUMP && !is_steep
}

/// Tests the change between two neighbouring landings, which were computed with the variation `given`. Widens the
/// interval by at most `widest` (ft/s) to either side.
pub(crate) async fn test(
    given: Variation,
    [low, high]: [&Sample; 2],
    widest: f64,
    land: &Land<'_>,
) -> Result<Certainty, Stopped> {
    let width = high.speed - low.speed;
    let mut agreed = [low.speed, high.speed];
    for (end, sample, sign) in [(0, low, -1.0), (1, high, 1.0)] {
        let class = sample.class();
        let agree = async |speed: f64, is_new: bool| -> Result<bool, Stopped> {
            let itself = is_new.then_some(given);
            let test = testing(sample.trial.tolerance);
            for variation in itself.into_iter().chain([test]) {
                if land(speed, variation).await?.class != class {
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
