//! Table 4-3 of the report: velocity of the CG through the landing at cross-slope 170 deg.

use crate::common::complaints::Complaints;
use crate::common::{reference, scenes, settings, table_4_1};
use touchdown_dynamics::scene::Settings;

/// The print's rounding and the report's own error, ft/s.
const LIMIT: f64 = 0.012;
/// One unit of the last digit of the printed direction, which is cut off rather than rounded, deg.
const PRINTED_ANGLE: f64 = 0.1;

#[test]
fn velocities_agree_with_the_print() {
    let scene = scenes::table_4_3();
    let tolerance = settings(Settings::DEFAULT_TOLERANCE);
    let (_, instants) = scenes::history(&table_4_1(), &scene, &tolerance, 0.02);
    let rows = reference("table-4-3.csv");
    assert_eq!(rows.len(), 13);
    let mut complaints = Complaints::default();
    for row in &rows {
        let time = row.number("time_s");
        let name = format!("{time} s");
        let instant = &instants[(time / 0.02).round() as usize];
        complaints.near(&name, "t", instant.time, time, 1e-9);
        let velocity = instant.velocity;
        complaints.near(&name, "Xd", velocity.x, row.number("x_velocity_fps"), LIMIT);
        complaints.near(&name, "Yd", velocity.y, row.number("y_velocity_fps"), LIMIT);
        // Direction of motion: λ of the CG.
        let direction = (-velocity.x).atan2(velocity.y).to_degrees();
        let printed = row.number("cross_slope_deg");
        complaints.near(&name, "cross-slope", direction, printed, PRINTED_ANGLE);
    }
    complaints.settle();
}
