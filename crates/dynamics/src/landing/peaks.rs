//! The greatest force and stroke of each strut, within steps as at their ends.

use super::hidden_forces::Stretch;
use super::trajectory::Trajectory;
use crate::integrator::cubic::greatest;
use crate::integrator::event::stray;
use crate::motion::{Signal, Signals};

impl Trajectory<'_> {
    /// Notes the struts over the step up to fraction `reach`. The signals there are in one of the `buffers`, or are
    /// those of its end.
    #[inline(always)]
    pub(super) fn note_struts(&mut self, buffer: Option<usize>, reach: f64) {
        let start = self.signals.start();
        let end = match buffer {
            Some(buffer) => &self.buffers[buffer],
            None => self.signals.end(),
        };
        let length = reach * self.step.length;
        for j in 0..self.motion.leg_count() {
            let stroke = &mut self.peaks.stroke[j];
            *stroke = stroke.max(end.of(j, Signal::Stroke));
            if start.of(j, Signal::StrokeRate) > 0.0 && end.of(j, Signal::StrokeRate) < 0.0 {
                let signal = Signals::<f64>::index(j, Signal::Stroke);
                *stroke = stroke.max(greatest(signal, [start, end], length));
            }
            let [from, to] = [start, end].map(|signals| force(signals, j));
            let higher = from.max(to);
            let most = &mut self.peaks.force[j];
            *most = most.max(higher);
            let most = *most;
            // How far the force may have been beyond its ends, at most.
            let beyond = if self.is_middle_seen {
                let middle = force(&self.middle, j);
                (middle - from).abs() + (to - middle).abs()
            } else if let Some(earlier) = &self.earlier {
                let before = force(self.signals.previous(), j);
                let ratio = length / earlier.length;
                let rise = from - before;
                // A force that rises ever faster is greatest at the end.
                if rise > 0.0 && to - from >= ratio * rise {
                    0.0
                } else {
                    stray(before, from, to, ratio)
                }
            } else {
                (to - from).abs()
            };
            if higher + beyond > most {
                let stretch =
                    Stretch::of(&self.step, j, self.pieces.strut(j), reach, higher + beyond);
                (self.hidden_forces).keep(stretch, &self.motion, &self.peaks.force);
            }
        }
    }
}

/// Magnitude of the force on strut `leg`, lb.
#[inline(always)]
fn force(signals: &Signals<f64>, leg: usize) -> f64 {
    signals.of(leg, Signal::StrutForce).abs()
}
