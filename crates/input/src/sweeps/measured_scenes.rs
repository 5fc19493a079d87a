//! Touchdowns for measuring run time and error: level, on a slope of 15 deg, at a vertical velocity of 14 ft/s.

use touchdown_dynamics::scene::Scene;

use crate::readers::scene_input::{HORIZONTAL_VELOCITY, NamedConditions, SceneFault};

/// A level touchdown at cross-slope and roll (deg) and horizontal velocity (ft/s).
fn level(cross_slope: f64, roll: f64, horizontal_velocity: f64) -> Result<Scene, SceneFault> {
    let conditions = [
        ("vertical_velocity_fps", 14.0),
        (HORIZONTAL_VELOCITY, horizontal_velocity),
        ("cross_slope_deg", cross_slope),
        ("roll_deg", roll),
        ("slope_deg", 15.0),
        ("friction", 1.0),
    ];
    NamedConditions::of(conditions).scene()
}

/// Forty landings (ten when quick) around the toppling boundary: cross-slopes 180 to 160 deg,
/// rolls -20 to 10 deg, 10.9 to 11.9 ft/s.
///
/// # Errors
/// Never: all conditions lie in their ranges.
pub fn near_boundary(quick: bool) -> Result<Vec<Scene>, SceneFault> {
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

/// The level grid of 143 points without horizontal velocity: cross-slopes 80 to 180 deg and rolls -60 to 60 deg, in
/// steps of 10 deg; five of them when quick.
///
/// # Errors
/// Never: all conditions lie in their ranges.
pub fn level_grid(quick: bool) -> Result<Vec<Scene>, SceneFault> {
    const QUICK: [(i32, i32); 5] = [(18, 0), (18, -2), (17, -1), (16, 1), (13, -2)];
    let points = (8..=18).flat_map(|cross| (-6..=6).map(move |roll| (cross, roll)));
    points
        .filter(|point| !quick || QUICK.contains(point))
        .map(|(cross, roll)| level(10.0 * f64::from(cross), 10.0 * f64::from(roll), 0.0))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_differ_and_the_quick_ones_are_among_them() {
        type Scenes = fn(bool) -> Result<Vec<Scene>, SceneFault>;
        for (scenes, all, some) in [(near_boundary as Scenes, 40, 10), (level_grid, 143, 5)] {
            let (whole, quick) = (scenes(false).unwrap(), scenes(true).unwrap());
            assert_eq!((whole.len(), quick.len()), (all, some));
            assert!((1..all).all(|index| !whole[..index].contains(&whole[index])));
            assert!(quick.iter().all(|scene| whole.contains(scene)));
        }
    }
}
