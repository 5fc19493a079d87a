//! Positions and velocities: the surface in the vehicle's frame, and the geometry of one leg
//! (model chapters 1 and 3).
//!
//! The inward surface normal and the velocities are turned into the vehicle once, and then into the plane of each leg,
//! where its geometry lies. All these planes meet in the centreline. Legs are therefore placed from the *centre*, the
//! point of the centreline level with the CG: the CG itself unless it is off the centreline.

mod body_frame;
mod leg_frame;
mod leg_geometry;
mod local_ground;
mod plane;

pub use body_frame::{BodyFrame, SeenGround, Surface};
pub use leg_frame::{LegFrame, LegPose, PointVelocity, SeenAlongLeg};
pub use leg_geometry::LegGeometry;
pub use local_ground::{LegGround, LocalPlane};
pub use plane::{PlaneDirection, PlanePoint, turned};
