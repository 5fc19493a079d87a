//! Refines a first-level interval of a map over one axis.
//!
//! An interval is halved if its ends have different bands, down to the width of an edge, or if the transitions at its
//! middle are off the straight lines between those at its ends. The wanted places of an interval depend on its known
//! places alone, so the order in which they become known does not matter.

use touchdown_input::points::refined_grid::MapRules;

use crate::maps::cell::Cell;
use crate::maps::cell_refinement::{END, Leaf, Refined, UNKNOWN};
use crate::maps::height::SpeedBands;
use crate::maps::located_side::BRACKET;

/// Refines a first-level interval.
pub(crate) fn refined<'k>(
    interval: Cell,
    rules: &MapRules,
    bands: impl Fn(usize) -> Option<&'k SpeedBands>,
) -> Refined {
    let mut refinement = Refinement {
        rules,
        bands,
        refined: Refined::default(),
    };
    let [low, size] = [interval.low[0], interval.size[0]];
    let ends = [low, low + size].map(|place| refinement.ask(place, f64::INFINITY));
    if let [Some(a), Some(b)] = ends {
        refinement.visit([low, size], [a, b], None);
    }
    refinement.refined
}

struct Refinement<'r, F> {
    rules: &'r MapRules,
    bands: F,
    refined: Refined,
}

impl<'k, F: Fn(usize) -> Option<&'k SpeedBands>> Refinement<'_, F> {
    /// Bands of a place; `None` if they must be known first.
    fn ask(&mut self, place: usize, urgency: f64) -> Option<&'k SpeedBands> {
        let known = (self.bands)(place);
        if known.is_none() {
            self.refined.wanted.insert([place, 0], urgency);
        }
        known
    }

    fn leaf(&mut self, [low, size]: [usize; 2], error: Option<f64>) {
        self.refined.leaves.push(Leaf {
            cell: Cell {
                low: [low, 0],
                size: [size, 0],
            },
            error,
            bend: None,
            check: None,
        });
    }

    /// Visits an interval between two places with known bands; `parent` is the error of the interval it is a half of,
    /// ft/s, if known.
    fn visit(&mut self, [low, size]: [usize; 2], [a, b]: [&'k SpeedBands; 2], parent: Option<f64>) {
        if size <= BRACKET {
            return self.leaf([low, size], parent);
        }
        let leap = a.leap(b);
        // Lines half as long are four times closer to a smooth curve. Intervals without a transition come last.
        let expected = match parent {
            _ if a.are_one() => 0.0,
            None => UNKNOWN,
            Some(error) => 0.5 * error.min(leap),
        };
        let weight = if leap.is_finite() {
            expected.sqrt()
        } else {
            END
        };
        // First-level intervals are equally long, so that lengths compare.
        let urgency = weight * size as f64;
        let half = size / 2;
        let Some(middle) = self.ask(low + half, urgency) else {
            return self.leaf([low, size], parent);
        };
        let error = middle.off_halfway(a, b);
        if error <= self.rules.error {
            return self.leaf([low, size], Some(error));
        }
        let known = if error.is_finite() {
            Some(error)
        } else {
            parent
        };
        self.visit([low, half], [a, middle], known);
        self.visit([low + half, half], [middle, b], known);
    }
}
