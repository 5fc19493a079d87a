//! A plain search for the first velocity at which a landing is no longer stable.

use std::sync::Arc;

use super::side_by_side;
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// Step of the scan over V_H, ft/s.
pub const SCAN_STEP: f64 = 0.25;
/// Greatest V_H of the scan in steps: 25 ft/s.
pub const SCAN_STEPS: usize = 100;
/// Width to which a transition is narrowed, ft/s.
const BRACKET: f64 = 1e-4;

/// First transition: class beyond it and velocity, ft/s.
pub type Transition = Option<(Class, f64)>;

/// A vehicle in a scene, landed at one horizontal velocity after another.
pub struct Search<'a> {
    /// The vehicle.
    pub vehicle: &'a Vehicle,
    /// The scene but for its V_H.
    pub scene: Scene,
    /// How landings are computed.
    pub settings: Settings,
}

impl Search<'_> {
    /// Class of the landing at this V_H, ft/s.
    fn class(&self, velocity: f64) -> Class {
        let scene = self.scene.with_horizontal_velocity(velocity).unwrap();
        land(self.vehicle, &scene, &self.settings).outcome.class()
    }

    /// Class at step `k` of the scan.
    pub fn class_at_step(&self, k: usize) -> Class {
        self.class(SCAN_STEP * k as f64)
    }

    /// The class at every step of the scan, landed side by side.
    pub fn scan(&self) -> Vec<Class> {
        let vehicle = Arc::new(self.vehicle.clone());
        let requests = (0..=SCAN_STEPS).map(|k| Request {
            key: k,
            vehicle: Arc::clone(&vehicle),
            scene: (self.scene)
                .with_horizontal_velocity(SCAN_STEP * k as f64)
                .unwrap(),
            settings: self.settings,
        });
        let landings = side_by_side(requests).into_iter();
        landings.map(|landing| landing.outcome.class()).collect()
    }

    /// The first transition of a scan with class `class` at each of its steps.
    pub fn first_transition(&self, class: impl Fn(usize) -> Class) -> Transition {
        let (step, mut kind) = (0..=SCAN_STEPS)
            .map(|k| (k, class(k)))
            .find(|(_, class)| *class != Class::Stable)?;
        assert_ne!(step, 0, "stable at rest");
        let (mut low, mut high) = (SCAN_STEP * (step - 1) as f64, SCAN_STEP * step as f64);
        while high - low > BRACKET {
            let middle = 0.5 * (low + high);
            match self.class(middle) {
                Class::Stable => low = middle,
                other => (high, kind) = (middle, other),
            }
        }
        Some((kind, 0.5 * (low + high)))
    }
}
