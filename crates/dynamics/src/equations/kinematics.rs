//! Positions and velocities: the surface in the vehicle's frame, and the geometry of one leg
//! (model chapters 1 and 3).
//!
//! The inward surface normal and the velocities are turned into the vehicle once, and then into
//! the plane of each leg, where its geometry lies. All these planes meet in the centreline. Legs are therefore placed
//! from the *centre*, the point of the centreline level with the CG: the CG itself unless that is off the centreline.

mod plane;

use libm::sincos;
use nalgebra::{Matrix3, Vector3};

use crate::lanes::per_lane;
use crate::products::{times, transposed_times};
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::{Body, rotation};
use crate::vehicle::Leg;

pub use plane::{PlaneDirection, PlanePoint};

/// The rigid body's frame at one instant.
#[derive(Debug, Clone, Copy)]
pub struct BodyFrame<S> {
    /// The rotation B, vehicle to ground (1).
    pub rotation: Matrix3<S>,
    /// Inward surface normal n in vehicle axes.
    pub normal: Vector3<S>,
    /// Centre relative to the CG: x and y of vehicle axes, ft.
    pub center: [S; 2],
    /// Velocity of the centre in vehicle axes, ft/s.
    pub velocity: Vector3<S>,
    /// Velocity of the centre relative to the CG in vehicle axes, ft/s.
    pub center_velocity: Vector3<S>,
    /// Angular velocity ω in vehicle axes, rad/s.
    pub rate: Vector3<S>,
    /// Depth Z' of the centre below the surface, ft (negative above).
    pub depth: S,
    /// 1/cos ξ_B, held beyond 84 deg: the blocks stand along the centreline, cos ξ_B = k·n.
    pub upright: S,
}

per_lane!(BodyFrame {
    rotation,
    normal,
    center,
    velocity,
    center_velocity,
    rate,
    depth,
    upright,
});

/// 1/cos ξ of an element inclined by ξ. Beyond 84 deg, where no law of the model reaches, the
/// cosine is held: an interference keeps the sign of the depth, and what hangs in the air over a
/// vehicle lying on its side does not seem to touch the ground.
#[inline(always)]
fn upright<S: Real>(inclination: S) -> S {
    S::one() / inclination.max(S::constant(LEAST_INCLINATION))
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

    /// The frame over this surface of a body whose centre lies so (x and y of vehicle axes, ft) from the CG.
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
            upright: upright(normal.z),
            depth: self.depth(&body.position) + (normal.x * x + normal.y * y),
            normal,
            center: *center,
            velocity: transposed_times(&rotation, &body.velocity) + center_velocity,
            center_velocity,
            rate: body.rate,
            rotation,
        }
    }
}

impl<S: Real> BodyFrame<S> {
    /// A point given from the centre in vehicle axes, as seen from the CG in ground axes, ft.
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

/// Constants of a leg's geometry.
#[derive(Debug, Clone, Copy)]
pub struct LegGeometry<S> {
    /// Outboard direction e_j = (sin θj, cos θj, 0).
    outboard: [S; 2],
    hardpoint_radius: S,
    hardpoint_depth: S,
    link_length: S,
    /// l_A l_L and l_A² + l_L² of (11).
    product: S,
    squares: S,
    sin_beta: S,
    cos_beta: S,
    extended_length: S,
    /// Centroid offset of a pad section from the pivot, 2 d_f / 3π.
    centroid: S,
    pad_height: S,
    block_radius: S,
    block_depth: S,
}

per_lane!(LegGeometry {
    outboard,
    hardpoint_radius,
    hardpoint_depth,
    link_length,
    product,
    squares,
    sin_beta,
    cos_beta,
    extended_length,
    centroid,
    pad_height,
    block_radius,
    block_depth,
});

/// The body's frame seen along one leg: components outboard (e), across (k×e) and down (k).
///
/// A leg moves in its own plane, so in these axes half of every vector of its geometry vanishes.
#[derive(Debug, Clone, Copy)]
pub struct LegFrame<S> {
    /// Inward surface normal n.
    pub normal: Vector3<S>,
    /// n×ω, the rate at which the normal turns in the vehicle, 1/s.
    pub normal_rate: Vector3<S>,
    velocity: Vector3<S>,
    center_velocity: Vector3<S>,
    rate: Vector3<S>,
    depth: S,
    upright: S,
}

/// Geometry of a leg at one instant.
#[derive(Debug, Clone, Copy)]
pub struct LegPose<S> {
    /// Footpad pivot r_p (7).
    pub pivot: PlanePoint<S>,
    /// Normal s of the lower link: pivot velocity per l_L γ̇.
    pub link_normal: PlaneDirection<S>,
    /// Pad axis y''.
    pub pad_y: PlaneDirection<S>,
    /// Pad axis z''.
    pub pad_z: PlaneDirection<S>,
    /// cos ξ = z''·n.
    pub pad_inclination: S,
    /// 1/cos ξ, held beyond 84 deg.
    pub pad_upright: S,
    /// y''·n.
    pub pad_y_normal: S,
    /// Strut stroke δ, ft.
    pub stroke: S,
    /// Strut lever dl_D/dγ (12), ft.
    pub strut_lever: S,
    /// Interference of the outboard and inboard pad sections (19), ft.
    pub pad_interference: [S; 2],
    /// Interference of the block (28), ft.
    pub block_interference: S,
    /// Crushed centre of the block.
    pub block_center: PlanePoint<S>,
}

impl<S: Real> LegGeometry<S> {
    /// Geometry of a leg whose hardpoints lie `hardpoint_depth` (ΔCG, ft) below the CG.
    pub fn new(leg: &Leg, hardpoint_depth: f64) -> Self {
        let design = leg.design();
        let (linkage, footpad) = (&design.linkage, &design.footpad);
        // Without a block its place is at the hardpoint; nothing presses there.
        let [block_radius, block_height] = design
            .block
            .as_ref()
            .map_or([linkage.lower_hardpoint_radius, 0.0], |block| {
                [block.radius, block.height]
            });
        let (a, l) = (linkage.hardpoint_distance, linkage.lower_link_length);
        let constant = S::constant;
        let (sin_azimuth, cos_azimuth) = sincos(design.azimuth);
        let (sin_beta, cos_beta) = sincos(linkage.hardpoint_angle);
        Self {
            outboard: [constant(sin_azimuth), constant(cos_azimuth)],
            hardpoint_radius: constant(linkage.lower_hardpoint_radius),
            hardpoint_depth: constant(hardpoint_depth),
            link_length: constant(l),
            product: constant(a * l),
            squares: constant(a * a + l * l),
            sin_beta: constant(sin_beta),
            cos_beta: constant(cos_beta),
            extended_length: constant(design.strut.extended_length),
            centroid: constant(2.0 * footpad.diameter / (3.0 * std::f64::consts::PI)),
            pad_height: constant(footpad.height),
            block_radius: constant(block_radius),
            block_depth: constant(hardpoint_depth + block_height),
        }
    }

    /// Length l_L of the lower link, ft.
    #[inline(always)]
    pub fn link_length(&self) -> S {
        self.link_length
    }

    /// Uncrushed pad height h_f0, ft.
    #[inline(always)]
    pub fn pad_height(&self) -> S {
        self.pad_height
    }

    /// Centroid offsets y'' of the outboard and inboard sections, ft.
    #[inline(always)]
    pub fn centroids(&self) -> [S; 2] {
        [self.centroid, -self.centroid]
    }

    /// Crushed centroid of a pad section (0 outboard, 1 inboard) relative to the pivot, ft.
    #[inline(always)]
    pub fn section_centroid(&self, pose: &LegPose<S>, section: usize) -> PlaneDirection<S> {
        let height = self.pad_height - pose.pad_interference[section];
        let mut centroid = PlaneDirection::zero();
        centroid.add(self.centroids()[section], &pose.pad_y);
        centroid.add(height, &pose.pad_z);
        centroid
    }

    /// Lower hardpoint relative to the centre (6), ft.
    #[inline(always)]
    pub fn lower_hardpoint(&self) -> Vector3<S> {
        let [ex, ey] = self.outboard;
        Vector3::new(
            self.hardpoint_radius * ex,
            self.hardpoint_radius * ey,
            self.hardpoint_depth,
        )
    }

    /// Footpad pivot relative to the centre at link angle γ (7), ft.
    #[inline(always)]
    pub fn pivot(&self, link_angle: S) -> Vector3<S> {
        let (sine, cosine) = link_angle.sin_cos();
        self.off_leg_plane(&PlanePoint {
            reach: self.hardpoint_radius + self.link_length * cosine,
            drop: self.hardpoint_depth + self.link_length * sine,
        })
    }

    /// A point in the plane of this leg, relative to the centre in vehicle axes, ft.
    #[inline(always)]
    pub fn off_leg_plane(&self, point: &PlanePoint<S>) -> Vector3<S> {
        let [ex, ey] = self.outboard;
        Vector3::new(point.reach * ex, point.reach * ey, point.drop)
    }

    /// Length of the strut (11), ft, at sine and cosine of the link angle γ.
    #[inline(always)]
    fn strut_length(&self, sin_g: S, cos_g: S) -> S {
        let sin_gb = sin_g * self.cos_beta - cos_g * self.sin_beta;
        (self.squares + (self.product + self.product) * sin_gb).sqrt()
    }

    /// Stroke δ of the strut at link angle γ, ft.
    #[inline(always)]
    pub fn stroke(&self, link_angle: S) -> S {
        let (sine, cosine) = link_angle.sin_cos();
        self.extended_length - self.strut_length(sine, cosine)
    }

    /// d²l_D/dγ², ft, of a strut at this stroke δ and lever dl_D/dγ (11), (12), ft.
    #[inline(always)]
    pub fn strut_lever_change(&self, stroke: S, lever: S) -> S {
        let length = self.extended_length - stroke;
        // l_A l_L sin(γ − β), by (11).
        let offset = (length * length - self.squares) * S::constant(0.5);
        -(offset + lever * lever) / length
    }

    /// The body's frame in the axes of this leg.
    #[inline(always)]
    pub fn frame(&self, body: &BodyFrame<S>) -> LegFrame<S> {
        let normal = self.in_leg_axes(&body.normal);
        let rate = self.in_leg_axes(&body.rate);
        LegFrame {
            normal_rate: normal.cross(&rate),
            normal,
            velocity: self.in_leg_axes(&body.velocity),
            center_velocity: self.in_leg_axes(&body.center_velocity),
            rate,
            depth: body.depth,
            upright: body.upright,
        }
    }

    #[inline(always)]
    fn in_leg_axes(&self, v: &Vector3<S>) -> Vector3<S> {
        let [ex, ey] = self.outboard;
        Vector3::new(ex * v.x + ey * v.y, ex * v.y - ey * v.x, v.z)
    }

    /// Turns a vector from leg axes into vehicle axes.
    #[inline(always)]
    pub fn in_vehicle_axes(&self, v: &Vector3<S>) -> Vector3<S> {
        let [ex, ey] = self.outboard;
        Vector3::new(ex * v.x - ey * v.y, ey * v.x + ex * v.y, v.z)
    }

    /// The leg at link angle γ and pad angle α.
    #[inline(always)]
    pub fn pose(&self, frame: &LegFrame<S>, link_angle: S, pad_angle: S) -> LegPose<S> {
        let n = &frame.normal;
        let (sin_g, cos_g) = link_angle.sin_cos();
        let (sin_d, cos_d) = (link_angle - pad_angle).sin_cos();

        let pivot = PlanePoint {
            reach: self.hardpoint_radius + self.link_length * cos_g,
            drop: self.hardpoint_depth + self.link_length * sin_g,
        };
        let link_normal = PlaneDirection {
            outboard: -sin_g,
            down: cos_g,
        };
        let pad_y = PlaneDirection {
            outboard: cos_d,
            down: sin_d,
        };
        let pad_z = PlaneDirection {
            outboard: -sin_d,
            down: cos_d,
        };

        // γ − β in (12)
        let cos_gb = cos_g * self.cos_beta + sin_g * self.sin_beta;
        let length = self.strut_length(sin_g, cos_g);

        let pad_y_normal = pad_y.dot(n);
        let pad_inclination = pad_z.dot(n);
        let pivot_depth = frame.depth + pivot.reach * n.x + pivot.drop * n.z;
        // Z'(r_k)/cos ξ with r_k = r_p ± centroid y'' + h_f0 z''
        let pad_upright = upright(pad_inclination);
        let lean = self.centroid * pad_y_normal;
        let pad_interference = [
            (pivot_depth + lean) * pad_upright + self.pad_height,
            (pivot_depth - lean) * pad_upright + self.pad_height,
        ];

        let block_depth = frame.depth + self.block_radius * n.x + self.block_depth * n.z;
        let block_interference = block_depth * frame.upright;

        LegPose {
            pivot,
            link_normal,
            pad_y,
            pad_z,
            pad_inclination,
            pad_upright,
            pad_y_normal,
            stroke: self.extended_length - length,
            strut_lever: self.product * cos_gb / length,
            pad_interference,
            block_interference,
            block_center: PlanePoint {
                reach: self.block_radius,
                drop: self.block_depth - block_interference,
            },
        }
    }
}

/// Velocity, relative to the surface, of a point of the vehicle, split along the inward normal.
#[derive(Debug, Clone, Copy)]
pub struct PointVelocity<S> {
    /// Rate into the ground, ft/s.
    pub inward: S,
    /// Sliding velocity in leg axes, ft/s.
    pub sliding: Vector3<S>,
    /// Squared sliding speed S², ft²/s².
    pub sliding_squared: S,
}

impl<S: Real> LegFrame<S> {
    /// Angular velocity ω, rad/s.
    #[inline(always)]
    pub fn rate(&self) -> Vector3<S> {
        self.rate
    }

    /// Velocity of a point of the body in leg axes: V + ω×r.
    #[inline(always)]
    fn carried(&self, point: &PlanePoint<S>) -> Vector3<S> {
        let (v, w) = (&self.velocity, &self.rate);
        Vector3::new(
            v.x + w.y * point.drop,
            v.y + w.z * point.reach - w.x * point.drop,
            v.z - w.y * point.reach,
        )
    }

    /// Velocity of a point of the body relative to the CG: ω×r.
    #[inline(always)]
    pub fn carried_round(&self, point: &PlanePoint<S>) -> Vector3<S> {
        let w = &self.rate;
        let round_center = Vector3::new(
            w.y * point.drop,
            w.z * point.reach - w.x * point.drop,
            -(w.y * point.reach),
        );
        round_center + self.center_velocity
    }

    #[inline(always)]
    fn split(&self, velocity: &Vector3<S>) -> PointVelocity<S> {
        let inward = self.normal.dot(velocity);
        let sliding = velocity - self.normal * inward;
        PointVelocity {
            inward,
            sliding,
            sliding_squared: sliding.dot(&sliding),
        }
    }

    /// Two directions along the surface, with and across the sliding velocity; any two when there
    /// is none.
    #[inline(always)]
    pub fn tangents(&self, velocity: &PointVelocity<S>) -> (Vector3<S>, Vector3<S>) {
        let n = &self.normal;
        // A drift too slow to matter, outboard along the surface, gives a foot at rest a direction.
        let outboard = Vector3::new(S::one() - n.x * n.x, -n.x * n.y, -n.x * n.z);
        let drift = velocity.sliding + outboard * S::constant(1e-9);
        let along = drift * (S::one() / drift.dot(&drift).max(S::constant(1e-40)).sqrt());
        (along, n.cross(&along))
    }

    /// Velocity of a point of the body.
    #[inline(always)]
    pub fn velocity_at(&self, point: &PlanePoint<S>) -> PointVelocity<S> {
        self.split(&self.carried(point))
    }

    /// Velocity of the footpad pivot, which swings with the lower link at l_L γ̇ (ft/s).
    #[inline(always)]
    pub fn pivot_velocity(&self, pose: &LegPose<S>, swing: S) -> PointVelocity<S> {
        let mut velocity = self.carried(&pose.pivot);
        velocity.x += pose.link_normal.outboard * swing;
        velocity.z += pose.link_normal.down * swing;
        self.split(&velocity)
    }

    /// dI/dt of the pad sections (19), ft/s, for link rate γ̇ and pad rate dα/dt, rad/s.
    #[inline(always)]
    pub fn pad_interference_rates(
        &self,
        pose: &LegPose<S>,
        geometry: &LegGeometry<S>,
        pivot_inward: S,
        link_rate: S,
        pad_speed: S,
    ) -> [S; 2] {
        // I = depth/cos ξ: dI/dt = (d depth/dt − I d cos ξ/dt)/cos ξ, and in the vehicle the
        // normal turns as dn/dt = n×ω.
        let turn = link_rate - pad_speed;
        let inclination_rate = pose.pad_z.dot(&self.normal_rate) - turn * pose.pad_y_normal;
        let lean_rate = pose.pad_y.dot(&self.normal_rate) + turn * pose.pad_inclination;
        let lean = geometry.centroid * lean_rate;
        let [outer, inner] = pose
            .pad_interference
            .map(|i| (i - geometry.pad_height) * inclination_rate);
        [
            (pivot_inward + lean - outer) * pose.pad_upright,
            (pivot_inward - lean - inner) * pose.pad_upright,
        ]
    }

    /// dI/dt of the block (28), ft/s.
    #[inline(always)]
    pub fn block_interference_rate(&self, centre_inward: S) -> S {
        // The uncrushed centre lies I_B k below the crushed one, and depth = I_B k·n:
        // k·n dI/dt = n·(V + ω×r_c + I_B ω×k) − I_B k·(n×ω) = n·(V + ω×r_c).
        centre_inward * self.upright
    }
}
