//! Extremes of a landing so far.

use crate::integrator::parabola::Parabola;
use crate::laws::three_struts::STRUTS;
use crate::per_leg::PerLeg;

/// Parabolas fitted to find an extreme between the nodes of a step.
const REFINEMENTS: usize = 4;

/// Extremes so far.
pub(super) struct Extremes {
    /// Least stability angle σ (rad) and its time (s).
    pub(super) angle: (f64, f64),
    /// Least height of the hardpoints over the surface, ft.
    pub(super) clearance: f64,
    /// Greatest magnitude of the load of each leg's primary strut, lb.
    pub(super) force: PerLeg<f64>,
    /// Least negative strokes and least strokes of the struts of each leg, ft: how far they were shortened and lengthened.
    pub(super) strokes: PerLeg<[[f64; STRUTS]; 2]>,
}

/// What decides stability, at one instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    /// Stability angle σ, rad.
    pub(super) angle: f64,
    /// Least height of the hardpoints over the surface, ft.
    pub(super) clearance: f64,
}

impl Seen {
    /// Before the first look.
    pub(super) const NOTHING: Self = Self {
        angle: f64::INFINITY,
        clearance: f64::INFINITY,
    };
}

impl Extremes {
    pub(super) fn none(legs: usize) -> Self {
        Self {
            angle: (f64::INFINITY, 0.0),
            clearance: f64::INFINITY,
            force: PerLeg::same(legs, 0.0),
            strokes: PerLeg::same(legs, [[0.0; STRUTS]; 2]),
        }
    }

    pub(super) fn note_angle(&mut self, seen: Seen, time: f64) {
        if seen.angle < self.angle.0 {
            self.angle = (seen.angle, time);
        }
        self.clearance = self.clearance.min(seen.clearance);
    }
}

/// Closes in by parabolas on a value less than `least` between three nodes (θ, value). Returns where it is, and the value.
pub(super) fn close_in(
    nodes: [(f64, f64); 3],
    mut least: f64,
    value: impl Fn(f64) -> f64,
) -> Option<(f64, f64)> {
    let mut parabola = Parabola::through(nodes);
    let mut found = None;
    for _ in 0..REFINEMENTS {
        let Some(theta) = parabola.lowest(least) else {
            break;
        };
        let node = (theta, value(theta));
        if node.1 < least {
            (least, found) = (node.1, Some(node));
        }
        parabola = parabola.about(node);
    }
    found
}
