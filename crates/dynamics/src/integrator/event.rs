//! Event location: the first exit of a signal from the range over which the active laws hold.
//!
//! The ranges are widened by a slack that is large against rounding and physically negligible. An event is located just
//! outside the widened range, and the next range reaches back over the boundary by the same slack. So the side after an
//! event is known, not measured, and the same root cannot fire twice.

use crate::extremes::least;
use crate::scalar::Real;

/// Open range of a signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
}

/// Side on which a signal left its range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// Through the lower end.
    Below,
    /// Through the upper end.
    Above,
}

impl Bounds {
    /// No restriction.
    pub const FREE: Self = Self {
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
    };

    /// Values above `lower`.
    pub fn above(lower: f64) -> Self {
        Self {
            lower,
            upper: f64::INFINITY,
        }
    }

    /// Values below `upper`.
    pub fn below(upper: f64) -> Self {
        Self {
            lower: f64::NEG_INFINITY,
            upper,
        }
    }

    /// Values between the two.
    pub fn between(lower: f64, upper: f64) -> Self {
        Self { lower, upper }
    }

    /// The range with `slack` added at both ends.
    pub fn widened(self, slack: f64) -> Self {
        Self {
            lower: self.lower - slack,
            upper: self.upper + slack,
        }
    }

    /// Returns whether there is nothing to guard.
    pub fn is_free(&self) -> bool {
        *self == Self::FREE
    }

    /// Values in both ranges.
    pub fn meet(self, other: Self) -> Self {
        Self {
            lower: self.lower.max(other.lower),
            upper: self.upper.min(other.upper),
        }
    }

    /// Side on which `value` lies outside, if it does. NaN lies outside.
    #[inline(always)]
    pub fn exit(&self, value: f64) -> Option<Exit> {
        if value < self.lower {
            Some(Exit::Below)
        } else if value <= self.upper {
            None
        } else {
            Some(Exit::Above)
        }
    }

    /// Distance of `value` outside the range; negative inside.
    #[inline(always)]
    pub fn violation(&self, value: f64) -> f64 {
        (value - self.upper).max(self.lower - value)
    }
}

/// A set of signals at one instant.
pub trait SignalValues: Copy {
    /// Signal `index`.
    fn get(&self, index: usize) -> f64;
}

impl<const SIGNALS: usize> SignalValues for [f64; SIGNALS] {
    #[inline(always)]
    fn get(&self, index: usize) -> f64 {
        self[index]
    }
}

/// A signal with a range to stay in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guard {
    /// Index of the signal.
    pub signal: usize,
    /// Its range.
    pub range: Bounds,
}

/// Signals at one point of a step.
#[derive(Debug, Clone)]
pub struct Node<V> {
    /// Fraction of the step, 0 to 1.
    pub theta: f64,
    /// The signals there.
    pub signals: V,
}

/// Signals at one point of a step.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a, V> {
    /// Fraction of the step, 0 to 1.
    pub theta: f64,
    /// The signals there.
    pub signals: &'a V,
}

impl<V: Copy> Node<V> {
    pub(super) fn of(look: Sample<'_, V>) -> Self {
        Self {
            theta: look.theta,
            signals: *look.signals,
        }
    }

    /// This node as a sample.
    pub fn sample(&self) -> Sample<'_, V> {
        Sample {
            theta: self.theta,
            signals: &self.signals,
        }
    }
}

/// Returns whether any watched signal is outside its range.
#[inline(always)]
fn any_outside<V: SignalValues>(signals: &V, guards: &[Guard]) -> bool {
    let mut outside = false;
    for Guard { signal, range } in guards {
        let value = signals.get(*signal);
        outside |= !(value >= range.lower && value <= range.upper);
    }
    outside
}

/// Share of a predicted overshoot that the prediction may miss.
pub(super) const CAUTION: f64 = 0.5;
/// Evaluations spent on one suspected excursion.
const LOOKS: usize = 6;

/// Bound on how far a signal can stray between two known values: the change over the step plus the change that the
/// previous step suggests. `ratio` is this step's length over the previous one's. The bound is eight times as far as a
/// parabola through the three values would turn.
#[inline(always)]
pub fn stray<S: Real>(before: S, start: S, end: S, ratio: S) -> S {
    (end - start).abs() + ratio * (start - before).abs()
}

/// A step this many times as long as the previous one may bend as that one did not show.
pub const FAR_LONGER: f64 = 6.0;

/// Returns whether a quantity falls throughout a step: it fell over the previous step, and has slowed down by less than
/// half. `ratio` is this step's length over that one's.
pub fn falls(before: f64, start: f64, end: f64, ratio: f64) -> bool {
    end < start && start < before && start - end > 0.5 * ratio * (before - start)
}

/// Returns whether a quantity cannot have fallen below `least`, or below its end value, within a step: it stays well
/// above `least`, or falls without slowing down.
pub fn is_plain(before: f64, start: f64, end: f64, ratio: f64, least: f64) -> bool {
    ratio < FAR_LONGER && falls(before, start, end, ratio)
        || start.min(end) - least > stray(before, start, end, ratio)
}

/// Finds the first exit of any signal within a step or a part of it. The samples are at its start, where all signals
/// are inside, between, and at its end. `evaluate` writes the signals at a fraction of the step. Excursions that begin
/// and end between the samples are sought where three neighbouring values bend toward an end of the range. Returns a
/// fraction just outside, within `resolution` of the exit, and the one of `buffers` with the signals there; the other
/// buffers are overwritten.
pub fn first_exit<V: SignalValues>(
    [start, middle, end]: [Sample<'_, V>; 3],
    guards: &[Guard],
    resolution: f64,
    buffers: &mut [V; 3],
    mut evaluate: impl FnMut(f64, &mut V),
) -> Option<(f64, usize)> {
    let mut out_at_middle = false;
    let mut out_at_end = false;
    let mut earliest: Option<(Node<V>, Node<V>)> = None;
    for guard in guards {
        let signal = guard.signal;
        let v = [
            start.signals.get(signal),
            middle.signals.get(signal),
            end.signals.get(signal),
        ];
        let inside = |v: f64| v >= guard.range.lower && v <= guard.range.upper;
        let (middle_inside, end_inside) = (inside(v[1]), inside(v[2]));
        out_at_middle |= !middle_inside;
        out_at_end |= !end_inside;
        // Only a signal that bends back can come and go.
        let slopes = [
            (v[1] - v[0]) * (end.theta - middle.theta),
            (v[2] - v[1]) * (middle.theta - start.theta),
        ];
        let turns = (3.0 * slopes[0] - slopes[1]) * (3.0 * slopes[1] - slopes[0]) <= 0.0;
        if turns && middle_inside && end_inside {
            let t = [start.theta, middle.theta, end.theta];
            if let Some(found) = hidden_excursion(guard, start, t, v, guards, &mut evaluate)
                && earliest
                    .as_ref()
                    .is_none_or(|(_, known)| found.1.theta < known.theta)
            {
                earliest = Some(found);
            }
        }
    }
    let nodes = match &earliest {
        Some((a, b)) if !(out_at_middle && middle.theta <= b.theta) => {
            [a.sample(), b.sample(), end]
        }
        _ if out_at_middle => [start, middle, end],
        _ if out_at_end => [middle, end, start],
        _ => return None,
    };
    let predict = |nodes: [Sample<'_, V>; 3]| {
        let exits = guards.iter().map(|guard| exit_on_parabola(guard, nodes));
        least(exits)
    };
    let exit = locate(nodes, guards, resolution, predict, buffers, evaluate);
    Some(exit)
}

/// Fraction of the step and value at the extremum of the parabola through three nodes, if it lies between the outer
/// nodes.
fn vertex(t: [f64; 3], v: [f64; 3]) -> Option<(f64, f64)> {
    let first = (v[1] - v[0]) / (t[1] - t[0]);
    let second = (v[2] - v[1]) / (t[2] - t[1]);
    let curvature = (second - first) / (t[2] - t[0]);
    // Slope at t[0]; the parabola turns where slope + 2 curvature x vanishes.
    let slope = first - curvature * (t[1] - t[0]);
    let x = -slope / (2.0 * curvature);
    (x > 0.0 && x < t[2] - t[0]).then(|| (t[0] + x, v[0] + 0.5 * slope * x))
}

/// Searches for an exit of a signal between three nodes (at `t`, with values `v`) where it is inside its range. Returns
/// a node with all signals inside and a later one with one outside.
fn hidden_excursion<V: SignalValues>(
    guard: &Guard,
    start: Sample<'_, V>,
    mut t: [f64; 3],
    mut v: [f64; 3],
    guards: &[Guard],
    evaluate: &mut impl FnMut(f64, &mut V),
) -> Option<(Node<V>, Node<V>)> {
    let mut inside: Option<Node<V>> = None;
    for _ in 0..LOOKS {
        let (theta, value) = vertex(t, v)?;
        let nearest = if value > v[1] {
            v[0].max(v[1]).max(v[2])
        } else {
            v[0].min(v[1]).min(v[2])
        };
        guard.range.exit(value + CAUTION * (value - nearest))?;
        let mut node_at = |theta: f64| {
            let mut node = Node {
                theta,
                ..Node::of(start)
            };
            evaluate(theta, &mut node.signals);
            node
        };
        let node = node_at(theta);
        if any_outside(&node.signals, guards) {
            return Some((inside.unwrap_or_else(|| Node::of(start)), node));
        }
        // Keep the three nodes that surround the extremum.
        let seen = node.signals.get(guard.signal);
        if theta < t[1] {
            (t, v) = ([t[0], theta, t[1]], [v[0], seen, v[1]]);
        } else {
            (t, v) = ([t[1], theta, t[2]], [v[1], seen, v[2]]);
            inside = Some(node_at(t[0]));
        }
    }
    None
}

/// Predictions of an exit in a row that may fail to halve its bracket.
const MOST_FAILURES: u32 = 2;

/// Narrows the bracket from the first of three nodes, inside, to the second, outside, until its far end lies within
/// `resolution` of the exit. `predict` estimates the exit from the ends of the bracket and the node that was an end
/// last. After predictions that do not halve the bracket it is halved. Returns the far end, and the one of `buffers`
/// with the signals there.
pub(super) fn locate<V: SignalValues>(
    nodes: [Sample<'_, V>; 3],
    guards: &[Guard],
    resolution: f64,
    predict: impl Fn([Sample<'_, V>; 3]) -> f64,
    buffers: &mut [V; 3],
    mut evaluate: impl FnMut(f64, &mut V),
) -> (f64, usize) {
    let mut thetas = nodes.map(|node| node.theta);
    // A node keeps the signals it came with until a new one takes its place.
    let mut given = nodes.map(|node| Some(node.signals));
    // The nodes stay in place, except the one that a new one replaces.
    let [mut inside, mut outside, mut third] = [0, 1, 2];
    let mut failures = 0;
    loop {
        let (a, b) = (thetas[inside], thetas[outside]);
        let width = b - a;
        let exit = predict([inside, outside, third].map(|index| Sample {
            theta: thetas[index],
            signals: given[index].unwrap_or(&buffers[index]),
        }));
        let middle = a + 0.5 * width;
        // A little beyond the exit, to land outside.
        let aim = exit + 0.25 * resolution;
        let theta = if failures == MOST_FAILURES || !(aim > a && aim < b) {
            failures = 0;
            middle
        } else {
            aim
        };
        let is_narrow = b - exit <= resolution || width <= resolution;
        if is_narrow || theta <= a || theta >= b {
            if let Some(signals) = given[outside] {
                buffers[outside] = *signals;
            }
            return (b, outside);
        }
        thetas[third] = theta;
        given[third] = None;
        evaluate(theta, &mut buffers[third]);
        if any_outside(&buffers[third], guards) {
            std::mem::swap(&mut third, &mut outside);
        } else {
            std::mem::swap(&mut third, &mut inside);
        }
        if thetas[outside] - thetas[inside] > 0.5 * width {
            failures += 1;
        } else {
            failures = 0;
        }
    }
}

/// Exit of a signal from its range on the parabola through three nodes, inside at the first and outside at the second;
/// infinite if not outside. Other signals do not matter: of two that leave, one may be far outside where the other has
/// just left.
fn exit_on_parabola<V: SignalValues>(
    guard: &Guard,
    [inside, outside, third]: [Sample<'_, V>; 3],
) -> f64 {
    let value = |node: Sample<'_, V>| node.signals.get(guard.signal);
    let border = match guard.range.exit(value(outside)) {
        None => return f64::INFINITY,
        Some(Exit::Below) => guard.range.lower,
        Some(Exit::Above) => guard.range.upper,
    };
    let beyond = value(outside) - border;
    let buffer = |node: Sample<'_, V>| (node.theta, (value(node) - border) / beyond);
    exit_between(buffer(inside), outside.theta, buffer(third))
}

/// Point between `a` and `b` where the parabola through a value not above 0 at `a`, 1 at `b` and a third value rises
/// through 0.
fn exit_between((a, at_a): (f64, f64), b: f64, (c, at_c): (f64, f64)) -> f64 {
    let width = b - a;
    let rise = 1.0 - at_a;
    // With u from 0 at a to 1 at b: p = at_a + rise u + bend u (u − 1).
    let bend = ((at_c - 1.0) / (c - b) * width - rise) * (width / (c - a));
    let slope = rise - bend;
    let root = (slope * slope - 4.0 * bend * at_a).max(0.0).sqrt();
    let u = if slope >= 0.0 {
        -2.0 * at_a / (slope + root)
    } else {
        (root - slope) / (2.0 * bend)
    };
    a + width * u.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Pair = [f64; 2];

    /// A signal that rises evenly and one that rises at `pace` from `from` on, faster and faster.
    fn signals_at(theta: f64, from: f64, pace: f64) -> Pair {
        let late = theta - from;
        [theta, pace * late * (1.0 + late)]
    }

    #[test]
    fn of_two_signals_that_are_out_at_the_middle_the_first_to_leave_is_found() {
        for (border, from, pace) in [
            (0.3194, 0.3813, 1.0),
            (0.3194, 0.3813, 40.0),
            (0.3194, 0.3813, 1e-3),
            (0.3813, 0.3194, 40.0),
            (0.0100, 0.4900, 1e4),
            (0.4900, 0.0100, 1e-4),
        ] {
            for resolution in [1e-4, 1e-8] {
                let guards = [border, 0.0].map(Bounds::below);
                let guards = [0, 1].map(|signal| Guard {
                    signal,
                    range: guards[signal],
                });
                let at = |theta| Node {
                    theta,
                    signals: signals_at(theta, from, pace),
                };
                let nodes = [0.0, 0.5, 1.0].map(at);
                let mut looks = 0;
                let found = first_exit(
                    nodes.each_ref().map(Node::sample),
                    &guards,
                    resolution,
                    &mut [[0.0; 2]; 3],
                    |theta, signals| {
                        looks += 1;
                        *signals = signals_at(theta, from, pace);
                    },
                );
                let beyond = found.unwrap().0 - border.min(from);
                assert!(beyond > 0.0 && beyond <= resolution, "{beyond}");
                assert!(looks < 8, "{looks}");
            }
        }
    }
}
