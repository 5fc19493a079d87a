//! Motion that stops end at once, under [`crate::rules::ContactRule::Face`] ("Stops of the hinge" and "Extension stop of the
//! strut" in the model).

use super::Motion;
use super::leg::LegMotion;
use crate::state::LegState;

impl Motion<f64> {
    /// Brings the pad of leg `index` to a stop of its hinge: its rate against the link ends, and a free link takes over
    /// its momentum. The stop provides the energy that this adds to the link.
    pub fn stop_pad(&self, index: usize, link_is_free: bool, leg: &mut LegState<f64>) {
        let LegMotion {
            link_inertia,
            pad_inertia,
            ..
        } = self.legs[index];
        if link_is_free {
            let before = leg.link_rate;
            leg.link_rate -= pad_inertia / (link_inertia + pad_inertia) * leg.pad_rate;
            let [.., stop] = &mut leg.work;
            *stop -= 0.5 * link_inertia * (leg.link_rate * leg.link_rate - before * before);
        }
        leg.pad_rate = 0.0;
    }

    /// Brings the link of leg `index` to its extension stop, which takes its energy. A pad that swings keeps its own rate.
    pub fn stop_link(&self, index: usize, pad_swings: bool, leg: &mut LegState<f64>) {
        let [.., stop] = &mut leg.work;
        *stop += 0.5 * self.legs[index].link_inertia * leg.link_rate * leg.link_rate;
        if pad_swings {
            leg.pad_rate -= leg.link_rate;
        }
        leg.link_rate = 0.0;
    }
}
