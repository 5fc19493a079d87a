//! The equations of motion and the derivatives of their forces.

pub mod body_factors;
pub mod kinematics;
pub mod motion;
pub mod response;
pub mod state;
pub mod three_struts;
