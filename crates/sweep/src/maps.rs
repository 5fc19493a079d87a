//! Maps that refine themselves: which points are wanted, and the surface through them.

pub(crate) mod cell;
pub(crate) mod cell_refinement;
pub(crate) mod curved;
pub mod edge_lines;
pub mod height;
pub(crate) mod located_side;
pub(crate) mod pieces;
pub mod resampled;
pub mod rounds;
pub mod surface_pieces;

#[cfg(test)]
mod tests;
