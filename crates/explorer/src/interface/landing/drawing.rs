//! Drawing data of a landing: the ground, the vehicle, and all positions at every instant.
//!
//! Ground axes X (across the slope), Y (horizontal, uphill) and Z (down), from the surface point below the CG at first
//! contact; ft and lb.

mod ground;
mod hinged;
mod motion;
mod shape;
mod three_struts;

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::vehicle::{Legs, Vehicle};

use ground::{Ground, Patch};
use hinged::HingedLegs;
use motion::{Instants, LegPlace};
use shape::{LegShape, Shape};
use three_struts::ThreeStrutLegs;

/// A vector, rounded.
type Triple = [f64; 3];

/// Drawing data of a landing.
#[derive(Debug, Serialize)]
pub struct Drawing {
    ground: Ground,
    vehicle: Shape,
    instants: Instants,
}

/// What is drawn of the legs of a vehicle, which are all of one kind.
trait LegKind {
    /// Shapes of the legs around the point `center` of the centreline (vehicle axes from the CG).
    fn shapes(&self, center: &Vector3<f64>) -> Vec<LegShape>;
    /// The ground under them.
    fn patches(&self) -> Vec<Patch>;
    /// The two critical feet at an instant, if there are any.
    fn critical_feet(&mut self, instant: &Instant) -> Option<[usize; 2]>;
    /// The legs at an instant.
    fn places(&self, instant: &Instant) -> Vec<LegPlace>;
}

impl Drawing {
    /// Collects the data of a landing under these rules.
    pub fn of(vehicle: &Vehicle, scene: &Scene, rules: Rules, instants: &[Instant]) -> Self {
        match vehicle.legs() {
            Legs::Hinged(_) => {
                let legs = HingedLegs::new(vehicle, scene, rules);
                Self::with(vehicle, scene, legs, instants)
            }
            Legs::ThreeStrut(legs) => {
                let legs = ThreeStrutLegs::new(vehicle, legs, scene);
                Self::with(vehicle, scene, legs, instants)
            }
        }
    }

    fn with(
        vehicle: &Vehicle,
        scene: &Scene,
        mut legs: impl LegKind,
        instants: &[Instant],
    ) -> Self {
        Self {
            ground: Ground::of(scene, legs.patches()),
            vehicle: Shape::of(vehicle, &legs),
            instants: Instants::of(vehicle, &mut legs, instants),
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
