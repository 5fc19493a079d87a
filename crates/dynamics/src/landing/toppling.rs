//! Toppling under physical rules: the CG stays beyond the hull of the feet.

use super::rest::{WHILE, free_fall};
use crate::scene::Scene;
use crate::state::Body;
use crate::vehicle::Vehicle;

/// Cosine of the tilt beyond which no foot catches a vehicle in flight: 90 deg.
const FALLEN: f64 = 0.0;

/// Counts how long the CG of a vehicle has been beyond the hull of its feet.
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

    /// Notes whether the CG is beyond the hull now, `passed` (s) after it was last noted. If it has been, that time counts where
    /// the lowest hardpoint has no `clearance` (ft), where the ground pushes, or where the `body` has fallen. Returns whether the
    /// vehicle has toppled.
    #[inline(always)]
    pub(super) fn note(
        &mut self,
        is_beyond: bool,
        passed: f64,
        clearance: f64,
        body: impl FnOnce() -> Body<f64>,
        is_pushed: impl FnOnce() -> bool,
    ) -> bool {
        let counts = || clearance < 0.0 || is_pushed() || body().tilt_cosine() < FALLEN;
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
    use nalgebra::{Vector3, Vector4};

    fn of_one_second() -> Toppling {
        Toppling {
            limit: 1.0,
            beyond: None,
        }
    }

    /// Notes an upright vehicle over the ground that is or isn't pushed by it.
    fn note(toppling: &mut Toppling, is_beyond: bool, passed: f64, is_pushed: bool) -> bool {
        toppling.note(is_beyond, passed, 1.0, || inclined(0.0), || is_pushed)
    }

    fn inclined(tilt: f64) -> Body<f64> {
        Body {
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
            quaternion: Vector4::new((0.5 * tilt).cos(), (0.5 * tilt).sin(), 0.0, 0.0),
            rate: Vector3::zeros(),
        }
    }

    /// In flight the time counts of a vehicle that has fallen, or reaches into the ground.
    #[test]
    fn what_no_foot_will_catch_topples_in_flight() {
        for (clearance, tilt, topples) in [(1.0, 89.0, false), (1.0, 91.0, true), (-0.1, 0.0, true)]
        {
            let mut toppling = of_one_second();
            let body = || inclined(f64::to_radians(tilt));
            toppling.note(true, 0.0, clearance, body, || false);
            let found = toppling.note(true, 1.0, clearance, body, || false);
            assert_eq!(found, topples, "{clearance} ft, {tilt} deg");
        }
    }

    #[test]
    fn a_vehicle_topples_over_the_ground_and_not_in_flight() {
        let mut toppling = of_one_second();
        assert!(
            !note(&mut toppling, true, 5.0, true),
            "it has just gone beyond"
        );
        assert!(!note(&mut toppling, true, 0.6, true));
        assert!(
            !note(&mut toppling, true, 9.0, false),
            "flight does not count"
        );
        assert!(toppling.is_beyond());
        assert!(note(&mut toppling, true, 0.6, true));
    }

    #[test]
    fn a_vehicle_that_comes_back_starts_anew() {
        let mut toppling = of_one_second();
        note(&mut toppling, true, 0.0, true);
        note(&mut toppling, true, 0.9, true);
        assert!(!note(&mut toppling, false, 0.2, true));
        assert!(!toppling.is_beyond());
        assert!(!note(&mut toppling, true, 0.9, true));
        assert!(!note(&mut toppling, true, 0.9, true));
    }
}
