//! Gentle kinks of the strut law (42)-(45): where a link turns round or leaves the zone in which resistance fades in,
//! and where a stroke reaches a knot of the tables.
//!
//! Such a kink changes no law: the force is evaluated correctly on either side of it. But a step over a kink is of
//! lower order than a step that ends there. So steps aim a little past the first predicted kink, and end where it is
//! located on their dense output.

use arrayvec::ArrayVec;

use super::trajectory::Trajectory;
use crate::integrator::event::{Bounds, Guard, Node, SignalValues, first_exit};
use crate::motion::{Signal, Signals};
use crate::per_leg::{MOST_LEGS, PerLeg};

/// Shares of a step between which a kink moves its end.
const WITHIN: [f64; 2] = [0.03, 0.98];
/// Overshoot past a predicted kink, as a share of the distance to it.
const PAST: f64 = 1e-4;
/// Share of a step within which a kink is located. An overshoot this small does not show in the step's error.
const RESOLUTION: f64 = 1e-3;

/// Stroke (ft) and link rate (rad/s) of each leg.
#[derive(Clone, Copy)]
struct LinkSignals(PerLeg<[f64; 2]>);

impl SignalValues for LinkSignals {
    fn get(&self, index: usize) -> f64 {
        self.0.as_flattened()[index]
    }
}

impl Trajectory<'_> {
    /// Length (s) of a step that would be `length` long, but ends a little past the first kink predicted within it.
    pub(super) fn past_kink(&mut self, length: f64) -> f64 {
        let [first, last] = WITHIN.map(|share| share * length);
        let mut end = last;
        let or_leave = |end, range, course| {
            let time = time_to_leave(range, course, end);
            time.filter(|time| *time > first).unwrap_or(end)
        };
        for j in 0..self.leg_count() {
            let acceleration = self.step.slopes[0].link_rate(j);
            let told = |signal| self.signals.start().of(j, signal);
            let rate = told(Signal::LinkRate);
            self.kinks[j] = self.modes[j].gentle_kinks(&self.laws[j], rate);
            let Some(kinks) = &self.kinks[j] else {
                continue;
            };
            let jerk = self.earlier.as_ref().map_or(0.0, |earlier| {
                (acceleration - earlier.link_accelerations[j]) / earlier.length
            });
            end = or_leave(end, kinks.link_rates, [rate, acceleration, jerk]);
            let stroke = told(Signal::Stroke);
            let stroking = -told(Signal::StrutLever);
            let course = [stroke, stroking * rate, stroking * acceleration];
            end = or_leave(end, kinks.strokes, course);
        }
        if end < last {
            end * (1.0 + PAST)
        } else {
            length
        }
    }

    /// Fraction of the step, up to `reach`, at which it crosses the first gentle kink; `None` if it starts or ends
    /// there.
    pub(super) fn kink_before(&mut self, reach: f64) -> Option<f64> {
        let runs_over = (0..self.leg_count()).any(|j| self.may_run_over(j));
        let kink = if runs_over { self.locate_kink() } else { None };
        kink.filter(|theta| *theta > RESOLUTION && *theta < reach)
    }

    /// Returns whether leg `j` may have crossed a gentle kink within the step, judged from its ends.
    fn may_run_over(&self, j: usize) -> bool {
        let Some(kinks) = &self.kinks[j] else {
            return false;
        };
        let [start, end] = [self.signals.start(), self.signals.end()];
        let [first, last] = [0, 5].map(|k| self.step.slopes[k].link_rate(j));
        let length = self.step.length;
        let [start_rate, end_rate] = [start, end].map(|all| all.of(j, Signal::LinkRate));
        let stroking = end.of(j, Signal::StrutLever) * end_rate;
        kinks.strokes.violation(end.of(j, Signal::Stroke)) > RESOLUTION * (length * stroking).abs()
            || kinks.link_rates.violation(end_rate) > RESOLUTION * (length * last).abs()
            || first * last < 0.0
                && (kinks.link_rates)
                    .exit(twice_the_turn(start_rate, [first, last], length))
                    .is_some()
    }

    /// Fraction of the step at which it crosses the first gentle kink, if any.
    fn locate_kink(&mut self) -> Option<f64> {
        let signals = &self.signals;
        let told = |all: &Signals<f64>| {
            LinkSignals(PerLeg::from_fn(self.leg_count(), |j| {
                [Signal::Stroke, Signal::LinkRate].map(|one| all.of(j, one))
            }))
        };
        let look = |theta: f64| {
            let (weights, slopes) = self.step.change(theta);
            let [angles, rates] = self.step.before.links_advanced(weights, slopes);
            LinkSignals(PerLeg::from_fn(self.leg_count(), |j| {
                [self.motion.geometry(j).stroke(angles[j]), rates[j]]
            }))
        };
        let node = |theta, signals| Node { theta, signals };
        let start = node(0.0, told(signals.start()));
        let middle = node(0.5, look(0.5));
        let end = node(1.0, told(signals.end()));
        let mut guards = ArrayVec::<Guard, { 2 * MOST_LEGS }>::new();
        for (j, kinks) in self.kinks.iter().enumerate() {
            let ranges = kinks.map(|kinks| [kinks.strokes, kinks.link_rates]);
            for (k, range) in ranges.into_iter().flatten().enumerate() {
                let signal = 2 * j + k;
                if range.exit(start.signals.get(signal)).is_none() {
                    guards.push(Guard { signal, range });
                }
            }
        }
        let nodes = [&start, &middle, &end].map(Node::sample);
        let mut buffers = [start.signals; 3];
        let kink = first_exit(
            nodes,
            &guards,
            RESOLUTION,
            &mut buffers,
            |theta, signals| {
                *signals = look(theta);
            },
        );
        kink.map(|(theta, _)| theta)
    }
}

/// Value of a parabola that starts at `value` and whose slopes at the ends of a `length` differ in sign, twice as far from its
/// start as its turning point is.
fn twice_the_turn(value: f64, [first, last]: [f64; 2], length: f64) -> f64 {
    value + length * first * first / (first - last)
}

/// Time (s) at which a quantity with this value and these first and second derivatives leaves a range, if that is
/// before `within`.
fn time_to_leave(range: Bounds, [value, slope, bend]: [f64; 3], within: f64) -> Option<f64> {
    let end = value + (slope + 0.5 * bend * within) * within;
    let way = end.clamp(range.lower, range.upper) - value;
    if value + way == end {
        return None;
    }
    let root = (slope * slope + 2.0 * bend * way).max(0.0).sqrt();
    let time = 2.0 * way / (slope + root.copysign(way));
    (time < within).then_some(time)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 + 2t − 8t² rises to 1.125 at t = 1/8 and is 0 at t = 1/2.
    const COURSE: [f64; 3] = [1.0, 2.0, -16.0];

    #[test]
    fn a_parabola_leaves_a_range_where_it_meets_its_end() {
        let leave = |range, within| time_to_leave(range, COURSE, within);
        assert_eq!(leave(Bounds::above(0.0), 0.6), Some(0.5));
        assert_eq!(leave(Bounds::above(0.0), 0.4), None);
        assert_eq!(leave(Bounds::FREE, 10.0), None);
        let upper = leave(Bounds::below(1.09375), 0.1).unwrap();
        assert!((upper - 0.0625).abs() < 1e-15, "{upper}");
    }

    #[test]
    fn mirrored_motion_leaves_at_the_same_time() {
        let mirrored = COURSE.map(|derivative| -derivative);
        let time = time_to_leave(Bounds::below(0.0), mirrored, 0.6);
        assert_eq!(time, Some(0.5));
    }

    #[test]
    fn a_parabola_turns_where_its_slope_is_zero() {
        // 1 + 2t − t²/2 turns at t = 2, at 3.
        assert_eq!(twice_the_turn(1.0, [2.0, -1.0], 3.0), 5.0);
        assert_eq!(twice_the_turn(-1.0, [-2.0, 1.0], 3.0), -5.0);
    }

    #[test]
    fn what_stands_still_stays() {
        assert_eq!(
            time_to_leave(Bounds::between(0.0, 1.0), [0.5, 0.0, 0.0], 1.0),
            None
        );
    }
}
