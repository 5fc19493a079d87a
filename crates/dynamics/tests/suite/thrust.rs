//! Thrust after first contact, gravity of the scene, and landings that go on beyond their verdict.

use crate::common::scenes::history;
use crate::common::{level, ring, settings, side_by_side, table_4_1};
use std::sync::Arc;
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings, Stop};
use touchdown_dynamics::thrust::Thrust;

fn thrust(knots: &[[f64; 2]], offset: [f64; 2]) -> Thrust {
    Thrust::new(knots, offset).unwrap()
}

/// An engine that dies away, a little beside the centreline.
fn dying() -> Thrust {
    thrust(&[[0.0, 80.0], [0.2, 60.0], [0.7, 0.0]], [0.05, -0.02])
}

fn with(thrust: Thrust, conditions: Conditions) -> Scene {
    Scene::new(Conditions {
        thrust,
        ..conditions
    })
    .unwrap()
}

#[test]
fn thrust_equal_to_weight_is_weightlessness() {
    // Level and upright, thrust along the vertical is gravity less: without rotation both are the same landing.
    let vehicle = ring(4);
    let conditions = Conditions {
        slope: 0.0,
        vertical_velocity: 6.0,
        ..level(180.0, 45.0, 0.0)
    };
    let lift = 60.0;
    let less = vehicle.gravity() - lift / vehicle.mass();
    let thrusting = with(thrust(&[[0.0, lift]], [0.0; 2]), conditions);
    let lighter = Scene::new(Conditions {
        gravity: Some(less),
        ..conditions
    })
    .unwrap();
    let [(one, ones), (other, others)] =
        [thrusting, lighter].map(|scene| history(&vehicle, &scene, &settings(1e-10), 0.01));
    assert_eq!(one.outcome, other.outcome);
    assert!((one.end_time - other.end_time).abs() < 1e-6);
    assert!((one.max_stroke[0] - other.max_stroke[0]).abs() < 1e-8);
    for (a, b) in ones.iter().zip(&others) {
        assert!((a.position.z - b.position.z).abs() < 1e-7, "{}", a.time);
    }
    // What the weight does less, the thrust has done.
    let energies = &one.energies;
    assert!(
        (energies.thrust + energies.potential_change - other.energies.potential_change).abs()
            < 1e-5
    );
    assert!(energies.thrust < -1.0, "{}", energies.thrust);
    assert!(energies.closure().abs() < 1e-4, "{}", energies.closure());
}

#[test]
fn accounts_with_thrust_close_and_tolerances_agree() {
    for (vehicle, roll) in [(table_4_1(), 10.0), (ring(4), 30.0)] {
        for speed in [6.0, 10.0, 13.0] {
            let scene = with(dying(), level(170.0, roll, speed));
            let [loose, tight] =
                [1e-6, 1e-9].map(|tolerance| land(&vehicle, &scene, &settings(tolerance)));
            assert_eq!(loose.outcome.class(), tight.outcome.class());
            let apart = (loose.min_stability_angle - tight.min_stability_angle).abs();
            assert!(apart < 1e-4, "{apart}");
            assert!(tight.energies.thrust.abs() > 10.0);
            assert!(
                tight.energies.closure().abs() < 1e-4,
                "{}",
                tight.energies.closure()
            );
            let none = land(
                &vehicle,
                &Scene::new(level(170.0, roll, speed)).unwrap(),
                &settings(1e-9),
            );
            assert_ne!(none.end_time, tight.end_time);
        }
    }
}

#[test]
fn accounts_of_histories_with_thrust_close_at_every_instant() {
    let scene = with(dying(), level(170.0, 10.0, 10.0));
    let (landing, instants) = history(&table_4_1(), &scene, &settings(1e-9), 0.01);
    assert!(instants.len() > 50);
    for instant in &instants {
        let thrust_work = instant.thrust_work.unwrap();
        let works: f64 = instant.legs.iter().map(|leg| leg.work.total()).sum();
        let open = landing.energies.initial_kinetic + instant.potential_change + thrust_work
            - works
            - instant.kinetic_energy;
        assert!(open.abs() < 1e-3, "{} s: {open} ft lb", instant.time);
    }
    let last = instants.last().unwrap().thrust_work;
    assert_eq!(last, Some(landing.energies.thrust));
}

#[test]
fn thrust_beyond_the_weight_lifts_off_again_and_ends_at_the_time_limit() {
    let vehicle = ring(4);
    let scene = with(
        thrust(&[[0.0, 400.0]], [0.0; 2]),
        Conditions {
            slope: 0.0,
            ..level(180.0, 45.0, 1.0)
        },
    );
    let settings = Settings::new(1e-6, 8.0, CrushRule::Section).unwrap();
    let (landing, instants) = history(&vehicle, &scene, &settings, 0.5);
    assert_eq!(landing.outcome, Outcome::TimeExpired);
    assert!(landing.steps < 20_000, "{}", landing.steps);
    assert!(instants.last().unwrap().position.z < -50.0);
}

#[test]
fn lanes_with_and_without_thrust_do_not_touch_each_other() {
    let vehicle = Arc::new(table_4_1());
    let scenes: Vec<Scene> = (0..16)
        .map(|k| {
            let conditions = level(170.0, 5.0 * f64::from(k), 10.0 + 0.2 * f64::from(k));
            if k % 3 == 0 {
                with(dying(), conditions)
            } else {
                Scene::new(conditions).unwrap()
            }
        })
        .collect();
    let alone: Vec<_> = scenes
        .iter()
        .map(|scene| land(&vehicle, scene, &settings(3e-5)))
        .collect();
    let together = side_by_side(scenes.iter().enumerate().map(|(key, scene)| Request {
        key,
        vehicle: vehicle.clone(),
        scene: *scene,
        settings: settings(3e-5),
    }));
    assert_eq!(alone, together);
}

#[test]
fn gravity_of_the_scene_wins_over_that_of_the_vehicle() {
    let vehicle = table_4_1();
    let scene = Scene::new(Conditions {
        gravity: Some(vehicle.gravity()),
        ..level(180.0, 5.0, 11.0)
    })
    .unwrap();
    let plain = Scene::new(level(180.0, 5.0, 11.0)).unwrap();
    let [same, earth] = [vehicle.gravity(), 32.174].map(|gravity| {
        let conditions = *scene.conditions();
        let scene = Scene::new(Conditions {
            gravity: Some(gravity),
            ..conditions
        })
        .unwrap();
        land(&vehicle, &scene, &settings(1e-6))
    });
    assert_eq!(same, land(&vehicle, &plain, &settings(1e-6)));
    assert!(earth.energies.potential_change > 2.0 * same.energies.potential_change);
    assert!(
        Scene::new(Conditions {
            gravity: Some(0.0),
            ..level(180.0, 5.0, 11.0)
        })
        .is_err()
    );
}

#[test]
fn a_landing_may_go_on_beyond_its_verdict() {
    let vehicle = table_4_1();
    for (speed, class) in [(8.0, Class::Stable), (13.0, Class::Unstable)] {
        let scene = Scene::new(level(180.0, 5.0, speed)).unwrap();
        let limit = Settings::new(1e-6, 6.0, CrushRule::PivotRate).unwrap();
        let judged = land(&vehicle, &scene, &limit);
        let (beyond, instants) = history(&vehicle, &scene, &limit.stopping_at(Stop::Time), 0.1);
        assert_eq!(judged.outcome.class(), class);
        assert_eq!(beyond.outcome, judged.outcome);
        assert_eq!(judged.beyond, None);
        let went_on = beyond.beyond.unwrap();
        assert!((went_on.verdict_time - judged.end_time).abs() < 1e-5);
        assert!(
            beyond.end_time > judged.end_time + 0.1,
            "{}",
            beyond.end_time
        );
        assert!(beyond.energies.closure().abs() < 1e-2);
        assert_eq!(instants.last().unwrap().time, beyond.end_time);
        // Least clearance is that of all of it, least σ that up to the verdict.
        assert!((beyond.min_stability_angle - judged.min_stability_angle).abs() < 1e-5);
        let lowest = instants.iter().map(|instant| instant.clearance);
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        assert!(beyond.min_clearance <= lowest + 1e-9);
        assert!(beyond.min_clearance > lowest - 0.05);
        match went_on.end {
            Outcome::TimeExpired => assert!((beyond.end_time - 6.0).abs() < 1e-9),
            Outcome::Failure(_) | Outcome::Bottomed { .. } => assert_eq!(class, Class::Unstable),
            other => panic!("{other}"),
        }
    }
}
