//! Landings of a batch come out as alone, to the last bit.

use std::cell::Cell;
use std::sync::Arc;

use crate::common::random::{fixed_list, usual_conditions, wild_scene, wild_vehicle};
use crate::common::{level_scene, off_center, settings, table_4_1};
use rayon::prelude::*;
use touchdown_dynamics::batch::{Occupancy, Request, Width, land_in_lanes, land_many};
use touchdown_dynamics::friction::FrictionProfile;
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::methods::{FixedInterval, Method};
use touchdown_dynamics::scene::{CrushRule, Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// A landing and how it is computed.
struct Task {
    vehicle: Arc<Vehicle>,
    scene: Scene,
    settings: Settings,
}

/// The wild landing that takes all the steps there are: twelve million evaluations, a hundred times the others.
const ENDLESS: usize = 7;

const PROFILES: [FrictionProfile; 2] = [FrictionProfile::A, FrictionProfile::B];

/// Landings of all kinds, one beside the other: vehicles, tolerances, laws and methods differ.
fn tasks() -> Vec<Task> {
    let usual = fixed_list(&usual_conditions(), 30).into_iter();
    let vehicles = [table_4_1(), off_center(table_4_1())].into_iter().cycle();
    let usual = vehicles
        .zip(usual)
        .map(|(vehicle, conditions)| (vehicle, Scene::new(conditions).unwrap()));
    let mut wild = fixed_list(&(wild_vehicle(3), wild_scene()), 31);
    wild.remove(ENDLESS);
    let mut all: Vec<(Vehicle, Scene)> = usual.collect();
    all.extend(wild);
    let tolerance = |k: usize| [3e-5, 1e-6, 3e-4][k % 3];
    let runge_kutta = Method::RungeKutta(FixedInterval::new(1e-3).unwrap());
    let rule = |k: usize| [CrushRule::PivotRate, CrushRule::Section][k / 3 % 2];
    (all.into_iter().enumerate())
        .map(|(k, (vehicle, scene))| {
            let settings = Settings::new(tolerance(k), 3.0, rule(k)).unwrap();
            Task {
                vehicle: Arc::new(vehicle),
                scene,
                settings: match k % 10 {
                    7 => settings.with_friction_profile(PROFILES[k / 10 % 2]),
                    9 => settings.with_method(runge_kutta),
                    _ => settings,
                },
            }
        })
        .collect()
}

fn request(tasks: &[Task], key: usize) -> Option<Request> {
    tasks.get(key).map(|task| Request {
        key,
        vehicle: Arc::clone(&task.vehicle),
        scene: task.scene,
        settings: task.settings,
    })
}

fn alone(tasks: &[Task]) -> Vec<Landing> {
    (tasks.par_iter())
        .map(|task| land(&task.vehicle, &task.scene, &task.settings))
        .collect()
}

/// All of them in so many lanes, in the order of their keys.
fn in_lanes(width: Width, tasks: &[Task]) -> (Vec<Option<Landing>>, Occupancy) {
    let mut found = vec![None; tasks.len()];
    let mut keys = 0..;
    let occupancy = land_in_lanes(
        width,
        &mut || request(tasks, keys.next()?),
        &mut |key, landing| {
            assert!(found[key].is_none(), "landing {key} is told twice");
            found[key] = Some(landing);
        },
    );
    (found, occupancy)
}

/// Compares what is printed: numbers are written with all the digits that tell them from their neighbours, and what
/// is no number equals itself.
fn assert_same(found: &[Option<Landing>], expected: &[Landing]) {
    for (key, (found, expected)) in found.iter().zip(expected).enumerate() {
        let found = found.as_ref().unwrap();
        assert_eq!(
            format!("{found:?}"),
            format!("{expected:?}"),
            "landing {key}"
        );
    }
}

#[test]
fn a_landing_is_the_same_whatever_lands_beside_it_and_however_many() {
    let tasks = tasks();
    let expected = alone(&tasks);
    (Width::ALL.par_iter()).for_each(|width| assert_same(&in_lanes(*width, &tasks).0, &expected));
    // Other neighbours.
    let reversed: Vec<Task> = tasks.into_iter().rev().collect();
    let (mut found, _) = in_lanes(Width::fastest(), &reversed);
    found.reverse();
    assert_same(&found, &expected);
}

#[test]
fn lanes_stay_full_while_there_are_landings() {
    let tasks: Vec<Task> = (0..60)
        .map(|k| Task {
            vehicle: Arc::new(table_4_1()),
            scene: level_scene(180.0 - f64::from(k), 10.0, 9.0 + 0.1 * f64::from(k)),
            settings: settings(3e-5),
        })
        .collect();
    let (_, occupancy) = in_lanes(Width::Four, &tasks);
    assert!(occupancy.steps > 30_000, "{occupancy:?}");
    assert!(occupancy.share() > 0.97, "{occupancy:?}");
}

/// Whoever asks may hold back: with few under way they step alone.
#[test]
fn landings_come_as_they_are_asked_for() {
    let tasks = &tasks()[..12];
    let expected = alone(tasks);
    let mut found = vec![None; tasks.len()];
    let (asked, under_way) = (Cell::new(0), Cell::new(0));
    let mut next = || {
        if under_way.get() == 2 {
            return None;
        }
        let request = request(tasks, asked.get())?;
        asked.set(asked.get() + 1);
        under_way.set(under_way.get() + 1);
        Some(request)
    };
    let occupancy = land_many(&mut next, &mut |key, landing| {
        under_way.set(under_way.get() - 1);
        found[key] = Some(landing);
    });
    assert_same(&found, &expected);
    assert_eq!(occupancy.steps, occupancy.lanes);
    let nothing = land_many(&mut || None, &mut |_, _| panic!("nobody lands"));
    assert_eq!(nothing, Occupancy::default());
}
