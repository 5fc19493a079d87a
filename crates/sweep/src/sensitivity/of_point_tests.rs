use std::convert::Infallible;

use super::*;
use crate::examples::figure_4_09;
use futures::executor::block_on;
use touchdown_dynamics::outcome::Outcome;
use touchdown_input::sweeps::sweep_file::Job;
use touchdown_search::boundary::Transition;
use touchdown_search::contact_warnings::ContactWarnings;
use touchdown_search::trial::Margins;

#[test]
fn scales_are_magnitudes_but_of_angles() {
    let vehicle = figure_4_09().vehicle.vehicle;
    let scale = |name: &str, value| scale(&Parameter::named(name, 3).unwrap(), value, &vehicle);
    assert_eq!(scale("friction", 0.8), Some(0.8));
    assert_eq!(scale("friction", 0.0), None);
    assert_eq!(scale("roll_deg", 0.0), Some(30.0));
    assert_eq!(scale("angular_velocity_x_dps", 2.0), Some(30.0));
    assert_eq!(scale("vehicle.inertia_slug_ft2.xz", -5.87), Some(5.87));
    assert_eq!(scale("vehicle.legs[2].azimuth_deg", 120.0), Some(30.0));
    let height = scale("vehicle.center_of_gravity_offset_x_ft", 0.0).unwrap();
    assert!((2.0..5.0).contains(&height), "{height}");
    let in_mm = scale("vehicle.center_of_gravity_offset_x_mm", 0.0).unwrap();
    assert!((in_mm - 304.8 * height).abs() < 1e-9, "{in_mm}");
    let mean = scale("vehicle.inertia_slug_ft2.xz", 0.0).unwrap();
    assert!(
        (mean - (138.12 + 134.29 + 145.78) / 3.0).abs() < 1e-9,
        "{mean}"
    );
}

/// A landing of this class.
fn trial(class: Class, evaluations: u64) -> Trial {
    Trial {
        outcome: match class {
            Class::Stable => Outcome::StableSubsided,
            Class::Unstable => Outcome::UnstablePitch,
            _ => Outcome::TimeExpired,
        },
        class,
        least_angle: 0.5,
        margins: Margins::default(),
        duration: 3.0,
        tolerance: 3e-5,
        evaluations,
        warnings: ContactWarnings::default(),
    }
}

/// Class of a landing at friction μ and a speed.
type Landed = fn(f64, f64) -> Class;

/// Dependence on friction, around 1, of the boundary of such landings.
fn dependence_on_friction(landed: Landed, certainty: Certainty) -> Slope {
    dependence_on("friction", landed, certainty)
}

/// Dependence on any parameter.
fn dependence_on(parameter: &str, landed: Landed, certainty: Certainty) -> Slope {
    let mut sweep = figure_4_09();
    sweep.sensitivity = vec![Parameter::named(parameter, 3).unwrap()];
    let case = sweep.case(0).unwrap();
    let Job::Boundary(search) = case.job else {
        panic!("the sweep searches boundaries");
    };
    let land = async |case: &Case, speed, _: Variation| {
        let friction = case.scene.conditions().pad_friction;
        // No two landings are alike that differ in friction.
        let evaluations = (1e6 * friction) as u64;
        Ok::<_, Infallible>(trial(landed(friction, speed), evaluations))
    };
    let here = async |speed, variation| land(&case, speed, variation).await;
    let Ok(mut boundary) = block_on(search.boundary(here));
    if let Some(found) = &mut boundary.transition {
        *found = Transition {
            certainty,
            ..*found
        };
    }
    let Ok(found) = block_on(of_point(&sweep, 0, (&case, &search), &boundary, &land));
    found.slopes[0]
}

fn topples(is_over: bool) -> Class {
    match is_over {
        true => Class::Unstable,
        false => Class::Stable,
    }
}

#[test]
fn a_known_boundary_has_its_derivative_within_the_error() {
    let topple: Landed = |friction, speed| {
        let more = friction - 1.0;
        topples(speed > 11.0 + 2.0 * more + 3.0 * more * more)
    };
    let slope = dependence_on_friction(topple, Certainty::Certain);
    let Dependence::Smooth { derivative, error } = slope.dependence else {
        panic!("{slope:?}");
    };
    assert!((derivative - 2.0).abs() <= error, "{derivative} ± {error}");
    assert!(error < 0.05, "{error}");
    // The rule: (1e-4 ft/s of bracket, and 3e-5 of the speed) / speed, cube root.
    let rule = ((1e-4 + 3e-5 * 11.0) / 11.0_f64).cbrt();
    assert!((slope.step.unwrap() / rule - 1.0).abs() < 1e-3);
}

#[test]
fn where_there_is_no_derivative_a_word_says_why() {
    let at_the_ends = [
        [None, None],
        [None, None],
        [Some(11.0), Some(11.5)],
        [Some(3.0), Some(11.0)],
        [Some(11.0), None],
        [Some(11.5), Some(11.5)],
    ];
    let cases: [(Landed, Dependence); 6] = [
        (|_, _| Class::Stable, Dependence::NoTransition),
        (|_, _| Class::Unstable, Dependence::NoTransition),
        // A step of half a foot per second, and one that is farther than anything is followed.
        (
            |f, v| topples(v > 11.0 + 0.5 * f64::from(f > 1.01)),
            Dependence::Jumps,
        ),
        (
            |f, v| topples(v > 11.0 - 8.0 * f64::from(f < 0.99)),
            Dependence::Jumps,
        ),
        (|f, v| topples(v > 11.0 && f < 1.01), Dependence::Vanishes),
        (
            |f, v| topples(v > 11.0 + 5.0 * (f - 1.0).abs()),
            Dependence::Kinked,
        ),
    ];
    for (index, (landed, expected)) in cases.into_iter().enumerate() {
        let slope = dependence_on_friction(landed, Certainty::Certain);
        assert_eq!(slope.dependence, expected, "{index}");
        // The transitions at 0.9 and 1.1 take its place.
        let ends = slope
            .ends
            .map(|end| end.map(|speed| (10.0 * speed).round() / 10.0));
        assert_eq!(ends, at_the_ends[index], "{index}");
    }
    let disputed = Certainty::Disputed([10.0, 12.0]);
    let slope = dependence_on_friction(|_, v| topples(v > 11.0), disputed);
    assert_eq!(slope.dependence, Dependence::Disputed);
}

#[test]
fn what_changes_no_landing_has_a_derivative_of_zero() {
    // Its margin tells nothing of where it topples, so that searches scatter.
    let landed: Landed = |_, v| topples(v > 11.0 && !(11.01..11.02).contains(&v));
    let slope = dependence_on("vehicle.mass_slug", landed, Certainty::Certain);
    let none = Dependence::Smooth {
        derivative: 0.0,
        error: 0.0,
    };
    assert_eq!(slope.dependence, none);
}

#[test]
fn another_kind_of_transition_is_a_jump() {
    let landed: Landed = |friction, speed| match speed > 11.0 {
        true if friction > 1.01 => Class::Bottomed,
        over => topples(over),
    };
    let slope = dependence_on_friction(landed, Certainty::Certain);
    assert_eq!(slope.dependence, Dependence::Jumps);
}
