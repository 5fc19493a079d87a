//! The geometry of one leg: hardpoints, link, strut, footpad and block.

use libm::sincos;
use nalgebra::Vector3;

use super::body_frame::{BodyFrame, SeenGround, held, upright};
use super::leg_frame::{LegFrame, LegPose, SeenAlongLeg};
use super::plane::{PlaneDirection, PlanePoint};
use crate::lanes::per_lane;
use crate::scalar::Real;
use crate::vehicle::Leg;

/// Least squared sine of the inclination of a pad on its edge.
const LEAST_SINE: f64 = 1e-6;

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

impl<S: Real> LegGeometry<S> {
    /// Geometry of a leg whose hardpoints lie `hardpoint_depth` (ΔCG, ft) below the CG.
    pub fn new(leg: &Leg, hardpoint_depth: f64) -> Self {
        let design = leg.design();
        let (linkage, footpad) = (&design.linkage, &design.footpad);
        // Without a block its place is at the hardpoint, where nothing presses.
        let [block_radius, block_height] = design
            .block
            .as_ref()
            .map_or([linkage.lower_hardpoint_radius, 0.0], |block| {
                [block.radius, block.height]
            });
        let (a, l) = (linkage.hardpoint_distance, linkage.lower_link_length);
        let constant = S::constant;
        let centroid = 2.0 * footpad.diameter / (3.0 * std::f64::consts::PI);
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
            centroid: constant(centroid),
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

    /// Depths of the uncrushed centroids of the outboard and inboard sections below the ground, ft (negative above).
    pub fn section_depths(&self, pose: &LegPose<S>) -> [S; 2] {
        // An interference divides the depth of the pivot by the held cosine and counts the whole height of the pad.
        let cosine = held(pose.pad_inclination);
        let height = self.pad_height * (cosine - pose.pad_inclination);
        pose.pad_interference.map(|i| i * cosine - height)
    }

    /// Radius of a pad, ft.
    #[inline(always)]
    fn pad_radius(&self) -> S {
        // d_f/2 over the offset of a section's centroid, 2 d_f/3π.
        self.centroid * S::constant(0.75 * std::f64::consts::PI)
    }

    /// Height of the rim of a pad below its pivot, ft.
    #[inline(always)]
    fn rim_height(&self) -> S {
        self.pad_height * S::constant(0.5)
    }

    /// Depth of the edge of a pad below the ground, ft (negative above): that of the lowest point of its rim, at half
    /// of its height.
    #[inline(always)]
    pub fn edge_depth(&self, frame: &LegFrame<S>, pose: &LegPose<S>) -> S {
        let n = &frame.pad.normal;
        let pivot = frame.pad.depth + pose.pivot.reach * n.x + pose.pivot.drop * n.z;
        pivot + self.rim_height() * pose.pad_inclination + self.pad_radius() * pad_sine(pose)
    }

    /// Rate of that depth, ft/s, from the pivot's rate into the ground (ft/s) and the change of cos ξ (1/s).
    #[inline(always)]
    pub fn edge_rate(&self, pose: &LegPose<S>, pivot_inward: S, inclination_rate: S) -> S {
        let sinking = self.pad_radius() * (pose.pad_inclination / pad_sine(pose));
        pivot_inward + (self.rim_height() - sinking) * inclination_rate
    }

    /// Lowest point of the rim of a pad, at half of its height, relative to the pivot in leg axes, ft.
    #[inline(always)]
    pub fn edge(&self, frame: &LegFrame<S>, pose: &LegPose<S>) -> Vector3<S> {
        let reach = self.pad_radius() / pad_sine(pose);
        let upright = self.rim_height() - reach * pose.pad_inclination;
        frame.pad.normal * reach + pose.pad_z.in_leg_axes() * upright
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

    /// Motion of the footpad pivot per link angle γ, vehicle axes, ft.
    #[inline(always)]
    pub fn swing(&self, link_angle: S) -> Vector3<S> {
        let (sine, cosine) = link_angle.sin_cos();
        self.off_leg_plane(&PlanePoint {
            reach: -(self.link_length * sine),
            drop: self.link_length * cosine,
        })
    }

    /// Centre of the uncrushed block's face relative to the centre, ft.
    #[inline(always)]
    pub fn block_face(&self) -> Vector3<S> {
        self.off_leg_plane(&PlanePoint {
            reach: self.block_radius,
            drop: self.block_depth,
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

    /// Stroke δ of the strut and its lever dl_D/dγ (12) at link angle γ, ft.
    #[inline(always)]
    pub fn strut(&self, link_angle: S) -> [S; 2] {
        let (sine, cosine) = link_angle.sin_cos();
        let length = self.strut_length(sine, cosine);
        let cos_gb = cosine * self.cos_beta + sine * self.sin_beta;
        [
            self.extended_length - length,
            self.product * cos_gb / length,
        ]
    }

    /// d²l_D/dγ², ft, of a strut at this stroke δ and lever dl_D/dγ (11), (12), ft.
    #[inline(always)]
    pub fn strut_lever_change(&self, stroke: S, lever: S) -> S {
        let length = self.extended_length - stroke;
        // l_A l_L sin(γ − β), by (11).
        let offset = (length * length - self.squares) * S::constant(0.5);
        -(offset + lever * lever) / length
    }

    /// The body's frame in the axes of this leg, over the ground of its footpad and of its block.
    #[inline(always)]
    pub fn frame(&self, body: &BodyFrame<S>, [pad, block]: [&SeenGround<S>; 2]) -> LegFrame<S> {
        let rate = self.in_leg_axes(&body.rate);
        let pad = SeenAlongLeg {
            normal: self.in_leg_axes(&pad.normal),
            depth: pad.depth,
            upright: pad.upright,
        };
        LegFrame {
            normal_rate: pad.normal.cross(&rate),
            pad,
            block: SeenAlongLeg {
                normal: self.in_leg_axes(&block.normal),
                depth: block.depth,
                upright: block.upright,
            },
            velocity: self.in_leg_axes(&body.velocity),
            center_velocity: self.in_leg_axes(&body.center_velocity),
            rate,
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
        let n = &frame.pad.normal;
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
        let pivot_depth = frame.pad.depth + pivot.reach * n.x + pivot.drop * n.z;
        // Z'(r_k)/cos ξ with r_k = r_p ± centroid y'' + h_f0 z''
        let pad_upright = upright(pad_inclination);
        let lean = self.centroid * pad_y_normal;
        let pad_interference = [
            (pivot_depth + lean) * pad_upright + self.pad_height,
            (pivot_depth - lean) * pad_upright + self.pad_height,
        ];

        let (block, n) = (&frame.block, &frame.block.normal);
        let block_depth = block.depth + self.block_radius * n.x + self.block_depth * n.z;
        let block_interference = block_depth * block.upright;

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

    /// dI/dt of the pad sections (19), ft/s, for link rate γ̇ and pad rate dα/dt, rad/s.
    #[inline(always)]
    pub fn pad_interference_rates(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        pivot_inward: S,
        link_rate: S,
        pad_speed: S,
    ) -> [S; 2] {
        // I = depth/cos ξ: dI/dt = (d depth/dt − I d cos ξ/dt)/cos ξ, and in the vehicle the
        // normal turns as dn/dt = n×ω.
        let turn = link_rate - pad_speed;
        let inclination_rate = pose.pad_z.dot(&frame.normal_rate) - turn * pose.pad_y_normal;
        let lean_rate = pose.pad_y.dot(&frame.normal_rate) + turn * pose.pad_inclination;
        let lean = self.centroid * lean_rate;
        let [outer, inner] = pose
            .pad_interference
            .map(|i| (i - self.pad_height) * inclination_rate);
        [
            (pivot_inward + lean - outer) * pose.pad_upright,
            (pivot_inward - lean - inner) * pose.pad_upright,
        ]
    }
}

/// sin ξ of a pad.
#[inline(always)]
fn pad_sine<S: Real>(pose: &LegPose<S>) -> S {
    let cosine = pose.pad_inclination;
    (S::one() - cosine * cosine)
        .max(S::constant(LEAST_SINE))
        .sqrt()
}
