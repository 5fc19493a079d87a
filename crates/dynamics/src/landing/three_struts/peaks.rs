//! Extremes within steps as at their ends.

use super::extremes::{Seen, close_in};
use super::simulation::Simulation;
use crate::equations::three_struts::{Signals, State};
use crate::landing::hull::Hull;
use crate::laws::three_struts::{LOAD, STROKES};

impl Simulation<'_> {
    /// Stability and clearance at a state.
    pub(super) fn look(&self, state: &State) -> Seen {
        Seen {
            angle: Hull::of(&self.motion.feet(state)).stability_angle(),
            clearance: self.motion.clearance(state),
        }
    }

    fn state_at(&self, theta: f64) -> State {
        let mut state = self.step.before;
        self.step.motion_at(theta, &mut state);
        state
    }

    /// Notes the extremes over the step up to fraction `reach`, where the signals are these. Returns what is seen there.
    pub(super) fn note_extremes(&mut self, reach: f64, at_end: &Signals) -> Seen {
        let thetas = [0.0, 0.5 * reach, reach];
        let [middle, end] = [thetas[1], thetas[2]].map(|theta| self.state_at(theta));
        let seen = [self.seen, self.look(&middle), self.look(&end)];
        // The least σ is that up to the verdict.
        for (theta, seen) in thetas.into_iter().zip(seen).skip(1) {
            let time = self.time_at(theta);
            self.extremes.note_angle(seen, time);
        }
        let nodes = |number: fn(&Seen) -> f64| [0, 1, 2].map(|k| (thetas[k], number(&seen[k])));
        let angles = nodes(|seen| seen.angle);
        if let Some((theta, angle)) = close_in(angles, self.extremes.angle.0, |theta| {
            self.look(&self.state_at(theta)).angle
        }) {
            self.extremes.angle = (angle, self.time_at(theta));
        }
        let clearances = nodes(|seen| seen.clearance);
        if let Some((_, clearance)) = close_in(clearances, self.extremes.clearance, |theta| {
            self.look(&self.state_at(theta)).clearance
        }) {
            self.extremes.clearance = clearance;
        }
        let at_middle = match reach == 1.0 {
            true => self.signals[1],
            false => self.motion.signals(&middle, &self.pieces),
        };
        for leg in 0..self.leg_count() {
            self.note_struts(leg, thetas, [&at_middle, at_end]);
        }
        seen[2]
    }

    /// Notes the struts of a leg at three fractions of the step, and extremes between. The signals at the first are those at
    /// its start.
    fn note_struts(&mut self, leg: usize, thetas: [f64; 3], [middle, end]: [&Signals; 2]) {
        let nodes = [&self.signals[0], middle, end];
        // Extremes are sought as least values.
        let least = |signal: usize, sign: f64, known: f64| {
            let values = [0, 1, 2].map(|k| (thetas[k], sign * nodes[k][leg][signal]));
            let known = values
                .iter()
                .fold(known, |least, (_, value)| least.min(*value));
            let within = close_in(values, known, |theta| {
                let signals = self.motion.signals(&self.state_at(theta), &self.pieces);
                sign * signals[leg][signal]
            });
            within.map_or(known, |(_, value)| value)
        };
        let force = -self.extremes.force[leg];
        let force = least(LOAD, -1.0, force).min(least(LOAD, 1.0, force));
        let [shortest, longest] = &self.extremes.strokes[leg];
        let strokes = [0, 1, 2].map(|k| {
            let signal = STROKES.start + k;
            [
                least(signal, -1.0, shortest[k]),
                least(signal, 1.0, longest[k]),
            ]
        });
        self.extremes.force[leg] = -force;
        self.extremes.strokes[leg] = [0, 1].map(|way| strokes.map(|strut| strut[way]));
    }
}
