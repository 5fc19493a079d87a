//! Heights of a map at a point, which refinement compares: over two axes its first transition and number of bands, over one all
//! its bands over V_H.

use touchdown_dynamics::outcome::Class;
use touchdown_search::boundary::Boundary;

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

/// The bands of a point, lowest first: all that were searched, or the lowest two if only the first transition was.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SpeedBands {
    classes: Vec<Class>,
    /// Transitions between them, ft/s.
    transitions: Vec<f64>,
}

impl SpeedBands {
    /// Bands found by a search.
    pub(crate) fn of(boundary: &Boundary) -> Self {
        if let [below @ .., _] = boundary.bands.as_slice() {
            return Self {
                classes: boundary.bands.iter().map(|band| band.class).collect(),
                transitions: below.iter().map(|band| band.to).collect(),
            };
        }
        match &boundary.transition {
            None => Self::new(&[Class::Stable], &[]),
            Some(found) if found.low.is_none() => Self::new(&[found.to], &[]),
            Some(found) => Self::new(&[Class::Stable, found.to], &[found.speed()]),
        }
    }

    /// Bands of these classes, between these transitions (ft/s).
    pub(crate) fn new(classes: &[Class], transitions: &[f64]) -> Self {
        Self {
            classes: classes.to_vec(),
            transitions: transitions.to_vec(),
        }
    }

    /// True if there is no transition.
    pub(crate) fn are_one(&self) -> bool {
        self.transitions.is_empty()
    }

    /// Greatest difference of a transition, ft/s; infinite if the sequences of classes differ.
    pub(crate) fn leap(&self, other: &Self) -> f64 {
        if self.classes != other.classes {
            return f64::INFINITY;
        }
        greatest(
            self.transitions
                .iter()
                .zip(&other.transitions)
                .map(|(one, other)| one - other),
        )
    }

    /// Greatest distance of a transition from the mean of those of two others, ft/s; infinite if the sequences of
    /// classes differ.
    pub(crate) fn off_halfway(&self, low: &Self, high: &Self) -> f64 {
        if self.classes != low.classes || self.classes != high.classes {
            return f64::INFINITY;
        }
        let ends = low.transitions.iter().zip(&high.transitions);
        let halfway = ends.map(|(low, high)| 0.5 * (low + high));
        greatest(
            self.transitions
                .iter()
                .zip(halfway)
                .map(|(here, halfway)| here - halfway),
        )
    }
}

fn greatest(differences: impl Iterator<Item = f64>) -> f64 {
    differences.fold(0.0, |most, difference| difference.abs().max(most))
}
