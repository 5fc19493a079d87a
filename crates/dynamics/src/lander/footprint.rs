//! The ground that a vehicle covers as it stands with its struts extended.

use arrayvec::ArrayVec;

use crate::invalid::{Invalid, bounded, require};
use crate::per_leg::MOST_LEGS;

/// The feet at the corners of the polygon of the feet, in ring order.
pub type OuterFeet = ArrayVec<usize, MOST_LEGS>;

/// Keys of the CG's offset from the centreline, along x and y of vehicle axes.
const KEYS: [&str; 2] = [
    "center_of_gravity_offset_x_ft",
    "center_of_gravity_offset_y_ft",
];

/// Checks that a CG off the centreline is over the polygon of the feet, all of them x and y of vehicle axes, ft: beyond
/// it a vehicle falls over where it stands.
///
/// # Errors
/// Names the component to change and its range.
pub(super) fn check_offset(offset: [f64; 2], feet: &[[f64; 2]]) -> Result<(), Invalid> {
    for (key, value) in KEYS.iter().zip(offset) {
        bounded(key, value)?;
    }
    let (greater, lesser) = match offset[0].abs() >= offset[1].abs() {
        true => (0, 1),
        false => (1, 0),
    };
    let across = feet.iter().map(|foot| foot[lesser]);
    within(lesser, offset, ends(across), "")?;
    // Every line between two feet is in the polygon, its edges among them.
    let crossings = feet.iter().flat_map(|a| {
        let crossing = |b: &[f64; 2]| {
            let part = (offset[lesser] - a[lesser]) / (b[lesser] - a[lesser]);
            (0.0..=1.0)
                .contains(&part)
                .then(|| a[greater] + part * (b[greater] - a[greater]))
        };
        feet.iter().filter_map(crossing).collect::<Vec<_>>()
    });
    let at = format!(" at {} = {}", KEYS[lesser], offset[lesser]);
    within(greater, offset, ends(crossings), &at)
}

/// The outer ones of all feet, which come in ring order: x and y of vehicle axes and depth below the lower hardpoints, ft.
///
/// A foot is not where it stands within the polygon of the others, or so high over it that a vehicle that topples over its
/// neighbours has its CG, likewise x, y and depth, beyond them before the foot comes down: on a leg too short to touch.
pub(super) fn outer_feet(feet: &[[f64; 3]], center_of_gravity: [f64; 3]) -> OuterFeet {
    let mut ring: OuterFeet = (0..feet.len()).collect();
    let needless = |ring: &[usize]| {
        (0..ring.len()).find(|&place| {
            let at = |step: usize| feet[ring[(place + step) % ring.len()]];
            let (before, foot, after) = (at(ring.len() - 1), at(0), at(1));
            let [foot, center] =
                [foot, center_of_gravity].map(|point| beyond(before, after, point));
            let inward = -center[0];
            foot[0] <= 0.0 || inward > 0.0 && foot[1] * center[1] >= foot[0] * inward
        })
    };
    while ring.len() > 3
        && let Some(place) = needless(&ring)
    {
        ring.remove(place);
    }
    ring
}

/// How far a point is outward of and above the line between two feet, ft.
fn beyond([x0, y0, z0]: [f64; 3], [x1, y1, z1]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 2] {
    let [along_x, along_y] = [x1 - x0, y1 - y0];
    let squared = along_x * along_x + along_y * along_y;
    let share = ((x - x0) * along_x + (y - y0) * along_y) / squared;
    let outward = (along_x * (y - y0) - along_y * (x - x0)) / squared.sqrt();
    [outward, z0 + share * (z1 - z0) - z]
}

/// Least and greatest.
fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    )
}

fn within(
    component: usize,
    offset: [f64; 2],
    [least, most]: [f64; 2],
    at: &str,
) -> Result<(), Invalid> {
    let allowed = format!(
        "{least:.4} < value < {most:.4}, which keeps the CG over the polygon of the feet{at}"
    );
    require(KEYS[component], offset[component], &allowed, |value| {
        least < value && value < most
    })
    .map(|_| ())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Outer ones of feet with these reaches and depths, under a CG that is 2 ft over the lower hardpoints.
    fn outer(reaches: &[f64], depths: &[f64]) -> Vec<usize> {
        let legs = reaches.len() as f64;
        let feet: Vec<[f64; 3]> = (reaches.iter().zip(depths).enumerate())
            .map(|(leg, (reach, depth))| {
                let azimuth = std::f64::consts::TAU * leg as f64 / legs;
                [reach * azimuth.sin(), reach * azimuth.cos(), *depth]
            })
            .collect();
        outer_feet(&feet, [0.0, 0.0, -2.0]).to_vec()
    }

    #[test]
    fn feet_within_the_polygon_are_not_outer() {
        let level = [3.0; 6];
        assert_eq!(outer(&[1.0; 6], &level), [0, 1, 2, 3, 4, 5]);
        // The line between its neighbours passes at half their reach.
        assert_eq!(
            outer(&[4.0, 1.9, 4.0, 4.0, 4.0, 4.0], &level),
            [0, 2, 3, 4, 5]
        );
        assert_eq!(
            outer(&[4.0, 2.1, 4.0, 4.0, 4.0, 4.0], &level),
            [0, 1, 2, 3, 4, 5]
        );
        assert_eq!(outer(&[4.0, 1.0, 4.0, 1.0, 4.0, 1.0], &level), [0, 2, 4]);
        assert_eq!(outer(&[4.0, 0.5, 2.0], &level), [0, 1, 2]);
    }

    #[test]
    fn feet_that_come_down_too_late_are_not_outer() {
        // The line between the neighbours is 2 ft ahead of the CG and 5 ft below it. The foot, 1 ft further ahead, comes down
        // in time when it is no more than 0.4 ft higher.
        let reaches = [4.0, 3.0, 4.0, 4.0, 4.0, 4.0];
        let raised = |by: f64| outer(&reaches, &[3.0, 3.0 - by, 3.0, 3.0, 3.0, 3.0]);
        assert_eq!(raised(0.39), [0, 1, 2, 3, 4, 5]);
        assert_eq!(raised(0.41), [0, 2, 3, 4, 5]);
    }
}
