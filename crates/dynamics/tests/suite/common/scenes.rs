//! The touchdowns that the report and the reference follow through time.

use nalgebra::Vector3;
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::scene::{Conditions, Scene, Settings};
use touchdown_dynamics::state::State;
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
pub fn history(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
) -> (Landing, Vec<Instant>) {
    let mut instants = Vec::new();
    let landing = land_observed(
        vehicle,
        scene,
        settings,
        interval,
        &mut |instant: &Instant| {
            instants.push(instant.clone());
        },
    );
    (landing, instants)
}

/// A vehicle just after first contact: all pads pressed in, but not so far that they crush, struts
/// stroking at these link rates (rad/s), the body turning at `rate` (rad/s).
pub fn pressed_in(mut state: State<f64>, link_rates: [f64; 3], rate: Vector3<f64>) -> State<f64> {
    let mut body = state.body();
    // Deeper than the links below raise the pads.
    body.position.z += 0.068;
    body.rate = rate;
    state.set_body(&body);
    for (j, link_rate) in link_rates.into_iter().enumerate() {
        let mut leg = state.leg(j);
        leg.link_angle -= 0.02;
        leg.link_rate = link_rate;
        state.set_leg(j, &leg);
    }
    state
}
