//! The greatest force and stroke of each strut, within steps as at their ends.

use super::trajectory::Trajectory;
use crate::integrator::cubic::greatest;
use crate::integrator::event::{FAR_LONGER, falls};
use crate::integrator::parabola::Parabola;
use crate::motion::{Glance, Signal};
use crate::per_leg::PerLeg;

/// Parabolas laid toward a greatest force between the ends of a step.
const REFINEMENTS: usize = 2;
/// Share by which a force has to be greater to be sought.
const NOTABLE: f64 = 1e-4;

/// The greatest values so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct StrutPeaks {
    /// Magnitude of the force F, lb.
    pub(super) force: PerLeg<f64>,
    /// Stroke δ, ft.
    pub(super) stroke: PerLeg<f64>,
}

impl StrutPeaks {
    pub(super) fn none(legs: usize) -> Self {
        Self {
            force: PerLeg::same(legs, 0.0),
            stroke: PerLeg::same(legs, 0.0),
        }
    }

    /// Takes note of a stretch of `length` s by what is seen at its ends.
    #[inline(always)]
    fn note(&mut self, ends: [&Glance<f64>; 2], length: f64) {
        let [start, end] = ends;
        for (j, peak) in self.stroke.iter_mut().enumerate() {
            *peak = peak.max(end.of(j, Signal::Stroke));
            let rate = |signals: &Glance<f64>| signals.of(j, Signal::StrokeRate);
            if rate(start) > 0.0 && rate(end) < 0.0 {
                let stroke = Glance::<f64>::index(j, Signal::Stroke);
                *peak = peak.max(greatest(stroke, ends, length));
            }
        }
        for signals in ends {
            self.note_forces(signals);
        }
    }

    #[inline(always)]
    fn note_forces(&mut self, signals: &Glance<f64>) {
        for (j, peak) in self.force.iter_mut().enumerate() {
            *peak = peak.max(force(signals, j));
        }
    }

    /// Force on strut `leg` worth seeking, lb.
    #[inline(always)]
    fn notable_force(&self, leg: usize) -> f64 {
        (1.0 + NOTABLE) * self.force[leg]
    }

    /// Whether the force on any strut may have been greater than ever between three looks at a step.
    #[inline(always)]
    fn may_be_exceeded(&self, looks: [&Glance<f64>; 3]) -> bool {
        (0..self.force.len()).any(|j| {
            let [start, middle, end] = looks.map(|signals| force(signals, j));
            let turn = (middle - start).abs() + (end - middle).abs();
            start.max(middle).max(end) + turn > self.notable_force(j)
        })
    }

    /// Whether it may have been so within a stretch of which only the ends were looked at, as looks before the
    /// stretch before, at the start and at the end tell, `ratio` being its length over that one's.
    #[inline(always)]
    fn may_be_hidden(&self, looks: [&Glance<f64>; 3], ratio: f64) -> bool {
        let share = ratio / (1.0 + ratio);
        (0..self.force.len()).any(|j| {
            let [before, start, end] = looks.map(|signals| force(signals, j));
            let change = end - start;
            if ratio > FAR_LONGER {
                return start.max(end) + change.abs() > self.notable_force(j);
            }
            // A parabola through the three would not exceed its ends by more than a quarter of this.
            let bend = share * (change - ratio * (start - before)).abs();
            let rises = falls(-before, -start, -end, ratio);
            !rises && start.max(end) + bend > self.notable_force(j)
        })
    }
}

/// Magnitude of the force on strut `leg`, lb.
fn force(signals: &Glance<f64>, leg: usize) -> f64 {
    signals.of(leg, Signal::StrutForce).abs()
}

impl Trajectory<'_> {
    /// Takes note of the struts over the step up to fraction `reach`, where the signals are `end`, or those at the end
    /// of the step.
    #[inline(always)]
    pub(super) fn note_struts(&mut self, end: Option<&Glance<f64>>, reach: f64) {
        let start = self.signals.now();
        let end = end.unwrap_or(self.signals.ahead());
        let length = reach * self.step.length;
        self.peaks.note([start, end], length);
        let hides_force = if self.is_middle_seen {
            self.peaks.may_be_exceeded([start, &self.middle, end])
        } else {
            self.earlier.as_ref().is_none_or(|earlier| {
                let looks = [self.signals.before(), start, end];
                self.peaks.may_be_hidden(looks, length / earlier.length)
            })
        };
        if hides_force {
            let forces = [start, end]
                .map(|signals| PerLeg::from_fn(signals.leg_count(), |j| force(signals, j)));
            self.seek_forces(forces, reach);
        }
    }

    /// Seeks the greatest forces within the step up to fraction `reach`, from the forces at its ends.
    fn seek_forces(&mut self, [start, end]: [PerLeg<f64>; 2], reach: f64) {
        let half = if self.is_middle_seen {
            0.5
        } else {
            self.middle = self.look_at(0.5 * reach);
            0.5 * reach
        };
        for j in 0..self.leg_count() {
            let mut points = [
                (0.0, -start[j]),
                (half, -force(&self.middle, j)),
                (reach, -end[j]),
            ];
            if reach < half {
                points.swap(1, 2);
            }
            let mut parabola = Parabola::through(points);
            for _ in 0..REFINEMENTS {
                let lowest = parabola.lowest(-self.peaks.notable_force(j));
                let Some(theta) = lowest.filter(|&theta| theta < reach) else {
                    break;
                };
                let signals = self.look_at(theta);
                self.peaks.note_forces(&signals);
                parabola = parabola.about((theta, -force(&signals, j)));
            }
        }
    }
}
