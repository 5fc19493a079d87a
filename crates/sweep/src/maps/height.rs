//! First transition and number of bands of a point, as used by refinement.

use crate::summary::findings::Finding;

/// Result of a point as used by maps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Height {
    /// First transition, ft/s; `None` if there is none in the range searched.
    pub speed: Option<f64>,
    /// Number of bands, if all were searched.
    pub bands: usize,
}

impl Height {
    /// Height of a finding; `None` if it is not of a boundary search.
    pub fn of(finding: &Finding) -> Option<Self> {
        let boundary = finding.boundary()?;
        Some(Self {
            speed: boundary.transition.map(|transition| transition.speed()),
            bands: boundary.bands.len(),
        })
    }

    /// True if both or neither have a transition, and the numbers of bands agree.
    pub fn is_like(self, other: Self) -> bool {
        self.speed.is_some() == other.speed.is_some() && self.bands == other.bands
    }

    /// Difference of the first transitions, ft/s; infinite if the heights are not alike.
    pub fn leap(self, other: Self) -> f64 {
        match (self.speed, other.speed) {
            _ if !self.is_like(other) => f64::INFINITY,
            (Some(one), Some(other)) => (one - other).abs(),
            _ => 0.0,
        }
    }
}
