//! The surface from impact times: round trips over random slopes, and inputs that have no surface.

use std::f64::consts::PI;

use crate::common::{off_center, ring, sample_deck, table_4_1};
use nalgebra::{Matrix3, Vector3};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::impact_surface::{Approach, NoSurface, determine};
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

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
    let vehicle = match index % 3 {
        0 => table_4_1(),
        1 => sample_deck(),
        _ => off_center(table_4_1()),
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
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
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
    let [a, b, c] = *found.impact_points else {
        panic!("three points");
    };
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

/// Contact times of a landing without turning.
fn impact_times(vehicle: &Vehicle, approach: &Approach, slope: f64) -> [f64; 3] {
    contact_times(vehicle, approach, slope).try_into().unwrap()
}

/// The same of any number of legs.
fn contact_times(vehicle: &Vehicle, approach: &Approach, slope: f64) -> Vec<f64> {
    let velocity = approach.velocity;
    let conditions = Conditions {
        vertical_velocity: velocity.z,
        horizontal_velocity: velocity.x.hypot(velocity.y),
        cross_slope: (-velocity.x).atan2(velocity.y),
        attitude: approach.attitude,
        angular_velocity: approach.angular_velocity,
        slope,
        pad_friction: approach.friction,
        block_friction: approach.friction,
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    };
    let settings = Settings::new(1e-10, 1.5, CrushRule::PivotRate).unwrap();
    let landing = land(vehicle, &Scene::new(conditions).unwrap(), &settings);
    (landing.pad_contact.iter())
        .map(|time| time.unwrap())
        .collect()
}

#[test]
fn without_horizontal_motion_there_is_no_cross_slope() {
    let vehicle = table_4_1();
    let approach = level_approach(Vector3::new(0.0, 0.0, 10.0));
    let times = impact_times(&vehicle, &approach, 0.1);
    let found = determine(&vehicle, &approach, &times).unwrap();
    assert!(apart(found.slope, 0.1) < 1e-6);
    assert_eq!(found.cross_slope, None);
    assert_eq!(found.horizontal_velocity, 0.0);
    assert!(found.rotation.unwrap().abs() < 1e-6);
}

/// Of four legs three tell the slope, so that times that are off leave a surface that fits them best.
#[test]
fn more_times_than_needed_give_the_surface_that_fits_best() {
    let vehicle = ring(4);
    let approach = level_approach(Vector3::new(0.0, 2.0, 10.0));
    let times = contact_times(&vehicle, &approach, 0.1);
    let found = determine(&vehicle, &approach, &times).unwrap();
    assert!(apart(found.slope, 0.1) < 1e-6 && found.residual < 1e-8);

    const ERROR: f64 = 1e-4;
    let signs = [1.0, -1.0, 1.0, -1.0];
    let off: Vec<f64> = (times.iter().zip(signs))
        .map(|(time, sign)| 0.01 + time + ERROR * sign)
        .collect();
    let found = determine(&vehicle, &approach, &off).unwrap();
    assert!(
        (0.5 * ERROR..4.0 * ERROR).contains(&found.residual),
        "{}",
        found.residual
    );
    let slope_error = apart(found.slope, 0.1);
    assert!((1e-5..0.05).contains(&slope_error), "{slope_error}");
}

#[test]
fn level_ground_has_no_direction() {
    let vehicle = sample_deck();
    // A level vehicle of equal legs touches level ground with all pads at once, a leaning one does
    // not.
    let drifting = level_approach(Vector3::new(0.0, 3.0, 10.0));
    let level = Approach {
        attitude: euler(0.0, 0.0, 0.0),
        ..drifting
    };
    let leaning = impact_times(&vehicle, &drifting, 0.0);
    assert!(leaning.iter().any(|time| *time > 0.01), "{leaning:?}");
    for (approach, times) in [(level, [0.0; 3]), (drifting, leaning)] {
        let found = determine(&vehicle, &approach, &times).unwrap();
        assert!(found.slope < 1e-9, "{}", found.slope);
        assert_eq!((found.rotation, found.cross_slope), (None, None));
        assert!((found.horizontal_velocity - 3.0).abs() < 1e-12);
        assert!(apart(found.attitude.roll, approach.attitude.euler().roll) < 1e-9);
    }
}

#[test]
fn times_that_cannot_be_are_refused() {
    let approach = level_approach(Vector3::new(0.0, 3.0, 10.0));
    for times in [[0.0, -0.1, 0.2], [0.0, f64::NAN, 0.2], [0.0, 0.1, 101.0]] {
        let refused = determine(&table_4_1(), &approach, &times).unwrap_err();
        assert!(matches!(refused, NoSurface::Input(_)), "{refused}");
    }
}

#[test]
fn a_pad_that_falls_for_long_falls_down_a_wall() {
    let approach = level_approach(Vector3::new(0.0, 3.0, 10.0));
    let late = determine(&table_4_1(), &approach, &[0.0, 0.1, 30.0]).unwrap_err();
    assert_eq!(late, NoSurface::Wall);
    // And a vehicle lying on its side touches one with all pads at once.
    let upright = Approach {
        attitude: euler(90.0, 0.0, 0.0),
        ..approach
    };
    let aside = determine(&table_4_1(), &upright, &[0.0; 3]).unwrap_err();
    assert_eq!(aside, NoSurface::Wall);
}

#[test]
fn points_on_a_line_span_no_surface() {
    let vehicle = table_4_1();
    let attitude = euler(-20.0, 0.0, 0.0);
    // Outboard centroids (14) in ground axes from the CG.
    let centroids: [Vector3<f64>; 3] = std::array::from_fn(|j| {
        let leg = &vehicle.hinged_legs()[j];
        let (link, footpad) = (&leg.design().linkage, &leg.design().footpad);
        let (sine, cosine) = leg.extended_angle().sin_cos();
        let reach = link.lower_hardpoint_radius
            + link.lower_link_length * cosine
            + 2.0 * footpad.diameter / (3.0 * PI);
        let drop =
            vehicle.center_of_gravity_height() + link.lower_link_length * sine + footpad.height;
        let (east, north) = leg.design().azimuth.sin_cos();
        attitude.matrix() * Vector3::new(reach * east, reach * north, drop)
    });
    // So fast that footpad 1 comes, a while later, to where footpads 2 and 3 have a line between
    // them.
    let (later, gravity) = (0.3, vehicle.gravity());
    let middle = 0.5 * (centroids[1] + centroids[2]);
    let fall = Vector3::new(0.0, 0.0, 0.5 * gravity * later * later);
    let approach = Approach {
        velocity: (middle - centroids[0] - fall) / later,
        attitude,
        ..level_approach(Vector3::zeros())
    };
    let refused = determine(&vehicle, &approach, &[later, 0.0, 0.0]).unwrap_err();
    assert_eq!(refused, NoSurface::Collinear);
    // A hundredth of a second off the line they do span something.
    let other = determine(&vehicle, &approach, &[later + 0.01, 0.0, 0.0]);
    assert_ne!(other.err(), Some(NoSurface::Collinear));
}

#[test]
fn a_pad_that_never_would_touch_is_told_with_the_landings_end() {
    let vehicle = table_4_1();
    let late = determine(
        &vehicle,
        &level_approach(Vector3::new(0.0, 3.0, 14.0)),
        &[0.0, 1.0, 1.0],
    );
    let Err(NoSurface::NeverTouches { leg, outcome, time }) = late else {
        panic!("{late:?}");
    };
    assert!(leg > 0 && time < 2.05, "{leg} {time}");
    assert_ne!(outcome, Outcome::TimeExpired);
    // Set down at rest, a vehicle has come to rest before it presses on the ground.
    let at_rest = level_approach(Vector3::zeros());
    let refused = determine(&vehicle, &at_rest, &[0.0; 3]).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("stable-subsided 0.000 s after"),
        "{refused}"
    );
}
