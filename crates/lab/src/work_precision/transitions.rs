//! Error of the transition velocity.

use rayon::prelude::*;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use super::landings::median_and_worst;
use super::settings;
use touchdown::terminal::Failure;

/// Scan for first transitions, ft/s, and its tolerance.
const HIGHEST: f64 = 25.0;
const STEP: f64 = 0.25;
const SCAN_TOLERANCE: f64 = 1e-6;
/// Tolerance of the converged transitions.
const CONVERGED: f64 = 1e-9;
/// Width to which transitions are narrowed, ft/s.
const WIDTH: f64 = 1e-6;

/// First transitions with their converged velocities.
pub struct Transitions<'v> {
    vehicle: &'v Vehicle,
    /// Scene but for V_H, and V_H, ft/s.
    converged: Vec<(Scene, f64)>,
}

impl<'v> Transitions<'v> {
    /// Searches the first transition of every scene that has one up to 25 ft/s.
    pub fn converged(vehicle: &'v Vehicle, scenes: Vec<Scene>) -> Result<Self, Failure> {
        let converged: Vec<Option<(Scene, f64)>> = scenes
            .into_par_iter()
            .map(|scene| {
                let scan = Landings::new(vehicle, scene, SCAN_TOLERANCE)?;
                let mut speed = 0.0;
                while scan.is_stable(speed)? {
                    speed += STEP;
                    if speed > HIGHEST {
                        return Ok(None);
                    }
                }
                let near = scan.halve(speed - STEP, speed)?;
                let transition = Landings::new(vehicle, scene, CONVERGED)?.transition(near)?;
                Ok(transition.map(|speed| (scene, speed)))
            })
            .collect::<Result<_, Failure>>()?;
        Ok(Self {
            vehicle,
            converged: converged.into_iter().flatten().collect(),
        })
    }

    /// Number of transitions, and the error of their velocity, median and worst, ft/s. Where there
    /// is no transition within a scan step any more, the error is that step.
    pub fn measure(&self, tolerance: f64) -> Result<(usize, [f64; 2]), Failure> {
        let errors: Vec<f64> = self
            .converged
            .par_iter()
            .map(|&(scene, speed)| {
                let transition =
                    Landings::new(self.vehicle, scene, tolerance)?.transition(speed)?;
                Ok(transition.map_or(STEP, |transition| (transition - speed).abs()))
            })
            .collect::<Result<_, Failure>>()?;
        Ok((errors.len(), median_and_worst(errors)))
    }
}

/// Landings that differ in V_H.
struct Landings<'v> {
    vehicle: &'v Vehicle,
    scene: Scene,
    settings: Settings,
}

impl<'v> Landings<'v> {
    fn new(vehicle: &'v Vehicle, scene: Scene, tolerance: f64) -> Result<Self, Failure> {
        Ok(Self {
            vehicle,
            scene,
            settings: settings(tolerance)?,
        })
    }

    fn is_stable(&self, speed: f64) -> Result<bool, Failure> {
        let scene = self.scene.with_horizontal_velocity(speed);
        let landing = land(
            self.vehicle,
            &scene.map_err(Failure::running)?,
            &self.settings,
        );
        Ok(landing.outcome.class() == Class::Stable)
    }

    /// The transition nearest to a speed, sought in brackets that widen fourfold.
    fn transition(&self, near: f64) -> Result<Option<f64>, Failure> {
        let mut reach = 2.0 * WIDTH;
        while reach < STEP {
            let (low, high) = (near - reach, near + reach);
            if self.is_stable(low)? && !self.is_stable(high)? {
                return Ok(Some(self.halve(low, high)?));
            }
            reach *= 4.0;
        }
        Ok(None)
    }

    /// The transition between a stable speed and one that is not.
    fn halve(&self, mut low: f64, mut high: f64) -> Result<f64, Failure> {
        while high - low > WIDTH {
            let middle = 0.5 * (low + high);
            if self.is_stable(middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(0.5 * (low + high))
    }
}
