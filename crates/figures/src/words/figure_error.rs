//! Why there is no picture.

use std::fmt;

/// A picture that could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FigureError {
    /// The result table is not what the picture needs.
    Table(String),
    /// The result table is in order, but there is no picture of it.
    NoPicture(String),
    /// The PNG cannot be made.
    Rendering(String),
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table(complaint) => write!(f, "result table: {complaint}"),
            Self::NoPicture(reason) => write!(f, "has no picture: {reason}"),
            Self::Rendering(complaint) => write!(f, "PNG: {complaint}"),
        }
    }
}

impl std::error::Error for FigureError {}
