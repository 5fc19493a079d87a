//! Options that several commands share.

pub mod overrides;
pub mod solver_options;
pub mod touchdown_options;
pub mod units;
