//! The laws of a leg, each cut into pieces: coefficients, ranges in which they hold, and the next pieces.

pub mod contact;
pub mod crush;
pub mod friction;
pub mod hinge;
pub mod leg_pieces;
pub mod outcome;
pub mod signal;
pub mod strut;
pub mod three_struts;
