//! Landings on legs of three struts: tripods and cantilevers.

use crate::common::random::drawn;
use crate::common::scenes::history;
use crate::common::{even_inertia, ring};
use std::f64::consts::TAU;
use std::sync::Arc;
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::ground::{Ground, LegFooting};
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::parts::{
    Footpad, Honeycomb, Inertia, LegDesign, Linkage, Strut, StrutElement,
};
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings, Stop};
use touchdown_dynamics::soil::{Bearing, Soil};
use touchdown_dynamics::three_strut_leg::ThreeStrutLeg;
use touchdown_dynamics::three_struts::{
    Arrangement, BallFootpad, Foot, LegStrut, Telescope, ThreeStrutDesign,
};
use touchdown_dynamics::vehicle::{Leg, Legs, Vehicle};

const TRIPOD: Arrangement = Arrangement::Tripod;
const CANTILEVER: Arrangement = cantilever(0.0);
/// Tripods, and cantilevers without and with friction of their bearings.
const KINDS: [Arrangement; 3] = [TRIPOD, CANTILEVER, cantilever(0.1)];

const fn cantilever(bearing_friction: f64) -> Arrangement {
    Arrangement::Cantilever(Telescope {
        collar: 6.5,
        bearing_friction,
        bearing_overhang: 5.0,
        bearing_overlap: 4.0,
    })
}

fn load(knots: &[[f64; 2]]) -> Option<CrushLoad> {
    Some(CrushLoad::new(knots.to_vec()).unwrap())
}

/// A leg of a lander of the size of Apollo's.
fn leg(arrangement: Arrangement, azimuth: f64) -> ThreeStrutDesign {
    ThreeStrutDesign {
        azimuth,
        arrangement,
        foot: Foot {
            radius: 14.0,
            depth: 5.0,
            mass: 2.0,
        },
        primary: LegStrut {
            hardpoint_radius: 7.2,
            hardpoint_height: 6.2,
            stiffness: 5e5,
            damping: 200.0,
            square_damping: 0.0,
            compression_stroke: 2.7,
            tension_stroke: 0.2,
            compression_load: load(&[[0.0, 4500.0], [0.83, 4500.0], [0.83, 9500.0]]),
            tension_load: None,
        },
        secondary: LegStrut {
            hardpoint_radius: 7.2,
            hardpoint_height: 0.0,
            stiffness: 5e5,
            damping: 200.0,
            square_damping: 0.0,
            compression_stroke: 1.0,
            tension_stroke: 1.33,
            compression_load: load(&[[0.0, 4500.0]]),
            tension_load: load(&[[0.0, 500.0], [0.33, 500.0], [0.33, 5000.0]]),
        },
        spread: 3.0,
        footpad: BallFootpad {
            diameter: 3.1,
            height: 0.6,
            crush_pressure: 3000.0,
            profile: Profile::new(vec![[0.0, 0.0], [0.02, 1.0], [0.6, 1.0]]).unwrap(),
        },
    }
}

const INERTIA: Inertia = Inertia {
    xx: 16_000.0,
    yy: 17_500.0,
    zz: 18_500.0,
    xy: 300.0,
    xz: -200.0,
    yz: 150.0,
};

/// A lander with so many such legs.
fn lander(arrangement: Arrangement, legs: usize, inertia: Inertia) -> Vehicle {
    let legs = (0..legs).map(|index| {
        let azimuth = index as f64 / legs as f64 * TAU;
        ThreeStrutLeg::new(leg(arrangement, azimuth)).unwrap()
    });
    let legs: Vec<ThreeStrutLeg> = legs.collect();
    Vehicle::new(480.0, 5.31, 4.0, inertia, legs).unwrap()
}

fn settings(tolerance: f64) -> Settings {
    Settings::new(tolerance, 20.0, CrushRule::Section).unwrap()
}

/// To this time (s), whatever the verdict.
fn until(time: f64) -> Settings {
    Settings::new(1e-6, time, CrushRule::Section)
        .unwrap()
        .stopping_at(Stop::Time)
}

fn conditions() -> Conditions {
    let level = Euler {
        pitch: 0.0,
        yaw: 0.0,
        roll: 0.0,
    };
    Conditions {
        vertical_velocity: 10.0,
        horizontal_velocity: 0.0,
        cross_slope: 0.0,
        attitude: Attitude::from_euler(level),
        angular_velocity: [0.0; 3],
        slope: 0.0,
        pad_friction: 0.4,
        block_friction: 0.4,
        static_friction_ratio: None,
        soil: Default::default(),
        ground: Default::default(),
        gravity: None,
        thrust: Default::default(),
    }
}

fn landed(vehicle: &Vehicle, conditions: Conditions, tolerance: f64) -> Landing {
    land(
        vehicle,
        &Scene::new(conditions).unwrap(),
        &settings(tolerance),
    )
}

/// Wild touchdowns: kind, number of legs, attitude, speeds, slope, friction, soil.
fn wild(nth: usize) -> (Vehicle, Conditions) {
    let numbers = drawn(&proptest::array::uniform16(-1.0..1.0f64), 51, nth);
    let [
        p,
        y,
        r,
        vv,
        vh,
        cross,
        slope,
        friction,
        kind,
        legs,
        wx,
        wy,
        wz,
        soil,
        ..,
    ] = numbers;
    let arrangement = KINDS[(1.5 * (kind + 1.0)) as usize];
    let vehicle = lander(arrangement, 3 + ((legs + 1.0) * 2.0) as usize, INERTIA);
    let bearing = || {
        let bearing = Bearing::new(4000.0, 0.4, 1.0, 0.02).unwrap();
        bearing.with_inertial_drag(3.0).unwrap()
    };
    let conditions = Conditions {
        vertical_velocity: 8.0 + 4.0 * vv,
        horizontal_velocity: 6.0 * (1.0 + vh),
        cross_slope: 3.2 * cross,
        attitude: Attitude::from_euler(Euler {
            pitch: 0.15 * p,
            yaw: 0.15 * y,
            roll: 3.0 * r,
        }),
        angular_velocity: [wx, wy, wz].map(|rate| 0.05 * rate),
        slope: 0.2 * slope,
        pad_friction: 0.5 + 0.5 * friction,
        soil: if soil > 0.3 {
            Soil::Yielding(bearing())
        } else {
            Soil::Rock
        },
        ..conditions()
    };
    (vehicle, conditions)
}

#[test]
fn wild_landings_end_and_their_energy_accounts_close() {
    let mut classes = Vec::new();
    for nth in 0..24 {
        let (vehicle, conditions) = wild(nth);
        let landing = landed(&vehicle, conditions, 1e-5);
        let energies = &landing.energies;
        let closure = energies.closure() / energies.initial_kinetic;
        assert!(closure.abs() < 1e-5, "landing {nth}: {closure:e}");
        assert_eq!(energies.given_by_contact(), 0.0, "landing {nth}");
        let class = landing.outcome.class();
        assert_ne!(
            class,
            Class::Failure,
            "landing {nth}: {:?}",
            landing.outcome
        );
        assert!(
            landing
                .max_stroke_share
                .iter()
                .all(|share| *share <= 1.0 + 1e-6)
        );
        classes.push(class);
    }
    for class in [Class::Stable, Class::Bottomed] {
        assert!(classes.contains(&class), "{class:?} among {classes:?}");
    }
}

/// A vehicle turned by the angle between its legs is the same vehicle with its legs in another order, and its mirror image
/// lands as mirrored.
#[test]
fn turned_and_mirrored_landings_are_alike() {
    let even = even_inertia(17_000.0);
    for arrangement in KINDS {
        let vehicle = lander(arrangement, 4, even);
        let rolled = |roll: f64, cross_slope: f64| {
            let attitude = Attitude::from_euler(Euler {
                pitch: 0.0,
                yaw: 0.0,
                roll,
            });
            let conditions = Conditions {
                horizontal_velocity: 7.0,
                cross_slope,
                attitude,
                slope: 0.15,
                ..conditions()
            };
            landed(&vehicle, conditions, 1e-7)
        };
        let landing = rolled(0.2, 2.6);
        let turned = rolled(0.2 + TAU / 4.0, 2.6);
        let mirrored = rolled(-0.2, -2.6);
        for leg in 0..4 {
            let stroke = landing.max_stroke[leg];
            // Turned by a quarter, the next leg stands where a leg stood; mirrored, the legs at the sides change places.
            let images = [
                turned.max_stroke[(leg + 3) % 4],
                turned.max_stroke[(leg + 1) % 4],
                mirrored.max_stroke[(4 - leg) % 4],
            ];
            let off = images.map(|image| (image - stroke).abs());
            assert!(
                off[0].min(off[1]) < 1e-5,
                "{arrangement:?}, leg {leg}: {off:?}"
            );
            assert!(off[2] < 1e-5, "{arrangement:?}, leg {leg}: {off:?}");
        }
        for other in [&turned, &mirrored] {
            assert_eq!(landing.outcome, other.outcome);
            assert!((landing.min_stability_angle - other.min_stability_angle).abs() < 1e-6);
        }
    }
}

/// A light foot on ground without friction slides so that the struts push it along the vertical alone. That gives the load of
/// the secondary struts and the force on the body while the primary struts crush under a constant load.
#[test]
fn struts_that_crush_slow_the_body_as_in_closed_form() {
    for arrangement in KINDS {
        let legs: Vec<ThreeStrutLeg> = (0..4)
            .map(|index| {
                let mut design = leg(arrangement, f64::from(index) / 4.0 * TAU);
                design.foot.mass = 0.02;
                design.secondary.compression_load = None;
                design.secondary.tension_load = None;
                design.secondary.stiffness = 5e6;
                design.primary.damping = 0.0;
                design.footpad.crush_pressure = 1e5;
                ThreeStrutLeg::new(design).unwrap()
            })
            .collect();
        let [primary, secondary] = pushes(legs[0].design());
        // Horizontally: P p + 2 S s = 0, and friction of the bearings adds its part of the side load 2 |S s| to P.
        let side_load = (primary[0] / secondary[0]).abs() * f64::hypot(secondary[0], secondary[1]);
        let rubbing = match arrangement {
            Arrangement::Tripod => 0.0,
            Arrangement::Cantilever(telescope) => {
                telescope.bearing_friction * (1.0 + 2.0 * 5.0 / 4.0)
            }
        };
        let crushed = 4500.0 / (1.0 - rubbing * side_load);
        let load = -crushed * primary[0] / (2.0 * secondary[0]);
        let force = crushed * primary[1] + 2.0 * load * secondary[1];
        let vehicle = Vehicle::new(480.0, 5.31, 4.0, even_inertia(17_000.0), legs).unwrap();
        let scene = Scene::new(Conditions {
            vertical_velocity: 5.0,
            pad_friction: 0.0,
            ..conditions()
        });
        let (_, instants) = history(&vehicle, &scene.unwrap(), &until(0.02), 0.0005);
        let at = |time: f64| {
            let found = instants.iter().find(|at| at.time >= time - 1e-9).unwrap();
            (
                found.velocity.z,
                found.legs[0].three_strut().unwrap().secondary_forces,
            )
        };
        // After the first oscillations of the foot, and before the legs have turned far.
        let ((before, _), (after, loads)) = (at(0.004), at(0.016));
        let found = (before - after) / 0.012;
        let expected = 4.0 * force / 480.0 - 5.31;
        assert!(
            (found / expected - 1.0).abs() < 0.03,
            "{arrangement:?}: {found} for {expected} ft/s²"
        );
        assert!(
            (loads[0] / load - 1.0).abs() < 0.05,
            "{arrangement:?}: {loads:?} for {load} lb"
        );
    }
}

/// Force on the foot (outboard, down) per load of the primary strut and of a secondary strut, at rest.
fn pushes(design: &ThreeStrutDesign) -> [[f64; 2]; 2] {
    let (foot, [upper, side, _]) = design.places();
    let along = (foot - upper).normalize();
    let own = match design.arrangement {
        Arrangement::Tripod => (foot - side).normalize(),
        Arrangement::Cantilever(Telescope { collar, .. }) => {
            let toward = (upper + along * collar - side).normalize();
            (toward - along * along.dot(&toward)) * (collar / (foot - upper).norm())
        }
    };
    [along, own].map(|push| [push.x, push.z])
}

/// Legs whose secondary struts hardly give way, with feet that weigh little, turn about the line through their hardpoints: they
/// land as hinged legs do. Elasticity and mass of the feet each make up a few 1e-4 ft of what is left.
#[test]
fn with_rigid_secondary_struts_a_leg_turns_about_one_hinge() {
    let [soft, stiff] = [0.0625, 4.0].map(difference_from_hinged_legs);
    assert!(stiff < 2e-4, "{stiff:e} ft of 0.63");
    assert!(soft > 50.0 * stiff, "{soft:e} ft");
}

/// Greatest difference of a stroke (ft) between landings on hinged legs and on tripods with secondary struts this many times
/// as stiff, and feet as much lighter.
fn difference_from_hinged_legs(stiffer: f64) -> f64 {
    let foot_mass = 0.05 / stiffer;
    let footpad = Footpad {
        diameter: 0.02,
        height: 0.004,
        crush_pressure: 1e8,
        inertia: 1e-3,
        hinge_damping: 0.0,
        minimum_angle: -1.2,
        maximum_angle: 1.4,
        profile: Profile::new(vec![[0.0, 0.0], [0.002, 1.0], [0.004, 1.0]]).unwrap(),
        edge: None,
    };
    let [radius, reach, drop, spread] = [2.0, 5.0, 4.0, 2.0];
    let [out, up] = [0.5, 3.0];
    let load = || CrushLoad::new(vec![[0.0, 900.0], [0.6, 1200.0]]).unwrap();
    let link = f64::hypot(reach, drop);
    let strut = f64::hypot(reach - out, drop + up);
    let hinged: Vec<Leg> = (0..4)
        .map(|index| {
            Leg::new(LegDesign {
                azimuth: f64::from(index) / 4.0 * TAU,
                linkage: Linkage {
                    lower_hardpoint_radius: radius,
                    lower_link_length: link,
                    hardpoint_distance: f64::hypot(out, up),
                    hardpoint_angle: f64::atan2(out, up),
                    inertia: foot_mass * link * link,
                },
                strut: Strut {
                    extended_length: strut,
                    minimum_length: strut - 2.0,
                    friction_fraction: 0.0,
                    element: StrutElement::Honeycomb(Honeycomb {
                        unloading_stiffness: 1e5,
                        crush_load: load(),
                    }),
                },
                footpad: footpad.clone(),
                block: None,
            })
            .unwrap()
        })
        .collect();
    let three: Vec<ThreeStrutLeg> = (0..4)
        .map(|index| {
            let stiff = LegStrut {
                hardpoint_radius: radius,
                hardpoint_height: 0.0,
                stiffness: 1e6 * stiffer,
                damping: 50.0,
                square_damping: 0.0,
                compression_stroke: 1.0,
                tension_stroke: 1.0,
                compression_load: None,
                tension_load: None,
            };
            ThreeStrutLeg::new(ThreeStrutDesign {
                azimuth: f64::from(index) / 4.0 * TAU,
                arrangement: TRIPOD,
                foot: Foot {
                    radius: radius + reach,
                    depth: drop,
                    mass: foot_mass,
                },
                primary: LegStrut {
                    hardpoint_radius: radius + out,
                    hardpoint_height: up,
                    stiffness: 1e5,
                    damping: 0.0,
                    compression_stroke: 2.0,
                    compression_load: Some(load()),
                    ..stiff.clone()
                },
                secondary: stiff,
                spread,
                footpad: BallFootpad {
                    diameter: footpad.diameter,
                    height: footpad.height,
                    crush_pressure: footpad.crush_pressure,
                    profile: footpad.profile.clone(),
                },
            })
            .unwrap()
        })
        .collect();
    let vehicle = |legs: Legs| Vehicle::new(60.0, 5.31, 2.0, even_inertia(300.0), legs).unwrap();
    let conditions = Conditions {
        vertical_velocity: 9.0,
        horizontal_velocity: 3.0,
        cross_slope: 0.4,
        pad_friction: 0.0,
        ..conditions()
    };
    let [one, other] = [vehicle(hinged.into()), vehicle(three.into())]
        .map(|vehicle| land(&vehicle, &Scene::new(conditions).unwrap(), &until(0.25)));
    assert_eq!(one.outcome.class(), other.outcome.class());
    (one.max_stroke.iter().zip(&other.max_stroke))
        .fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// Tighter tolerances come closer to the same landing, in proportion.
#[test]
fn landings_converge_with_the_tolerance() {
    for arrangement in KINDS {
        let vehicle = lander(arrangement, 4, INERTIA);
        let strokes = |tolerance| {
            let conditions = Conditions {
                horizontal_velocity: 4.0,
                cross_slope: 2.5,
                slope: 0.1,
                ..conditions()
            };
            landed(&vehicle, conditions, tolerance).max_stroke
        };
        let best = strokes(1e-9);
        let error = |tolerance| {
            let strokes = strokes(tolerance);
            (strokes.iter().zip(&best)).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
        };
        let [loose, tight] = [1e-4, 1e-6].map(error);
        assert!(loose < 1e-3, "{arrangement:?}: {loose:e}");
        assert!(
            tight < 1e-5 && tight < 0.1 * loose,
            "{arrangement:?}: {tight:e} after {loose:e}"
        );
    }
}

/// At rest the ground bears the weight of body and feet, and each foot stands still.
#[test]
fn at_rest_the_ground_bears_the_weight() {
    for arrangement in KINDS {
        let vehicle = lander(arrangement, 4, INERTIA);
        let scene = Scene::new(conditions()).unwrap();
        let (_, instants) = history(&vehicle, &scene, &until(4.0), 0.05);
        let last = instants.last().unwrap();
        let borne: f64 = last.legs.iter().map(|leg| leg.pad_normal).sum();
        let weight = 5.31 * (480.0 + 4.0 * 2.0);
        assert!(
            (borne / weight - 1.0).abs() < 0.02,
            "{borne} for {weight} lb"
        );
        assert!(last.velocity.norm() < 0.05, "{}", last.velocity);
    }
}

/// Greatest height to which its kinetic energy would lift the vehicle in the last 0.7 s of landings that end stable so, ft.
fn greatest_last_lift(stop: Stop) -> f64 {
    let vehicle = lander(Arrangement::Tripod, 4, INERTIA);
    let weight = vehicle.mass() * 5.31;
    let lifts = (0..16).filter_map(|nth| {
        let touchdown = Conditions {
            horizontal_velocity: 0.3 * f64::from(nth),
            cross_slope: 0.4 * f64::from(nth),
            slope: 0.02 * f64::from(nth % 5),
            ..conditions()
        };
        let settings = settings(3e-5).stopping_at(stop);
        let (landing, instants) =
            history(&vehicle, &Scene::new(touchdown).unwrap(), &settings, 0.01);
        let last = instants
            .iter()
            .filter(|one| one.time > landing.end_time - 0.7);
        let energy = last.map(|one| one.kinetic_energy).fold(0.0, f64::max);
        (landing.outcome == Outcome::StableSubsided).then_some(energy / weight)
    });
    lifts.fold(0.0, f64::max)
}

/// Feet are some 17 ft from the CG, which bounds the height over any edge of them. They stand for longer than 0.7 s.
#[test]
fn a_verdict_allows_a_tenth_of_the_toppling_energy_and_rest_a_fiftieth() {
    let [at_verdict, at_rest] = [Stop::Verdict, Stop::Rest].map(greatest_last_lift);
    assert!(at_verdict < 0.1 * 17.0, "{at_verdict} ft");
    assert!(
        at_rest < at_verdict && at_rest < 0.02 * 17.0,
        "{at_rest} ft"
    );
}

/// Feet are where their velocities take them.
#[test]
fn histories_tell_how_feet_move() {
    let vehicle = lander(TRIPOD, 3, INERTIA);
    let scene = Scene::new(Conditions {
        horizontal_velocity: 3.0,
        ..conditions()
    });
    let interval = 1e-4;
    let (_, instants) = history(&vehicle, &scene.unwrap(), &until(0.1), interval);
    let of_feet = |k: usize| {
        let instant = &instants[k];
        let turned = instant.attitude.matrix();
        let legs = instant.legs.iter().map(|leg| leg.three_strut().unwrap());
        legs.map(|leg| (instant.position + turned * leg.foot, leg.velocity))
            .collect::<Vec<_>>()
    };
    let mut fastest = 0.0_f64;
    for k in 1..1000 {
        for (before, after) in of_feet(k - 1).into_iter().zip(of_feet(k)) {
            let moved = (after.0 - before.0) / interval;
            let off = moved - 0.5 * (before.1 + after.1);
            assert!(off.norm() < 0.05, "{off} of {moved}");
            fastest = fastest.max(moved.norm());
        }
    }
    assert!(fastest > 10.0);
}

/// Soil that is stronger under all legs is that stronger soil, bit for bit; a foot on stronger soil than the others sinks less.
#[test]
fn soil_of_its_own_under_each_leg() {
    let vehicle = lander(CANTILEVER, 4, INERTIA);
    let on = |strength: f64, factors: [f64; 4]| {
        let ground = factors.map(|bearing_factor| LegFooting {
            bearing_factor,
            ..LegFooting::SURFACE
        });
        let conditions = Conditions {
            soil: Soil::Yielding(Bearing::new(strength, 0.164, 1.0, 0.004).unwrap()),
            ground: Ground::new(&ground).unwrap(),
            ..conditions()
        };
        landed(&vehicle, conditions, 1e-6)
    };
    assert_eq!(on(500.0, [1.5; 4]), on(750.0, [1.0; 4]));
    let sinkage = on(500.0, [1.0, 1.0, 4.0, 1.0]).max_sinkage;
    for leg in [0, 1, 3] {
        assert!(sinkage[2] < 0.5 * sinkage[leg], "{sinkage:?}");
    }
}

/// In a batch they land as alone, beside vehicles on hinged legs.
#[test]
fn a_batch_lands_them_as_alone() {
    let (scene, settings) = (Scene::new(conditions()).unwrap(), settings(1e-5));
    let vehicles = [Arc::new(ring(4)), Arc::new(lander(TRIPOD, 4, INERTIA))];
    let mut requests = (0..6).map(|key| Request {
        key,
        vehicle: Arc::clone(&vehicles[key % 2]),
        scene,
        settings,
    });
    let mut landed = 0;
    land_many(&mut || requests.next(), &mut |key, landing| {
        assert_eq!(landing, land(&vehicles[key % 2], &scene, &settings));
        landed += 1;
    });
    assert_eq!(landed, 6);
    // A batch that begins with one of them lands all one by one.
    let mut requests = (0..2).map(|key| Request {
        key,
        vehicle: Arc::clone(&vehicles[1 - key]),
        scene,
        settings,
    });
    land_many(&mut || requests.next(), &mut |key, landing| {
        assert_eq!(landing, land(&vehicles[1 - key], &scene, &settings));
    });
}

#[test]
fn legs_that_cannot_hold_a_foot_are_refused() {
    let refused = |change: fn(&mut ThreeStrutDesign)| {
        let mut design = leg(CANTILEVER, 0.0);
        change(&mut design);
        let invalid = ThreeStrutLeg::new(design).unwrap_err();
        format!(
            "{} = {}: {}",
            invalid.quantity, invalid.value, invalid.allowed
        )
    };
    for (change, expected) in [
        (
            (|leg| leg.primary.compression_stroke = 20.0) as fn(&mut ThreeStrutDesign),
            "primary.compression_stroke_ft = 20: less than the strut is long at rest",
        ),
        (
            |leg| leg.arrangement = Arrangement::Cantilever(Telescope::without_friction(12.0)),
            "linkage.collar_ft = 12: less than the primary strut is long when it bottoms",
        ),
        (
            |leg| {
                leg.arrangement = cantilever(0.1);
                leg.primary.compression_stroke = 5.5;
            },
            "linkage.bearing_overhang_ft = 5: 5.5000 < value ≤ 6.6027 ft: the foot stays outside",
        ),
        (
            |leg| {
                leg.arrangement = cantilever(0.1);
                leg.primary.tension_stroke = 4.0;
            },
            "linkage.bearing_overlap_ft = 4: 4.0000 < value ≤ 5.4027 ft: the piston stays inside",
        ),
        (
            |leg| leg.spread = 0.01,
            "linkage (volume that the directions of the three struts span) = ",
        ),
        (
            |leg| leg.foot.mass = 0.0,
            "linkage.foot_mass_slug = 0: 0 < value",
        ),
        (
            |leg| leg.secondary.damping = -1.0,
            "secondary.damping_lb_s_per_ft = -1: 0 ≤ value",
        ),
    ] {
        let found = refused(change);
        assert!(found.starts_with(expected), "{found}");
    }
}
