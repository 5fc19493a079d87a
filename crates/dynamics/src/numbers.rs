//! Numbers: one, or several in the lanes of a register; one item a leg.

pub mod extremes;
pub mod lanes;
pub mod per_leg;
pub mod products;
pub mod registers;
pub mod scalar;
