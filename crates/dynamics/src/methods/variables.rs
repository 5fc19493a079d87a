//! The variables of the report in its numbering (3.4.4.3): rates and angles of footpads and lower
//! links, velocity and position of the CG, angular velocity, attitude angles, energies.

use std::f64::consts::{PI, TAU};

use crate::attitude::Attitude;
use crate::per_leg::PerLeg;
use crate::state::State;

use crate::method::ErrorLimits;

/// Energies that are summed over the legs: struts, footpads, blocks, sliding of both.
const ENERGIES: usize = 5;

/// Greatest errors per second in the report's numbering; infinite for those without a limit, footpad rates and
/// energies.
pub fn limits(limits: &ErrorLimits, legs: usize) -> Vec<f64> {
    let groups = [
        (f64::INFINITY, legs),
        (limits.pad_angle, legs),
        (limits.link_rate, legs),
        (limits.link_angle, legs),
        (limits.velocity, 3),
        (limits.position, 3),
        (limits.angular_velocity, 3),
        (limits.attitude, 3),
        (f64::INFINITY, ENERGIES),
    ];
    let each = groups.map(|(limit, count)| vec![limit; count]);
    each.concat()
}

/// Names of the variables of a vehicle with this many legs, with units.
pub fn names(legs: usize) -> Vec<String> {
    let of_legs = |name: &str, unit: &str| -> Vec<String> {
        (1..=legs)
            .map(|leg| format!("{name} {leg}, {unit}"))
            .collect()
    };
    let of_axes = |name: &str, unit: &str| -> Vec<String> {
        ["x", "y", "z"]
            .iter()
            .map(|axis| format!("{name} {axis}, {unit}"))
            .collect()
    };
    let angles = ["pitch, rad", "yaw, rad", "roll, rad"].map(str::to_owned);
    let energies = [
        "strut energy, ft lb",
        "footpad energy, ft lb",
        "block energy, ft lb",
        "footpad sliding, ft lb",
        "block sliding, ft lb",
    ];
    [
        of_legs("footpad rate", "rad/s"),
        of_legs("footpad angle", "rad"),
        of_legs("link rate", "rad/s"),
        of_legs("link angle", "rad"),
        of_axes("velocity", "ft/s"),
        of_axes("position", "ft"),
        of_axes("angular velocity", "rad/s"),
        angles.to_vec(),
        energies.map(str::to_owned).to_vec(),
    ]
    .concat()
}

/// Writes a − b in the report's numbering into `difference`.
pub fn difference(a: &State<f64>, b: &State<f64>, difference: &mut Vec<f64>) {
    difference.clear();
    let legs = PerLeg::from_fn(a.leg_count(), |j| (a.leg(j), b.leg(j)));
    difference.extend(legs.iter().map(|(a, b)| a.pad_rate - b.pad_rate));
    difference.extend(legs.iter().map(|(a, b)| a.pad_turn - b.pad_turn));
    difference.extend(legs.iter().map(|(a, b)| a.link_rate - b.link_rate));
    difference.extend(legs.iter().map(|(a, b)| a.link_angle - b.link_angle));
    let [body_a, body_b] = [a.body(), b.body()];
    difference.extend((body_a.velocity - body_b.velocity).iter());
    difference.extend((body_a.position - body_b.position).iter());
    difference.extend((body_a.rate - body_b.rate).iter());
    let [angles_a, angles_b] = [body_a, body_b].map(|body| {
        let q = body.quaternion;
        let euler = Attitude::from_quaternion([q.x, q.y, q.z, q.w]).euler();
        [euler.pitch, euler.yaw, euler.roll]
    });
    difference.extend((0..3).map(|k| (angles_a[k] - angles_b[k] + PI).rem_euclid(TAU) - PI));
    // The last of the six works of a leg, that of its stop, is not in the report.
    difference.extend((0..ENERGIES).map(|element| {
        legs.iter()
            .map(|(a, b)| a.work[ENERGY_ORDER[element]] - b.work[ENERGY_ORDER[element]])
            .sum::<f64>()
    }));
}

/// Indices of the report's energies among the works of a leg.
const ENERGY_ORDER: [usize; ENERGIES] = [0, 1, 3, 2, 4];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_are_numbered_as_in_the_report() {
        let names = names(3);
        assert_eq!(names.len(), 29);
        assert_eq!(names[8 - 1], "link rate 2, rad/s");
        assert_eq!(names[21 - 1], "angular velocity z, rad/s");
        assert_eq!(names[25 - 1], "strut energy, ft lb");
        let limits = limits(&ErrorLimits::default(), 3);
        let checked = limits.iter().filter(|limit| limit.is_finite()).count();
        assert_eq!((limits.len(), checked), (29, 21));
    }
}
