//! The equations of motion and how their forces answer.

pub mod kinematics;
pub mod motion;
pub mod response;
pub mod state;
