//! The slope, and the ground under each leg.

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::scene::Scene;

use super::{Triple, rounded, triple};

/// The ground.
#[derive(Debug, Serialize)]
pub struct Ground {
    slope_deg: f64,
    /// Upward normal of the surface.
    normal: Triple,
    /// Down the steepest slope, along the surface.
    downhill: Triple,
    /// A point of the surface.
    surface_point: Triple,
    /// Horizontal direction of V_H.
    velocity_direction: Triple,
    patches: Vec<Patch>,
}

/// The plane of the ground under a footpad or a block.
#[derive(Debug, Serialize)]
pub struct Patch {
    leg: usize,
    of: &'static str,
    point: Triple,
    normal: Triple,
    is_even: bool,
}

impl Patch {
    /// The ground that a `place` over leg `leg` (ground axes) is this deep below, with its inward normal.
    pub fn new(
        leg: usize,
        of: &'static str,
        is_even: bool,
        mut place: Vector3<f64>,
        inward: &Vector3<f64>,
        depth: f64,
    ) -> Self {
        // Patches are placed along the vertical.
        place.z -= depth / inward.z;
        Self {
            leg: leg + 1,
            of,
            point: triple(&place),
            normal: triple(&-inward),
            is_even,
        }
    }
}

impl Ground {
    /// The ground of a scene with these patches.
    pub fn of(scene: &Scene, patches: Vec<Patch>) -> Self {
        let conditions = scene.conditions();
        let (sine, cosine) = conditions.slope.sin_cos();
        let (sin_cross, cos_cross) = conditions.cross_slope.sin_cos();
        Self {
            slope_deg: conditions.slope.to_degrees(),
            normal: [0.0, rounded(-sine), rounded(-cosine)],
            downhill: [0.0, rounded(-cosine), rounded(sine)],
            surface_point: [0.0; 3],
            velocity_direction: [rounded(-sin_cross), rounded(cos_cross), 0.0],
            patches,
        }
    }
}
