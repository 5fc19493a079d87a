//! A landing computed a little differently: for a scan, or for a test.

use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::quantities::TOLERANCE;
use touchdown_dynamics::scene::{Conditions, Scene, Settings, Stop};

/// A change in how a landing is computed, for a scan or a test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Variation {
    /// None.
    Unchanged,
    /// A factor on the solver's tolerance.
    Tolerance(f64),
    /// A factor on the solver's tolerance, for a scan: steady landings end early.
    Scan(f64),
    /// A solver tolerance, and a turn about the x axis of the ground, deg.
    At {
        /// The tolerance.
        tolerance: f64,
        /// The turn, deg.
        tilt: f64,
    },
}

impl Variation {
    /// Applies the variation to a scene and settings. The landing ends at its verdict.
    ///
    /// # Errors
    /// If the changed scene or settings are invalid.
    pub fn of(self, scene: &Scene, settings: &Settings) -> Result<(Scene, Settings), Invalid> {
        let conditions = *scene.conditions();
        let mut settings = settings.stopping_at(Stop::Verdict);
        let mut tilt = 0.0;
        match self {
            Self::Unchanged => {}
            Self::Tolerance(factor) => settings = at_tolerance(settings, factor)?,
            Self::Scan(factor) => settings = at_tolerance(settings, factor)?.ending_early(),
            Self::At {
                tolerance,
                tilt: degrees,
            } => {
                settings = settings.with_tolerance(tolerance)?;
                tilt = degrees;
            }
        }
        let scene = match tilt == 0.0 {
            true => *scene,
            false => Scene::new(tilted(conditions, tilt))?,
        };
        Ok((scene, settings))
    }
}

/// Turns the conditions about the x axis of the ground, deg.
fn tilted(conditions: Conditions, degrees: f64) -> Conditions {
    let tilt = Attitude::from_euler(Euler {
        pitch: degrees.to_radians(),
        yaw: 0.0,
        roll: 0.0,
    });
    Conditions {
        attitude: tilt.after(&conditions.attitude),
        ..conditions
    }
}

/// Settings with their tolerance multiplied by a factor.
fn at_tolerance(settings: Settings, factor: f64) -> Result<Settings, Invalid> {
    let tolerance = settings.tolerance() * factor;
    settings.with_tolerance(tolerance.clamp(TOLERANCE.range.lower, TOLERANCE.range.upper))
}
