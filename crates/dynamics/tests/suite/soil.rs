//! Soil that yields under footpads and blocks.

use crate::common::random::{drawn, wild_scene, wild_vehicle};
use crate::common::scenes::history;
use crate::common::{even_inertia, level, ring, surveyor_leg};
use std::f64::consts::FRAC_PI_8;
use touchdown_dynamics::crush::CrushLaw;
use touchdown_dynamics::ground::{Ground, LegFooting};
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::soil::{Bearing, Soil};
use touchdown_dynamics::vehicle::{Leg, Vehicle};

/// Crush pressure of an element, lb/ft².
const PRESSURE: f64 = 1500.0;

/// Relative crush pressure that rises steeply, less steeply, and stays.
fn profile() -> Profile {
    Profile::new(vec![[0.0, 0.0], [0.01, 0.5], [0.1, 0.9], [0.4, 0.9]]).unwrap()
}

fn soil(strength: f64, depth: f64, exponent: f64, rebound: f64) -> Bearing {
    Bearing::new(strength, depth, exponent, rebound).unwrap()
}

/// A lander under the rules that hold for any, its pads and blocks of this profile.
fn lander(profile: &Profile) -> Vehicle {
    let legs = [0.0, 120.0, 240.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.footpad.profile = profile.clone();
        design.footpad.crush_pressure = PRESSURE;
        if let Some(block) = &mut design.block {
            block.profile = profile.clone();
            block.crush_pressure = PRESSURE;
        }
        Leg::new(design).unwrap()
    });
    Vehicle::new(20.0, 5.31, 1.445, even_inertia(142.0), legs)
        .unwrap()
        .with_rules(Rules::PHYSICAL)
}

fn settings(tolerance: f64) -> Settings {
    Settings::new(tolerance, 20.0, CrushRule::Section).unwrap()
}

fn landed(vehicle: &Vehicle, conditions: Conditions, soil: Soil, tolerance: f64) -> Landing {
    let scene = Scene::new(Conditions { soil, ..conditions }).unwrap();
    land(vehicle, &scene, &settings(tolerance))
}

/// Pressed in by any pressure, element and plate give way by the sum of what each of them does alone; unloaded, they keep the sum
/// of their sets.
#[test]
fn crush_and_sinkage_add_up_at_the_same_pressure() {
    let element = CrushLaw::new(&profile(), 0.0);
    let [strength, depth, rebound] = [1000.0, 0.2, 0.01];
    let both = element
        .clone()
        .on_soil(&soil(strength, depth, 1.0, rebound), PRESSURE);
    for step in 1..100 {
        let crush = 0.001 * f64::from(step);
        let alone = element.state_at(0.0, crush, true);
        let pressure = alone.line.at(crush);
        let sinkage = depth * pressure * PRESSURE / strength;
        let deepest = crush + sinkage;
        let found = both.state_at(0.0, deepest, true);
        assert!((found.line.at(deepest) - pressure).abs() < 1e-12, "{crush}");
        assert!((both.sinkage_at(deepest) - sinkage).abs() < 1e-12);
        assert!((both.interference_at_crush(crush) - deepest).abs() < 1e-12);
        let elastic = rebound * sinkage;
        assert!((found.set - (alone.set + sinkage - elastic)).abs() < 1e-12);
        assert!((both.own_set(found.set) - alone.set).abs() < 1e-12);
        assert!((both.deepest(found.set) - deepest).abs() < 1e-12);
    }
}

/// Soil weaker than an element takes all of the deformation, soil stronger none, whatever its exponent.
#[test]
fn the_weaker_of_element_and_soil_gives_way() {
    let element = CrushLaw::new(&profile(), 0.0);
    for exponent in [0.5, 0.8, 1.0, 1.4, 2.0] {
        let weak = soil(20.0, 0.2, exponent, 0.01);
        let weak = element.clone().on_soil(&weak, PRESSURE);
        assert!(weak.sinkage_at(0.3) > 0.298, "{exponent}");
        let strong = soil(2e5, 0.01, exponent, 0.01);
        let strong = element.clone().on_soil(&strong, PRESSURE);
        assert!(strong.sinkage_at(0.3) < 0.002, "{exponent}");
    }
}

/// Soil that gives back all of its sinkage is a spring under each element, and with it another element.
#[test]
fn elastic_soil_is_a_softer_element() {
    let [strength, depth] = [4000.0, 0.1];
    let spring = Soil::Yielding(soil(strength, depth, 1.0, 1.0));
    let profile = profile();
    let knots = profile.knots().iter().map(|[crush, pressure]| {
        let sinkage = depth * pressure * PRESSURE / strength;
        [crush + sinkage, *pressure]
    });
    let softer = Profile::new(knots.collect()).unwrap();
    let conditions = level(180.0, 20.0, 9.0);
    let on_soil = landed(&lander(&profile), conditions, spring, 1e-9);
    let on_rock = landed(&lander(&softer), conditions, Soil::Rock, 1e-9);
    assert_eq!(on_soil.outcome, on_rock.outcome);
    assert!((on_soil.end_time - on_rock.end_time).abs() < 1e-6 * on_rock.end_time);
    for leg in 0..3 {
        let [soil, rock] = [&on_soil, &on_rock].map(|landing| landing.max_stroke[leg]);
        assert!((soil - rock).abs() < 1e-6 * rock);
        let deepest = on_soil.max_pad_crush[leg] + on_soil.max_sinkage[leg];
        assert!((deepest - on_rock.max_pad_crush[leg]).abs() < 1e-6);
    }
    assert_eq!(on_rock.max_sinkage, [0.0; 3]);
}

#[test]
fn hard_soil_is_rock() {
    let (vehicle, conditions) = (lander(&profile()), level(180.0, 20.0, 9.0));
    let rock = landed(&vehicle, conditions, Soil::Rock, 1e-9);
    let mut off = [1e6, 1e7, 1e8].map(|strength| {
        let hard = Soil::Yielding(soil(strength, 0.01, 1.0, 0.5));
        let landing = landed(&vehicle, conditions, hard, 1e-9);
        assert_eq!(landing.outcome, rock.outcome);
        (landing.max_stroke[0] - rock.max_stroke[0]).abs()
    });
    assert!(off[2] < 1e-6, "{off:?}");
    off[0] *= 0.2;
    off[1] *= 0.2;
    assert!(
        off[1] < off[0] && off[2] < off[1],
        "of first order: {off:?}"
    );
}

/// A lander dropped on its pads: crush and sinkage of each section took the area under its pressure over its way.
#[test]
fn pads_sink_by_the_work_that_they_take() {
    let vehicle = lander(&profile());
    let [strength, depth] = [600.0, 0.2];
    let scene = Scene::new(Conditions {
        slope: 0.0,
        vertical_velocity: 4.0,
        pad_friction: 0.0,
        soil: Soil::Yielding(soil(strength, depth, 1.0, 0.001)),
        ..level(180.0, 0.0, 0.0)
    });
    let (landing, instants) = history(&vehicle, &scene.unwrap(), &settings(1e-7), 0.01);
    let footpad = &vehicle.hinged_legs()[0].design().footpad;
    let last = &instants[instants.len() - 1].legs[0];
    let section = FRAC_PI_8 * footpad.diameter * footpad.diameter;
    let works = last.sinkages.unwrap().pad.map(|sinkage| {
        let pressure = strength * sinkage / depth;
        assert!(
            pressure < 0.5 * PRESSURE,
            "it stays on its first line: {pressure}"
        );
        let crush = 0.02 * pressure / PRESSURE;
        section * 0.5 * pressure * (sinkage + crush)
    });
    let work = works[0] + works[1];
    // On a pad inclined by ξ, (29) has the factor (1 + cos²ξ)/2 on what a depth along its centreline takes.
    let inclined = instants
        .iter()
        .map(|at| at.legs[0].hinged().unwrap())
        .map(|posture| posture.link_angle - posture.pad_angle);
    let cosine = inclined.map(f64::cos).fold(1.0, f64::min);
    let least = 0.5 * (1.0 + cosine * cosine) * work;
    let taken = landing.energies.legs[0].pad_crush;
    assert!(least > 0.9 * work, "pads stand nearly level: {cosine}");
    assert!(least < taken && taken < work, "{taken} for {work}");
    let [crush, sinkage] = [landing.max_pad_crush[0], landing.max_sinkage[0]];
    assert!((crush - 0.02 * strength * sinkage / depth / PRESSURE).abs() < 1e-9);
    assert!(sinkage > 10.0 * crush && sinkage > 0.02, "{sinkage}");
}

/// Pads of a lander dropped on soil that they push aside: the ground bears by how deep they are, and by the square of the
/// rate at which they sink.
#[test]
fn soil_resists_by_the_square_of_the_rate_of_sinking() {
    let vehicle = lander(&profile());
    let [strength, depth, drag, interval] = [600.0, 0.2, 6.0, 2e-4];
    let bearing = soil(strength, depth, 1.0, 0.001);
    let scene = Scene::new(Conditions {
        slope: 0.0,
        vertical_velocity: 6.0,
        pad_friction: 0.0,
        soil: Soil::Yielding(bearing.with_inertial_drag(drag).unwrap()),
        ..level(180.0, 0.0, 0.0)
    });
    let (_, instants) = history(&vehicle, &scene.unwrap(), &settings(1e-9), interval);
    let diameter = vehicle.hinged_legs()[0].design().footpad.diameter;
    let area = 2.0 * FRAC_PI_8 * diameter * diameter;
    let sinkage = |at: &Instant| at.legs[0].sinkages.unwrap().pad[0];
    let (mut compared, mut by_rate) = (0, 0.0_f64);
    for around in instants[1..400].windows(3) {
        let [before, here, after] = [0, 1, 2].map(|k| sinkage(&around[k]));
        if before == 0.0 || after <= here {
            continue;
        }
        let rate = (after - before) / (2.0 * interval);
        let pressures = [strength * here / depth, drag * rate * rate];
        let found = around[1].legs[0].pad_normal / area;
        let expected = pressures[0] + pressures[1];
        // The pad is inclined by a few degrees, and the rate a difference.
        assert!(
            (found - expected).abs() < 0.02 * expected,
            "{here}: {found} for {expected}"
        );
        compared += 1;
        by_rate = by_rate.max(pressures[1] / expected);
    }
    assert!(compared > 50 && by_rate > 0.5, "{compared}, {by_rate}");
}

/// The way of a mass (slug) that falls on one pad (1 ft²) at 14 ft/s, until it stands: on the front of pad and soil, and
/// where the pad and the soil, which sinks as fast as the pad pushes it aside, are followed one by one.
fn ways_of_a_pad(mass: f64, bearing: &Bearing, strength: f64, depth: f64) -> [f64; 2] {
    const TIME_STEP: f64 = 1e-5;
    let drag = bearing.inertial_drag();
    let pad = CrushLaw::new(&profile(), 0.0);
    let both = pad.clone().on_soil(bearing, PRESSURE);
    let load_at = |crush: f64| PRESSURE * pad.state_at(0.0, crush, true).line.at(crush);
    let fall = |load: &mut dyn FnMut(f64, f64) -> f64| {
        let (mut way, mut speed) = (0.0, 14.0);
        while speed > 0.0 {
            way += TIME_STEP * speed;
            speed -= TIME_STEP * load(way, speed) / mass;
        }
        way
    };
    let on_front = fall(&mut |way, speed| {
        let line = both.state_at(0.0, way, true).line;
        PRESSURE * (line.at(way) + line.drag_at(speed))
    });
    let mut sinkage = 0.0_f64;
    let one_by_one = fall(&mut |way, _| {
        // Pad and soil bear alike at the sinkage after this step.
        let (mut least, mut greatest) = (sinkage, way);
        for _ in 0..40 {
            let next = 0.5 * (least + greatest);
            let rate = (next - sinkage) / TIME_STEP;
            let soil = strength * next / depth + drag * rate * rate;
            if soil > load_at(way - next) {
                greatest = next;
            } else {
                least = next;
            }
        }
        sinkage = least;
        load_at(way - sinkage)
    });
    [on_front, one_by_one]
}

/// A pad is not crushed by the drag of soil. That makes its way too short, by a part of what the drag shortens it.
#[test]
fn drag_on_the_front_is_nearly_drag_on_the_soil() {
    for (mass, strength, drag, off) in [
        (2.0, 440.0, 3.0, 0.012),
        (2.0, 440.0, 6.0, 0.055),
        (2.0, 1150.0, 3.0, 0.05),
        (2.0, 1150.0, 6.0, 0.135),
    ] {
        let depth = 0.164;
        let still = soil(strength, depth, 1.0, 0.001);
        let bearing = still.with_inertial_drag(drag).unwrap();
        let [found, expected] = ways_of_a_pad(mass, &bearing, strength, depth);
        let [without, _] = ways_of_a_pad(mass, &still, strength, depth);
        let short = 1.0 - found / expected;
        let shortened = 1.0 - expected / without;
        assert!(short > 0.0 && short < off, "{strength}, {drag}: {short}");
        assert!(shortened > 1.2 * short, "{strength}, {drag}: {shortened}");
    }
}

/// As little as soil resists being pushed aside, as little it changes a landing.
#[test]
fn soil_of_little_inertia_lands_as_soil_of_none() {
    let (vehicle, conditions) = (lander(&profile()), level(180.0, 20.0, 9.0));
    let sunk = |drag: f64| {
        let soil = soil(600.0, 0.2, 1.0, 0.01).with_inertial_drag(drag);
        landed(&vehicle, conditions, Soil::Yielding(soil.unwrap()), 1e-9).max_sinkage[0]
    };
    let [none, least, less, much] = [0.0, 0.003, 0.03, 3.0].map(sunk);
    assert!(much < 0.95 * none, "{much} of {none}");
    let ratio = (none - less) / (none - least);
    assert!((ratio - 10.0).abs() < 0.3, "of first order: {ratio}");
}

/// Soil that is stronger under all legs is that stronger soil, bit for bit. Where one leg of a lander that lands level stands on
/// stronger soil than the others, it sinks less than they do, as long as all soil yields like a spring: half as much on twice the
/// strength at the same pressure.
#[test]
fn soil_of_its_own_under_each_leg() {
    let vehicle = lander(&profile());
    let under = |strength: f64, factors: [f64; 3]| {
        let ground = factors.map(|bearing_factor| LegFooting {
            bearing_factor,
            ..LegFooting::SURFACE
        });
        let conditions = Conditions {
            ground: Ground::new(&ground).unwrap(),
            slope: 0.0,
            vertical_velocity: 4.0,
            ..level(180.0, 0.0, 0.0)
        };
        let soil = Soil::Yielding(soil(strength, 0.2, 1.0, 0.001));
        landed(&vehicle, conditions, soil, 1e-7)
    };
    assert_eq!(under(600.0, [1.5; 3]), under(900.0, [1.0; 3]));
    let sinkage = under(600.0, [1.0, 8.0, 1.0]).max_sinkage;
    let [weak, strong] = [sinkage[0], sinkage[1]];
    assert!(
        strong < 0.2 * weak && strong > 0.05 * weak,
        "{strong} {weak}"
    );
    assert!((sinkage[2] - weak).abs() < 1e-3 * weak, "both lie alike");
}

/// Rock is as strong under each leg.
#[test]
fn rock_has_no_strength_of_its_own_under_a_leg() {
    let ground = [1.0, 2.0].map(|bearing_factor| LegFooting {
        bearing_factor,
        ..LegFooting::SURFACE
    });
    let refused = |ground: &[LegFooting], soil| {
        let ground = Ground::new(ground).unwrap();
        Scene::new(Conditions {
            ground,
            soil,
            ..level(180.0, 0.0, 0.0)
        })
        .map_err(|invalid| invalid.to_string())
        .err()
    };
    let expected = "footing[2].bearing_factor = 2: expected 1 on rock, which does not yield";
    assert_eq!(refused(&ground, Soil::Rock).unwrap(), expected);
    let yielding = Soil::Yielding(soil(600.0, 0.2, 1.0, 0.001));
    assert_eq!(refused(&ground, yielding), None);
    let none = Ground::new(&[LegFooting {
        bearing_factor: 0.001,
        ..LegFooting::SURFACE
    }]);
    let none = none.unwrap_err().to_string();
    assert!(
        none.starts_with("footing[1].bearing_factor = 0.001: "),
        "{none}"
    );
}

/// Whatever lands on whatever soil: no energy comes from it, the account closes, and pads sink no less than they are left in
/// the ground.
#[test]
fn soil_only_takes_energy() {
    for nth in 0..60 {
        let vehicle = drawn(&wild_vehicle(3 + nth % 4), 54, nth).with_rules(Rules::PHYSICAL);
        let conditions = *drawn(&wild_scene(), 54, nth).conditions();
        let part = nth as f64 / 60.0;
        let strength = 200.0 * 30_f64.powf(part);
        let bearing = soil(strength, 0.05 + 0.2 * (1.0 - part), 0.5 + 1.5 * part, 0.01);
        let bearing = bearing.with_inertial_drag((nth % 3) as f64 * 3.0).unwrap();
        let landing = landed(&vehicle, conditions, Soil::Yielding(bearing), 1e-7);
        let energies = &landing.energies;
        let scale = energies.initial_kinetic + energies.potential_change.abs();
        assert!(
            energies.closure().abs() < 1e-4 * scale,
            "{nth}: {}",
            energies.closure()
        );
        assert!(energies.given_by_contact() < 1e-4 * scale, "{nth}");
        let are_finite = landing
            .max_sinkage
            .iter()
            .chain(landing.max_pad_crush.iter());
        assert!({ are_finite }.all(|depth| depth.is_finite() && *depth >= 0.0));
    }
}

#[test]
fn finer_tolerances_agree_on_soil() {
    let vehicle = ring(4).with_rules(Rules::PHYSICAL);
    let soft = soil(500.0, 0.2, 0.8, 0.01).with_inertial_drag(3.0).unwrap();
    let soft = Soil::Yielding(soft);
    let conditions = level(170.0, 10.0, 8.0);
    let at = |tolerance| landed(&vehicle, conditions, soft, tolerance);
    let [coarse, fine, finest] = [1e-5, 1e-7, 1e-10].map(at);
    assert_eq!(coarse.outcome, finest.outcome);
    let off = |landing: &Landing| (landing.max_sinkage[0] - finest.max_sinkage[0]).abs();
    assert!(finest.max_sinkage[0] > 0.05);
    assert!(
        off(&coarse) < 1e-4 && off(&fine) < 1e-6,
        "{} {}",
        off(&coarse),
        off(&fine)
    );
}

/// A pad leaves its print: the greatest sinkage never falls.
#[test]
fn sinkage_in_histories_only_grows() {
    let vehicle = lander(&profile());
    let soft = Soil::Yielding(soil(500.0, 0.2, 1.0, 0.01));
    let scene = Scene::new(Conditions {
        soil: soft,
        ..level(180.0, 0.0, 8.0)
    })
    .unwrap();
    let (landing, instants) = history(&vehicle, &scene, &settings(1e-6), 0.01);
    for leg in 0..3 {
        let sunk = instants.iter().map(|at| at.legs[leg].sinkages.unwrap().pad);
        let deepest = sunk.fold([0.0; 2], |[a, b], [c, d]| {
            assert!(c >= a - 1e-9 && d >= b - 1e-9);
            [c, d]
        });
        assert!((deepest[0].max(deepest[1]) - landing.max_sinkage[leg]).abs() < 1e-6);
    }
}

#[test]
fn soil_that_would_heal_is_refused() {
    for (numbers, quantity) in [
        ([0.0, 0.2, 1.0, 0.01], "soil.bearing_strength_psf"),
        ([500.0, 0.0, 1.0, 0.01], "soil.bearing_depth_ft"),
        ([500.0, 0.2, 2.5, 0.01], "soil.bearing_exponent"),
        ([500.0, 0.2, 1.0, 0.0], "soil.rebound"),
        ([500.0, 0.2, 2.0, 0.5], "soil.rebound"),
        ([500.0, 0.2, 0.5, 0.5], "soil.rebound"),
    ] {
        let [strength, depth, exponent, rebound] = numbers;
        let refused = Bearing::new(strength, depth, exponent, rebound).unwrap_err();
        assert_eq!(refused.quantity, quantity, "{numbers:?}");
    }
    let refused = soil(500.0, 0.2, 1.0, 0.01).with_inertial_drag(-1.0);
    assert_eq!(refused.unwrap_err().quantity, "soil.inertial_drag_slug_ft3");
}
