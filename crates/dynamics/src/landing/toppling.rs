//! Toppling under physical rules: the CG stays beyond the hull of the feet.

use super::rest::{WHILE, free_fall};
use crate::scene::Scene;
use crate::state::Body;
use crate::vehicle::Vehicle;

/// Cosine of the tilt beyond which a vehicle no longer stands: 60 deg.
const FALLEN: f64 = 0.5;

/// Returns whether a vehicle is inclined so far that no foot will catch it.
pub(super) fn has_fallen(body: &Body<f64>) -> bool {
    body.tilt_cosine() < FALLEN
}

/// How long the CG of a vehicle has been beyond the hull of its feet.
///
/// It may come back: feet still move out, or a strut pushes. In flight it is not yet decided: a foot may catch it. So only the time
/// counts in which the ground pushes on a foot or a block, the body reaches into the ground, or the vehicle has fallen.
pub(super) struct Toppling {
    /// Time after which the vehicle has toppled, s.
    limit: f64,
    /// Time so far that counts, s, while the CG is beyond.
    beyond: Option<f64>,
}

impl Toppling {
    /// Before the touchdown of a vehicle in a scene.
    pub(super) fn new(vehicle: &Vehicle, scene: &Scene) -> Self {
        Self {
            limit: WHILE * free_fall(vehicle.standing_height(), scene.gravity(vehicle)),
            beyond: None,
        }
    }

    /// Notes whether the CG is beyond the hull now, `passed` (s) after it was last noted, and whether that time counts if it
    /// has been. Returns whether the vehicle has toppled.
    #[inline(always)]
    pub(super) fn note(
        &mut self,
        is_beyond: bool,
        passed: f64,
        counts: impl FnOnce() -> bool,
    ) -> bool {
        self.beyond = match self.beyond {
            _ if !is_beyond => None,
            None => Some(0.0),
            Some(before) if counts() => Some(before + passed),
            Some(before) => Some(before),
        };
        self.beyond.is_some_and(|time| time >= self.limit)
    }

    /// Returns whether the CG is beyond the hull.
    pub(super) fn is_beyond(&self) -> bool {
        self.beyond.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_one_second() -> Toppling {
        Toppling {
            limit: 1.0,
            beyond: None,
        }
    }

    #[test]
    fn a_vehicle_topples_over_the_ground_and_not_in_flight() {
        let mut toppling = of_one_second();
        assert!(
            !toppling.note(true, 5.0, || true),
            "it has just gone beyond"
        );
        assert!(!toppling.note(true, 0.6, || true));
        assert!(!toppling.note(true, 9.0, || false), "flight does not count");
        assert!(toppling.is_beyond());
        assert!(toppling.note(true, 0.6, || true));
    }

    #[test]
    fn a_vehicle_that_comes_back_starts_anew() {
        let mut toppling = of_one_second();
        toppling.note(true, 0.0, || true);
        toppling.note(true, 0.9, || true);
        assert!(!toppling.note(false, 0.2, || true));
        assert!(!toppling.is_beyond());
        assert!(!toppling.note(true, 0.9, || true));
        assert!(!toppling.note(true, 0.9, || true));
    }
}
