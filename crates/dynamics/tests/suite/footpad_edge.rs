//! Footpads that turn over and go on bearing a load.

use std::sync::Arc;

use crate::common::{even_inertia, level, settings, side_by_side, surveyor_leg};
use touchdown_dynamics::attitude::{Attitude, Tip};
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::{Class, Failure, Outcome};
use touchdown_dynamics::parts::PadEdge;
use touchdown_dynamics::rules::CrushRule;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, Scene, Stop};
use touchdown_dynamics::vehicle::{Leg, Vehicle};

fn lander(edge: Option<PadEdge>) -> Vehicle {
    let legs = [0.0, 120.0, 240.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.footpad.edge = edge;
        Leg::new(design).unwrap()
    });
    Vehicle::new(20.0, 5.31, 1.445, even_inertia(142.0), legs.to_vec())
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// Steep and fast: pads turn over.
fn wild(k: i32) -> Scene {
    let conditions = level(
        150.0 + 7.0 * f64::from(k),
        11.0 * f64::from(k),
        17.0 + f64::from(k),
    );
    Scene::new(Conditions {
        slope: 20f64.to_radians(),
        vertical_velocity: 18.0,
        ..conditions
    })
    .unwrap()
}

fn as_in_1966() -> PadEdge {
    PadEdge {
        angle: 65f64.to_radians(),
        load: 187.0,
    }
}

#[test]
fn a_pad_on_its_edge_bears_on_where_there_was_no_law() {
    let [without, with] = [None, Some(as_in_1966())].map(lander);
    let mut went_on = 0;
    for k in 0..40 {
        let scene = wild(k);
        let beyond = settings(1e-7).stopping_at(Stop::Time);
        let failed = land(&without, &scene, &beyond);
        let landing = land(&with, &scene, &beyond);
        let end = |landing: &touchdown_dynamics::landing::Landing| {
            landing
                .beyond
                .as_ref()
                .map_or(landing.outcome.clone(), |beyond| beyond.end.clone())
        };
        assert!(!matches!(
            end(&landing),
            Outcome::Failure(Failure::PadInclination { .. })
        ));
        if matches!(
            end(&failed),
            Outcome::Failure(Failure::PadInclination { .. })
        ) {
            went_on += 1;
            assert!(landing.end_time > failed.end_time);
        } else {
            // No pad turned over: nothing is different.
            assert_eq!(landing, failed);
        }
        let scale = landing.energies.initial_kinetic;
        assert!(
            landing.energies.closure().abs() < 1e-5 * scale,
            "{k}: {}",
            landing.energies.closure()
        );
    }
    assert!(went_on > 3, "{went_on}");
}

#[test]
fn tolerances_agree_on_landings_with_pads_on_their_edges() {
    let vehicle = lander(Some(PadEdge {
        angle: 50f64.to_radians(),
        load: 300.0,
    }));
    for k in [1, 5, 8, 14] {
        let [loose, tight] =
            [1e-8, 1e-10].map(|tolerance| land(&vehicle, &wild(k), &settings(tolerance)));
        assert_eq!(loose.outcome.class(), tight.outcome.class(), "{k}");
        assert_ne!(tight.outcome.class(), Class::Failure);
        assert!(
            (loose.min_stability_angle - tight.min_stability_angle).abs() < 1e-3,
            "{k}"
        );
    }
}

#[test]
fn pads_on_their_edges_neither_chatter_nor_swing_for_ever() {
    // Vehicles that come down on their side, spinning, so that pads land on their edges and roll over them.
    let scenes = (0..120).map(|k| {
        let of = |step: f64, range: f64| range * ((step * f64::from(k)) % 1.0);
        Scene::new(Conditions {
            attitude: Attitude::from_tip(Tip {
                tip: 0.3 + of(0.37, 0.8),
                azimuth: of(0.71, 6.0),
                nominal_roll: 0.0,
            }),
            slope: of(0.13, 0.7),
            vertical_velocity: 2.0 + of(0.29, 20.0),
            angular_velocity: [of(0.53, 3.0) - 1.5, of(0.61, 3.0) - 1.5, 0.0],
            ..level(40.0 * f64::from(k), 0.0, of(0.83, 25.0))
        })
        .unwrap()
    });
    let vehicle = Arc::new(lander(Some(as_in_1966())));
    let settings = settings(3e-5).with_crush_rule(CrushRule::Section);
    let requests = scenes.enumerate().map(|(key, scene)| Request {
        key,
        vehicle: vehicle.clone(),
        scene,
        settings,
    });
    let landings = side_by_side(requests);
    for (k, landing) in landings.iter().enumerate() {
        let evaluations = landing.evaluations;
        assert!(
            evaluations < 200_000,
            "{k}: {evaluations}, {:?}",
            landing.outcome
        );
        assert_ne!(landing.outcome.class(), Class::Failure, "{k}");
    }
}
