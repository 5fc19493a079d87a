//! Contact at the face of footpads and the ends of blocks, which only takes energy.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::Vector3;
use proptest::prelude::*;
use rayon::prelude::*;

use crate::common::bare::{Bare, pressed_by};
use crate::common::random::{fixed_list, usual_conditions};
use crate::common::scenes::history;
use crate::common::{
    PRINCIPAL, even_inertia, level, ring, side_by_side, surveyor, surveyor_leg, table_4_1,
};
use touchdown_dynamics::attitude::{Attitude, Euler};
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::contact::LegMode;
use touchdown_dynamics::energy::kinetic;
use touchdown_dynamics::integrator::event::Exit;
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::motion::Signal;
use touchdown_dynamics::outcome::{Class, Failure, Outcome};
use touchdown_dynamics::parts::PadEdge;
use touchdown_dynamics::rules::{ContactRule, FrictionProfile};
use touchdown_dynamics::scene::{Conditions, CrushRule, Scene, Settings, Stop};
use touchdown_dynamics::state::State;
use touchdown_dynamics::vehicle::{Leg, Vehicle};

/// A landing that is hard to account for: any number of legs, pads up to 30 times as stiff, some on their edges, some in damped
/// hinges, little friction or much.
fn wild() -> impl Strategy<Value = (Vehicle, Scene)> {
    let legs = (3usize..9, 0.0..1.0, 0.3..1.0);
    let extras = (prop::bool::ANY, prop::bool::ANY);
    let spin = prop::array::uniform3(-1.0..1.0);
    (legs, extras, usual_conditions(), 0.0..1.0, spin).prop_map(|drawn| {
        let ((legs, stiffness, inertia), (damps, has_edges), conditions, friction, spin) = drawn;
        let azimuths = (0..legs).map(|leg| 360.0 * leg as f64 / legs as f64);
        let legs: Vec<Leg> = azimuths
            .map(|azimuth| {
                let mut design = surveyor_leg(azimuth);
                let pad = &mut design.footpad;
                pad.crush_pressure *= 30f64.powf(stiffness);
                pad.inertia *= inertia;
                pad.hinge_damping = if damps { 0.3 } else { 0.0 };
                pad.edge = has_edges.then_some(PadEdge {
                    angle: 65f64.to_radians(),
                    load: 187.0,
                });
                Leg::new(design).unwrap()
            })
            .collect();
        let friction = 0.2 * 15f64.powf(friction);
        let conditions = Conditions {
            pad_friction: friction,
            block_friction: friction,
            angular_velocity: spin,
            ..conditions
        };
        let vehicle = Vehicle::new(20.0, 5.31, 1.5417, even_inertia(142.22), legs).unwrap();
        (vehicle, Scene::new(conditions).unwrap())
    })
}

fn settings(tolerance: f64, rule: ContactRule) -> Settings {
    (Settings::new(tolerance, 40.0, CrushRule::Section).unwrap()).with_contact_rule(rule)
}

/// The most that contact of any pad or block has given since first contact, at any of these instants, over a scale, ft·lb.
fn given(instants: &[Instant], scale: f64) -> f64 {
    let works = instants.iter().flat_map(|instant| {
        instant.legs.iter().flat_map(|leg| {
            let work = &leg.work;
            [
                work.pad_crush + work.pad_friction,
                work.block_crush + work.block_friction,
            ]
        })
    });
    works.fold(0.0, |worst: f64, work| worst.max(-work)) / scale
}

/// A wild landing for some seconds beyond its verdict: what it came to, and the most that contact gave over the energy at contact.
fn followed((vehicle, scene): &(Vehicle, Scene), rule: ContactRule) -> (Landing, f64) {
    let settings = Settings::new(1e-6, 5.0, CrushRule::Section).unwrap();
    let settings = settings.with_contact_rule(rule).stopping_at(Stop::Time);
    let (landing, instants) = history(vehicle, scene, &settings, 0.01);
    let given = given(&instants, landing.energies.initial_kinetic);
    (landing, given)
}

#[test]
fn contact_at_the_face_only_takes_energy() {
    let cases = fixed_list(&wild(), 20);
    let worst = (cases.par_iter())
        .map(|case| {
            let (landing, given) = followed(case, ContactRule::Face);
            let energies = &landing.energies;
            let closure = energies.closure().abs() / energies.initial_kinetic;
            assert_eq!(energies.given_by_contact(), 0.0);
            let end = landing.beyond.map_or(landing.outcome, |beyond| beyond.end);
            if let Outcome::Failure(failure) = end {
                let has_no_law = matches!(failure, Failure::PadInclination { .. });
                assert!(has_no_law, "{failure} at {} s", landing.end_time);
            }
            [given, closure]
        })
        .reduce(|| [0.0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
    println!("given and closure at most {worst:?}");
    assert!(worst[0] < 1e-6 && worst[1] < 1e-5, "{worst:?}");
    let at_pivot = cases[..5]
        .par_iter()
        .map(|case| followed(case, ContactRule::Pivot).1);
    assert!(at_pivot.reduce(|| 0.0, f64::max) > 1e-3);
}

/// Least stroke of any strut in wild landings under a rule, ft.
fn least_stroke(rule: ContactRule) -> f64 {
    let least = |(vehicle, scene): &(Vehicle, Scene)| {
        let settings = settings(1e-6, rule).with_time_limit(3.0).unwrap();
        let (_, instants) = history(vehicle, scene, &settings.stopping_at(Stop::Time), 0.002);
        let legs = instants.iter().flat_map(|instant| instant.legs.iter());
        legs.map(|leg| leg.stroke).fold(0.0, f64::min)
    };
    let cases = fixed_list(&wild(), 10);
    cases.par_iter().map(least).reduce(|| 0.0, f64::min)
}

#[test]
fn no_link_opens_beyond_its_extension_stop() {
    let [at_face, at_pivot] = [ContactRule::Face, ContactRule::Pivot].map(least_stroke);
    assert!(at_face > -1e-6, "{at_face} ft");
    assert!(at_pivot < -1e-3, "{at_pivot} ft: the rule of 1966 lets it");
}

/// Of the pads of a leg: A Σ p²/2E (1 + cos²ξ)/2, while they are on their elastic lines, ft·lb.
fn stored(bare: &Bare, vehicle: &Vehicle, state: &State<f64>, leg: usize) -> f64 {
    let pad = &vehicle.hinged_legs()[leg].design().footpad;
    let signals = bare.signals(state);
    let cosine = signals.of(leg, Signal::PadInclination);
    let slope = pad.profile.first_slope();
    let squares = [Signal::OuterInterference, Signal::InnerInterference]
        .map(|signal| slope * signals.of(leg, signal).max(0.0))
        .map(|pressure| pressure * pressure);
    let strength = PI / 8.0 * pad.diameter * pad.diameter * pad.crush_pressure;
    let factor = 0.5 * (1.0 + cosine * cosine);
    strength * factor * (squares[0] + squares[1]) / (2.0 * slope)
}

/// On the elastic line the work of a pad is what it stores, and all works are what body and links lose, whatever moves.
#[test]
fn work_at_the_face_is_what_pads_store_and_what_the_motion_loses() {
    let vehicle = table_4_1();
    let (mut bare, mut state) = pressed_by(&vehicle, 0.006, 3.0, ContactRule::Face);
    for (j, rate) in [2.0, -3.0, 1.0].into_iter().enumerate() {
        let mut leg = state.leg(j);
        leg.pad_rate = rate;
        leg.pad_turn = leg.link_angle + 0.003 * rate;
        state.set_leg(j, &leg);
    }
    let deep = bare.signals(&state).of(0, Signal::OuterInterference);
    let mut body = state.body();
    body.rate = Vector3::new(0.4, -0.3, 0.2);
    body.position.z += 0.005 - deep;
    body.velocity.z = 1.0;
    state.set_body(&body);
    bare.settle(&state);
    let mut slope = State::zero(3);
    bare.derivative(&state, &mut slope);
    const TIME: f64 = 1e-6;
    let [before, after] = [-TIME, TIME].map(|time| state.advanced_motion([time], [&slope]));
    let mut pressed = 0;
    for j in 0..3 {
        let change = [&after, &before].map(|state| stored(&bare, &vehicle, state, j));
        let rate = (change[0] - change[1]) / (2.0 * TIME);
        let work = slope.leg(j).work[1];
        pressed += u32::from(work.abs() > 1.0);
        assert!(
            (rate - work).abs() < 1e-6 * work.abs().max(1.0),
            "{rate} {work}"
        );
    }
    assert!(pressed > 0);
    let [before_energy, after_energy] = [&before, &after].map(|state| kinetic(&bare.motion, state));
    let gained = (after_energy - before_energy) / (2.0 * TIME);
    let fallen = bare.motion.mass() * bare.motion.gravity() * state.body().velocity.z;
    let works: f64 = (0..3).flat_map(|j| slope.leg(j).work).sum();
    let off = gained - fallen + works;
    assert!(off.abs() < 1e-6 * works.abs(), "{off} of {works}");
}

#[test]
fn landings_at_the_face_take_about_as_many_evaluations() {
    for vehicle in [table_4_1(), ring(4), ring(6)] {
        let vehicle = Arc::new(vehicle);
        let conditions = fixed_list(&usual_conditions(), 40);
        let [pivot, face] = [ContactRule::Pivot, ContactRule::Face].map(|rule| {
            let requests = conditions
                .iter()
                .enumerate()
                .map(|(key, conditions)| Request {
                    key,
                    vehicle: Arc::clone(&vehicle),
                    scene: Scene::new(*conditions).unwrap(),
                    settings: settings(3e-5, rule),
                });
            side_by_side(requests)
        });
        let evaluations = |landing: &Landing| {
            assert_ne!(landing.outcome.class(), Class::Failure);
            landing.evaluations as f64
        };
        let mut ratios: Vec<f64> = (face.iter().zip(&pivot))
            .map(|(face, pivot)| evaluations(face) / evaluations(pivot))
            .collect();
        ratios.sort_by(f64::total_cmp);
        let median = ratios[ratios.len() / 2];
        let legs = vehicle.leg_count();
        println!(
            "{legs} legs: {median:.2}, at most {:.1}",
            ratios[ratios.len() - 1]
        );
        assert!(median < 1.5, "{median}");
    }
}

#[test]
fn mirrored_landings_mirror_each_other() {
    let vehicle = surveyor(1.445, PRINCIPAL);
    for k in 0..8 {
        let of = |sign: f64| {
            let k = f64::from(k);
            let attitude = Euler {
                pitch: 0.05,
                yaw: sign * 0.02 * k,
                roll: sign * (0.3 + 0.1 * k),
            };
            let scene = Scene::new(Conditions {
                attitude: Attitude::from_euler(attitude),
                ..level(sign * (100.0 + 10.0 * k), 0.0, 6.0)
            });
            land(
                &vehicle,
                &scene.unwrap(),
                &settings(1e-8, ContactRule::Face),
            )
        };
        let [one, other] = [1.0, -1.0].map(of);
        assert_eq!(one.outcome.class(), other.outcome.class(), "{k}");
        let apart = (one.min_stability_angle - other.min_stability_angle).abs();
        assert!(apart < 1e-6, "{k}: {apart}");
    }
}

#[test]
fn tolerances_agree() {
    let vehicle = table_4_1();
    for conditions in fixed_list(&usual_conditions(), 6) {
        let scene = Scene::new(conditions).unwrap();
        let [loose, tight] = [1e-7, 1e-9]
            .map(|tolerance| land(&vehicle, &scene, &settings(tolerance, ContactRule::Face)));
        assert_eq!(loose.outcome, tight.outcome);
        assert!((loose.min_stability_angle - tight.min_stability_angle).abs() < 1e-5);
    }
}

#[test]
fn landings_come_out_the_same_beside_landings_under_another_rule() {
    let vehicle = Arc::new(table_4_1());
    let requests: Vec<Request> = (fixed_list(&usual_conditions(), 24).into_iter().enumerate())
        .map(|(key, conditions)| Request {
            key,
            vehicle: vehicle.clone(),
            scene: Scene::new(conditions).unwrap(),
            settings: settings(
                3e-5,
                if key % 3 == 1 {
                    ContactRule::Pivot
                } else {
                    ContactRule::Face
                },
            ),
        })
        .collect();
    for (landing, request) in side_by_side(requests.iter().cloned()).iter().zip(&requests) {
        let alone = land(&vehicle, &request.scene, &request.settings);
        assert_eq!(*landing, alone, "{}", request.key);
    }
}

#[test]
fn a_pad_crushed_by_its_height_ends_the_landing() {
    let legs = [0.0, 120.0, 240.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.footpad.crush_pressure *= 0.05;
        Leg::new(design).unwrap()
    });
    let vehicle = Vehicle::new(20.0, 5.31, 1.445, PRINCIPAL, legs).unwrap();
    let scene = Scene::new(level(180.0, 0.0, 0.0)).unwrap();
    let [pivot, face] = [ContactRule::Pivot, ContactRule::Face]
        .map(|rule| land(&vehicle, &scene, &settings(1e-6, rule)));
    let height = vehicle.hinged_legs()[0].design().footpad.height;
    let deepest = |landing: &Landing| {
        landing
            .max_pad_crush
            .iter()
            .fold(0.0, |a: f64, b| a.max(*b))
    };
    assert!(matches!(face.outcome, Outcome::BottomedPad { .. }));
    assert!(
        (deepest(&face) / height - 1.0).abs() < 1e-6,
        "{} of {height}",
        deepest(&face)
    );
    assert!(deepest(&pivot) > height, "{}", deepest(&pivot));
}

#[test]
fn a_block_bears_down_to_its_hardpoint() {
    let leg = Leg::new(surveyor_leg(0.0)).unwrap();
    let height = leg.design().block.as_ref().unwrap().height;
    let [pivot, face] = [ContactRule::Pivot, ContactRule::Face].map(|rule| {
        let laws = leg.laws().clone().with_contact_rule(rule);
        let laws = laws.with_crush_rule(CrushRule::Section);
        let mut mode = LegMode::untouched(&laws);
        let mut signals = [0.0; Signal::COUNT];
        let block = Signal::BlockInterference;
        for depth in [1e-3, 0.1, 0.5, height + 1e-9] {
            signals[block as usize] = depth;
            while let Some(exit) = mode.ranges(&laws)[block as usize].exit(depth) {
                mode.cross(&laws, 0, block, exit, &signals)?;
            }
        }
        Ok(())
    });
    assert_eq!(pivot, Ok(()));
    assert_eq!(face, Err(Outcome::BottomedBlock { leg: 0 }));
}

#[test]
fn a_pad_that_turns_over_is_not_loaded_at_once() {
    let mut design = surveyor_leg(0.0);
    design.footpad.edge = Some(PadEdge {
        angle: 65f64.to_radians(),
        load: 187.0,
    });
    let leg = Leg::new(design).unwrap();
    let laws = leg.laws().clone().with_crush_rule(CrushRule::Section);
    let mut mode = LegMode::untouched(&laws);
    let mut signals = [0.0; Signal::COUNT];
    let outer = Signal::OuterInterference;
    let settle = |mode: &mut LegMode, signals: &[f64; Signal::COUNT]| {
        while let Some(exit) = mode.ranges(&laws)[outer as usize].exit(signals[outer as usize]) {
            mode.cross(&laws, 0, outer, exit, signals).unwrap();
        }
    };
    // Its sections hang clear of the ground, while its rim is below it.
    signals[outer as usize] = -0.1;
    signals[Signal::InnerInterference as usize] = -0.2;
    (mode.cross(&laws, 0, Signal::PadInclination, Exit::Below, &signals)).unwrap();
    signals[outer as usize] = 0.3;
    settle(&mut mode, &signals);
    assert!(mode.pieces(&laws).edge.load.is_slack());
    // It is pressed as it goes deeper, and back on its face it keeps what has been crushed.
    signals[outer as usize] = 0.304;
    settle(&mut mode, &signals);
    assert!(!mode.pieces(&laws).edge.load.is_slack());
    (mode.cross(&laws, 0, Signal::PadInclination, Exit::Above, &signals)).unwrap();
    signals[outer as usize] = 0.2;
    settle(&mut mode, &signals);
    assert!(mode.pieces(&laws).pad[0].is_slack());
    assert_eq!(mode.sets(&laws, &signals).pad[0], 0.2);
}

/// Friction that sets in like a step sticks to feet at rates of a million per second: explicit steps, held at their limit of
/// stability, took more than two million.
#[test]
fn feet_stuck_by_steep_friction_take_implicit_steps() {
    let scene = Scene::new(Conditions {
        vertical_velocity: 10.9,
        slope: 7.5f64.to_radians(),
        pad_friction: 5.0,
        block_friction: 5.0,
        ..level(298.6, 23.0, 3.7)
    });
    let scene = scene.unwrap();
    for rule in [ContactRule::Pivot, ContactRule::Face] {
        for profile in [FrictionProfile::A, FrictionProfile::B] {
            let settings = settings(1e-6, rule).with_friction_profile(profile);
            let landing = land(&table_4_1(), &scene, &settings);
            assert_eq!(landing.outcome, Outcome::StableSubsided);
            let evaluations = landing.evaluations;
            assert!(
                evaluations < 100_000,
                "{rule:?}, {profile:?}: {evaluations}"
            );
        }
    }
}
