//! Extremes of a landing so far.

use num_traits::Zero;

use crate::integrator::parabola::Parabola;
use crate::laws::three_struts::{LOAD, STROKES, STRUTS};
use crate::quads::{LANES, QUADS, Quad};

/// Parabolas fitted to find an extreme between the nodes of a step.
const REFINEMENTS: usize = 4;

/// Signals of struts whose extremes are noted: the strokes, and the load of the primary strut.
pub(super) const TRACKED: [usize; STRUTS + 1] =
    [STROKES.start, STROKES.start + 1, STROKES.start + 2, LOAD];
/// Signs under which their least values are sought.
pub(super) const SIGNS: [f64; 2] = [1.0, -1.0];

/// Extremes so far.
pub(super) struct Extremes {
    /// Least stability angle σ (rad) and its time (s).
    pub(super) angle: (f64, f64),
    /// Least height of the hardpoints over the surface, ft.
    pub(super) clearance: f64,
    /// Least values of the [`TRACKED`] signals of the struts, and of their negatives, for groups of legs.
    pub(super) struts: [[[Quad; 2]; STRUTS + 1]; QUADS],
}

/// Quantities that decide stability, at one instant.
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
    pub(super) fn none() -> Self {
        Self {
            angle: (f64::INFINITY, 0.0),
            clearance: f64::INFINITY,
            struts: [[[Quad::zero(); 2]; STRUTS + 1]; QUADS],
        }
    }

    /// Least value of a tracked signal of a leg, and of its negative.
    pub(super) fn strut(&self, leg: usize, place: usize) -> [f64; 2] {
        self.struts[leg / LANES][place].map(|least| least.0[leg % LANES])
    }

    /// Greatest magnitude of the load of a leg's primary strut, lb.
    pub(super) fn force(&self, leg: usize) -> f64 {
        let [pull, push] = self.strut(leg, STRUTS);
        -pull.min(push)
    }

    /// Returns how far a strut of a leg was shortened and lengthened, ft.
    pub(super) fn strokes(&self, leg: usize, strut: usize) -> [f64; 2] {
        let [longer, shorter] = self.strut(leg, strut);
        [-shorter, -longer]
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
