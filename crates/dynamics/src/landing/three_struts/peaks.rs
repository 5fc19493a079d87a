//! Extremes within steps as at their ends.

use super::extremes::{Seen, close_in};
use super::simulation::Simulation;
use crate::equations::three_struts::{Signals, State};
use crate::landing::hull::Hull;
use crate::laws::three_struts::{STROKES, STRUTS};

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

    /// Notes the extremes over the step up to fraction `reach`, where the signals are these. Returns σ there.
    pub(super) fn note_extremes(&mut self, reach: f64, at_end: &Signals) -> f64 {
        let thetas = [0.0, 0.5 * reach, reach];
        let states = thetas.map(|theta| self.state_at(theta));
        let seen = states.map(|state| self.look(&state));
        // The least σ is that up to the verdict.
        for (theta, seen) in thetas.into_iter().zip(seen) {
            let time = self.time_at(theta);
            self.extremes.note_angle(seen, time);
        }
        let angles = [0, 1, 2].map(|k| (thetas[k], seen[k].angle));
        if let Some((theta, angle)) = close_in(angles, self.extremes.angle.0, |theta| {
            self.look(&self.state_at(theta)).angle
        }) {
            self.extremes.angle = (angle, self.time_at(theta));
        }
        let heights = [0, 1, 2].map(|k| (thetas[k], seen[k].clearance));
        if let Some((_, clearance)) = close_in(heights, self.extremes.clearance, |theta| {
            self.look(&self.state_at(theta)).clearance
        }) {
            self.extremes.clearance = clearance;
        }
        let middle = self.motion.signals(&states[1], &self.pieces);
        for leg in 0..self.leg_count() {
            self.note_struts(leg, thetas, &states, [&middle, at_end]);
        }
        seen[2].angle
    }

    fn note_struts(
        &mut self,
        leg: usize,
        thetas: [f64; 3],
        states: &[State; 3],
        [middle, end]: [&Signals; 2],
    ) {
        let strokes = |signals: &Signals| -> [f64; STRUTS] {
            std::array::from_fn(|k| signals[leg][STROKES.start + k])
        };
        let force = |state: &State| (self.motion.forces(leg, state, &self.pieces)).struts[0].abs();
        // Extremes are sought as least values.
        let forces = [0, 1, 2].map(|k| (thetas[k], -force(&states[k])));
        let known = -forces
            .iter()
            .fold(self.extremes.force[leg], |most, (_, force)| {
                most.max(-force)
            });
        let within = close_in(forces, known, |theta| -force(&self.state_at(theta)));
        let greatest_force = -within.map_or(known, |(_, force)| force);
        let nodes = [strokes(&self.signals[0]), strokes(middle), strokes(end)];
        let share = |k: usize, stroke: f64| self.laws[leg].stroke_share(k, stroke);
        let mut greatest_share = self.extremes.stroke_share[leg];
        let mut greatest_stroke = self.extremes.stroke[leg];
        for (k, _) in STROKES.enumerate() {
            for sign in [1.0, -1.0] {
                let values = [0, 1, 2].map(|node| (thetas[node], -sign * nodes[node][k]));
                let known = values
                    .iter()
                    .fold(f64::INFINITY, |least, (_, value)| least.min(*value));
                let within = close_in(values, known, |theta| {
                    let signals = self.motion.signals(&self.state_at(theta), &self.pieces);
                    -sign * strokes(&signals)[k]
                });
                let stroke = -sign * within.map_or(known, |(_, value)| value);
                greatest_share = greatest_share.max(share(k, stroke));
                if k == 0 {
                    greatest_stroke = greatest_stroke.max(stroke);
                }
            }
        }
        self.extremes.force[leg] = greatest_force;
        self.extremes.stroke[leg] = greatest_stroke;
        self.extremes.stroke_share[leg] = greatest_share;
    }
}
