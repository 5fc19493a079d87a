//! The slope, and the ground under each leg.

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::kinematics::SeenGround;
use touchdown_dynamics::motion::Motion;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::touchdown::touchdown;
use touchdown_dynamics::vehicle::Vehicle;

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
struct Patch {
    leg: usize,
    of: &'static str,
    point: Triple,
    normal: Triple,
    is_even: bool,
}

impl Ground {
    /// The ground under a vehicle at touchdown.
    pub fn of(vehicle: &Vehicle, scene: &Scene, motion: &Motion<f64>) -> Self {
        let conditions = scene.conditions();
        let (sine, cosine) = conditions.slope.sin_cos();
        let (sin_cross, cos_cross) = conditions.cross_slope.sin_cos();
        let body = touchdown(vehicle, scene, motion).body();
        let frame = motion.frame(&body);
        let mut patches = Vec::new();
        for (index, leg) in vehicle.hinged_legs().iter().enumerate() {
            let geometry = motion.geometry(index);
            let [pad, block] = motion.ground(index, &frame);
            let footing = conditions.ground.leg(index);
            let mut add = |of, is_even, seen: &SeenGround<f64>, place: Vector3<f64>| {
                let inward = frame.rotation * seen.normal;
                let mut point = body.position + frame.seen_from_center_of_gravity(&place);
                // Patches are placed along the vertical.
                point.z -= seen.depth_of(&place) / inward.z;
                patches.push(Patch {
                    leg: index + 1,
                    of,
                    point: triple(&point),
                    normal: triple(&-inward),
                    is_even,
                });
            };
            let foot = geometry.pivot(leg.extended_angle());
            add("pad", footing.pad.is_even(), &pad, foot);
            if leg.design().block.is_some() {
                add(
                    "block",
                    footing.block.is_even(),
                    &block,
                    geometry.block_face(),
                );
            }
        }
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
