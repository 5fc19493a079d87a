//! The body's frame and the ground seen along one leg, the positions of its parts, and velocities over the ground.

use nalgebra::Vector3;

use super::plane::{PlaneDirection, PlanePoint};
use crate::scalar::Real;

/// The body's frame seen along one leg: components outboard (e), across (k×e) and down (k).
///
/// A leg moves in its own plane, so half of every vector of its geometry vanishes in these axes.
#[derive(Debug, Clone, Copy)]
pub struct LegFrame<S> {
    /// The ground of the footpad.
    pub pad: SeenAlongLeg<S>,
    /// The ground of the block.
    pub block: SeenAlongLeg<S>,
    /// n×ω, the rate at which the normal of the footpad's ground turns in the vehicle, 1/s.
    pub(super) normal_rate: Vector3<S>,
    pub(super) velocity: Vector3<S>,
    pub(super) center_velocity: Vector3<S>,
    pub(super) rate: Vector3<S>,
}

/// A plane of the ground seen along one leg.
#[derive(Debug, Clone, Copy)]
pub struct SeenAlongLeg<S> {
    /// Inward normal n.
    pub normal: Vector3<S>,
    /// Depth of the centre below the plane, ft.
    pub(super) depth: S,
    /// 1/cos ξ_B ([`super::SeenGround`]).
    pub upright: S,
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

    /// Velocity of the crushed centre of the block, fixed to the body.
    #[inline(always)]
    pub fn block_velocity(&self, pose: &LegPose<S>) -> PointVelocity<S> {
        self.block.split(&self.carried(&pose.block_center))
    }

    /// Velocity of the footpad pivot, which swings with the lower link at l_L γ̇ (ft/s).
    #[inline(always)]
    pub fn pivot_velocity(&self, pose: &LegPose<S>, swing: S) -> PointVelocity<S> {
        let mut velocity = self.carried(&pose.pivot);
        velocity.x += pose.link_normal.outboard * swing;
        velocity.z += pose.link_normal.down * swing;
        self.pad.split(&velocity)
    }

    /// Velocity of a place on the footpad at this offset from the centre (leg axes, ft); link and hinge add `own`
    /// (ft/s).
    #[inline(always)]
    pub fn pad_velocity(&self, place: &Vector3<S>, own: &Vector3<S>) -> PointVelocity<S> {
        self.pad
            .split(&(self.velocity + self.rate.cross(place) + own))
    }

    /// Velocity of a place relative to the CG, carried by the body.
    #[inline(always)]
    pub fn place_carried_round(&self, place: &Vector3<S>) -> Vector3<S> {
        self.rate.cross(place) + self.center_velocity
    }

    /// d cos ξ/dt of the footpad, 1/s, turned by link and hinge at this rate (rad/s).
    #[inline(always)]
    pub fn inclination_rate(&self, pose: &LegPose<S>, turning: S) -> S {
        pose.pad_z.dot(&self.normal_rate) - turning * pose.pad_y_normal
    }

    /// dI/dt of the block (28), ft/s, at this interference (ft) and any inclination: beyond 84 deg the cosine is held.
    #[inline(always)]
    pub fn held_block_interference_rate(&self, centre_inward: S, interference: S) -> S {
        let (zero, one) = (S::zero(), S::one());
        let upright = self.block.upright;
        let is_held = (self.block.normal.z * upright - one).where_negative(one, zero);
        let deepening = is_held.where_zero(zero, interference * self.block_inclination_rate());
        (centre_inward + deepening) * upright
    }

    /// d cos ξ/dt of the block, 1/s.
    #[inline(always)]
    pub fn block_inclination_rate(&self) -> S {
        let (n, w) = (&self.block.normal, &self.rate);
        n.x * w.y - n.y * w.x
    }

    /// dI/dt of the block (28), ft/s.
    #[inline(always)]
    pub fn block_interference_rate(&self, centre_inward: S) -> S {
        // The uncrushed centre lies I_B k below the crushed one, and depth = I_B k·n:
        // k·n dI/dt = n·(V + ω×r_c + I_B ω×k) − I_B k·(n×ω) = n·(V + ω×r_c).
        centre_inward * self.block.upright
    }
}

impl<S: Real> SeenAlongLeg<S> {
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

    /// Two directions along the ground, with and across the sliding velocity; any two if there is none.
    #[inline(always)]
    pub fn tangents(&self, velocity: &PointVelocity<S>) -> (Vector3<S>, Vector3<S>) {
        let n = &self.normal;
        // A drift too slow to matter, outboard along the surface, gives a foot at rest a direction.
        let outboard = Vector3::new(S::one() - n.x * n.x, -n.x * n.y, -n.x * n.z);
        let drift = velocity.sliding + outboard * S::constant(1e-9);
        let along = drift * (S::one() / drift.dot(&drift).max(S::constant(1e-40)).sqrt());
        (along, n.cross(&along))
    }
}
