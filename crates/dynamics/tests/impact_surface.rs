//! The surface from impact times: round trips over random slopes, and inputs that have no surface.

mod common;

use common::{sample_deck, table_4_1};
use nalgebra::{Matrix3, Vector3};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::impact_surface::{Approach, NoSurface, determine};
use touchdown_dynamics::landing::land;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};

fn about_z(angle: f64) -> Matrix3<f64> {
    let (sine, cosine) = angle.sin_cos();
    Matrix3::new(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0)
}

fn euler(pitch: f64, yaw: f64, roll: f64) -> Attitude {
    let [pitch, yaw, roll] = [pitch, yaw, roll].map(f64::to_radians);
    Attitude::from_euler(Euler { pitch, yaw, roll })
}

/// A number between two others, the same for the same index.
fn spread(index: u32, salt: f64, low: f64, high: f64) -> f64 {
    low + (high - low) * (f64::from(index) * salt).fract()
}

/// Difference of two angles, deg.
fn apart(a: f64, b: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    let difference = (a - b).rem_euclid(turn);
    difference.min(turn - difference).to_degrees()
}

/// An approach in axes turned by ζ against the customary ones, its impact times by landing on the
/// slope, and what must be found.
fn round_trip(index: u32) {
    let vehicle = if index.is_multiple_of(2) {
        table_4_1()
    } else {
        sample_deck()
    };
    let conditions = Conditions {
        vertical_velocity: spread(index, 0.618, 8.0, 16.0),
        horizontal_velocity: spread(index, 0.414, 1.0, 9.0),
        cross_slope: spread(index, 0.732, -3.1, 3.1),
        attitude: euler(
            spread(index, 0.236, -4.0, 4.0),
            spread(index, 0.646, -4.0, 4.0),
            // Beyond the report's ±90 deg too.
            spread(index, 0.317, -175.0, 175.0),
        ),
        angular_velocity: [
            spread(index, 0.162, -0.05, 0.05),
            spread(index, 0.872, -0.05, 0.05),
            0.02,
        ],
        slope: spread(index, 0.541, 2.0, 14.0).to_radians(),
        pad_friction: 0.8,
        block_friction: 0.8,
    };
    let settings = Settings::new(1e-10, 1.5, CrushRule::PivotRate).unwrap();
    let landing = land(&vehicle, &Scene::new(conditions).unwrap(), &settings);
    let times = landing.pad_contact.map(|time| time.unwrap());
    let turn = spread(index, 0.905, -3.0, 3.0);
    let (sine, cosine) = conditions.cross_slope.sin_cos();
    let speed = conditions.horizontal_velocity;
    let velocity = Vector3::new(-speed * sine, speed * cosine, conditions.vertical_velocity);
    let approach = Approach {
        velocity: about_z(turn) * velocity,
        attitude: Attitude::from_matrix(&(about_z(turn) * conditions.attitude.matrix())),
        angular_velocity: conditions.angular_velocity,
        friction: 0.8,
    };
    let found = determine(&vehicle, &approach, &times)
        .unwrap_or_else(|error| panic!("{index}: {error}; times {times:?}"));
    let expected = conditions.attitude.euler();
    for (name, ours, theirs) in [
        ("slope", found.slope, conditions.slope),
        (
            "cross-slope",
            found.cross_slope.unwrap(),
            conditions.cross_slope,
        ),
        ("rotation", found.rotation.unwrap(), turn),
        ("pitch", found.attitude.pitch, expected.pitch),
        ("yaw", found.attitude.yaw, expected.yaw),
        ("roll", found.attitude.roll, expected.roll),
    ] {
        let difference = apart(ours, theirs);
        assert!(
            difference < 1e-6,
            "{index}: {name} off by {difference:e} deg"
        );
    }
    assert!((found.horizontal_velocity - speed).abs() < 1e-9);
    // The points of impact lie on the surface found.
    let normal = about_z(turn) * Vector3::new(0.0, conditions.slope.sin(), conditions.slope.cos());
    let [a, b, c] = found.impact_points;
    assert!(normal.dot(&(b - a)).abs() < 1e-5 && normal.dot(&(c - a)).abs() < 1e-5);
}

#[test]
fn slope_cross_slope_and_attitude_come_back() {
    for index in 1..=24 {
        round_trip(index);
    }
}

fn level_approach(velocity: Vector3<f64>) -> Approach {
    Approach {
        velocity,
        attitude: euler(2.0, 0.0, 10.0),
        angular_velocity: [0.0; 3],
        friction: 0.8,
    }
}

#[test]
fn without_horizontal_motion_there_is_no_cross_slope() {
    let vehicle = table_4_1();
    let conditions = Conditions {
        vertical_velocity: 10.0,
        horizontal_velocity: 0.0,
        cross_slope: 0.0,
        attitude: euler(2.0, 0.0, 10.0),
        angular_velocity: [0.0; 3],
        slope: 0.1,
        pad_friction: 0.8,
        block_friction: 0.8,
    };
    let settings = Settings::new(1e-10, 1.5, CrushRule::PivotRate).unwrap();
    let landing = land(&vehicle, &Scene::new(conditions).unwrap(), &settings);
    let times = landing.pad_contact.map(Option::unwrap);
    let approach = level_approach(Vector3::new(0.0, 0.0, 10.0));
    let found = determine(&vehicle, &approach, &times).unwrap();
    assert!(apart(found.slope, 0.1) < 1e-6);
    assert_eq!(found.cross_slope, None);
    assert!(found.rotation.unwrap().abs() < 1e-6);
}

#[test]
fn level_ground_has_no_direction() {
    let vehicle = sample_deck();
    let approach = Approach {
        attitude: euler(0.0, 0.0, 0.0),
        ..level_approach(Vector3::new(0.0, 3.0, 10.0))
    };
    // A level vehicle of equal legs touches level ground with all pads at once.
    let found = determine(&vehicle, &approach, &[0.0; 3]).unwrap();
    assert!(found.slope < 1e-8, "{}", found.slope);
    if found.rotation.is_none() {
        assert_eq!(found.cross_slope, None);
    }
}

#[test]
fn what_has_no_surface_is_told_so() {
    let vehicle = table_4_1();
    let approach = level_approach(Vector3::new(0.0, 3.0, 10.0));
    let refuse = |times: [f64; 3]| determine(&vehicle, &approach, &times).unwrap_err();
    assert!(matches!(refuse([0.0, -0.1, 0.2]), NoSurface::Input(_)));
    assert!(matches!(refuse([0.0, f64::NAN, 0.2]), NoSurface::Input(_)));
    // So late a pad would have to fall into a pit.
    let late = refuse([0.0, 0.1, 30.0]);
    assert!(
        matches!(
            late,
            NoSurface::Wall | NoSurface::NeverTouches { .. } | NoSurface::NotFound { .. }
        ),
        "{late}"
    );
}
