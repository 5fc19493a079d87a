//! Narrows an interval in which the outcome changes to a bracket of the required width.
//!
//! Bisection takes one landing per halving, and the landings nearest to a transition are the longest of all. The
//! margins of the landings run nearly straight through zero where the outcome changes, so interpolation finds the place
//! in two or three landings. Only speeds that halving can reach are computed, and both ends of the bracket are
//! landings: if an interval holds one transition, the bracket equals that of bisection to the last bit.
//!
//! Measured on 42 intervals with all landings of their lattices computed: the 24 from stable to toppling took 3.1
//! landings in the mean instead of 8, the 7 that bottom 4.3, the 10 from toppling to stable, whose margins often jump,
//! 6.5. Evaluations fell by 45 %. Prediction from neighbouring grid points was measured and left out: extrapolating two
//! neighbours misses by 0.13 ft/s in the median (312 points of Figures 4-5 to 4-25) and is within 0.01 ft/s at 15 % of
//! the points, so it could save at most one of three landings at few of them.
//!
//! On the level-vehicle grid both methods match the first transitions of the reference to 0.001 ft/s except at two
//! points (cross-slope 170 deg, roll 30 deg; 160 and 20). There a toppling band of 0.002 ft/s lies 0.006 and 0.003 ft/s
//! below the transition of the reference, which used halving. Interpolation finds the band, halving the transition.
//!
//! Where margins jump or turn back an interval may hold several changes, so its wide gaps are checked again. Which of
//! several changes is found is a matter of chance with either method.

use touchdown_dynamics::outcome::Class;

use crate::hidden_band_checks::CheckCounts;
use crate::landings_on_request::{LandAt, Stopped};
use crate::lattice::Lattice;
use crate::trial::{Sample, margin_jumps};

/// Method of narrowing brackets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Refinement {
    /// Interpolates margins that decide the change; halves without one.
    #[default]
    Margin,
    /// Halves.
    Bisection,
}

/// Landings in excess of halving that interpolation may spend before it has to halve.
const SLACK: i32 = 2;

/// A gap wider than the interval divided by this is wide.
const WIDE_GAP: u64 = 4;

/// Parameters of narrowing an interval.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Narrowing {
    /// Method of choosing the next speed.
    pub(crate) refinement: Refinement,
    /// Greatest bracket width, ft/s.
    pub(crate) tolerance: f64,
    /// True to narrow changes above the lowest one too.
    pub(crate) to_all: bool,
}

/// Result of narrowing an interval.
#[derive(Debug, Default)]
pub(crate) struct Narrowed {
    /// Landings inside the interval, in no order.
    pub(crate) samples: Vec<Sample>,
    /// Loose ends of the interval that a change lies next to, computed again at the solver's tolerance.
    pub(crate) ends: Vec<Sample>,
    /// Gaps between like landings that were checked for another change.
    pub(crate) checks: CheckCounts,
    /// Landings that interpolation saved over halving.
    pub(crate) interpolated: i64,
}

impl Narrowing {
    /// Narrows the change of class between two landings, and any other met on the way. `sample` lands at the solver's
    /// tolerance; the two landings may be looser.
    pub(crate) async fn between(
        &self,
        low: &Sample,
        high: &Sample,
        sample: &LandAt<'_>,
    ) -> Result<Narrowed, Stopped> {
        let lattice = Lattice::new(low.speed, high.speed, self.tolerance);
        let mut nodes = Vec::new();
        let mut land = async |index| {
            let node = Node {
                index,
                sample: sample(lattice.speed(index)).await?,
            };
            nodes.push(node.clone());
            Ok(node)
        };
        let node = |index, sample: &Sample| Node {
            index,
            sample: sample.clone(),
        };
        let ends = [node(0, low), node(lattice.parts(), high)];
        let [from, to] = ends.clone();
        self.narrow(from, to, &mut land).await?;
        let mut narrowed = Narrowed::default();
        let is_regular = is_regular(&ends, &nodes);
        if self.refinement == Refinement::Margin {
            narrowed.interpolated = lattice.halvings() as i64 - nodes.len() as i64;
        }
        if !is_regular {
            let mut land = async |index| {
                let sample = sample(lattice.speed(index)).await?;
                Ok(Node { index, sample })
            };
            narrowed.checks = self.look_again(&ends, &mut nodes, &mut land).await?;
        }
        for end in &ends {
            let is_beside = |node: &Node| node.index.abs_diff(end.index) == 1;
            let differs = |node: &Node| node.class() != end.class();
            let neighbours = nodes.iter().chain(&ends).filter(|node| is_beside(node));
            if end.sample.is_loose && { neighbours }.any(differs) {
                narrowed.ends.push(sample(end.sample.speed).await?);
            }
        }
        narrowed.samples = nodes.into_iter().map(|node| node.sample).collect();
        Ok(narrowed)
    }

    /// Looks for further changes where a margin jumps or turns back inside the interval: lands at the thirds of each
    /// wide gap between like landings, and narrows what it finds.
    async fn look_again(
        &self,
        ends: &[Node; 2],
        found: &mut Vec<Node>,
        land: &mut impl AsyncFnMut(u64) -> Result<Node, Stopped>,
    ) -> Result<CheckCounts, Stopped> {
        let mut nodes: Vec<Node> = ends.iter().chain(found.iter()).cloned().collect();
        nodes.sort_by_key(|node| node.index);
        let wide = ends[1].index / WIDE_GAP;
        let gaps = nodes
            .windows(2)
            .take_while(|pair| self.to_all || pair[1].class() == ends[0].class())
            .filter(|pair| {
                pair[0].class() == pair[1].class() && pair[1].index - pair[0].index > wide.max(2)
            });
        let mut looks = CheckCounts::default();
        for gap in gaps {
            let [below, above] = [&gap[0], &gap[1]];
            let width = above.index - below.index;
            let mut kept = async |index| {
                let node = land(index).await?;
                found.push(node.clone());
                Ok(node)
            };
            let thirds = [
                kept(below.index + width / 3).await?,
                kept(above.index - width / 3).await?,
            ];
            looks.count(thirds.iter().any(|node| node.class() != below.class()));
            let [first, second] = &thirds;
            for [low, high] in [[below, first], [first, second], [second, above]] {
                self.narrow(low.clone(), high.clone(), &mut kept).await?;
            }
        }
        Ok(looks)
    }

    async fn narrow(
        &self,
        mut low: Node,
        mut high: Node,
        land: &mut impl AsyncFnMut(u64) -> Result<Node, Stopped>,
    ) -> Result<(), Stopped> {
        let most = libm::log2((high.index - low.index) as f64).ceil() as i32 + SLACK;
        let mut landings = 0;
        let mut outside: Option<Node> = None;
        while low.class() != high.class() && high.index - low.index > 1 {
            let aim = match self.refinement {
                Refinement::Margin => aim_of(&low, &high, outside.as_ref()),
                Refinement::Bisection => None,
            };
            landings += 1;
            // The rest must stay within reach of halving.
            let widest = libm::ldexp(1.0, most - landings);
            let node = land(place(aim, low.index, high.index, widest)).await?;
            if node.class() == low.class() {
                outside = Some(std::mem::replace(&mut low, node));
            } else if node.class() == high.class() {
                outside = Some(std::mem::replace(&mut high, node));
            } else {
                if self.to_all {
                    Box::pin(self.narrow(node.clone(), high, land)).await?;
                }
                high = node;
                outside = None;
            }
        }
        Ok(())
    }
}

/// True if the class changes once along the landings, at a margin that runs through zero and never turns back.
fn is_regular(ends: &[Node; 2], between: &[Node]) -> bool {
    let mut nodes: Vec<&Node> = ends.iter().chain(between).collect();
    nodes.sort_by_key(|node| node.index);
    let changes: Vec<&[&Node]> = nodes
        .windows(2)
        .filter(|pair| pair[0].class() != pair[1].class())
        .collect();
    let [change] = changes[..] else {
        return false;
    };
    let [low, high] = [change[0], change[1]];
    let classes = [low.class(), high.class()];
    let margins: Option<Vec<f64>> = nodes.iter().map(|node| node.margin(classes)).collect();
    let falls = |a: f64, b: f64| match classes[0] {
        Class::Stable => a > b,
        _ => a < b,
    };
    !margin_jumps(&low.sample, &high.sample)
        && margins.is_some_and(|margins| margins.windows(2).all(|pair| falls(pair[0], pair[1])))
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

/// Place where the margin that decides the change between two landings passes zero ([`aim`]).
fn aim_of(low: &Node, high: &Node, outside: Option<&Node>) -> Option<f64> {
    let classes = [low.class(), high.class()];
    let point = |node: &Node| Some([node.index as f64, node.margin(classes)?]);
    aim(point(low)?, point(high)?, outside.and_then(point))
}

/// Zero of a margin between two landings, each given by lattice place and margin: on the line through both, or on the
/// parabola through a further landing `outside` too if the margin is monotone. `None` without a change of sign.
pub(crate) fn aim(a: [f64; 2], b: [f64; 2], outside: Option<[f64; 2]>) -> Option<f64> {
    let changes_sign = (a[1] > 0.0) != (b[1] > 0.0);
    let line = || a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]);
    changes_sign.then(|| {
        outside
            .and_then(|c| inverse(a, b, c))
            .filter(|place| (a[0]..b[0]).contains(place))
            .unwrap_or_else(line)
    })
}

/// Zero of the parabola through three points that gives the place as a function of the margin; `None` if the margin is
/// not monotone over them.
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

/// The next place to land at: next to the aim, on the side of the farther end, with neither part wider than `widest`;
/// the middle if there is no aim.
pub(crate) fn place(aim: Option<f64>, low: u64, high: u64, widest: f64) -> u64 {
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
