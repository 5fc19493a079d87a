//! How fast a landing was still on its way when it ended: what tells how far beyond toppling or
//! bottoming it would have gone.

use super::Flight;
use crate::motion::Signal;
use crate::record::{FinalRates, Instant};
use crate::stability::Judge;
use crate::state::State;

/// Time between the states of which differences are taken, s: long enough for second differences.
const SPAN: f64 = 1e-5;

impl<O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'_, O, LEGS> {
    /// Rates of σ and of the strokes at the present state, by central differences along the motion
    /// that the present accelerations would give.
    pub(super) fn final_rates(&self) -> FinalRates<LEGS> {
        let state = &self.step.before;
        let mut derivative = State::zero();
        self.motion.derivative(state, &self.pieces, &mut derivative);
        let [earlier, later] = [-SPAN, SPAN].map(|time| {
            let mut moved = state.advanced_motion([time], [&derivative]);
            for j in 0..LEGS {
                let mut leg = moved.leg(j);
                leg.link_angle += 0.5 * time * time * derivative.leg(j).link_rate;
                moved.set_leg(j, &leg);
            }
            moved
        });

        let mut judge = Judge::new(self.scene, self.calm_height());
        let is_defined = judge.look(&self.motion, state).is_ok();
        let angle = |state| judge.observe(&self.motion, state).angle;
        let strokes = |state| {
            let signals = self.motion.signals(state, &self.pieces, false);
            signals.map(|leg| leg[Signal::Stroke as usize])
        };
        let [before, now, after] = [strokes(&earlier), strokes(state), strokes(&later)];
        FinalRates {
            stability_angle: is_defined.then(|| (angle(&later) - angle(&earlier)) / (2.0 * SPAN)),
            strokes: std::array::from_fn(|j| (after[j] - before[j]) / (2.0 * SPAN)),
            stroke_accelerations: std::array::from_fn(|j| {
                (after[j] - 2.0 * now[j] + before[j]) / (SPAN * SPAN)
            }),
        }
    }
}
