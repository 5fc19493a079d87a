//! A plain search for the first velocity at which a landing is no longer stable.

use std::sync::Arc;

use super::side_by_side;
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// Step of the scan over V_H, ft/s.
pub const SCAN_STEP: f64 = 0.25;
/// Greatest V_H of the scan in steps: 25 ft/s.
pub const SCAN_STEPS: usize = 100;
/// Steps of a scan that are landed before it is looked at.
const ABREAST: usize = 16;
/// How often a step is halved to narrow down a transition: to less than 1e-4 ft/s.
const HALVINGS: usize = 12;

/// First transition: class beyond it and velocity, ft/s.
pub type Transition = Option<(Class, f64)>;

/// A vehicle in a scene, landed at one horizontal velocity after another.
pub struct Search {
    /// The vehicle.
    pub vehicle: Arc<Vehicle>,
    /// The scene but for its V_H.
    pub scene: Scene,
    /// How landings are computed.
    pub settings: Settings,
}

impl Search {
    /// The landing at this V_H, ft/s.
    fn request(&self, key: usize, velocity: f64) -> Request {
        Request {
            key,
            vehicle: Arc::clone(&self.vehicle),
            scene: self.scene.with_horizontal_velocity(velocity).unwrap(),
            settings: self.settings,
        }
    }

    /// The same at another tolerance.
    pub fn at(&self, tolerance: f64) -> Self {
        Self {
            vehicle: Arc::clone(&self.vehicle),
            scene: self.scene,
            settings: self.settings.with_tolerance(tolerance).unwrap(),
        }
    }

    /// The classes up to the first that is not stable, and some more.
    pub fn scan_to_first(&self) -> Vec<Class> {
        let mut scan = Vec::new();
        while scan.len() <= SCAN_STEPS && scan.iter().all(|class| *class == Class::Stable) {
            let next = scan.len()..=SCAN_STEPS;
            scan.extend(self.scan(next.take(ABREAST)));
        }
        scan
    }

    /// The classes at these steps of the scan, landed side by side.
    pub fn scan(&self, steps: impl Iterator<Item = usize>) -> Vec<Class> {
        let requests = steps
            .enumerate()
            .map(|(key, step)| self.request(key, SCAN_STEP * step as f64));
        classes(requests)
    }
}

fn classes(requests: impl Iterator<Item = Request>) -> Vec<Class> {
    let landings = side_by_side(requests).into_iter();
    landings.map(|landing| landing.outcome.class()).collect()
}

/// The classes of each search at all steps of the scan, at another tolerance. All are landed side by side.
pub fn scans_at(searches: &[Search], tolerance: f64) -> Vec<Vec<Class>> {
    let searches: Vec<Search> = searches.iter().map(|search| search.at(tolerance)).collect();
    let steps = searches
        .iter()
        .flat_map(|search| (0..=SCAN_STEPS).map(move |step| (search, step)));
    let requests = steps.enumerate();
    let found =
        classes(requests.map(|(key, (search, step))| search.request(key, SCAN_STEP * step as f64)));
    found
        .chunks(SCAN_STEPS + 1)
        .map(<[Class]>::to_vec)
        .collect()
}

/// A stable landing and one that is not, at these V_H, ft/s.
struct Bracket {
    class: Class,
    low: f64,
    high: f64,
}

impl Bracket {
    /// At the first class of a scan from V_H = 0 on that is not stable.
    fn of_scan(scan: &[Class]) -> Option<Self> {
        let step = scan.iter().position(|class| *class != Class::Stable)?;
        assert_ne!(step, 0, "stable at rest");
        Some(Self {
            class: scan[step],
            low: SCAN_STEP * (step - 1) as f64,
            high: SCAN_STEP * step as f64,
        })
    }

    fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// The first transition of each search, by a scan that goes at least up to it. All are narrowed down side by side.
pub fn first_transitions(searches: &[Search], scans: &[Vec<Class>]) -> Vec<Transition> {
    let brackets = scans.iter().map(|scan| Bracket::of_scan(scan));
    let mut brackets: Vec<Option<Bracket>> = brackets.collect();
    for _ in 0..HALVINGS {
        let mut open: Vec<_> = (searches.iter().zip(&mut brackets))
            .filter_map(|(search, bracket)| Some((search, bracket.as_mut()?)))
            .collect();
        let requests = open.iter().enumerate();
        let found =
            classes(requests.map(|(key, (search, bracket))| search.request(key, bracket.middle())));
        for ((_, bracket), class) in open.iter_mut().zip(found) {
            match class {
                Class::Stable => bracket.low = bracket.middle(),
                other => (bracket.class, bracket.high) = (other, bracket.middle()),
            }
        }
    }
    let transition = |bracket: Bracket| (bracket.class, bracket.middle());
    (brackets.into_iter().map(|bracket| bracket.map(transition))).collect()
}
