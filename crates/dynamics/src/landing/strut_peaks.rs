//! The greatest force and stroke of each strut so far.

use crate::integrator::cubic::greatest;
use crate::integrator::event::{FAR_LONGER, falls};
use crate::motion::{Signal, Signals};
use crate::per_leg::PerLeg;

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

    /// Takes note of a stretch of `length` s from the signals at its ends.
    #[inline(always)]
    pub(super) fn note(&mut self, ends: [&Signals<f64>; 2], length: f64) {
        let [start, end] = ends;
        for (j, peak) in self.stroke.iter_mut().enumerate() {
            *peak = peak.max(end.of(j, Signal::Stroke));
            let rate = |signals: &Signals<f64>| signals.of(j, Signal::StrokeRate);
            if rate(start) > 0.0 && rate(end) < 0.0 {
                let stroke = Signals::<f64>::index(j, Signal::Stroke);
                *peak = peak.max(greatest(stroke, ends, length));
            }
        }
        for signals in ends {
            self.note_forces(signals);
        }
    }

    #[inline(always)]
    pub(super) fn note_forces(&mut self, signals: &Signals<f64>) {
        for (j, peak) in self.force.iter_mut().enumerate() {
            *peak = peak.max(force(signals, j));
        }
    }

    /// Force on strut `leg` worth seeking, lb.
    #[inline(always)]
    pub(super) fn notable_force(&self, leg: usize) -> f64 {
        (1.0 + NOTABLE) * self.force[leg]
    }

    /// Whether the force on any strut may have exceeded its greatest value between three samples of a step.
    #[inline(always)]
    pub(super) fn may_be_exceeded(&self, looks: [&Signals<f64>; 3]) -> bool {
        let [start, middle, end] = looks;
        for j in 0..self.force.len() {
            let [start, middle, end] = [force(start, j), force(middle, j), force(end, j)];
            let turn = (middle - start).abs() + (end - middle).abs();
            if start.max(middle).max(end) + turn > self.notable_force(j) {
                return true;
            }
        }
        false
    }

    /// The same for a stretch of which only the ends were evaluated, judged from the signals at the start of the previous stretch and
    /// at the start and end of this one; `ratio` is its length over the previous one's.
    #[inline(always)]
    pub(super) fn may_be_hidden(&self, looks: [&Signals<f64>; 3], ratio: f64) -> bool {
        let [before, start, end] = looks;
        let share = ratio / (1.0 + ratio);
        for j in 0..self.force.len() {
            let [before, start, end] = [force(before, j), force(start, j), force(end, j)];
            let change = end - start;
            // A parabola through the three would not exceed its ends by more than a quarter of this.
            let bend = if ratio > FAR_LONGER {
                change.abs()
            } else {
                share * (change - ratio * (start - before)).abs()
            };
            let rises = ratio <= FAR_LONGER && falls(-before, -start, -end, ratio);
            if !rises && start.max(end) + bend > self.notable_force(j) {
                return true;
            }
        }
        false
    }
}

/// Magnitude of the force on strut `leg`, lb.
#[inline(always)]
pub(super) fn force(signals: &Signals<f64>, leg: usize) -> f64 {
    signals.of(leg, Signal::StrutForce).abs()
}
