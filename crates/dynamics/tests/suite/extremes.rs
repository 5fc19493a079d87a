//! The extremes that a landing reports (least stability angle and clearance, greatest forces and strokes of its
//! struts) are those that a closely sampled landing shows.

use crate::common::random::{fixed_list, usual_conditions};
use crate::common::{level, settings, table_4_1};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::per_leg::PerLeg;
use touchdown_dynamics::scene::{Conditions, Scene};

/// Time between looks, s.
const INTERVAL: f64 = 1e-4;
/// Landings watched: these, and those in which the CG comes nearly to a halt between two steps and turns round, so
/// that σ dips for a few milliseconds.
const FIRST: usize = 25;
const TURNING_ROUND: [usize; 6] = [211, 754, 769, 1870, 2583, 2659];

fn watched() -> Vec<(usize, Conditions)> {
    let list = fixed_list(&usual_conditions(), 1 + TURNING_ROUND[5]);
    (list.into_iter().enumerate())
        .filter(|(index, _)| *index < FIRST || TURNING_ROUND.contains(index))
        .collect()
}

/// Extremes as they were seen, the least ones negative: all are greatest values.
struct Sample([f64; 8]);

impl Sample {
    const NAMES: [&str; 8] = [
        "least angle, rad",
        "least clearance, ft",
        "force 1, lb",
        "force 2, lb",
        "force 3, lb",
        "stroke 1, ft",
        "stroke 2, ft",
        "stroke 3, ft",
    ];

    fn new(angle: f64, clearance: f64, forces: PerLeg<f64>, strokes: PerLeg<f64>) -> Self {
        let ([f1, f2, f3], [s1, s2, s3]) = (&*forces, &*strokes) else {
            panic!("three legs");
        };
        Self([-angle, -clearance, *f1, *f2, *f3, *s1, *s2, *s3])
    }
}

#[test]
fn no_close_look_sees_more_than_the_extremes_that_are_reported() {
    let vehicle = table_4_1();
    // Allowed at the tolerances of searches and of single landings: angle in rad, clearance and stroke in ft.
    for (tolerance, [angle, length]) in [(3e-5, [1e-5, 1e-5]), (1e-6, [1e-6, 1e-5])] {
        for (index, conditions) in watched() {
            let scene = Scene::new(conditions).unwrap();
            let mut seen = Sample([f64::NEG_INFINITY; 8]);
            let landing = land_observed(
                &vehicle,
                &scene,
                &settings(tolerance),
                INTERVAL,
                &mut |now: &Instant| {
                    let Sample(look) = Sample::new(
                        now.stability_angle,
                        now.clearance,
                        now.legs.map(|leg| leg.strut_force.abs()),
                        now.legs.map(|leg| leg.stroke),
                    );
                    seen = Sample(std::array::from_fn(|k| seen.0[k].max(look[k])));
                },
            );
            let reported = Sample::new(
                landing.min_stability_angle,
                landing.min_clearance,
                landing.max_strut_force,
                landing.max_stroke,
            );
            // Forces to rounding.
            let force = |k: usize| 1e-9 * reported.0[k];
            let short = [
                angle,
                length,
                force(2),
                force(3),
                force(4),
                length,
                length,
                length,
            ];
            // Looks may pass over the very top of a peak.
            let beyond = [1e-3, 1e-3, 5.0, 5.0, 5.0, 1e-4, 1e-4, 1e-4];
            for (k, name) in Sample::NAMES.into_iter().enumerate() {
                let over = seen.0[k] - reported.0[k];
                assert!(
                    over <= short[k] && over >= -beyond[k],
                    "landing {index} at {tolerance:e}, {name}: {} reported, {} seen",
                    reported.0[k],
                    seen.0[k]
                );
            }
        }
    }
}

/// The force on strut 2 falls over a step, and within the next rises to its greatest and falls again.
#[test]
fn a_force_that_falls_and_then_peaks_within_a_step_is_reported_at_its_greatest() {
    let conditions = Conditions {
        vertical_velocity: 17.2929,
        attitude: Attitude::from_euler(Euler {
            pitch: -4.9877f64.to_radians(),
            yaw: 2.1596f64.to_radians(),
            roll: -7.9801f64.to_radians(),
        }),
        angular_velocity: [-5.8348f64.to_radians(), 0.0, 0.0],
        slope: 16.0733f64.to_radians(),
        pad_friction: 0.2213,
        block_friction: 0.2213,
        ..level(173.8741, 0.0, 8.3251)
    };
    let mut seen = 0f64;
    let landing = land_observed(
        &table_4_1(),
        &Scene::new(conditions).unwrap(),
        &settings(1e-6),
        INTERVAL,
        &mut |now: &Instant| seen = seen.max(now.legs[1].strut_force.abs()),
    );
    let reported = landing.max_strut_force[1];
    assert!(
        reported >= seen * (1.0 - 1e-9),
        "{reported} reported, {seen} seen"
    );
}
