//! The ground covered by a vehicle that stands with its struts extended: legs around the centreline, and the CG over the
//! polygon of the feet.

use std::f64::consts::TAU;

use arrayvec::ArrayVec;

use crate::invalid::{Invalid, require};
use crate::per_leg::MOST_LEGS;
use crate::quantities::OFFSET;
use crate::quantity::check;

/// Keys of the CG's offset from the centreline, along x and y of vehicle axes.
const KEYS: [&str; 2] = [OFFSET[0].quantity.key, OFFSET[1].quantity.key];

/// Least and greatest angle between neighbouring legs, deg.
const LEAST_GAP: f64 = 1.0;
const GREATEST_GAP: f64 = 180.0 - 1e-6;

/// Indices of the legs in the order of their azimuths, 0 to 360 deg.
pub type Ring = ArrayVec<usize, MOST_LEGS>;

/// A leg of any kind as the checks of a vehicle see it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stand {
    /// Azimuth about the centreline, rad.
    pub(super) azimuth: f64,
    /// Pivot of the footpad at rest: x and y of vehicle axes from the centreline, ft.
    pub(super) foot: [f64; 2],
    /// Height of the plane of the lower hardpoints over level ground, ft.
    pub(super) stance: f64,
}

/// The legs by azimuth. They have to surround the centreline: with half a turn or more between two neighbours a vehicle
/// falls over where it stands.
pub(super) fn ring_of(legs: &[Stand]) -> Result<Ring, Invalid> {
    let turn = |leg: usize| legs[leg].azimuth.rem_euclid(TAU);
    let mut ring: Ring = (0..legs.len()).collect();
    ring.sort_by(|&a, &b| turn(a).total_cmp(&turn(b)));
    for (&leg, &next) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        let gap = (turn(next) - turn(leg)).rem_euclid(TAU).to_degrees();
        let [here, azimuth] = [leg, next].map(|leg| legs[leg].azimuth.to_degrees());
        let allowed = if gap < LEAST_GAP {
            format!("{LEAST_GAP} deg or more from another leg, that at {here:.4} deg")
        } else if gap > GREATEST_GAP {
            format!(
                "less than 180 deg from the leg before it, that at {here:.4} deg: legs surround the centreline"
            )
        } else {
            continue;
        };
        let quantity = format!("legs[{}].azimuth_deg", next + 1);
        return Err(Invalid::new(quantity, azimuth, allowed));
    }
    Ok(ring)
}

/// Checks that a CG off the centreline is over the polygon of the feet (x and y of vehicle axes, ft). Beyond it a
/// vehicle falls over where it stands.
///
/// # Errors
/// Names the component to change and its range.
pub(super) fn check_offset(offset: [f64; 2], feet: &[[f64; 2]]) -> Result<(), Invalid> {
    check("", &OFFSET, &offset)?;
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
