//! Forms of the attitude, both ways, and where Euler angles fail.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::common::complaints::Complaints;
use crate::common::random::any_euler;
use crate::common::reference;
use nalgebra::{Matrix3, Rotation3, Vector3, Vector4};
use proptest::prelude::*;
use touchdown_dynamics::attitude::{Attitude, Euler, Tip};
use touchdown_dynamics::state::quaternion_rate;

/// Difference of two attitudes, about rad.
fn apart(one: &Attitude, other: &Attitude) -> f64 {
    (one.matrix() - other.matrix()).norm()
}

/// The report's matrix (1), multiplied out from its three turns.
fn by_turns(euler: Euler) -> Matrix3<f64> {
    let about =
        |axis: Vector3<f64>, angle: f64| Rotation3::from_scaled_axis(axis * angle).into_inner();
    about(Vector3::x(), euler.pitch)
        * about(Vector3::y(), euler.yaw)
        * about(Vector3::z(), euler.roll)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn euler_angles_both_ways(euler in any_euler()) {
        let attitude = Attitude::from_euler(euler);
        prop_assert!((attitude.matrix() - by_turns(euler)).norm() < 1e-14);
        let back = attitude.euler();
        prop_assert!((back.yaw - euler.yaw).abs() < 1e-14, "{back:?}");
        prop_assert!(apart(&attitude, &Attitude::from_euler(back)) < 3e-14);
        let off = (back.pitch - euler.pitch).abs().max((back.roll - euler.roll).abs());
        prop_assert!(off < 2e-14 / euler.yaw.cos(), "{back:?}");
    }

    /// Pitch and roll lose digits as 1/cos Φ near a right angle of yaw, but lose them together: the
    /// attitude keeps its own.
    #[test]
    fn euler_angles_near_a_right_angle_of_yaw(
        far in any_euler(), off in 1e-14f64.ln()..0.1f64.ln(), up in proptest::bool::ANY
    ) {
        let yaw = if up { FRAC_PI_2 - off.exp() } else { off.exp() - FRAC_PI_2 };
        let attitude = Attitude::from_euler(Euler { yaw, ..far });
        let back = attitude.euler();
        prop_assert!((back.yaw - yaw).abs() < 1e-14, "{back:?}");
        prop_assert!(apart(&attitude, &Attitude::from_euler(back)) < 3e-14);
        let tip = attitude.tip();
        prop_assert!(apart(&attitude, &Attitude::from_tip(tip)) < 3e-14);
    }

    #[test]
    fn quaternions_both_ways(euler in any_euler(), scale in 0.01f64..100.0) {
        let attitude = Attitude::from_euler(euler);
        let longer = attitude.quaternion().map(|q: f64| -scale * q);
        prop_assert!(apart(&attitude, &Attitude::from_quaternion(longer)) < 1e-14);
    }

    #[test]
    fn tip_both_ways(tip in 0.0..PI, azimuth in -PI..PI, nominal_roll in -PI..PI) {
        let given = Tip { tip, azimuth, nominal_roll };
        let attitude = Attitude::from_tip(given);
        // The top leans toward (−sin Γ, cos Γ), and leaning turns the vehicle about (cos Γ, sin Γ).
        let top = -attitude.matrix().column(2);
        let lean = Vector3::new(-azimuth.sin() * tip.sin(), azimuth.cos() * tip.sin(), -tip.cos());
        prop_assert!((top - lean).norm() < 1e-14);
        let back = attitude.tip();
        prop_assert!(apart(&attitude, &Attitude::from_tip(back)) < 1e-13);
        prop_assert!((back.tip - tip).abs() < 1e-13);
        if tip > 1e-3 && tip < PI - 1e-3 {
            prop_assert!((back.azimuth - azimuth).abs() < 1e-11, "{back:?}");
            let turns = (back.nominal_roll - nominal_roll) / (2.0 * PI);
            prop_assert!((turns - turns.round()).abs() < 1e-11, "{back:?}");
        }
    }

    #[test]
    fn euler_rates_both_ways(
        anywhere in any_euler(),
        omega in prop::array::uniform3(-3.0..3.0),
    ) {
        // Not where cos Φ is below 0.05, and Euler rates large.
        let euler = Euler { yaw: 0.968 * anywhere.yaw, ..anywhere };
        let rates = euler.rates(omega).unwrap();
        let back = Vector3::from(euler.angular_velocity(rates));
        prop_assert!((back - Vector3::from(omega)).norm() < 1e-12);
        // A short turn of the quaternion changes the angles by their rates.
        let step = 1e-5;
        let [w, x, y, z] = Attitude::from_euler(euler).quaternion();
        let quaternion = Vector4::new(w, x, y, z);
        let rate = quaternion_rate(&quaternion, &Vector3::from(omega));
        let ahead = |h: f64| {
            let q = quaternion + rate * h;
            Attitude::from_quaternion([q.x, q.y, q.z, q.w]).euler()
        };
        let (after, before) = (ahead(step), ahead(-step));
        let changes = [
            after.pitch - before.pitch,
            after.yaw - before.yaw,
            after.roll - before.roll,
        ];
        for (change, rate) in changes.into_iter().zip(rates) {
            let turns = (change - 2.0 * step * rate) / (2.0 * PI);
            let off = (turns - turns.round()) * 2.0 * PI / (2.0 * step);
            prop_assert!(off.abs() < 1e-3, "off by {off} rad/s");
        }
    }

    #[test]
    fn a_right_angle_of_yaw(pitch in -PI..PI, roll in -PI..PI, up in proptest::bool::ANY) {
        let yaw = if up { FRAC_PI_2 } else { -FRAC_PI_2 };
        let euler = Euler { pitch, yaw, roll };
        let attitude = Attitude::from_euler(euler);
        let back = attitude.euler();
        prop_assert!((back.yaw - yaw).abs() < 1e-14);
        // Pitch and roll turn about the same line: all of it is given as pitch.
        prop_assert_eq!(back.roll, 0.0);
        prop_assert!(apart(&attitude, &Attitude::from_euler(back)) < 3e-14);
        prop_assert!(euler.rates([1.0, 0.0, 0.0]).is_none());
        let tip = attitude.tip();
        prop_assert!(apart(&attitude, &Attitude::from_tip(tip)) < 1e-13);
    }
}

#[test]
fn euler_angles_of_tipped_vehicles() {
    let mut complaints = Complaints::default();
    let rows = reference("tipped.csv");
    for row in &rows {
        let angle = |column: &str| row.number(column).to_radians();
        let euler = Attitude::from_tip(Tip {
            tip: angle("tip_deg"),
            azimuth: angle("tip_azimuth_deg"),
            nominal_roll: angle("nominal_roll_deg"),
        })
        .euler();
        let name = format!(
            "tip {} at {}",
            row.text("tip_deg"),
            row.text("tip_azimuth_deg")
        );
        for (column, value) in [
            ("pitch_deg", euler.pitch),
            ("yaw_deg", euler.yaw),
            ("roll_deg", euler.roll),
        ] {
            complaints.near(&name, column, value.to_degrees(), row.number(column), 1e-7);
        }
    }
    assert_eq!(rows.len(), 27);
    complaints.settle();
}
