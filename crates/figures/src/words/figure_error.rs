//! Why there is no picture.

use std::fmt;

/// A picture that could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FigureError {
    /// The result table is not what the picture needs.
    Table(String),
    /// Drawing failed.
    Drawing(String),
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table(complaint) => write!(f, "result table: {complaint}"),
            Self::Drawing(complaint) => write!(f, "drawing: {complaint}"),
        }
    }
}

impl std::error::Error for FigureError {}

/// Wraps an error of the drawing library.
pub(crate) fn drawing(error: impl fmt::Display) -> FigureError {
    FigureError::Drawing(error.to_string())
}
