//! A stiff, fully plastic lander whose feet do not slide, against a rigid polygon that pivots over its feet.
//!
//! In the plane of motion the CG is h over the line of the feet and b from the leading ones, r² = h² + b². They touch first,
//! the nose down by ε: the CG is then b' = b cos ε − h sin ε behind them and h' = h cos ε + b sin ε over them. A plastic impact
//! of a foot leaves the angular momentum about that foot, I_p ω = m (V h' − W b') at forward speed V and descent W with
//! I_p = I + m r², and takes the rest of the energy. The body then turns about the foot, and topples when that carries the CG
//! over it: ½ I_p ω² ≥ m g (r − h').
//!
//! With the nose up the trailing feet would touch first, the CG b' ahead of them. They do not stop: after a plastic impact the CG
//! would descend at ω b' with ω = m (V h' + W b')/I_p, faster than the W before at any speed that topples, so the impact would have
//! to pull the feet down. Friction turns the body and lifts them off instead.

use crate::common::{even_inertia, surveyor_leg};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::ground::Ground;
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::parts::PadEdge;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::thrust::Thrust;
use touchdown_dynamics::vehicle::{Honeycomb, Leg, StrutElement, Vehicle};

const MASS: f64 = 20.0;
const GRAVITY: f64 = 5.31;
/// Moment of inertia about any axis, slug ft2.
const INERTIA: f64 = 142.0;
/// Descent, ft/s.
const DESCENT: f64 = 2.0;
/// Energy that a pad gives back, ft lb.
const ELASTIC_ENERGY: f64 = 1.0;
/// Inclination of the nose at first contact, rad.
const NOSE: f64 = 0.06;

/// A lander with four legs whose struts do not give way and whose pads crush at a force (lb) that hardly varies.
fn lander(force: f64) -> Vehicle {
    let legs = [0.0, 90.0, 180.0, 270.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.block = None;
        design.linkage.inertia = 0.1;
        design.strut.element = StrutElement::Honeycomb(Honeycomb {
            unloading_stiffness: 4e6,
            crush_load: CrushLoad::new(vec![[0.0, 1e8]]).unwrap(),
        });
        // Flat and wide, so that friction does not turn it over.
        (design.footpad.diameter, design.footpad.height) = (4.0, 0.05);
        let area = std::f64::consts::FRAC_PI_4 * design.footpad.diameter * design.footpad.diameter;
        design.footpad.crush_pressure = force / area;
        design.footpad.profile = Profile::new(vec![
            [0.0, 0.0],
            [ELASTIC_ENERGY * 2.0 / force, 1.0],
            [1.0, 1.0],
        ])
        .unwrap();
        design.footpad.inertia = 3e-3;
        design.footpad.edge = Some(PadEdge {
            angle: 60f64.to_radians(),
            load: force,
        });
        design.footpad.minimum_angle = -85f64.to_radians();
        design.footpad.maximum_angle = 85f64.to_radians();
        Leg::new(design).unwrap()
    });
    Vehicle::new(MASS, GRAVITY, 4.0, even_inertia(INERTIA), legs.to_vec())
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// Whether the lander topples at a speed, its nose down, rolled by 0 or 45 deg.
fn topples(vehicle: &Vehicle, roll_deg: f64, speed: f64) -> bool {
    // It moves toward -y: the nose is down where pitch is negative.
    let attitude = Attitude::from_euler(Euler {
        pitch: -NOSE,
        yaw: 0.0,
        roll: roll_deg.to_radians(),
    });
    let scene = Scene::new(Conditions {
        vertical_velocity: DESCENT,
        horizontal_velocity: speed,
        cross_slope: std::f64::consts::PI,
        attitude,
        angular_velocity: [0.0; 3],
        slope: 0.0,
        pad_friction: 10.0,
        block_friction: 10.0,
        static_friction_ratio: None,
        soil: touchdown_dynamics::soil::Soil::Rock,
        ground: Ground::default(),
        gravity: None,
        thrust: Thrust::default(),
    })
    .unwrap();
    let settings = Settings::new(1e-5, 30.0, CrushRule::Section).unwrap();
    let landing = land(vehicle, &scene, &settings);
    match landing.outcome.class() {
        Class::Unstable => true,
        Class::Stable => false,
        _ => panic!(
            "{:?} at {speed} ft/s, {} s, {:?}",
            landing.outcome, landing.end_time, landing.pad_contact
        ),
    }
}

/// h, and b of a foot at the end of its leg.
fn polygon(vehicle: &Vehicle) -> [f64; 2] {
    let leg = &vehicle.hinged_legs()[0];
    let linkage = &leg.design().linkage;
    let (sine, cosine) = leg.extended_angle().sin_cos();
    [
        vehicle.center_of_gravity_height() + linkage.lower_link_length * sine,
        linkage.lower_hardpoint_radius + linkage.lower_link_length * cosine,
    ]
}

/// Speed at which the polygon topples over its leading feet.
fn closed_form([h, b]: [f64; 2]) -> f64 {
    let r = h.hypot(b);
    let about_foot = INERTIA + MASS * r * r;
    let (sine, cosine) = NOSE.sin_cos();
    let (behind, over) = (b * cosine - h * sine, h * cosine + b * sine);
    let momentum = (about_foot * 2.0 * MASS * GRAVITY * (r - over)).sqrt();
    (momentum / MASS + DESCENT * behind) / over
}

/// Around the closed form: a lander with stiff pads stays upright a little below it and topples at it, one with soft pads,
/// whose crushing lowers the CG and takes time, topples below already.
fn check(roll_deg: f64, [soft, stiff]: [f64; 2], below: f64) {
    let topples = |force: f64, share: f64| {
        let vehicle = lander(force);
        let [h, foot] = polygon(&vehicle);
        let expected = closed_form([h, foot * roll_deg.to_radians().cos()]);
        topples(&vehicle, roll_deg, share * expected)
    };
    assert!(topples(soft, below), "soft pads");
    assert!(!topples(stiff, below), "stiff pads, below");
    assert!(topples(stiff, 1.01), "stiff pads, above");
}

#[test]
fn over_two_leading_feet() {
    check(45.0, [600.0, 2400.0], 0.97);
}

#[test]
fn over_one_leading_foot() {
    check(0.0, [600.0, 4800.0], 0.95);
}
