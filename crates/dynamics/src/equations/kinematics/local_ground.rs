//! Ground under one leg that differs from the surface: a plane under the footpad and one under the block.

use libm::sincos;
use nalgebra::Vector3;

use super::body_frame::{BodyFrame, SeenGround};
use super::leg_geometry::LegGeometry;
use crate::ground::{LegFooting, Patch};
use crate::lanes::per_lane;
use crate::products::transposed_times;
use crate::scalar::Real;
use crate::scene::Scene;

/// The ground under one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegGround<S> {
    pad: LocalPlane<S>,
    block: LocalPlane<S>,
    /// 1 if either plane is not that of the surface, else 0.
    unevenness: S,
}

per_lane!(LegGround {
    pad,
    block,
    unevenness,
});

/// A plane: the depth of a point p (ground axes, ft) below it is n·p + offset.
#[derive(Debug, Clone, Copy)]
pub struct LocalPlane<S> {
    /// Inward normal in ground axes.
    normal: Vector3<S>,
    /// In ft.
    offset: S,
}

per_lane!(LocalPlane { normal, offset });

impl LegGround<f64> {
    /// The ground under leg `index` of a vehicle that touches down in a scene with its feet extended. `[x, y]` is the
    /// centre relative to the CG (vehicle axes, ft), `link_angle` that of the extended link, rad.
    pub fn new(
        scene: &Scene,
        index: usize,
        geometry: &LegGeometry<f64>,
        [x, y]: [f64; 2],
        link_angle: f64,
    ) -> Self {
        let conditions = scene.conditions();
        let LegFooting { pad, block, .. } = *conditions.ground.leg(index);
        let attitude = conditions.attitude.matrix();
        let center = Vector3::new(x, y, 0.0);
        let place = |point: Vector3<f64>| attitude * (center + point);
        Self {
            unevenness: if pad.is_even() && block.is_even() {
                0.0
            } else {
                1.0
            },
            pad: LocalPlane::new(&pad, conditions.slope, place(geometry.pivot(link_angle))),
            block: LocalPlane::new(&block, conditions.slope, place(geometry.block_face())),
        }
    }
}

impl LocalPlane<f64> {
    /// The plane of a patch on a slope (rad) through the point that lies the patch's height over the surface on the vertical
    /// of `place` (from the CG at first contact, ground axes, ft).
    pub fn new(patch: &Patch, slope: f64, place: Vector3<f64>) -> Self {
        let (sine, cosine) = sincos(slope);
        let (sin_along, cos_along) = sincos(slope + patch.tilt_along);
        let (sin_across, cos_across) = sincos(patch.tilt_across);
        let normal = Vector3::new(sin_across, cos_across * sin_along, cos_across * cos_along);
        let z = -(patch.height + sine * place.y) / cosine;
        Self {
            normal,
            offset: if patch.is_tilted() {
                -normal.dot(&Vector3::new(place.x, place.y, z))
            } else {
                patch.height
            },
        }
    }
}

impl<S: Real> LocalPlane<S> {
    /// Inward normal in ground axes.
    pub fn normal(&self) -> &Vector3<S> {
        &self.normal
    }

    /// Depth below the plane of a point in ground axes, ft.
    #[inline(always)]
    pub fn depth_of(&self, point: &Vector3<S>) -> S {
        self.normal.dot(point) + self.offset
    }

    /// Vertical rise of a point to leave the plane, ft, from its depth (ft) below it.
    pub fn rise(&self, depth: S) -> S {
        depth / self.normal.z
    }
}

impl<S: Real> LegGround<S> {
    /// Returns whether the leg stands over the surface.
    #[inline(always)]
    pub fn is_even(&self) -> bool {
        self.unevenness.is_zero()
    }

    /// The planes of footpad and block, seen from a body.
    #[inline(always)]
    pub fn seen(&self, body: &BodyFrame<S>) -> [SeenGround<S>; 2] {
        [&self.pad, &self.block].map(|plane| {
            let normal = transposed_times(&body.rotation, &plane.normal);
            let depth = plane.normal.dot(&body.position) + plane.offset;
            SeenGround::new(normal, depth, body.center)
        })
    }

    /// Vertical rise of a point to leave the plane of the footpad, ft, from its depth (ft) below the plane.
    pub fn rise(&self, depth: S) -> S {
        self.pad.rise(depth)
    }
}
