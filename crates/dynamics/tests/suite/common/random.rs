//! Random vehicles and touchdowns for proptest, and fixed lists of them for long tables.

use std::f64::consts::PI;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use touchdown_dynamics::attitude::{Attitude, Euler, Tip};
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene};
use touchdown_dynamics::vehicle::{Inertia, Leg, LegDesign, Vehicle};

use super::{damper, surveyor_leg};

/// The first `count` values of a strategy, the same in every run.
pub fn fixed_list<S: Strategy>(strategy: &S, count: usize) -> Vec<S::Value> {
    let mut runner = TestRunner::deterministic();
    (0..count)
        .map(|_| strategy.new_tree(&mut runner).unwrap().current())
        .collect()
}

/// The value that a strategy draws as its `nth` (from 0) with a seed.
pub fn drawn<S: Strategy>(strategy: &S, seed: u64, nth: usize) -> S::Value {
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let mut draw = || strategy.new_tree(&mut runner).unwrap().current();
    for _ in 0..nth {
        draw();
    }
    draw()
}

/// Either crush rule.
pub fn crush_rule() -> impl Strategy<Value = CrushRule> {
    prop_oneof![Just(CrushRule::PivotRate), Just(CrushRule::Section)]
}

/// Touchdowns like those of the report's studies: tip to 12 deg, slope to 25 deg, no spin.
pub fn usual_conditions() -> impl Strategy<Value = Conditions> {
    let speeds = (5.0..16.0, 0.0..20.0, 0.0..2.0 * PI);
    let attitude = (0.0..0.2, 0.0..2.0 * PI, 0.0..2.0 * PI);
    let ground = (0.0..0.43, 0.4..1.2, 0.4..1.2);
    (speeds, attitude, ground).prop_map(|(speeds, attitude, ground)| Conditions {
        vertical_velocity: speeds.0,
        horizontal_velocity: speeds.1,
        cross_slope: speeds.2,
        attitude: Attitude::from_tip(Tip {
            tip: attitude.0,
            azimuth: attitude.1,
            nominal_roll: attitude.2,
        }),
        angular_velocity: [0.0; 3],
        slope: ground.0,
        pad_friction: ground.1,
        block_friction: ground.2,
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: touchdown_dynamics::ground::Ground::default(),
        gravity: None,
        thrust: touchdown_dynamics::thrust::Thrust::default(),
    })
}

/// Static friction of a third of the touchdowns, drawn from the last digits of another number.
fn static_friction(friction: f64) -> Option<f64> {
    let part = (1e4 * friction).fract();
    (part < 1.0 / 3.0).then_some(1.0 + 12.0 * part)
}

/// Touchdowns without regard to sense: any lean to a right angle, steep slopes both ways, spins.
pub fn wild_scene() -> impl Strategy<Value = Scene> {
    let speeds = (0.0..30.0, 0.0..30.0, -PI..PI);
    let attitude = (0.0..PI / 2.0, -PI..PI, -PI..PI);
    let steep = 60f64.to_radians();
    let ground = (-steep..steep, 0.0..2.0, 0.0..2.0);
    let spin = prop::array::uniform3(-5.0..5.0);
    // Level, at rest, on level or frictionless ground: the places where something vanishes.
    let vanish = prop::array::uniform6(prop::bool::weighted(0.1));
    (speeds, attitude, ground, spin, vanish).prop_map(|(speeds, attitude, ground, spin, vanish)| {
        let unless = |index: usize, value: f64| if vanish[index] { 0.0 } else { value };
        Scene::new(Conditions {
            vertical_velocity: unless(0, speeds.0),
            horizontal_velocity: unless(1, speeds.1),
            cross_slope: speeds.2,
            attitude: Attitude::from_tip(Tip {
                tip: unless(2, attitude.0),
                azimuth: attitude.1,
                nominal_roll: attitude.2,
            }),
            angular_velocity: if vanish[3] { [0.0; 3] } else { spin },
            slope: unless(4, ground.0),
            pad_friction: unless(5, ground.1),
            block_friction: ground.2,
            static_friction_ratio: static_friction(ground.2),
            soil: touchdown_dynamics::soil::Soil::Rock,
            ground: touchdown_dynamics::ground::Ground::default(),
            gravity: None,
            thrust: touchdown_dynamics::thrust::Thrust::default(),
        })
        .unwrap()
    })
}

/// A leg at this azimuth with every number off the Surveyor's by up to a third or so.
fn wild_leg(azimuth_deg: f64) -> impl Strategy<Value = Leg> {
    let factor = || 0.7..1.4;
    let link = (factor(), 0.97..1.03, factor());
    let strut = (factor(), factor(), factor(), 0.0..0.3, 0.0..2.0, 0.0..2.0);
    let pad = (factor(), factor(), factor(), factor());
    let block = (factor(), factor(), factor(), factor());
    (link, strut, pad, block).prop_filter_map("a leg that can be built", move |all| {
        let (link, resistance, pad, cushion) = all;
        let LegDesign {
            azimuth,
            mut linkage,
            mut strut,
            mut footpad,
            mut block,
        } = surveyor_leg(azimuth_deg);
        linkage.lower_hardpoint_radius *= link.0;
        linkage.lower_link_length *= link.1;
        linkage.inertia *= link.2;
        strut.friction_fraction = resistance.3;
        let element = damper(&mut strut);
        element.preload *= resistance.0;
        element.spring_constant *= resistance.1;
        element.structural_stiffness *= resistance.2;
        element.compression_damping *= resistance.4;
        element.rebound_damping *= resistance.5;
        footpad.diameter *= pad.0;
        footpad.height *= pad.1;
        footpad.crush_pressure *= pad.2;
        footpad.inertia *= pad.3;
        if let Some(block) = &mut block {
            block.radius *= cushion.0;
            block.height *= cushion.1;
            block.diameter *= cushion.2;
            block.crush_pressure *= cushion.3;
        }
        Leg::new(LegDesign {
            azimuth,
            linkage,
            strut,
            footpad,
            block,
        })
        .ok()
    })
}

/// A lander with so many differing legs around the ring.
pub fn wild_vehicle(count: usize) -> impl Strategy<Value = Vehicle> {
    let legs: Vec<_> = (0..count)
        .map(|j| wild_leg(360.0 * j as f64 / count as f64).boxed())
        .collect();
    let moments = prop::array::uniform3(50.0..300.0);
    let products = prop::array::uniform3(-20.0..20.0);
    let offset = prop::array::uniform2(-0.5..0.5);
    (
        5.0..60.0,
        1.5..30.0,
        0.3..3.0,
        offset,
        moments,
        products,
        legs,
    )
        .prop_filter_map(
            "a vehicle that can be built",
            |(mass, gravity, height, offset, moments, products, legs)| {
                // No body has a moment greater than the sum of the other two.
                let twist: f64 = products.iter().map(|product: &f64| product.abs()).sum();
                let most = |k: usize| -> f64 {
                    let others: f64 = moments[(k + 1) % 3] + moments[(k + 2) % 3];
                    let spare = (3.0 * twist).min(0.3 * others);
                    f64::min(moments[k], others - spare)
                };
                let inertia = Inertia {
                    xx: most(0),
                    yy: most(1),
                    zz: most(2),
                    xy: products[0],
                    xz: products[1],
                    yz: products[2],
                };
                Vehicle::new(mass, gravity, height, inertia, legs)
                    .and_then(|vehicle| vehicle.with_center_of_gravity_offset(offset))
                    .map(|vehicle| vehicle.with_rules(Rules::REPORT))
                    .ok()
            },
        )
}

/// Any Euler angles, right angles of yaw not excluded.
pub fn any_euler() -> impl Strategy<Value = Euler> {
    (-PI..PI, -PI / 2.0..PI / 2.0, -PI..PI).prop_map(|(pitch, yaw, roll)| Euler {
        pitch,
        yaw,
        roll,
    })
}
