//! A CG off the centreline: every point of a leg is where a rigid body has it, and every force turns the body by its lever
//! about the CG.

use crate::common::bare::{Bare, pressed};
use crate::common::{OFFSET, level_scene, off_center, settings, table_4_1};
use nalgebra::{Matrix3, Vector3};
use touchdown_dynamics::land::land;
use touchdown_dynamics::motion::Signal;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::state::{State, rotation};
use touchdown_dynamics::vehicle::Vehicle;

/// A point of a leg by its distance from the centreline and below the CG (ft), in ground axes as the state has the body.
fn point(vehicle: &Vehicle, leg: usize, reach: f64, drop: f64, state: &State<f64>) -> Vector3<f64> {
    let (sine, cosine) = vehicle.hinged_legs()[leg].design().azimuth.sin_cos();
    let [cg_x, cg_y] = vehicle.center_of_gravity_offset();
    let body = state.body();
    let from_cg = Vector3::new(reach * sine - cg_x, reach * cosine - cg_y, drop);
    body.position + rotation(&body.quaternion) * from_cg
}

fn pivot(vehicle: &Vehicle, leg: usize, state: &State<f64>) -> Vector3<f64> {
    let linkage = &vehicle.hinged_legs()[leg].design().linkage;
    let (sine, cosine) = state.leg(leg).link_angle.sin_cos();
    let reach = linkage.lower_hardpoint_radius + linkage.lower_link_length * cosine;
    let drop = vehicle.center_of_gravity_height() + linkage.lower_link_length * sine;
    point(vehicle, leg, reach, drop, state)
}

/// Centre of a pad section that has not been crushed: 1 outboard, −1 inboard.
fn section(vehicle: &Vehicle, leg: usize, side: f64, state: &State<f64>) -> Vector3<f64> {
    let design = vehicle.hinged_legs()[leg].design();
    let (linkage, footpad) = (&design.linkage, &design.footpad);
    let angles = state.leg(leg);
    let (sin_link, cos_link) = angles.link_angle.sin_cos();
    let (sin_pad, cos_pad) = (angles.link_angle - angles.pad_turn).sin_cos();
    let aside = side * 2.0 * footpad.diameter / (3.0 * std::f64::consts::PI);
    let reach =
        linkage.lower_hardpoint_radius + linkage.lower_link_length * cos_link + aside * cos_pad
            - footpad.height * sin_pad;
    let drop = vehicle.center_of_gravity_height()
        + linkage.lower_link_length * sin_link
        + aside * sin_pad
        + footpad.height * cos_pad;
    point(vehicle, leg, reach, drop, state)
}

/// Centre of a block of which so much (ft) has been crushed.
fn block(vehicle: &Vehicle, leg: usize, crushed: f64, state: &State<f64>) -> Vector3<f64> {
    let block = &vehicle.hinged_legs()[leg].design().block.as_ref().unwrap();
    let drop = vehicle.center_of_gravity_height() + block.height - crushed;
    point(vehicle, leg, block.radius, drop, state)
}

const SLOPE: f64 = 15.0 * std::f64::consts::PI / 180.0;

/// The normal of the slope into the ground.
fn normal() -> Vector3<f64> {
    Vector3::new(0.0, SLOPE.sin(), SLOPE.cos())
}

fn near(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() < tolerance * (1.0 + expected.abs()),
        "{what}: {found}, not {expected}"
    );
}

/// States with pads alone and with blocks on the surface as well.
fn states() -> Vec<(Vehicle, Bare, State<f64>)> {
    let with = |depth, sliding| {
        let vehicle = off_center(table_4_1());
        let (bare, mut state) = pressed(&vehicle, depth, sliding);
        let mut body = state.body();
        body.velocity.z = 0.7;
        body.rate = Vector3::new(0.4, -0.7, 0.9);
        state.set_body(&body);
        (vehicle, bare, state)
    };
    vec![with(0.06, 1.0), with(0.9, 2.0)]
}

#[test]
fn points_of_legs_are_where_a_rigid_body_has_them() {
    for (vehicle, bare, state) in states() {
        let signals = bare.signals(&state);
        let body = state.body();
        let depth = |point: &Vector3<f64>| normal().dot(point);
        for leg in 0..3 {
            let of = |signal| signals.of(leg, signal);
            let foot = pivot(&vehicle, leg, &state) - body.position;
            for (signal, expected) in [Signal::FootX, Signal::FootY, Signal::FootZ]
                .into_iter()
                .zip(&foot)
            {
                near("foot", of(signal), *expected, 1e-12);
            }
            let height = vehicle.center_of_gravity_height();
            let radius = vehicle.hinged_legs()[leg]
                .design()
                .linkage
                .lower_hardpoint_radius;
            let hardpoint = point(&vehicle, leg, radius, height, &state);
            near(
                "hardpoint",
                of(Signal::HardpointDepth),
                depth(&hardpoint),
                1e-12,
            );
            for (signal, side) in [
                (Signal::OuterInterference, 1.0),
                (Signal::InnerInterference, -1.0),
            ] {
                let section = section(&vehicle, leg, side, &state);
                let inclination = of(Signal::PadInclination);
                near("section", of(signal), depth(&section) / inclination, 1e-12);
            }
            let upright = normal().dot(&rotation(&body.quaternion).column(2));
            let block = block(&vehicle, leg, 0.0, &state);
            near(
                "block",
                of(Signal::BlockInterference),
                depth(&block) / upright,
                1e-12,
            );
        }
    }
}

/// What legs do to a body by their loads: force in ground axes (lb), torque about the CG in vehicle axes (ft·lb).
fn push(vehicle: &Vehicle, bare: &Bare, state: &State<f64>) -> [Vector3<f64>; 2] {
    const TIME: f64 = 1e-6;
    let mut slope = State::zero(3);
    bare.derivative(state, &mut slope);
    let [before, after] = [-TIME, TIME].map(|time| state.advanced_motion([time], [&slope]));
    let loads = bare.loads(state);
    let signals = bare.signals(state);
    let body = state.body();
    let to_vehicle: Matrix3<f64> = rotation(&body.quaternion).transpose();
    let [mut force, mut torque] = [Vector3::zeros(); 2];
    for leg in 0..3 {
        let crushed = signals.of(leg, Signal::BlockInterference);
        type Place<'a> = &'a dyn Fn(&State<f64>) -> Vector3<f64>;
        let pad: Place = &|state| pivot(vehicle, leg, state);
        let block: Place = &|state| block(vehicle, leg, crushed, state);
        let loads = &loads[leg];
        for (place, pressure, friction) in [
            (pad, loads.pad_normal, loads.pad_friction),
            (block, loads.block_normal, loads.block_friction),
        ] {
            let velocity = (place(&after) - place(&before)) / (2.0 * TIME);
            let sliding = velocity - normal() * normal().dot(&velocity);
            let pushed = -(normal() * pressure + sliding.normalize() * friction);
            force += pushed;
            torque += to_vehicle * (place(state) - body.position).cross(&pushed);
        }
    }
    [force, torque]
}

#[test]
fn forces_turn_the_body_by_their_levers_about_the_center_of_gravity() {
    for (vehicle, bare, state) in states() {
        let [force, torque] = push(&vehicle, &bare, &state);
        let mut slope = State::zero(3);
        bare.derivative(&state, &mut slope);
        let (body, change) = (state.body(), slope.body());
        let weight = Vector3::new(0.0, 0.0, vehicle.mass() * vehicle.gravity());
        let inertial = change.velocity * vehicle.mass() - weight;
        let momentum = vehicle.inertia() * body.rate;
        let twist = vehicle.inertia() * change.rate + body.rate.cross(&momentum);
        assert!(
            force.norm() > 500.0 && torque.norm() > 100.0,
            "{force} {torque}"
        );
        for k in 0..3 {
            near("force", inertial[k], force[k], 1e-6);
            near("torque", twist[k], torque[k], 1e-6);
        }
        // It is the offset that is looked at here: without it the same forces turn the body otherwise.
        let lever = rotation(&body.quaternion) * Vector3::new(OFFSET[0], OFFSET[1], 0.0);
        assert!(lever.cross(&force).norm() > 100.0);
    }
}

#[test]
fn landings_with_an_offset_end_at_the_tolerance_of_searches_as_converged_ones_do() {
    let vehicle = off_center(table_4_1());
    let mut classes = Vec::new();
    for (cross_slope, roll, speed) in [
        (180.0, 0.0, 9.0),
        (180.0, 0.0, 13.0),
        (170.0, -10.0, 11.0),
        (120.0, 30.0, 12.0),
        (90.0, -45.0, 15.0),
        (-150.0, 20.0, 12.5),
    ] {
        let scene = level_scene(cross_slope, roll, speed);
        let [loose, tight] =
            [3e-5, 1e-8].map(|tolerance| land(&vehicle, &scene, &settings(tolerance)));
        assert_eq!(
            loose.outcome, tight.outcome,
            "{cross_slope}, {roll}, {speed}"
        );
        classes.push(tight.outcome.class());
        let off = (loose.min_stability_angle - tight.min_stability_angle).abs();
        assert!(off < 1e-2, "{cross_slope}, {roll}, {speed}: {off}");
    }
    assert!(
        classes.contains(&Class::Stable) && classes.contains(&Class::Unstable),
        "{classes:?}"
    );
}

/// First transition of a vehicle straight downhill, to 0.01 ft/s, between speeds at which it is stable and topples.
fn transition(vehicle: &Vehicle) -> f64 {
    let topples = |speed| {
        let scene = level_scene(180.0, 0.0, speed);
        land(vehicle, &scene, &settings(1e-6)).outcome.class() == Class::Unstable
    };
    let [mut low, mut high] = [7.0, 15.0];
    assert!(!topples(low) && topples(high));
    while high - low > 0.01 {
        let middle = 0.5 * (low + high);
        if topples(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

#[test]
fn a_center_of_gravity_downhill_topples_sooner_and_one_uphill_later() {
    // Unturned, y of the vehicle points uphill.
    let with = |y: f64| transition(&table_4_1().with_center_of_gravity_offset([0.0, y]).unwrap());
    let [downhill, centred, uphill] = [with(-0.2), with(0.0), with(0.2)];
    println!("{downhill} {centred} {uphill}");
    assert!((centred - 11.40).abs() < 0.02, "{centred}");
    assert!(
        downhill < centred - 0.2 && centred + 0.2 < uphill,
        "{downhill} {uphill}"
    );
}
