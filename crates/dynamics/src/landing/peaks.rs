//! The greatest force and stroke of each strut, within steps as at their ends.

use super::hidden_forces::Stretch;
use super::strut_peaks::force;
use super::trajectory::Trajectory;
use crate::integrator::event::stray;
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
        let forces =
            [start, end].map(|signals| PerLeg::from_fn(signals.leg_count(), |j| force(signals, j)));
        let hides_force = if self.is_middle_seen {
            self.peaks.may_be_exceeded([start, &self.middle, end])
        } else {
            self.earlier.as_ref().is_none_or(|earlier| {
                let looks = [self.signals.previous(), start, end];
                self.peaks.may_be_hidden(looks, length / earlier.length)
            })
        };
        if hides_force {
            self.seek_forces(forces, reach);
        }
        self.keep_what_may_hide(forces, reach);
    }

    /// Keeps the step up to fraction `reach` for struts that may have borne more in it than ever, with these forces at its ends.
    #[inline(always)]
    fn keep_what_may_hide(&mut self, [start, end]: [PerLeg<f64>; 2], reach: f64) {
        let forces = self.peaks.force;
        self.hidden_forces.retain_beyond(&forces);
        for j in 0..self.leg_count() {
            let stray = match &self.earlier {
                _ if self.is_middle_seen => {
                    let middle = force(&self.middle, j);
                    (middle - start[j]).abs() + (end[j] - middle).abs()
                }
                Some(earlier) => {
                    let before = force(self.signals.previous(), j);
                    let ratio = reach * self.step.length / earlier.length;
                    let rise = start[j] - before;
                    if rise > 0.0 && end[j] - start[j] >= ratio * rise {
                        // It rises ever faster.
                        continue;
                    }
                    stray(before, start[j], end[j], ratio)
                }
                None => (end[j] - start[j]).abs(),
            };
            let most = start[j].max(end[j]) + stray;
            if most > forces[j] {
                let stretch = Stretch::of(&self.step, j, self.pieces.strut(j), reach, most);
                self.hidden_forces.keep(stretch, &self.motion, &forces);
            }
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
