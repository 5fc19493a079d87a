//! Numbers: single, or several in the lanes of a register; one item per leg.

pub mod extremes;
pub mod lanes;
pub mod per_leg;
pub mod products;
pub mod quads;
pub mod registers;
pub mod scalar;
