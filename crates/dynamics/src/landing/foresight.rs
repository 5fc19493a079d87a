//! Steps that end where a gentle kink of a strut law is foreseen: where a link turns round or leaves the
//! zone in which resistance fades in, and where a stroke comes to a knot of the tables.
//!
//! Such a kink is no event, as the law is evaluated rightly on either side of it. But a step that runs
//! over one is of lower order than a step that ends there, or very nearly there.

use super::Flight;
use crate::integrator::event::Bounds;
use crate::motion::Signal;
use crate::record::Instant;

/// Share of a step within which its end is moved to a kink.
const WITHIN: [f64; 2] = [0.03, 0.98];
/// Link rate below which a link trembles rather than turns, rad/s.
const TREMBLING: f64 = 1e-4;

impl<O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'_, O, LEGS> {
    /// Length of a step (s) that is to be `length` long, but ends where the first kink within it is
    /// foreseen.
    pub(super) fn up_to_kink(&self, length: f64) -> f64 {
        let accelerations = self.step.slopes[0].link_rates();
        let [first, last] = WITHIN.map(|share| share * length);
        let mut end = last;
        let or_leave = |end, range, course| {
            let time = time_to_leave(range, course, end);
            time.filter(|time| *time > first).unwrap_or(end)
        };
        for (j, acceleration) in accelerations.into_iter().enumerate() {
            let signals = &self.signals.now()[j];
            let Some(kinks) = self.modes[j].gentle_kinks(&self.laws[j], signals) else {
                continue;
            };
            let rate = signals[Signal::LinkRate as usize];
            if rate.abs() > TREMBLING {
                let jerk = self.earlier.as_ref().map_or(0.0, |earlier| {
                    (acceleration - earlier.link_accelerations[j]) / earlier.length
                });
                end = or_leave(end, kinks.link_rates, [rate, acceleration, jerk]);
            }
            let stroke = signals[Signal::Stroke as usize];
            let stroking = -signals[Signal::StrutLever as usize];
            let course = [stroke, stroking * rate, stroking * acceleration];
            end = or_leave(end, kinks.strokes, course);
        }
        if end < last { end } else { length }
    }
}

/// When a quantity that goes on from its present value with its first and second derivatives leaves a
/// range, if that is within so long a time, s.
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
    fn what_stands_still_stays() {
        assert_eq!(
            time_to_leave(Bounds::between(0.0, 1.0), [0.5, 0.0, 0.0], 1.0),
            None
        );
    }
}
