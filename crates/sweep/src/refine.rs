//! From an interval in which the outcome changes to a bracket as narrow as was asked for.
//!
//! Bisection takes one landing for every halving, and the landings nearest to a transition are the
//! longest of all. The margins of the landings run through zero where the outcome changes, nearly on
//! a straight line, so that interpolating them finds the place in two or three landings. Only speeds
//! that halving can meet are landed at, and both ends of the bracket are landings: where an
//! interval holds one transition, the bracket is that of bisection to the last bit.

use touchdown_dynamics::outcome::Class;

use crate::lattice::Lattice;
use crate::trial::Sample;

/// How brackets are narrowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Refinement {
    /// Interpolates margins where they speak of the change, and halves where they do not.
    #[default]
    Margin,
    /// Halves.
    Bisection,
}

/// Landings more than halving would take that interpolation may spend before it has to halve.
const SLACK: i32 = 2;

/// How an interval is narrowed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Narrowing {
    /// How the next speed is chosen.
    pub(crate) refinement: Refinement,
    /// Greatest width of the brackets, ft/s.
    pub(crate) tolerance: f64,
    /// Whether changes above the lowest that is met are narrowed too.
    pub(crate) to_all: bool,
}

impl Narrowing {
    /// Narrows down the change of class between two landings and any other that is met on the way;
    /// returns the landings in between, in no order.
    pub(crate) fn between<Stop>(
        &self,
        low: &Sample,
        high: &Sample,
        sample: &mut impl FnMut(f64) -> Result<Sample, Stop>,
    ) -> Result<Vec<Sample>, Stop> {
        let lattice = Lattice::new(low.speed, high.speed, self.tolerance);
        let mut found = Vec::new();
        let mut land = |index| {
            let sample = sample(lattice.speed(index))?;
            found.push(sample.clone());
            Ok(Node { index, sample })
        };
        let node = |index, sample: &Sample| Node {
            index,
            sample: sample.clone(),
        };
        self.narrow(node(0, low), node(lattice.parts(), high), &mut land)?;
        Ok(found)
    }

    fn narrow<Stop>(
        &self,
        mut low: Node,
        mut high: Node,
        land: &mut impl FnMut(u64) -> Result<Node, Stop>,
    ) -> Result<(), Stop> {
        let most = ((high.index - low.index) as f64).log2().ceil() as i32 + SLACK;
        let mut landings = 0;
        let mut outside: Option<Node> = None;
        while low.class() != high.class() && high.index - low.index > 1 {
            let aim = match self.refinement {
                Refinement::Margin => aim(&low, &high, outside.as_ref()),
                Refinement::Bisection => None,
            };
            landings += 1;
            // What is left must be within reach of halving.
            let widest = 2f64.powi(most - landings);
            let node = land(place(aim, low.index, high.index, widest))?;
            if node.class() == low.class() {
                outside = Some(std::mem::replace(&mut low, node));
            } else if node.class() == high.class() {
                outside = Some(std::mem::replace(&mut high, node));
            } else {
                if self.to_all {
                    self.narrow(node.clone(), high, land)?;
                }
                high = node;
                outside = None;
            }
        }
        Ok(())
    }
}

/// A landing at a speed of the lattice.
#[derive(Debug, Clone)]
struct Node {
    index: u64,
    sample: Sample,
}

impl Node {
    fn class(&self) -> Class {
        self.sample.class()
    }

    fn margin(&self, classes: [Class; 2]) -> Option<f64> {
        self.sample.trial.margin(classes)
    }
}

/// Where the margin passes zero between two landings, counted in parts of the lattice: on the line
/// through both, or on the parabola through a landing beyond them too where the margin is monotone.
fn aim(low: &Node, high: &Node, outside: Option<&Node>) -> Option<f64> {
    let classes = [low.class(), high.class()];
    let point = |node: &Node| Some([node.index as f64, node.margin(classes)?]);
    let [a, b] = [point(low)?, point(high)?];
    let changes_sign = (a[1] > 0.0) != (b[1] > 0.0);
    let line = || a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]);
    changes_sign.then(|| {
        outside
            .and_then(point)
            .and_then(|c| inverse(a, b, c))
            .filter(|place| (a[0]..b[0]).contains(place))
            .unwrap_or_else(line)
    })
}

/// Place of zero on the parabola through three points in which the place is a function of the margin;
/// `None` where the margin is not monotone over them.
fn inverse(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<f64> {
    let mut points = [a, b, c];
    points.sort_by(|p, q| p[0].total_cmp(&q[0]));
    let [[x0, y0], [x1, y1], [x2, y2]] = points;
    let is_monotone = (y1 - y0) * (y2 - y1) > 0.0;
    is_monotone.then(|| {
        x0 * y1 * y2 / ((y0 - y1) * (y0 - y2))
            + x1 * y0 * y2 / ((y1 - y0) * (y1 - y2))
            + x2 * y0 * y1 / ((y2 - y0) * (y2 - y1))
    })
}

/// The place to land at next: next to the aim, on the side of the farther end, and so that neither
/// part is wider than `widest`; the middle without an aim.
fn place(aim: Option<f64>, low: u64, high: u64, widest: f64) -> u64 {
    let middle = low + (high - low) / 2;
    let Some(aim) = aim else {
        return middle;
    };
    let (a, b) = (low as f64, high as f64);
    let beside = if aim - a < b - aim {
        aim.ceil()
    } else {
        aim.floor()
    };
    let reach = (widest - 0.5 * (b - a)).max(0.0);
    let centre = 0.5 * (a + b);
    let within = beside.max(centre - reach).min(centre + reach).round();
    (within as u64).clamp(low + 1, high - 1)
}

#[cfg(test)]
#[path = "refine_tests.rs"]
mod tests;
