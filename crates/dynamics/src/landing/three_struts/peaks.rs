//! Extremes within steps as at their ends.

use arrayvec::ArrayVec;
use num_traits::Zero;

use super::extremes::{SIGNS, Seen, TRACKED, close_in};
use super::simulation::Simulation;
use crate::equations::three_struts::{Signals, State};
use crate::landing::hull::Hull;
use crate::quads::{LANES, Quad, legs_in, quads};
use crate::scalar::Real;

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
        let middle = self.state_at(thetas[1]);
        let end = match reach == 1.0 {
            true => self.look(&self.step.after),
            false => self.look(&self.state_at(reach)),
        };
        let seen = [self.seen, self.look(&middle), end];
        let least_angle = self.extremes.angle;
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
        if self.noted.is_some() {
            // The least σ is that up to the verdict.
            self.extremes.angle = least_angle;
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
        self.note_struts(thetas, &at_middle, at_end);
        seen[2]
    }

    /// Notes the struts at three fractions of the step, and extremes between. The signals at the first are those at its start.
    fn note_struts(&mut self, thetas: [f64; 3], middle: &Signals, end: &Signals) {
        let nodes = [self.signals[0], *middle, *end];
        for quad in 0..quads(self.leg_count()) {
            for (place, signal) in TRACKED.into_iter().enumerate() {
                let [first, second, third] = [0, 1, 2].map(|k| nodes[k].quad(quad)[signal]);
                for (way, sign) in SIGNS.into_iter().enumerate() {
                    let sign = Quad::constant(sign);
                    let least = -(-first * sign).max(-second * sign).max(-third * sign);
                    // The parabola through the nodes goes no farther below the lowest of them.
                    let bend = (first - second + third - second) * sign;
                    let bound = least - bend.max(Quad::zero()) * Quad::constant(0.125);
                    let known = &self.extremes.struts[quad][place][way];
                    let passes = |lane: &usize| bound.0[*lane] < known.0[*lane];
                    let lanes = (0..legs_in(quad, self.leg_count())).filter(passes);
                    for lane in lanes.collect::<ArrayVec<usize, LANES>>() {
                        self.note_strut(LANES * quad + lane, [place, way], thetas, &nodes);
                    }
                }
            }
        }
    }

    /// Notes one of the tracked signals of a leg, one way.
    #[cold]
    fn note_strut(
        &mut self,
        leg: usize,
        [place, way]: [usize; 2],
        thetas: [f64; 3],
        nodes: &[Signals; 3],
    ) {
        let (signal, sign) = (TRACKED[place], SIGNS[way]);
        let values = [0, 1, 2].map(|k| (thetas[k], sign * nodes[k].of(leg, signal)));
        let known = self.extremes.strut(leg, place)[way];
        let known = (values.iter()).fold(known, |least, (_, value)| least.min(*value));
        let within = close_in(values, known, |theta| {
            let signals = self.motion.signals(&self.state_at(theta), &self.pieces);
            sign * signals.of(leg, signal)
        });
        let least = within.map_or(known, |(_, value)| value);
        self.extremes.struts[leg / LANES][place][way].0[leg % LANES] = least;
    }
}
