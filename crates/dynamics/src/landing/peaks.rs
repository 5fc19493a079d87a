//! The greatest force and stroke of each strut, within steps as at their ends.

use super::strut_peaks::force;
use super::trajectory::Trajectory;
use crate::integrator::parabola::Parabola;
use crate::per_leg::PerLeg;

/// Parabolas fitted to find a greatest force between the ends of a step.
const REFINEMENTS: usize = 2;

impl Trajectory<'_> {
    /// Takes note of the struts over the step up to fraction `reach`, where one of the `buffers` has the signals, or up to
    /// its end.
    #[inline(always)]
    pub(super) fn note_struts(&mut self, buffer: Option<usize>, reach: f64) {
        let start = self.signals.start();
        let end = match buffer {
            Some(buffer) => &self.buffers[buffer],
            None => self.signals.end(),
        };
        let length = reach * self.step.length;
        self.peaks.note([start, end], length);
        let hides_force = if self.is_middle_seen {
            self.peaks.may_be_exceeded([start, &self.middle, end])
        } else {
            self.earlier.as_ref().is_none_or(|earlier| {
                let looks = [self.signals.previous(), start, end];
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
            self.middle = self.signals_at(0.5 * reach);
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
                let signals = self.signals_at(theta);
                self.peaks.note_forces(&signals);
                parabola = parabola.about((theta, -force(&signals, j)));
            }
        }
    }
}
