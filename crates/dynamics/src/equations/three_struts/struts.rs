//! Lengths of the struts of a leg: all that one kind of leg differs from another by.

use nalgebra::Vector3;

use crate::laws::three_struts::STRUTS;
use crate::three_struts::{Arrangement, ThreeStrutDesign};

/// Geometry of the struts of one leg, in vehicle axes from the CG.
#[derive(Debug, Clone, Copy)]
pub(super) struct Struts {
    arrangement: Arrangement,
    /// Foot at rest, ft.
    pub(super) foot: Vector3<f64>,
    /// Hardpoints, ft.
    pub(super) hardpoints: [Vector3<f64>; STRUTS],
    /// Lengths at rest, ft.
    lengths: [f64; STRUTS],
}

/// A strut at one place of the foot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// Stroke, ft: how much shorter it is than at rest.
    pub(super) stroke: f64,
    /// Force on the foot per load of the strut: change of its length with the place of the foot.
    pub(super) push: Vector3<f64>,
}

impl Struts {
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
        Self {
            arrangement: design.arrangement,
            foot: in_vehicle_axes(foot),
            hardpoints: hardpoints.map(in_vehicle_axes),
            lengths: design.rest_lengths(),
        }
    }

    /// The struts with the foot at a place.
    #[inline(always)]
    pub(super) fn at(&self, foot: &Vector3<f64>) -> [Reach; STRUTS] {
        let [primary, ..] = &self.hardpoints;
        let (length, along) = length_and_direction(&(foot - primary));
        let reach = |k: usize, length: f64, push| Reach {
            stroke: self.lengths[k] - length,
            push,
        };
        let secondary = |k: usize| match self.arrangement {
            Arrangement::Tripod => {
                let (length, along) = length_and_direction(&(foot - self.hardpoints[k]));
                reach(k, length, along)
            }
            Arrangement::Cantilever { collar } => {
                let end = primary + along * collar;
                let (own, toward) = length_and_direction(&(end - self.hardpoints[k]));
                // As the foot moves, the collar follows across the primary strut.
                let across = toward - along * along.dot(&toward);
                reach(k, own, across * (collar / length))
            }
        };
        [reach(0, length, along), secondary(1), secondary(2)]
    }
}

#[inline(always)]
fn length_and_direction(span: &Vector3<f64>) -> (f64, Vector3<f64>) {
    let length = libm::sqrt(span.norm_squared());
    (length, span / length)
}
