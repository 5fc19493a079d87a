//! Drawing data of a landing: the ground, the vehicle, and all positions at every instant.
//!
//! Ground axes X (across the slope), Y (horizontal, uphill) and Z (down), from the surface point below the CG at first
//! contact; ft and lb.

mod ground;
mod motion;
mod shape;

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::motion::Motion;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::vehicle::Vehicle;

use ground::Ground;
use motion::Instants;
use shape::Shape;

/// A vector, rounded.
type Triple = [f64; 3];

/// Drawing data of a landing.
#[derive(Debug, Serialize)]
pub struct Drawing {
    ground: Ground,
    vehicle: Shape,
    instants: Instants,
}

impl Drawing {
    /// Collects the data of a landing under these rules.
    pub fn of(vehicle: &Vehicle, scene: &Scene, rules: Rules, instants: &[Instant]) -> Self {
        let motion = Motion::new(vehicle, scene);
        Self {
            ground: Ground::of(vehicle, scene, &motion),
            vehicle: Shape::of(vehicle, &motion),
            instants: Instants::of(vehicle, scene, rules, &motion, instants),
        }
    }
}

/// Rounds a number to the digits a drawing needs.
fn rounded(number: f64) -> f64 {
    const STEPS: f64 = 1e6;
    // Adding zero removes the sign of a negative zero.
    (number * STEPS).round() / STEPS + 0.0
}

fn triple(vector: &Vector3<f64>) -> Triple {
    [vector.x, vector.y, vector.z].map(rounded)
}
