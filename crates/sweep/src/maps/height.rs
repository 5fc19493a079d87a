//! What refinement knows of a point: its first transition, and how many bands it has.

use crate::findings::Finding;

/// What a point came to, as far as maps follow it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Height {
    /// First transition, ft/s; `None` where there is none in the range that was searched.
    pub speed: Option<f64>,
    /// Bands, where all were searched.
    pub bands: usize,
}

impl Height {
    /// What a point came to; `None` where no transition was searched.
    pub fn of(finding: &Finding) -> Option<Self> {
        let boundary = finding.boundary()?;
        Some(Self {
            speed: boundary.transition.map(|transition| transition.speed()),
            bands: boundary.bands.len(),
        })
    }

    /// Whether both have a transition, or neither, and as many bands.
    pub fn is_like(self, other: Self) -> bool {
        self.speed.is_some() == other.speed.is_some() && self.bands == other.bands
    }

    /// Difference of the first transitions, ft/s; infinite where the two are not alike.
    pub fn leap(self, other: Self) -> f64 {
        match (self.speed, other.speed) {
            _ if !self.is_like(other) => f64::INFINITY,
            (Some(one), Some(other)) => (one - other).abs(),
            _ => 0.0,
        }
    }
}
