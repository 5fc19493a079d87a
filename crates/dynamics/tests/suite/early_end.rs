//! Landings whose end is known before they are at rest: endless slides, and steady landings of a scan.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{level, level_scene, settings, table_4_1};
use touchdown_dynamics::land::{land, land_observed};
use touchdown_dynamics::landing::{Instant, land_located_while};
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};

/// On a slope of 30 deg a friction of 0.4 is less than the tangent of the slope, one of 0.7 is more.
#[test]
fn a_slide_that_friction_cannot_stop_ends_as_such() {
    let vehicle = table_4_1();
    let end = |friction: f64| {
        let scene = Scene::new(Conditions {
            slope: 30f64.to_radians(),
            pad_friction: friction,
            block_friction: friction,
            ..level(180.0, 0.0, 2.0)
        });
        land(&vehicle, &scene.unwrap(), &settings(3e-5))
    };
    let slide = end(0.4);
    assert_eq!(slide.outcome, Outcome::Sliding);
    assert_eq!(slide.outcome.class(), Class::Undecided);
    assert!((2.0..15.0).contains(&slide.end_time), "{}", slide.end_time);
    assert_ne!(end(0.7).outcome, Outcome::Sliding);
}

/// Steady landings end early only where that is asked for; all others are the same to the last bit.
#[test]
fn landings_that_end_early_end_in_the_same_class() {
    let vehicle = table_4_1();
    let full = settings(3e-5);
    let mut early_ends = 0;
    for step in 0..50 {
        let scene = level_scene(90.0, 10.0, 0.5 * f64::from(step));
        let whole = land(&vehicle, &scene, &full);
        let early = land(&vehicle, &scene, &full.ending_early());
        if early.outcome == Outcome::StableSteady {
            assert_eq!(whole.outcome.class(), Class::Stable);
            assert!(early.evaluations < whole.evaluations && early.end_time < whole.end_time);
            early_ends += 1;
        } else {
            assert_eq!(early, whole);
        }
    }
    assert!((5..50).contains(&early_ends), "{early_ends}");
}

#[test]
fn a_landing_goes_on_only_as_long_as_it_is_told_to() {
    let (vehicle, scene, settings) = (table_4_1(), level_scene(180.0, 10.0, 8.0), settings(1e-6));
    let (mut asked, mut times) = (0, Vec::new());
    let mut observe = |instant: &Instant| times.push(instant.time);
    let whole = land_located_while(&vehicle, &scene, &settings, 0.1, &mut observe, || {
        asked += 1;
        true
    });
    let (mut usual, mut add) = (Vec::new(), |_: &Instant| {});
    assert_eq!(whole, Some(land(&vehicle, &scene, &settings)));
    assert!(asked > 100, "{asked}");
    land_observed(&vehicle, &scene, &settings, 0.1, &mut |instant| {
        usual.push(instant.time);
    });
    assert_eq!(times, usual);
    let mut left = asked - 1;
    let stopped = land_located_while(&vehicle, &scene, &settings, f64::INFINITY, &mut add, || {
        left -= 1;
        left > 0
    });
    assert_eq!((stopped, left), (None, 0));
}

/// The landing ends while its first strut is being compressed; another one goes on.
#[test]
fn rates_at_the_end_are_those_with_which_the_motion_goes_on() {
    const END: f64 = 0.05;
    const STEP: f64 = 1e-4;
    let (vehicle, scene) = (table_4_1(), level_scene(180.0, 5.0, 8.0));
    let up_to = |end| Settings::new(1e-9, end, CrushRule::PivotRate).unwrap();
    let rates = land(&vehicle, &scene, &up_to(END)).final_rates;
    let mut seen = Vec::new();
    land_observed(
        &vehicle,
        &scene,
        &up_to(2.0 * END),
        STEP,
        &mut |now: &Instant| {
            if (now.time - END).abs() < 1.5 * STEP {
                seen.push((now.stability_angle, now.legs.map(|leg| leg.stroke)));
            }
        },
    );
    let [before, at, after] = &seen[..] else {
        panic!("{seen:?}");
    };
    let close = |told: f64, known: f64| {
        assert!(
            (told - known).abs() <= 0.01 * known.abs(),
            "{told} told, {known} seen"
        );
    };
    close(
        rates.stability_angle.unwrap(),
        (after.0 - before.0) / (2.0 * STEP),
    );
    assert!(rates.strokes[0] > 1.0, "{rates:?}");
    for leg in 0..3 {
        let [before, at, after] = [before, at, after].map(|(_, strokes)| strokes[leg]);
        close(rates.strokes[leg], (after - before) / (2.0 * STEP));
        let bend = (after - 2.0 * at + before) / (STEP * STEP);
        close(rates.stroke_accelerations[leg], bend);
    }
}
