//! The touchdowns that the report and the reference follow through time.

use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::landing::{Instant, Landing, land_observed};
use touchdown_dynamics::scene::{Conditions, Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use super::{level, level_scene};

/// The sample run of 3.4.5: pitch 5 deg, friction 0.8, straight downhill.
pub fn sample_run() -> Scene {
    Scene::new(Conditions {
        vertical_velocity: 14.24567,
        attitude: Attitude::from_euler(Euler {
            pitch: 5f64.to_radians(),
            yaw: 0.0,
            roll: 0.0,
        }),
        pad_friction: 0.8,
        block_friction: 0.8,
        ..level(180.0, 0.0, 9.27685)
    })
    .unwrap()
}

/// The case of Table 4-3: V_H 12 ft/s at cross-slope 170 deg, roll −10 deg.
pub fn table_4_3() -> Scene {
    level_scene(170.0, -10.0, 12.0)
}

/// A landing with its history every `interval` seconds.
pub fn history<const LEGS: usize>(
    vehicle: &Vehicle<LEGS>,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
) -> (Landing<LEGS>, Vec<Instant<LEGS>>) {
    let mut instants = Vec::new();
    let landing = land_observed(vehicle, scene, settings, interval, |instant| {
        instants.push(instant.clone());
    });
    (landing, instants)
}
