//! Motions that have a closed form: ballistic flight, torque-free rotation, legs that hang, pads that press on a stop of
//! their hinge, and a vehicle that falls onto its body blocks.

use std::f64::consts::PI;

use crate::common::bare::{Bare, distance};
use crate::common::scenes::history;
use crate::common::{PRINCIPAL, level, level_scene, settings, surveyor, surveyor_leg, table_4_1};
use nalgebra::{Unit, UnitQuaternion, Vector3, Vector4};
use touchdown_dynamics::attitude::{Attitude, Tip};
use touchdown_dynamics::hinge::{Hinge, Stops};
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::rules::{ContactRule, Rules};
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings};
use touchdown_dynamics::state::{Body, State, rotation};
use touchdown_dynamics::touchdown::extended_legs;
use touchdown_dynamics::vehicle::{Leg, Vehicle};

/// Touching down with no vertical velocity and sliding off down a slope of 45 deg, a vehicle is in
/// free flight until the slope's fall has been made up: 2 V_H/g seconds for a point.
fn off_the_slope(vehicle: &Vehicle, spin: f64) -> Vec<Instant> {
    let scene = Scene::new(Conditions {
        vertical_velocity: 0.0,
        slope: PI / 4.0,
        angular_velocity: [0.0, 0.0, spin],
        ..level(180.0, 0.0, 10.0)
    })
    .unwrap();
    let settings = Settings::new(1e-10, 2.0, CrushRule::PivotRate).unwrap();
    let (landing, instants) = history(vehicle, &scene, &settings, 0.1);
    assert_eq!(landing.pad_contact, [None; 3]);
    assert_eq!(instants.len(), 21);
    instants
}

#[test]
fn ballistic_flight() {
    let vehicle = table_4_1();
    let instants = off_the_slope(&vehicle, 0.0);
    for instant in &instants {
        let t = instant.time;
        let fall = 0.5 * vehicle.gravity() * t * t;
        let expected = instants[0].position + Vector3::new(0.0, -10.0 * t, fall);
        assert!((instant.position - expected).norm() < 1e-12, "{t} s");
        let expected = Vector3::new(0.0, -10.0, vehicle.gravity() * t);
        assert!((instant.velocity - expected).norm() < 1e-12, "{t} s");
        assert_eq!(instant.angular_velocity, Vector3::zeros());
        let released = vehicle.mass() * vehicle.gravity() * fall;
        assert!((instant.potential_change - released).abs() < 1e-10);
    }
}

#[test]
fn the_lowest_pad_section_touches_at_any_tip() {
    let vehicle = table_4_1();
    let leg = vehicle.hinged_legs()[0].design().clone();
    let (extended, linkage) = (vehicle.hinged_legs()[0].extended_angle(), &leg.linkage);
    let reach = linkage.lower_hardpoint_radius + linkage.lower_link_length * extended.cos();
    let drop = vehicle.center_of_gravity_height()
        + linkage.lower_link_length * extended.sin()
        + leg.footpad.height;
    let aside = 2.0 * leg.footpad.diameter / (3.0 * PI);
    for tip_deg in [0, 30, 84, 85, 95, 120, 150, 180] {
        for azimuth_deg in [0, 90, 200] {
            let attitude = Attitude::from_tip(Tip {
                tip: f64::from(tip_deg).to_radians(),
                azimuth: f64::from(azimuth_deg).to_radians(),
                nominal_roll: 0.3,
            });
            let conditions = Conditions {
                attitude,
                ..level(170.0, 0.0, 10.0)
            };
            let mut first = None;
            land_observed(
                &vehicle,
                &Scene::new(conditions).unwrap(),
                &settings(1e-6),
                1.0,
                &mut |instant| {
                    first.get_or_insert(instant.position);
                },
            );
            let depths = (vehicle.hinged_legs().iter()).flat_map(|leg| {
                let (sine, cosine) = leg.design().azimuth.sin_cos();
                [reach + aside, reach - aside].map(|reach| {
                    let section = Vector3::new(reach * sine, reach * cosine, drop);
                    let place = first.unwrap() + attitude.matrix() * section;
                    let (sine, cosine) = conditions.slope.sin_cos();
                    sine * place.y + cosine * place.z
                })
            });
            let deepest = depths.fold(f64::NEG_INFINITY, f64::max);
            assert!(deepest.abs() < 1e-12, "{tip_deg} deg: {deepest} ft");
        }
    }
}

#[test]
fn spin_through_a_landing() {
    let spin = 3.0;
    for instant in off_the_slope(&surveyor(1.445, PRINCIPAL), spin) {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), spin * instant.time);
        let off = instant.attitude.matrix() - turn.to_rotation_matrix().matrix();
        assert!(off.norm() < 1e-9, "{} s: {off}", instant.time);
    }
}

#[test]
fn spin_about_each_principal_axis() {
    let vehicle = surveyor(1.445, PRINCIPAL);
    let bare = Bare::new(&vehicle, &level_scene(180.0, 0.0, 0.0));
    let start = UnitQuaternion::from_euler_angles(0.3, -0.2, 0.5);
    let legs = extended_legs(&vehicle);
    for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
        let (spin, time) = (3.0, 2.0);
        let body = Body {
            position: Vector3::new(0.0, 0.0, -500.0),
            velocity: Vector3::zeros(),
            quaternion: Vector4::new(start.w, start.i, start.j, start.k),
            rate: axis * spin,
        };
        let end = bare.march(&State::new(&body, &legs), time, 2000).body();
        assert!((end.rate - axis * spin).norm() < 1e-13, "{axis}");
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), spin * time);
        let expected = (start * turn).to_rotation_matrix();
        let off = rotation(&end.quaternion) - expected.matrix();
        assert!(off.norm() < 1e-11, "{axis}: {off}");
    }
}

/// A vehicle that tumbles in the air, its links and pads still moving.
fn tumbling() -> (Bare, State<f64>) {
    let vehicle = table_4_1();
    let mut legs = extended_legs(&vehicle);
    for (leg, rate) in legs.iter_mut().zip([0.7, 0.4, 1.3]) {
        leg.link_rate = rate;
        leg.pad_rate = -0.5 * rate;
    }
    let body = Body {
        position: Vector3::new(1.0, -2.0, -50.0),
        velocity: Vector3::new(3.0, -11.0, 14.0),
        quaternion: Vector4::new(0.9, 0.1, -0.2, 0.3),
        rate: Vector3::new(2.0, -1.5, 3.0),
    };
    let state = State::new(&body, &legs);
    let mut bare = Bare::new(&vehicle, &level_scene(180.0, 0.0, 0.0));
    bare.lift_off(&state);
    (bare, state)
}

#[test]
fn free_flight_is_where_fine_steps_lead() {
    let (bare, start) = tumbling();
    let flight = bare.free_flight(&start);
    let reach = flight.reach(0.25);
    assert!((0.005..0.25).contains(&reach), "{reach} s");
    let mut end = start;
    for part in 1..=4 {
        let time = 0.25 * reach * f64::from(part);
        end = flight.at(time);
        let marched = bare.march(&start, time, 50 * part);
        let off = distance(&end, &marched);
        assert!(off < 1e-13, "{off} after {time} s");
        for j in 0..3 {
            let (work, expected) = (end.leg(j).work, marched.leg(j).work);
            let off = work.iter().zip(expected).map(|(a, b)| (a - b).abs());
            let worst = off.fold(0.0, f64::max);
            assert!(
                worst < 1e-9 * expected[STOP],
                "leg {j}: {work:?}, {expected:?}"
            );
        }
    }
    assert_ne!(end.leg(0).pad_turn, start.leg(0).pad_turn);
    assert!(end.leg(0).link_rate < 0.95 * start.leg(0).link_rate);
}

/// Where the work of a link on its stop is among the work integrals of a leg.
const STOP: usize = 5;

/// To its reach a flight is summed to the last bit, so it may be flown in any parts.
#[test]
fn a_flight_in_parts_is_the_same_flight() {
    let (bare, start) = tumbling();
    let reach = bare.free_flight(&start).reach(0.25);
    let fly = |parts: u32| {
        let mut state = start;
        for _ in 0..parts {
            let flight = bare.free_flight(&state);
            state = flight.at(reach / f64::from(parts));
        }
        state
    };
    let whole = fly(1);
    for parts in [2, 3, 7] {
        let off = distance(&fly(parts), &whole);
        assert!(off < 5e-15, "{off} in {parts} parts");
    }
}

/// A vehicle that slides off its slope and tumbles about no principal axis flies the same at a coarse tolerance.
#[test]
fn free_flight_knows_no_tolerance() {
    let vehicle = table_4_1();
    let scene = Scene::new(Conditions {
        vertical_velocity: 0.0,
        slope: PI / 4.0,
        angular_velocity: [0.2, -0.1, 0.3],
        ..level(180.0, 0.0, 20.0)
    })
    .unwrap();
    let [coarse, fine] = [1e-3, 1e-10].map(|tolerance| {
        let settings = Settings::new(tolerance, 1.0, CrushRule::PivotRate).unwrap();
        let (landing, instants) = history(&vehicle, &scene, &settings, 0.1);
        assert_eq!(landing.pad_contact, [None; 3]);
        instants
    });
    assert_eq!(coarse.len(), 11);
    for (one, other) in coarse.iter().zip(&fine) {
        assert!((one.position - other.position).norm() < 1e-12);
        let off = one.attitude.matrix() - other.attitude.matrix();
        assert!(off.norm() < 1e-13, "{} s: {off}", one.time);
    }
}

const STOPS: Stops = Stops {
    inner: 0.013,
    outer: 0.785,
    arrival: 1e-9,
    rule: ContactRule::Pivot,
};

/// dα/dt = α̇ (1 − 1000·overrun) (model chapter 6), with an α̇ that swells and fades, in steps of a classical Runge-Kutta
/// method much shorter than the millisecond it takes a pad to come to rest.
#[test]
fn a_pad_on_its_stop_lags_behind_its_rate_as_the_model_has_it() {
    for (stop, outward) in [(STOPS.outer, 1.0), (STOPS.inner, -1.0)] {
        let rate = |time: f64| outward * 5.0 * (1.0 + (2000.0 * time).sin());
        let turned = |time: f64| outward * 5.0 * (time + (1.0 - (2000.0 * time).cos()) / 2000.0);
        let written = |time: f64, angle: f64| {
            let overrun = outward * (angle - stop);
            rate(time) * (1.0 - 1000.0 * overrun)
        };
        let start = stop + outward * 1e-4;
        let hinge = Hinge::at(STOPS, start, rate(0.0));
        let from = hinge.turn(STOPS, start);
        assert!((hinge.angle(STOPS, from) - start).abs() < 1e-16);

        let length = 1e-6;
        let mut angle = start;
        for k in 0..1000 {
            let time = length * f64::from(k);
            let half = time + 0.5 * length;
            let k1 = written(time, angle);
            let k2 = written(half, angle + 0.5 * length * k1);
            let k3 = written(half, angle + 0.5 * length * k2);
            let k4 = written(time + length, angle + length * k3);
            angle += length / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
            let now = time + length;
            let found = hinge.angle(STOPS, from + turned(now));
            assert!((found - angle).abs() < 1e-12, "{now} s: {found}, {angle}");
        }
        let overrun = outward * (angle - stop);
        assert!((0.0008..0.001).contains(&overrun), "{overrun} rad");
    }
}

/// A Surveyor whose footpads give way to nothing at all, so that it lands on its blocks.
fn on_its_blocks() -> Vehicle {
    let legs = [0.0, 120.0, 240.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.footpad.crush_pressure = 1e-12;
        Leg::new(design).unwrap()
    });
    Vehicle::new(20.0, 5.31, 1.445, PRINCIPAL, legs)
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// ∫ p dI of a table from 0 to `depth` and p at `depth`.
fn area_under(profile: &Profile, depth: f64) -> (f64, f64) {
    let mut area = 0.0;
    let knots = profile.knots();
    for (k, pair) in knots.windows(2).enumerate() {
        let [[x0, y0], [x1, y1]] = [pair[0], pair[1]];
        let last = k + 2 == knots.len();
        let upper = if last { depth } else { depth.min(x1) };
        let y = y0 + (y1 - y0) / (x1 - x0) * (upper - x0);
        area += 0.5 * (y0 + y) * (upper - x0);
        if upper >= depth {
            return (area, y);
        }
    }
    unreachable!("the last segment goes on for ever")
}

/// Falling straight down on level ground, a vehicle is slowed to the calm 2 ft/s at which its
/// motion counts as subsided when its blocks have taken up the rest of its energy.
#[test]
fn a_vehicle_dropped_on_its_blocks() {
    let vehicle = on_its_blocks();
    let block = vehicle.hinged_legs()[0].design().block.clone().unwrap();
    // 14 ft/s ends on the plateau of the profile, 20 ft/s on the steep rise beyond it.
    for speed in [14.0, 20.0] {
        let scene = Scene::new(Conditions {
            vertical_velocity: speed,
            slope: 0.0,
            ..level(180.0, 0.0, 0.0)
        })
        .unwrap();
        let (landing, instants) = history(&vehicle, &scene, &settings(1e-10), 0.01);
        assert_eq!(landing.outcome.to_string(), "stable-subsided");
        let end = instants.last().unwrap();
        assert!((end.velocity.z - 2.0).abs() < 1e-8, "{}", end.velocity.z);
        // Interference of a level block is what its face would be below the surface.
        let depth = end.position.z + vehicle.center_of_gravity_height() + block.height;
        let (area, pressure) = area_under(&block.profile, depth);
        let face = PI / 4.0 * block.diameter * block.diameter;
        let crushing = 3.0 * face * block.crush_pressure * area;
        let weight = vehicle.mass() * vehicle.gravity();
        let kinetic = 0.5 * vehicle.mass() * (speed * speed - 4.0);
        let released = weight * (end.position.z - instants[0].position.z);
        let gap = kinetic + released - crushing;
        assert!(
            gap.abs() < 1e-6 * kinetic,
            "{speed} ft/s: {gap} of {kinetic} ft·lb"
        );
        let elastic = block.profile.knots()[1][1] / block.profile.knots()[1][0];
        let set = depth - pressure / elastic;
        for leg in &end.legs {
            assert!(
                (leg.block_set - set).abs() < 1e-9,
                "{} for {set}",
                leg.block_set
            );
            let force = face * block.crush_pressure * pressure;
            assert!((leg.block_normal - force).abs() < 1e-6 * force);
            assert!((leg.work.block_crush - crushing / 3.0).abs() < 1e-6 * crushing);
        }
    }
}
