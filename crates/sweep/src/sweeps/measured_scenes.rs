//! The touchdowns by which run time and error are measured: level, on a slope of 15 deg, 14 ft/s
//! down.

use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::scene::{Conditions, Scene};

/// A level touchdown at cross-slope and roll (deg) and horizontal velocity (ft/s).
fn level(cross_slope: f64, roll: f64, horizontal_velocity: f64) -> Result<Scene, Invalid> {
    Scene::new(Conditions {
        vertical_velocity: 14.0,
        horizontal_velocity,
        cross_slope: cross_slope.to_radians(),
        attitude: Attitude::from_euler(Euler {
            pitch: 0.0,
            yaw: 0.0,
            roll: roll.to_radians(),
        }),
        angular_velocity: [0.0; 3],
        slope: 15f64.to_radians(),
        pad_friction: 1.0,
        block_friction: 1.0,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    })
}

/// Forty landings (ten when quick) around the toppling boundary: cross-slopes 180 to 160 deg,
/// rolls -20 to 10 deg, 10.9 to 11.9 ft/s.
///
/// # Errors
/// Never: all conditions lie in their ranges.
pub fn near_boundary(quick: bool) -> Result<Vec<Scene>, Invalid> {
    (0..40)
        .step_by(if quick { 4 } else { 1 })
        .map(|k| {
            let (cross_slope, roll) = (
                180.0 - 5.0 * f64::from(k % 5),
                -20.0 + 10.0 * f64::from(k / 5 % 4),
            );
            level(cross_slope, roll, 10.9 + 0.025 * f64::from(k))
        })
        .collect()
}

/// The level grid of 143 points, at rest sideways: cross-slopes 80 to 180 deg and rolls -60 to 60
/// deg by 10 deg; when quick, five of them.
///
/// # Errors
/// Never: all conditions lie in their ranges.
pub fn level_grid(quick: bool) -> Result<Vec<Scene>, Invalid> {
    const QUICK: [(i32, i32); 5] = [(18, 0), (18, -2), (17, -1), (16, 1), (13, -2)];
    let points = (8..=18).flat_map(|cross| (-6..=6).map(move |roll| (cross, roll)));
    points
        .filter(|point| !quick || QUICK.contains(point))
        .map(|(cross, roll)| level(10.0 * f64::from(cross), 10.0 * f64::from(roll), 0.0))
        .collect()
}
