//! Positions of the parts of a leg at one instant.

use super::plane::{PlaneDirection, PlanePoint};

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
