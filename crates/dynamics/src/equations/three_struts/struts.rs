//! Lengths of the struts of a leg: all that one kind of leg differs from another by.

use nalgebra::Vector3;

use crate::lanes::per_lane;
use crate::laws::three_struts::STRUTS;
use crate::scalar::Real;
use crate::three_struts::{Arrangement, Telescope, ThreeStrutDesign};

/// Geometry of the struts of one leg, in vehicle axes from the CG.
#[derive(Debug, Clone, Copy)]
pub(super) struct Struts<S> {
    /// Length of the primary strut from its hardpoint to the collar, ft; 0 where the secondary struts end at the foot.
    collar: S,
    /// 1 where the secondary struts end at the foot, 0 where they end at the collar.
    ends_at_foot: S,
    /// Foot at rest, ft.
    pub(super) foot: Vector3<S>,
    /// Hardpoints, ft.
    pub(super) hardpoints: [Vector3<S>; STRUTS],
    /// Lengths at rest, ft.
    lengths: [S; STRUTS],
}

per_lane!(Struts {
    collar,
    ends_at_foot,
    foot,
    hardpoints,
    lengths,
});

/// A strut at one place of the foot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach<S> {
    /// Stroke, ft: how much shorter it is than at rest.
    pub(super) stroke: S,
    /// Force on the foot per load of the strut: change of its length with the place of the foot.
    pub(super) push: Vector3<S>,
}

impl Struts<f64> {
    /// The struts of a leg whose plane of the lower hardpoints lies `depth` (ft) below the CG, placed from the `center`
    /// of the centreline (x and y of vehicle axes relative to the CG, ft).
    pub(super) fn new(design: &ThreeStrutDesign, depth: f64, [x, y]: [f64; 2]) -> Self {
        let (sine, cosine) = libm::sincos(design.azimuth);
        let in_vehicle_axes = |p: Vector3<f64>| {
            Vector3::new(
                x + p.x * sine + p.y * cosine,
                y + p.x * cosine - p.y * sine,
                depth + p.z,
            )
        };
        let (foot, hardpoints) = design.places();
        let (collar, ends_at_foot) = match design.arrangement {
            Arrangement::Tripod => (0.0, 1.0),
            Arrangement::Cantilever(Telescope { collar, .. }) => (collar, 0.0),
        };
        Self {
            collar,
            ends_at_foot,
            foot: in_vehicle_axes(foot),
            hardpoints: hardpoints.map(in_vehicle_axes),
            lengths: design.rest_lengths(),
        }
    }
}

impl<S: Real> Struts<S> {
    /// The struts with the foot at a place.
    #[inline(always)]
    pub(super) fn at(&self, foot: &Vector3<S>) -> [Reach<S>; STRUTS] {
        let [primary, left, right] = &self.hardpoints;
        let (length, along) = length_and_direction(&(foot - primary));
        // Where the secondary struts end.
        let arm = self.collar + length * self.ends_at_foot;
        let end = primary + along * arm;
        let share = arm / length;
        let first = Reach {
            stroke: self.lengths[0] - length,
            push: along,
        };
        [
            first,
            self.secondary(self.lengths[1], &(end - left), &along, share),
            self.secondary(self.lengths[2], &(end - right), &along, share),
        ]
    }

    /// A secondary strut of a length at rest that spans so much now. Its end follows a `share` of what the foot moves across the
    /// primary strut, which lies `along` this direction.
    #[inline(always)]
    fn secondary(&self, at_rest: S, span: &Vector3<S>, along: &Vector3<S>, share: S) -> Reach<S> {
        let (length, toward) = length_and_direction(span);
        let lengthwise = along * along.dot(&toward);
        Reach {
            stroke: at_rest - length,
            push: (toward - lengthwise) * share + lengthwise * self.ends_at_foot,
        }
    }
}

#[inline(always)]
fn length_and_direction<S: Real>(span: &Vector3<S>) -> (S, Vector3<S>) {
    let length = span.dot(span).sqrt();
    (length, span * (S::one() / length))
}
