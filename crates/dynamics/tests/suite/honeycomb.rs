//! Struts with honeycomb cartridges: the law of the cartridge, and landings on it.

use crate::common::scenes::history;
use crate::common::{even_inertia, level, settings, surveyor_leg};
use std::f64::consts::TAU;
use touchdown_dynamics::crush::{Crush, CrushLaw};
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::integrator::event::Exit;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, Scene};
use touchdown_dynamics::vehicle::{Honeycomb, Leg, Strut, StrutElement, Vehicle};

/// Stiffness of unloading, lb/ft.
const STIFFNESS: f64 = 40_000.0;

/// A cartridge with a step up, a slope and a step down.
fn cartridge() -> Vec<[f64; 2]> {
    vec![
        [0.0, 900.0],
        [0.05, 900.0],
        [0.05, 1500.0],
        [0.15, 1700.0],
        [0.15, 1400.0],
    ]
}

fn honeycomb() -> Honeycomb {
    Honeycomb {
        unloading_stiffness: STIFFNESS,
        crush_load: CrushLoad::new(cartridge()).unwrap(),
    }
}

/// A lander with so many legs, its struts with a cartridge and this friction. Its pads hardly give way, and blocks it has none.
fn lander(legs: usize, friction: f64) -> Vehicle {
    let legs = (0..legs).map(|leg| {
        let mut design = surveyor_leg((leg as f64 / legs as f64 * TAU).to_degrees());
        design.strut = Strut {
            friction_fraction: friction,
            element: StrutElement::Honeycomb(honeycomb()),
            ..design.strut
        };
        design.footpad.crush_pressure *= 10.0;
        design.block = None;
        Leg::new(design).unwrap()
    });
    let legs: Vec<Leg> = legs.collect();
    Vehicle::new(20.0, 5.31, 1.445, even_inertia(142.0), legs)
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// Work that crushes a cartridge to this stroke (ft), and the load there: the table, risen to at the elastic stiffness.
fn crushed(stroke: f64) -> (f64, f64) {
    let front = CrushLoad::new(cartridge()).unwrap().front(STIFFNESS);
    let (mut work, mut load, mut lower) = (0.0, 0.0, 0.0);
    for line in front {
        let upper = line.upper.min(stroke);
        let at = |stroke: f64| line.offset + line.slope * stroke;
        work += 0.5 * (at(lower) + at(upper)) * (upper - lower);
        (load, lower) = (at(upper), upper);
        if upper == stroke {
            break;
        }
    }
    (work, load)
}

#[test]
fn a_strut_crushes_along_its_table_and_keeps_its_set() {
    let vehicle = lander(3, 0.0);
    let scene = Scene::new(Conditions {
        slope: 0.0,
        vertical_velocity: 10.0,
        ..level(180.0, 0.0, 0.0)
    })
    .unwrap();
    let (landing, instants) = history(&vehicle, &scene, &settings(1e-9), 1e-4);
    assert!(
        landing.outcome.class() == Class::Stable,
        "{}",
        landing.outcome
    );
    assert!(landing.energies.closure().abs() < 1e-4);
    let mut deepest = 0.0_f64;
    for instant in &instants {
        let leg = &instant.legs[0];
        deepest = deepest.max(leg.stroke);
        let (work, load) = crushed(deepest);
        let elastic = load - STIFFNESS * (deepest - leg.stroke);
        let expected = elastic.max(0.0);
        // Between two instants of the history the strut may have gone deeper by a little.
        assert!(
            (leg.strut_force - expected).abs() < 2.0,
            "{}: {} lb, expected {expected}",
            instant.time,
            leg.strut_force
        );
        assert!(leg.strut_force >= 0.0, "it never pulls");
        let stored_or_lost = work - (load * load - expected * expected) / (2.0 * STIFFNESS);
        assert!(
            (leg.work.strut - stored_or_lost).abs() < 0.05 + 1e-3 * work,
            "{}: {} ft lb, {stored_or_lost}",
            instant.time,
            leg.work.strut
        );
    }
    // It has passed the step up and comes to rest elastically below the front.
    assert!(deepest > 0.1, "{deepest} ft");
    let stroke = landing.max_stroke[0];
    assert!((stroke - deepest).abs() < 1e-4);
}

#[test]
fn friction_of_the_strut_adds_its_fraction_of_the_load() {
    let [smooth, rough] = [0.0, 0.2].map(|friction| {
        let scene = Scene::new(Conditions {
            slope: 0.0,
            vertical_velocity: 10.0,
            ..level(180.0, 0.0, 0.0)
        });
        land(&lander(3, friction), &scene.unwrap(), &settings(1e-8))
    });
    assert!(rough.energies.closure().abs() < 1e-3);
    let [smooth, rough] =
        [smooth, rough].map(|landing| (landing.max_stroke[0], landing.max_strut_force[0]));
    assert!(rough.0 < smooth.0, "{rough:?}, {smooth:?}");
    // The greatest load of the table that the stroke has passed.
    let load = if rough.0 > 0.15 {
        1700.0
    } else {
        crushed(rough.0).1
    };
    assert!(
        (rough.1 / (1.2 * load) - 1.0).abs() < 1e-3,
        "{} lb of {load}",
        rough.1
    );
}

#[test]
fn a_cartridge_unloads_and_reloads_elastically() {
    let law = CrushLaw::of_cartridge(&honeycomb());
    let mut cartridge = Crush::untouched(&law);
    let load = |cartridge: &Crush, stroke: f64| cartridge.line(&law).at(stroke);
    // Elastic up to the first load, then on the table, over its step up and on.
    let go = |cartridge: &mut Crush, stroke: f64| {
        while let Some(exit) = cartridge.interference_bounds(&law, false).exit(stroke) {
            cartridge.cross_interference(&law, exit, stroke, true);
        }
    };
    go(&mut cartridge, 0.01);
    assert_eq!(load(&cartridge, 0.01), 400.0);
    go(&mut cartridge, 0.03);
    assert_eq!(load(&cartridge, 0.03), 900.0);
    go(&mut cartridge, 0.11);
    assert!((load(&cartridge, 0.11) - 1620.0).abs() < 1e-9);
    // Turning back leaves the front: the set stays.
    assert_eq!(cartridge.rate_bounds().exit(-1.0), Some(Exit::Below));
    cartridge.leave_front(&law, 0.11);
    let set = 0.11 - 1620.0 / STIFFNESS;
    assert!((cartridge.set_at(&law, 0.1) - set).abs() < 1e-15);
    assert!((load(&cartridge, 0.1) - (0.1 - set) * STIFFNESS).abs() < 1e-9);
    // Unloaded it does not pull.
    go(&mut cartridge, 0.05);
    assert_eq!(load(&cartridge, 0.05), 0.0);
    // It carries again beyond its set, and crushes again where it left off.
    go(&mut cartridge, 0.1);
    assert!((load(&cartridge, 0.1) - (0.1 - set) * STIFFNESS).abs() < 1e-9);
    go(&mut cartridge, 0.12);
    assert!((load(&cartridge, 0.12) - 1640.0).abs() < 1e-9);
    // A step down leaves it on the lower load.
    go(&mut cartridge, 0.16);
    assert_eq!(load(&cartridge, 0.16), 1400.0);
}

/// Landings down a slope: the account closes, tolerances agree, and turning a lander by its symmetry changes nothing.
#[test]
fn landings_on_honeycomb_close_their_accounts_and_converge() {
    for legs in [3, 4, 6] {
        let vehicle = lander(legs, 0.05);
        for (speed, roll) in [(4.0, 0.0), (8.0, 20.0), (14.0, 10.0)] {
            let scene = |roll: f64| {
                let conditions = level(180.0, roll, speed);
                Scene::new(Conditions {
                    vertical_velocity: 9.0,
                    ..conditions
                })
                .unwrap()
            };
            let [loose, tight] =
                [1e-6, 1e-9].map(|tolerance| land(&vehicle, &scene(roll), &settings(tolerance)));
            assert_eq!(
                loose.outcome.class(),
                tight.outcome.class(),
                "{legs} legs, {speed} ft/s"
            );
            assert!(
                tight.energies.closure().abs() < 1e-3,
                "{}",
                tight.energies.closure()
            );
            let apart = (loose.min_stability_angle - tight.min_stability_angle).abs();
            assert!(apart < 1e-3, "{legs} legs, {speed} ft/s: {apart} rad");
            let turned = scene(roll + 360.0 / legs as f64);
            let turned = land(&vehicle, &turned, &settings(1e-9));
            assert_eq!(turned.outcome.class(), tight.outcome.class());
            let apart = (turned.min_stability_angle - tight.min_stability_angle).abs();
            assert!(
                apart < 1e-6,
                "{legs} legs, {speed} ft/s, turned: {apart} rad"
            );
        }
    }
}
