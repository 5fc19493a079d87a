//! Symmetries of the vehicle are symmetries of its landings.

use crate::common::random::{crush_rule, fixed_list, usual_conditions};
use crate::common::scenes::history;
use crate::common::{
    OFFSET, PRINCIPAL, even_inertia, level, ring, sample_deck, settings, surveyor, surveyor_leg,
    table_4_1,
};
use nalgebra::{Matrix3, Rotation3, Vector3};
use rayon::prelude::*;
use touchdown_dynamics::attitude::{Attitude, Euler, Tip};
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::LegInstant;
use touchdown_dynamics::outcome::{Class, Failure, Outcome};
use touchdown_dynamics::record::{Instant, Landing};
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::vehicle::{Leg, Vehicle};

/// Touchdowns that turn as well.
fn touchdowns(count: usize) -> Vec<(Conditions, CrushRule)> {
    fixed_list(&(usual_conditions(), crush_rule()), count)
        .into_iter()
        .map(|(conditions, rule)| {
            let angular_velocity = [0.1, -0.2, 0.3];
            (
                Conditions {
                    angular_velocity,
                    ..conditions
                },
                rule,
            )
        })
        .collect()
}

/// How far two landings are from being images of each other.
#[derive(Clone, Copy)]
struct Deviation {
    /// Of the histories up to the earlier end, ft and rad.
    motion: f64,
    /// Of end time (s), least stability angle (rad) and clearance (ft).
    end: f64,
}

impl Deviation {
    fn max(self, other: Self) -> Self {
        Self {
            motion: self.motion.max(other.motion),
            end: self.end.max(other.end),
        }
    }
}

/// A landing and its image.
struct Pair {
    deviation: Deviation,
    /// How far the landing itself goes astray when its velocity differs by rounding; looked at where the image does.
    astray: Deviation,
}

/// What is asked of all images but those of landings that go astray by rounding.
const LIMIT: f64 = 1e-5;
/// Changes of velocity, in units of its last place, that show whether a landing does.
const NUDGES: [f64; 8] = [-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0];
/// How much further astray than by any nudge an image may be: it differs by more roundings than one.
const FURTHER: f64 = 10.0;

type Followed = (Landing, Vec<Instant>);

/// Lands a vehicle from `conditions` and its image from their `image`. The CG moves to `image_position`, leg `j`
/// becomes leg `image_leg[j]`.
fn compare(
    [vehicle, image_vehicle]: [&Vehicle; 2],
    image: impl Fn(&Conditions) -> Conditions + Sync,
    image_position: impl Fn(Vector3<f64>) -> Vector3<f64> + Sync,
    image_leg: &[usize],
) -> Vec<Pair> {
    let same: Vec<usize> = (0..image_leg.len()).collect();
    // Legs more than three cost more, and the same law is asked of them.
    touchdowns(if same.len() > 3 { 25 } else { 100 })
        .par_iter()
        .map(|(conditions, rule)| {
            let settings = Settings::new(1e-6, 1.5, *rule).unwrap();
            let landing = |vehicle: &Vehicle, conditions: Conditions| {
                history(vehicle, &Scene::new(conditions).unwrap(), &settings, 0.05)
            };
            let one = landing(vehicle, *conditions);
            let other = landing(image_vehicle, image(conditions));
            // When motion counts as subsided is no symmetric notion: within the time limit it may or may not.
            let is_over =
                |outcome: &Outcome| !matches!(outcome.class(), Class::Stable | Class::Undecided);
            let (end, image_end) = (mapped(&one.0.outcome, image_leg), &other.0.outcome);
            assert_eq!(is_over(&end), is_over(image_end), "{conditions:?}");
            if is_over(&end) {
                assert_eq!(end, *image_end, "{conditions:?}");
            }
            let deviation = apart(&one, &other, &image_position, image_leg);
            let mut astray = Deviation {
                motion: 0.0,
                end: 0.0,
            };
            if deviation.motion.max(deviation.end) > LIMIT {
                for nudge in NUDGES {
                    let horizontal_velocity =
                        conditions.horizontal_velocity * (1.0 + nudge * f64::EPSILON);
                    let nudged = Conditions {
                        horizontal_velocity,
                        ..*conditions
                    };
                    let nudged = landing(vehicle, nudged);
                    astray = astray.max(apart(&one, &nudged, &|position| position, &same));
                }
            }
            Pair { deviation, astray }
        })
        .collect()
}

/// How far a landing is from being the image of another.
fn apart(
    (one, instants): &Followed,
    (other, images): &Followed,
    image_position: &impl Fn(Vector3<f64>) -> Vector3<f64>,
    image_leg: &[usize],
) -> Deviation {
    let compared = instants.len().min(images.len()) - 1;
    let motion = (instants.iter().zip(images).take(compared))
        .flat_map(|(instant, other)| {
            let position = (image_position(instant.position) - other.position).norm();
            let link = |leg: &LegInstant| leg.hinged().unwrap().link_angle;
            let links = image_leg
                .iter()
                .zip(&instant.legs)
                .map(move |(&image, leg)| link(leg) - link(&other.legs[image]));
            links.chain([position, instant.clearance - other.clearance])
        })
        .fold(0.0, |worst: f64, off| worst.max(off.abs()));
    let end = [
        one.end_time - other.end_time,
        one.min_stability_angle - other.min_stability_angle,
        one.min_clearance - other.min_clearance,
    ]
    .into_iter()
    .fold(0.0, |worst: f64, off| worst.max(off.abs()));
    Deviation { motion, end }
}

/// Only rounding tells images apart. It grows where a vehicle bounces, in one landing of a hundred by so much that
/// it cannot tell its image from itself after a nudge.
fn check(what: &str, pairs: &[Pair], number: fn(&Deviation) -> f64) {
    let mut sorted: Vec<f64> = pairs.iter().map(|pair| number(&pair.deviation)).collect();
    sorted.sort_by(f64::total_cmp);
    let (most, worst) = (sorted[sorted.len() * 9 / 10], sorted[sorted.len() - 1]);
    println!("{what}: nine of ten within {most:.1e}, all within {worst:.1e}");
    assert!(most < 1e-9, "{what}: {most:e}");
    let beyond: Vec<_> = (pairs.iter())
        .map(|pair| [number(&pair.deviation), number(&pair.astray)])
        .filter(|[deviation, _]| *deviation > LIMIT)
        .collect();
    println!("{what}: beyond the limit, and astray by nudges: {beyond:?}");
    assert!(beyond.len() <= pairs.len() / 100, "{what}: {beyond:?}");
    assert!(
        beyond
            .iter()
            .all(|[deviation, astray]| *deviation < FURTHER * astray),
        "{what}: {beyond:?}"
    );
}

fn mapped(outcome: &Outcome, image_leg: &[usize]) -> Outcome {
    match outcome {
        Outcome::Bottomed { leg } => Outcome::Bottomed {
            leg: image_leg[*leg],
        },
        Outcome::BottomedPad { leg } => Outcome::BottomedPad {
            leg: image_leg[*leg],
        },
        Outcome::BottomedBlock { leg } => Outcome::BottomedBlock {
            leg: image_leg[*leg],
        },
        Outcome::Failure(Failure::PadInclination { leg }) => {
            Outcome::Failure(Failure::PadInclination {
                leg: image_leg[*leg],
            })
        }
        other => other.clone(),
    }
}

/// Where the CG is off the centreline, ft.
const OFFSETS: [[f64; 2]; 2] = [[0.0; 2], OFFSET];

fn off_by(vehicle: Vehicle, offset: [f64; 2]) -> Vehicle {
    vehicle.with_center_of_gravity_offset(offset).unwrap()
}

#[test]
fn mirror_images() {
    let mirror = |conditions: &Conditions| {
        let Euler { pitch, yaw, roll } = conditions.attitude.euler();
        let [x, y, z] = conditions.angular_velocity;
        Conditions {
            cross_slope: -conditions.cross_slope,
            attitude: Attitude::from_euler(Euler {
                pitch,
                yaw: -yaw,
                roll: -roll,
            }),
            angular_velocity: [x, -y, -z],
            ..*conditions
        }
    };
    let flip = |position: Vector3<f64>| Vector3::new(-position.x, position.y, position.z);
    for offset in OFFSETS {
        let vehicle = || surveyor(1.445, PRINCIPAL);
        let vehicles = [
            off_by(vehicle(), offset),
            off_by(vehicle(), [-offset[0], offset[1]]),
        ];
        let pairs = compare([&vehicles[0], &vehicles[1]], mirror, flip, &[0, 2, 1]);
        check("motion", &pairs, |d| d.motion);
        check("end", &pairs, |d| d.end);
    }
}

#[test]
fn a_third_of_a_turn_permutes_three_legs() {
    turns_permute_legs(3);
}

#[test]
fn a_quarter_of_a_turn_permutes_four_legs() {
    turns_permute_legs(4);
}

#[test]
fn a_sixth_of_a_turn_permutes_six_legs() {
    turns_permute_legs(6);
}

#[test]
fn a_leg_too_short_to_touch_changes_no_motion_and_no_outcome() {
    let three = ring(3);
    let mut legs = three.hinged_legs().to_vec();
    let mut short = surveyor_leg(60.0);
    for length in [
        &mut short.linkage.lower_link_length,
        &mut short.linkage.hardpoint_distance,
        &mut short.strut.extended_length,
        &mut short.strut.minimum_length,
    ] {
        *length *= 0.02;
    }
    short.block = None;
    short.footpad.height = 0.02;
    legs.insert(1, Leg::new(short).unwrap());
    let height = three.center_of_gravity_height();
    let four = Vehicle::new(
        three.mass(),
        three.gravity(),
        height,
        even_inertia(142.22),
        legs,
    )
    .unwrap()
    .with_rules(Rules::REPORT);
    for (conditions, rule) in touchdowns(60) {
        let scene = Scene::new(conditions).unwrap();
        let settings = settings(1e-8).with_crush_rule(rule);
        let [(alone, instants), (beside, others)] =
            [&three, &four].map(|vehicle| history(vehicle, &scene, &settings, 0.05));
        // σ is over other feet, and with it when a vehicle that topples or rocks back is seen to.
        assert_eq!(alone.outcome.class(), beside.outcome.class());
        assert_eq!(beside.pad_contact[1], None);
        let compared = instants.len().min(others.len()) - 1;
        for (one, other) in instants.iter().zip(&others).take(compared) {
            let apart = (one.position - other.position).norm();
            assert!(apart < 1e-7, "{apart} ft");
            for (leg, image) in [0, 2, 3].into_iter().enumerate() {
                let apart = (one.legs[leg].stroke - other.legs[image].stroke).abs();
                assert!(apart < 1e-7, "{apart} ft");
            }
        }
    }
}

#[test]
fn a_foot_that_hangs_a_little_higher_is_one_to_stand_on() {
    // The CG is on its far side of the line between its neighbours by less than it is higher: were the vehicle to topple over
    // that line, the foot would come down at once.
    let raised = 0.02;
    let mut legs = ring(4).hinged_legs().to_vec();
    let mut design = legs[0].design().clone();
    design.footpad.height -= raised;
    legs[0] = Leg::new(design).unwrap();
    let vehicle = Vehicle::new(20.0, 5.31, 1.5417, even_inertia(142.22), legs).unwrap();
    let vehicle = off_by(vehicle, [0.0, -0.2 * raised]);
    for cross_slope_deg in [0.0, 180.0] {
        let scene = Scene::new(Conditions {
            vertical_velocity: 3.0,
            slope: 0.0,
            ..level(cross_slope_deg, 0.0, 1.0)
        })
        .unwrap();
        let landing = land(&vehicle, &scene, &settings(1e-6));
        assert_eq!(landing.outcome, Outcome::StableSubsided);
        assert!(landing.min_stability_angle > 0.8);
    }
}

/// The vehicle turned from leg to leg of its own.
fn turns_permute_legs(legs: usize) {
    let angle = std::f64::consts::TAU / legs as f64;
    let image_leg: Vec<usize> = (0..legs).map(|leg| (leg + 1) % legs).collect();
    let (sine, cosine) = angle.sin_cos();
    let turned = |x: f64, y: f64| [cosine * x + sine * y, cosine * y - sine * x];
    let turn = |conditions: &Conditions| {
        let tip = conditions.attitude.tip();
        let [x, y, z] = conditions.angular_velocity;
        let [x, y] = turned(x, y);
        Conditions {
            attitude: Attitude::from_tip(Tip {
                nominal_roll: tip.nominal_roll + angle,
                ..tip
            }),
            angular_velocity: [x, y, z],
            ..*conditions
        }
    };
    for offset in OFFSETS {
        let image = off_by(ring(legs), turned(offset[0], offset[1]));
        let vehicles = [&off_by(ring(legs), offset), &image];
        let pairs = compare(vehicles, turn, |position| position, &image_leg);
        // Motion counts as subsided by body rates component by component, which do not turn along: the
        // end of a landing is no symmetric notion.
        check("motion", &pairs, |d| d.motion);
    }
}

#[test]
fn legs_in_another_order_are_the_same_lander() {
    // Leg j of the one is leg image_leg[j] of the other.
    for image_leg in [[1, 2, 0], [0, 2, 1]] {
        let one = table_4_1();
        let mut legs = one.hinged_legs().to_vec();
        // One that bottoms before the others.
        let mut weak = legs[1].design().clone();
        weak.strut.minimum_length += 0.1;
        legs[1] = Leg::new(weak).unwrap();
        let mut shuffled = legs.clone();
        for (leg, &image) in legs.iter().zip(&image_leg) {
            shuffled[image] = leg.clone();
        }
        let vehicles = [legs, shuffled].map(|legs| {
            Vehicle::new(20.0, 5.31, 1.445, PRINCIPAL, legs)
                .unwrap()
                .with_center_of_gravity_offset(OFFSET)
                .unwrap()
                .with_rules(Rules::REPORT)
        });
        let pairs = compare(
            [&vehicles[0], &vehicles[1]],
            |conditions| *conditions,
            |position| position,
            &image_leg,
        );
        check("motion", &pairs, |d| d.motion);
        check("end", &pairs, |d| d.end);
    }
}

#[test]
fn a_speed_at_which_directions_begin_has_one() {
    let vehicle = table_4_1();
    for cross_slope_deg in [-90.0, 0.0, 45.0, 90.0, 180.0] {
        let landing = |speed: f64| {
            let scene = Scene::new(Conditions {
                vertical_velocity: 10.0,
                slope: 0.0,
                ..level(cross_slope_deg, 0.0, speed)
            });
            land(&vehicle, &scene.unwrap(), &settings(1e-6))
        };
        let limit = 0.001f64;
        let [below, at, above] = [limit.next_down(), limit, limit.next_up()].map(landing);
        for landing in [&below, &at, &above] {
            assert_eq!(landing.outcome, Outcome::StableSubsided);
        }
        let near =
            |other: &Landing| (at.min_stability_angle - other.min_stability_angle).abs() < 1e-6;
        assert!(near(&above), "{cross_slope_deg} deg");
    }
}

/// The turns and mirrors about the centreline, other than none, that carry every leg to another's place.
fn leg_symmetries() -> [Matrix3<f64>; 5] {
    let turn = |degrees: f64| {
        Rotation3::from_axis_angle(&Vector3::z_axis(), degrees.to_radians()).into_inner()
    };
    let across_leg_1 = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0));
    let mirror = |azimuth: f64| turn(-azimuth) * across_leg_1 * turn(azimuth);
    [
        turn(120.0),
        turn(240.0),
        mirror(0.0),
        mirror(120.0),
        mirror(240.0),
    ]
}

#[test]
fn inertia_leaves_the_surveyor_no_symmetry_of_its_legs() {
    let changes = |vehicle: &Vehicle| {
        let inertia = vehicle.inertia();
        leg_symmetries().map(|g| (g * inertia * g.transpose() - inertia).amax())
    };
    let near = |changes: [f64; 5], expected: [f64; 5]| {
        let all = changes.iter().zip(expected);
        assert!(
            all.clone().all(|(a, b)| (a - b).abs() < 0.005),
            "{changes:?}"
        );
    };
    near(changes(&table_4_1()), [8.94, 11.87, 13.62, 3.03, 8.94]);
    // Its mirror plane is that of leg 1; unequal moments about x and y still forbid any turn.
    let without_products = surveyor(1.445, PRINCIPAL);
    near(changes(&without_products), [2.87, 2.87, 0.0, 2.87, 2.87]);
    near(changes(&sample_deck()), [0.0; 5]);
}
