//! Rates at the end of a landing. A search estimates from them how far beyond toppling or bottoming it would have gone.

use crate::motion::{Motion, Pieces, Signal};
use crate::per_leg::PerLeg;
use crate::record::FinalRates;
use crate::stability::StabilityMonitor;
use crate::state::State;

/// Time between the states that are differenced, s: long enough for second differences.
const SPAN: f64 = 1e-5;

/// Rates of σ and of the strokes at a time (s) and a state, by central differences along the motion under the present
/// accelerations. σ is measured over the critical feet that the monitor chooses at the state.
pub fn final_rates(
    mut monitor: StabilityMonitor,
    motion: &Motion<f64>,
    time: f64,
    state: &State<f64>,
    pieces: &Pieces<f64>,
) -> FinalRates {
    let mut derivative = State::zero(state.leg_count());
    if motion.acts_at_face() {
        motion.derivative::<true, true>(time, state, pieces, &mut derivative);
    } else {
        motion.derivative::<true, false>(time, state, pieces, &mut derivative);
    }
    let [earlier, later] = [-SPAN, SPAN].map(|time| {
        let mut moved = state.advanced_motion([time], [&derivative]);
        for j in 0..state.leg_count() {
            let mut leg = moved.leg(j);
            leg.link_angle += 0.5 * time * time * derivative.leg(j).link_rate;
            moved.set_leg(j, &leg);
        }
        moved
    });

    let is_defined = monitor.choose_plane(motion, state).is_ok();
    let angle = |state| monitor.observe(motion, state).angle;
    let strokes = |state| {
        let signals = motion.signals(state, pieces, false);
        PerLeg::from_fn(motion.leg_count(), |j| signals.of(j, Signal::Stroke))
    };
    let [before, now, after] = [strokes(&earlier), strokes(state), strokes(&later)];
    FinalRates {
        stability_angle: is_defined.then(|| (angle(&later) - angle(&earlier)) / (2.0 * SPAN)),
        strokes: PerLeg::from_fn(motion.leg_count(), |j| {
            (after[j] - before[j]) / (2.0 * SPAN)
        }),
        stroke_accelerations: PerLeg::from_fn(motion.leg_count(), |j| {
            (after[j] - 2.0 * now[j] + before[j]) / (SPAN * SPAN)
        }),
    }
}
