//! The frame of the rigid body over the surface.

use libm::sincos;
use nalgebra::{Matrix3, Vector3};

use crate::lanes::per_lane;
use crate::products::{times, transposed_times};
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::{Body, rotation};

/// The rigid body's frame at one instant.
#[derive(Debug, Clone, Copy)]
pub struct BodyFrame<S> {
    /// The rotation B, vehicle to ground (1).
    pub rotation: Matrix3<S>,
    /// CG in ground axes, ft.
    pub position: Vector3<S>,
    /// The surface.
    pub surface: SeenGround<S>,
    /// Centre relative to the CG: x and y of vehicle axes, ft.
    pub center: [S; 2],
    /// Velocity of the centre in vehicle axes, ft/s.
    pub velocity: Vector3<S>,
    /// Velocity of the centre relative to the CG in vehicle axes, ft/s.
    pub center_velocity: Vector3<S>,
    /// Angular velocity ω in vehicle axes, rad/s.
    pub rate: Vector3<S>,
}

per_lane!(BodyFrame {
    rotation,
    position,
    surface,
    center,
    velocity,
    center_velocity,
    rate,
});

/// A plane of the ground seen from the vehicle.
#[derive(Debug, Clone, Copy)]
pub struct SeenGround<S> {
    /// Inward normal n in vehicle axes.
    pub normal: Vector3<S>,
    /// Depth Z' of the centre below the plane, ft (negative above).
    pub depth: S,
    /// 1/cos ξ_B, held beyond 84 deg: the blocks stand along the centreline, cos ξ_B = k·n.
    pub upright: S,
}

per_lane!(SeenGround {
    normal,
    depth,
    upright,
});

impl<S: Real> SeenGround<S> {
    /// A plane with this inward normal (vehicle axes) and this depth of the CG below it (ft). The centre lies at x and
    /// y of vehicle axes (ft) from the CG.
    #[inline(always)]
    pub(super) fn new(normal: Vector3<S>, depth: S, [x, y]: [S; 2]) -> Self {
        Self {
            upright: upright(normal.z),
            depth: depth + (normal.x * x + normal.y * y),
            normal,
        }
    }

    /// Depth below the plane of a point given from the centre in vehicle axes, ft.
    #[inline(always)]
    pub fn depth_of(&self, point: &Vector3<S>) -> S {
        self.depth + self.normal.dot(point)
    }
}

/// 1/cos ξ of an element inclined by ξ. Beyond 84 deg, where no law of the model reaches, the cosine is held: an
/// interference keeps the sign of the depth, and elements in the air over a vehicle lying on its side do not seem to
/// touch the ground.
#[inline(always)]
pub(super) fn upright<S: Real>(inclination: S) -> S {
    S::one() / held(inclination)
}

/// The cosine that [`upright`] uses for this cos ξ.
#[inline(always)]
pub(super) fn held<S: Real>(inclination: S) -> S {
    inclination.max(S::constant(LEAST_INCLINATION))
}

/// Cosine below which an inclination is held.
const LEAST_INCLINATION: f64 = 0.1;

/// The surface: sine and cosine of the slope θs.
#[derive(Debug, Clone, Copy)]
pub struct Surface<S> {
    sine: S,
    cosine: S,
}

per_lane!(Surface { sine, cosine });

impl<S: Real> Surface<S> {
    /// The surface of a scene.
    pub fn new(scene: &Scene) -> Self {
        let (sine, cosine) = sincos(scene.conditions().slope);
        Self {
            sine: S::constant(sine),
            cosine: S::constant(cosine),
        }
    }

    /// Depth Z' of a point in ground axes below the surface, ft.
    #[inline(always)]
    pub fn depth(&self, point: &Vector3<S>) -> S {
        self.sine * point.y + self.cosine * point.z
    }

    /// The frame over this surface of a body whose centre lies at x and y of vehicle axes (ft) from the CG.
    #[inline(always)]
    pub fn frame(&self, body: &Body<S>, center: &[S; 2]) -> BodyFrame<S> {
        let rotation = rotation(&body.quaternion);
        let normal = Vector3::new(
            self.sine * rotation[(1, 0)] + self.cosine * rotation[(2, 0)],
            self.sine * rotation[(1, 1)] + self.cosine * rotation[(2, 1)],
            self.sine * rotation[(1, 2)] + self.cosine * rotation[(2, 2)],
        );
        let (rate, [x, y]) = (&body.rate, *center);
        let center_velocity = Vector3::new(-(rate.z * y), rate.z * x, rate.x * y - rate.y * x);
        BodyFrame {
            surface: SeenGround::new(normal, self.depth(&body.position), *center),
            position: body.position,
            center: *center,
            velocity: transposed_times(&rotation, &body.velocity) + center_velocity,
            center_velocity,
            rate: body.rate,
            rotation,
        }
    }
}

impl<S: Real> BodyFrame<S> {
    /// A point given from the centre in vehicle axes, relative to the CG in ground axes, ft.
    #[inline(always)]
    pub fn seen_from_center_of_gravity(&self, point: &Vector3<S>) -> Vector3<S> {
        let [x, y] = self.center;
        times(
            &self.rotation,
            &Vector3::new(point.x + x, point.y + y, point.z),
        )
    }

    /// Moment about the CG of a force (lb) at the centre, vehicle axes, ft·lb.
    #[inline(always)]
    pub fn moment_of_center(&self, force: &Vector3<S>) -> Vector3<S> {
        let [x, y] = self.center;
        Vector3::new(y * force.z, -(x * force.z), x * force.y - y * force.x)
    }
}
