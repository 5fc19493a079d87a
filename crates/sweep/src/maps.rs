//! Self-refining maps: the choice of points, and the surface through them.

pub(crate) mod cell;
pub(crate) mod cell_refinement;
pub(crate) mod curved;
pub(crate) mod edges;
pub mod height;
pub(crate) mod interval_refinement;
pub(crate) mod located_side;
pub(crate) mod pieces;
pub(crate) mod resampled;
pub mod rounds;
pub(crate) mod surface_pieces;

#[cfg(test)]
mod profile_tests;
#[cfg(test)]
mod tests;
