//! Ground that is higher, lower or steeper under some legs.

use crate::common::scenes::history;
use crate::common::{level, off_center, ring, settings, table_4_1};
use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::ground::{Ground, LegFooting, Patch};
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::motion::Motion;
use touchdown_dynamics::outcome::{Class, Failure, Outcome};
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, Scene};
use touchdown_dynamics::touchdown::touchdown;
use touchdown_dynamics::vehicle::Vehicle;

const TOLERANCE: f64 = 1e-9;

fn on(ground: &[LegFooting], conditions: Conditions) -> Scene {
    let ground = Ground::new(ground).unwrap();
    Scene::new(Conditions {
        ground,
        ..conditions
    })
    .unwrap()
}

fn both(patch: Patch) -> LegFooting {
    LegFooting::of(patch, patch)
}

fn raised(height: f64) -> Patch {
    Patch {
        height,
        ..Patch::default()
    }
}

fn assert_alike(one: &Landing, other: &Landing) {
    assert_eq!(one.outcome.to_string(), other.outcome.to_string());
    let apart = (one.min_stability_angle - other.min_stability_angle).abs();
    assert!(apart < 1e-7, "{apart} rad");
    assert!((one.end_time - other.end_time).abs() < 1e-6);
    for (a, b) in one.max_stroke.iter().zip(other.max_stroke.iter()) {
        assert!((a - b).abs() < 1e-7, "{a}, {b}");
    }
}

#[test]
fn ground_that_is_higher_everywhere_only_lifts_the_landing() {
    let vehicle = table_4_1();
    for (speed, roll) in [(9.0, 5.0), (11.5, -20.0), (13.0, 40.0)] {
        let conditions = level(170.0, roll, speed);
        let plain = land(&vehicle, &on(&[], conditions), &settings(TOLERANCE));
        for height in [0.7, -1.9] {
            let ground = [both(raised(height)); 3];
            let scene = on(&ground, conditions);
            let lifted = land(&vehicle, &scene, &settings(TOLERANCE));
            assert_eq!(plain.outcome, lifted.outcome);
            // Subsided motion is judged by the height of the CG over the surface, toppling is not.
            if plain.outcome.class() == Class::Unstable {
                assert_alike(&plain, &lifted);
            }
            let start = |scene: &Scene| {
                let motion = Motion::new(&vehicle, scene);
                touchdown(&vehicle, scene, &motion).body().position.z
            };
            let rise = start(&on(&[], conditions)) - start(&scene);
            assert!((rise - height / conditions.slope.cos()).abs() < 1e-12);
        }
    }
}

/// Patches that together are a plane of another slope, under the legs of a vehicle over a surface.
fn as_steeper_plane(vehicle: &Vehicle, conditions: Conditions, more: f64) -> Vec<LegFooting> {
    let attitude = conditions.attitude.matrix();
    let motion = Motion::new(vehicle, &Scene::new(conditions).unwrap());
    let steeper = conditions.slope + more;
    let patch = |point: Vector3<f64>| {
        let place = attitude * point;
        // On the plane through the origin, and how high over the surface that is.
        let z = -steeper.tan() * place.y;
        Patch {
            height: -(conditions.slope.sin() * place.y + conditions.slope.cos() * z),
            tilt_along: more,
            tilt_across: 0.0,
        }
    };
    (vehicle.hinged_legs().iter().enumerate())
        .map(|(j, leg)| {
            let pad = patch(motion.geometry(j).pivot(leg.extended_angle()));
            LegFooting::of(pad, patch(motion.geometry(j).block_face()))
        })
        .collect()
}

#[test]
fn tilted_patches_that_make_a_plane_are_that_plane() {
    let vehicle = table_4_1();
    let mut toppled = 0;
    for (speed, roll) in [(10.0, 5.0), (12.5, -20.0), (13.0, 40.0), (16.0, 10.0)] {
        let conditions = level(160.0, roll, speed);
        let more = 4f64.to_radians();
        let ground = as_steeper_plane(&vehicle, conditions, more);
        let patched = land(&vehicle, &on(&ground, conditions), &settings(TOLERANCE));
        let slope = conditions.slope + more;
        let plane = Scene::new(Conditions {
            slope,
            ..conditions
        })
        .unwrap();
        let plane = land(&vehicle, &plane, &settings(TOLERANCE));
        assert_eq!(patched.outcome.class(), plane.outcome.class());
        if plane.outcome.class() == Class::Unstable {
            toppled += 1;
            assert_alike(&patched, &plane);
        }
        let contacts = patched.pad_contact.iter().zip(plane.pad_contact.iter());
        for (a, b) in contacts {
            assert!((a.unwrap() - b.unwrap()).abs() < 1e-9);
        }
    }
    assert!(toppled >= 2, "{toppled}");
}

#[test]
fn a_rock_is_met_first_and_a_crater_last() {
    let vehicle = ring(4);
    let conditions = Conditions {
        slope: 0.0,
        vertical_velocity: 8.0,
        ..level(180.0, 45.0, 3.0)
    };
    let rock = |leg: usize, height: f64| {
        let mut ground = [LegFooting::default(); 4];
        ground[leg].pad = raised(height);
        land(&vehicle, &on(&ground, conditions), &settings(1e-8))
    };
    for leg in 0..4 {
        let contacts = rock(leg, 0.4).pad_contact.map(|time| time.unwrap());
        let first = contacts.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        assert!(first == contacts[leg] && first < 1e-6, "{contacts:?}");
        // The others fall the height of the rock.
        let fall = 0.4 / 8.0;
        for other in (0..4).filter(|other| *other != leg) {
            assert!((contacts[other] - fall).abs() < 0.02, "{contacts:?}");
        }
        let landing = rock(leg, -0.4);
        assert!(landing.pad_contact[leg].is_none_or(|time| time > 0.03));
        assert!(landing.energies.closure().abs() < 1e-3);
    }
}

/// Random ground: accounts close, tolerances agree, and the mirror image lands in the mirror image.
#[test]
fn landings_on_rough_ground_close_their_accounts_and_converge() {
    let vehicle = ring(4);
    let height = |k: usize| 0.25 * ((k * 7 + 3) % 11) as f64 / 10.0;
    let tilt = |k: usize| 0.2 * ((k * 5 + 2) % 9) as f64 / 8.0 - 0.1;
    for case in 0..6 {
        let ground: Vec<LegFooting> = (0..4)
            .map(|leg| {
                let k = 4 * case + leg;
                let pad = Patch {
                    height: height(k),
                    tilt_along: tilt(k),
                    tilt_across: tilt(k + 1),
                };
                let block = Patch {
                    height: height(k + 2) - 0.2,
                    ..pad
                };
                LegFooting::of(pad, block)
            })
            .collect();
        let scene = on(&ground, level(180.0, 45.0, 6.0 + case as f64));
        let [loose, (tight, instants)] =
            [1e-6, 1e-9].map(|tolerance| history(&vehicle, &scene, &settings(tolerance), 0.05));
        assert_eq!(loose.0.outcome.class(), tight.outcome.class(), "{case}");
        let apart = (loose.0.min_stability_angle - tight.min_stability_angle).abs();
        assert!(apart < 1e-4, "{case}: {apart}");
        assert!(
            tight.energies.closure().abs() < 1e-3,
            "{}",
            tight.energies.closure()
        );
        assert!(instants.len() > 5);
        // Mirrored at the plane of steepest slope: neighbours change places, and tilts across their signs.
        let mirrored: Vec<LegFooting> = [1, 0, 3, 2]
            .map(|leg: usize| {
                let mirror = |patch: Patch| Patch {
                    tilt_across: -patch.tilt_across,
                    ..patch
                };
                LegFooting::of(mirror(ground[leg].pad), mirror(ground[leg].block))
            })
            .into();
        let image = land(
            &vehicle,
            &on(&mirrored, level(180.0, 45.0, 6.0 + case as f64)),
            &settings(1e-9),
        );
        assert_eq!(image.outcome.class(), tight.outcome.class());
        let apart = (image.min_stability_angle - tight.min_stability_angle).abs();
        assert!(apart < 1e-6, "{case}: {apart} rad from the mirror image");
    }
}

#[test]
fn ground_that_reaches_into_the_body_at_first_contact_is_refused() {
    let landing = |height: f64| {
        let high = LegFooting {
            block: raised(height),
            ..LegFooting::default()
        };
        let even = LegFooting::default();
        let scene = on(&[even, high, even], level(180.0, 0.0, 5.0));
        land(&table_4_1(), &scene, &settings(1e-5)).outcome
    };
    let refused = Failure::GroundInBody { leg: 1 };
    assert_eq!(landing(4.0), Outcome::Failure(refused));
    assert_eq!(landing(0.5).class(), Class::Stable);
}

/// On level ground nothing has a direction but what stands on it. A quarter of a turn from Y (uphill) to X makes of a patch tilted
/// along the slope one that is tilted across it, and of one tilted across one that is tilted along it the other way.
#[test]
fn a_quarter_of_a_turn_of_everything_on_level_ground_is_the_same_landing() {
    let tilted = |tilt_along, tilt_across, height| Patch {
        height,
        tilt_along,
        tilt_across,
    };
    let footing = |turned: bool| {
        let patch = |along: f64, across: f64, height| match turned {
            false => tilted(along, across, height),
            true => tilted(-across, along, height),
        };
        let legs = [
            (patch(0.11, 0.0, 0.1), patch(0.0, 0.07, 0.2)),
            (patch(0.0, -0.13, -0.1), patch(-0.05, 0.0, 0.1)),
            (patch(-0.06, 0.0, 0.0), patch(0.0, 0.0, 0.15)),
        ];
        Ground::new(&legs.map(|(pad, block)| LegFooting::of(pad, block))).unwrap()
    };
    for rules in [Rules::REPORT, Rules::PHYSICAL] {
        let vehicle = off_center(table_4_1()).with_rules(rules);
        for (vertical, horizontal, direction) in
            [(9.0, 5.0, 20f64), (14.0, 3.0, -140.0), (6.0, 8.0, 95.0)]
        {
            let landed = [false, true].map(|turned| {
                let turn = if turned { FRAC_PI_2 } else { 0.0 };
                let conditions = Conditions {
                    vertical_velocity: vertical,
                    horizontal_velocity: horizontal,
                    cross_slope: direction.to_radians() - turn,
                    slope: 0.0,
                    pad_friction: 0.7,
                    block_friction: 0.4,
                    attitude: Attitude::from_euler(Euler {
                        pitch: 0.0,
                        yaw: 0.0,
                        roll: 0.2 - turn,
                    }),
                    angular_velocity: [0.0, 0.0, 0.3],
                    ground: footing(turned),
                    ..level(0.0, 0.0, 0.0)
                };
                let settings = settings(1e-9).with_time_limit(0.5).unwrap();
                land(&vehicle, &Scene::new(conditions).unwrap(), &settings)
            });
            let told = landed.map(|landing| {
                let forces = landing.max_strut_force;
                let friction = landing
                    .energies
                    .legs
                    .map(|leg| leg.pad_friction + leg.block_friction);
                [
                    [
                        landing.end_time,
                        landing.min_stability_angle,
                        landing.min_clearance,
                    ],
                    [forces[0], forces[1], forces[2]].map(|force| 1e-3 * force),
                    [friction[0], friction[1], friction[2]].map(|work| 1e-2 * work),
                ]
            });
            let [one, other] = told.map(|numbers| numbers.as_flattened().to_vec());
            for (one, other) in one.iter().zip(&other) {
                assert!(
                    (one - other).abs() < 1e-7,
                    "{rules:?}, {direction}: {told:?}"
                );
            }
        }
    }
}
