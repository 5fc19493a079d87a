//! Reasons why there is no picture.

use thiserror::Error;

/// A picture that could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FigureError {
    /// The result table is not what the picture needs.
    #[error("result table: {0}")]
    Table(String),
    /// The result table is in order, but there is no picture of it.
    #[error("has no picture: {0}")]
    NoPicture(String),
    /// The PNG cannot be made.
    #[error("PNG: {0}")]
    Rendering(String),
}
