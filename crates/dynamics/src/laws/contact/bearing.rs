//! Support of a leg: gaps to the ground, elements that give way, and crush of the footpad.

use super::{LEAST_INCLINATION, LegLaws, LegMode, PadDepths};
use crate::crush::{Crush, CrushLaw};
use crate::signal::{LegSignals, Signal};

impl LegMode {
    /// Gap between the footpad and its ground, along the ground's normal, ft.
    pub fn pad_gap(&self, laws: &LegLaws, signals: &LegSignals<f64>) -> f64 {
        let (outer, law) = self.outer(laws);
        let gap = |element: &Crush, law: &CrushLaw, signal: Signal| {
            let interference = signals[signal as usize];
            element.set_at(law, interference) - interference
        };
        let outer = gap(outer, law, Signal::OuterInterference);
        if self.is_on_edge {
            return outer.max(0.0);
        }
        let inner = gap(&self.pad[1], &laws.pad, Signal::InnerInterference);
        let inclination = signals[Signal::PadInclination as usize].max(LEAST_INCLINATION);
        outer.min(inner).max(0.0) * inclination
    }

    /// Gap between the block, if there is one, and its ground, ft, at the cosine `inclination` of its inclination.
    pub fn block_gap(
        &self,
        laws: &LegLaws,
        signals: &LegSignals<f64>,
        inclination: f64,
    ) -> Option<f64> {
        let interference = signals[Signal::BlockInterference as usize];
        let set = self.block.set_at(&laws.block, interference);
        (!laws.block.is_absent()).then(|| (set - interference).max(0.0) * inclination)
    }

    /// Returns whether the footpad is crushed faster than `limit`, ft/s.
    pub fn pad_crushes(&self, limit: f64, signals: &LegSignals<f64>) -> bool {
        if self.is_on_edge {
            return crushes(&self.edge, Signal::OuterRate, limit, signals);
        }
        let [outer, inner] = &self.pad;
        crushes(outer, Signal::OuterRate, limit, signals)
            || crushes(inner, Signal::InnerRate, limit, signals)
    }

    /// Returns whether the block is crushed faster than `limit`, ft/s.
    pub fn block_crushes(&self, limit: f64, signals: &LegSignals<f64>) -> bool {
        crushes(&self.block, Signal::BlockRate, limit, signals)
    }

    /// Returns whether the strut's cartridge is crushed faster than `limit`, ft/s.
    pub fn strut_crushes(&self, limit: f64, signals: &LegSignals<f64>) -> bool {
        crushes(&self.cartridge, Signal::StrokeRate, limit, signals)
    }

    /// Returns whether the strut comes to rest before its stop under this force, lb.
    pub fn strut_bears(&self, laws: &LegLaws, force: f64) -> bool {
        let stop = laws.bottoming_stroke();
        let greatest = if laws.cartridge.is_absent() {
            laws.strut.static_force(stop)
        } else {
            self.cartridge.greatest_front(&laws.cartridge, stop)
        };
        force < greatest
    }

    /// Greatest crush and sinkage of the pad up to these signals: of its sections or, if it is on its edge and the edge
    /// has less left, of its edge.
    pub fn pad_depths(&self, laws: &LegLaws, signals: &LegSignals<f64>) -> PadDepths {
        let [outer, inner] = [Signal::OuterInterference, Signal::InnerInterference]
            .map(|signal| signals[signal as usize]);
        let deepest = |depths: [f64; 2]| {
            let sections = self.pad.iter().zip(depths);
            let reached = sections.map(|(section, depth)| section.deepest(depth));
            laws.pad_depths_at(reached.fold(0.0, f64::max))
        };
        if !self.is_on_edge {
            return deepest([outer, inner]);
        }
        // The first signal is the depth of the edge; the sections are as they were.
        let sections = deepest(self.pad.map(|section| section.set()));
        let edge = PadDepths {
            crush: self.edge.deepest(outer),
            height: laws.heights.edge,
            ..sections
        };
        let has_less_left = edge.crush * sections.height > sections.crush * edge.height;
        if has_less_left { edge } else { sections }
    }
}

/// Returns whether an element is crushed faster than `limit`, ft/s.
fn crushes(element: &Crush, rate: Signal, limit: f64, signals: &LegSignals<f64>) -> bool {
    element.is_on_front() && signals[rate as usize] > limit
}
