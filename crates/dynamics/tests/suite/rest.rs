//! When motion counts as subsided: what landings that did go through afterwards.

use std::sync::Arc;

use crate::common::random::{fixed_list, usual_conditions};
use crate::common::{even_inertia, side_by_side, surveyor_leg};
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::rules::{CrushRule, RestRule, RuleChoices, Rules};
use touchdown_dynamics::scene::{Conditions, Scene, Settings, Stop};
use touchdown_dynamics::thrust::Thrust;
use touchdown_dynamics::vehicle::{Honeycomb, Leg, StrutElement, Vehicle};

/// A tall lander with four legs on honeycomb, no blocks, and pads of the Surveyor.
fn lander() -> Vehicle {
    let legs = [0.0, 90.0, 180.0, 270.0].map(|azimuth| {
        let mut design = surveyor_leg(azimuth);
        design.block = None;
        design.strut.element = StrutElement::Honeycomb(Honeycomb {
            unloading_stiffness: 40_000.0,
            crush_load: CrushLoad::new(vec![[0.0, 1500.0]]).unwrap(),
        });
        Leg::new(design).unwrap()
    });
    Vehicle::new(20.0, 5.31, 3.0, even_inertia(142.0), legs.to_vec())
        .unwrap()
        .with_rules(Rules::REPORT)
}

/// Landings from these conditions, computed side by side.
fn landed(
    vehicle: &Vehicle,
    settings: &Settings,
    conditions: impl Iterator<Item = Conditions>,
) -> Vec<(Scene, Landing)> {
    let vehicle = Arc::new(vehicle.clone());
    let scenes: Vec<Scene> = conditions
        .map(|conditions| Scene::new(conditions).unwrap())
        .collect();
    let requests = scenes.iter().enumerate().map(|(key, scene)| Request {
        key,
        vehicle: Arc::clone(&vehicle),
        scene: *scene,
        settings: *settings,
    });
    let landings = side_by_side(requests);
    scenes.into_iter().zip(landings).collect()
}

/// What becomes of landings on Ceres that count as subsided.
#[derive(Debug, Default)]
struct Afterwards {
    subsided: usize,
    /// Those that topple afterwards all the same.
    toppled: usize,
    /// Those whose body comes nearer to the ground than before.
    lowered: usize,
}

/// What becomes within so many seconds of landings that count as subsided under a rule. On Ceres 2 ft/s is too much: what has the energy of that speed
/// rises by 2 ft.
fn afterwards(rule: RestRule, time_limit: f64) -> Afterwards {
    let vehicle = lander();
    let settings = Settings::new(3e-5, time_limit, CrushRule::Section).unwrap();
    let settings = settings.with_rules(RuleChoices {
        rest: Some(rule),
        ..settings.rule_choices()
    });
    let settings = settings.stopping_at(Stop::Verdict);
    let mut found = Afterwards::default();
    let touchdowns = fixed_list(&usual_conditions(), 30).into_iter();
    let scenes = touchdowns.flat_map(|conditions| {
        (0..10).map(move |k| Conditions {
            vertical_velocity: 0.3 * conditions.vertical_velocity,
            gravity: Some(0.92),
            horizontal_velocity: 0.6 * f64::from(k),
            ..conditions
        })
    });
    for (scene, landing) in landed(&vehicle, &settings, scenes) {
        if landing.outcome != Outcome::StableSubsided {
            continue;
        }
        found.subsided += 1;
        let (mut angle, mut clearance) = (f64::INFINITY, f64::INFINITY);
        let mut observe = |instant: &Instant| {
            if instant.time > landing.end_time {
                angle = angle.min(instant.stability_angle);
                clearance = clearance.min(instant.clearance);
            }
        };
        let beyond = settings.stopping_at(Stop::Time);
        let beyond = land_observed(&vehicle, &scene, &beyond, 0.02, &mut observe);
        found.toppled += usize::from(angle <= 0.0);
        found.lowered += usize::from(clearance < landing.min_clearance - 0.01);
        // The clearance is that of the whole landing, the angle that up to the verdict.
        assert!(beyond.min_clearance <= clearance + 1e-9);
        assert_eq!(beyond.min_stability_angle, landing.min_stability_angle);
    }
    found
}

#[test]
fn what_has_too_little_energy_does_not_topple() {
    let by_limits = afterwards(RestRule::Limits, 12.0);
    let by_energy = afterwards(RestRule::Energy, 20.0);
    println!("{by_limits:?} {by_energy:?}");
    assert!(by_limits.toppled > 3 && by_limits.lowered > 3);
    assert!(by_energy.subsided > 100);
    assert_eq!(by_energy.toppled, 0);
}

/// Kinetic energy at the verdict of landings that end stable, as a height under the pull on the vehicle, ft: the
/// greatest. The engine stays on with this share of the weight.
fn greatest_lift_at_rest(share: f64) -> f64 {
    let vehicle = lander().with_rules(Rules::PHYSICAL);
    let settings = Settings::new(3e-5, 120.0, CrushRule::Section).unwrap();
    let settings = settings.stopping_at(Stop::Verdict);
    let weight = vehicle.mass() * 0.92;
    let thrust = Thrust::new(&[[0.0, share * weight]], [0.0; 2]).unwrap();
    let (mut greatest, mut stable) = (0.0f64, 0);
    let touchdowns = fixed_list(&usual_conditions(), 20).into_iter();
    let scenes = touchdowns.flat_map(|conditions| {
        (0..3).map(move |k| Conditions {
            vertical_velocity: 0.1 * conditions.vertical_velocity,
            horizontal_velocity: 0.2 * f64::from(k),
            gravity: Some(0.92),
            thrust,
            ..conditions
        })
    });
    for (_, landing) in landed(&vehicle, &settings, scenes) {
        if landing.outcome == Outcome::StableSubsided {
            stable += 1;
            greatest = greatest.max(landing.energies.final_kinetic / ((1.0 - share) * weight));
        }
    }
    assert!(stable > 20, "{stable} stable");
    greatest
}

/// Feet are less than 8 ft from the CG, which bounds the height over any edge of them.
#[test]
fn an_engine_that_stays_on_leaves_hardly_any_motion_at_rest() {
    let [off, on] = [0.0, 0.5].map(greatest_lift_at_rest);
    assert!(off > 0.02 * 8.0, "{off} ft");
    assert!(on < 0.02 * 8.0, "{on} ft");
}

/// Landings of that lander under physical rules that end so, within a time limit, s.
fn ending(stop: Stop, time_limit: f64) -> Vec<Landing> {
    let vehicle = lander().with_rules(Rules::PHYSICAL);
    let settings = Settings::new(3e-5, time_limit, CrushRule::Section).unwrap();
    let touchdowns = fixed_list(&usual_conditions(), 40).into_iter();
    let scenes = touchdowns.map(|conditions| Conditions {
        vertical_velocity: 0.5 * conditions.vertical_velocity,
        horizontal_velocity: 4.0,
        ..conditions
    });
    let landings = landed(&vehicle, &settings.stopping_at(stop), scenes);
    landings.into_iter().map(|(_, landing)| landing).collect()
}

/// Number of stable landings whose greatest stroke or load grows further, by 1 mm or by a pound, until long after.
fn still_growing(stop: Stop) -> usize {
    let pairs = ending(stop, 15.0).into_iter().zip(ending(Stop::Time, 15.0));
    let stable = pairs.filter(|(landing, _)| landing.outcome == Outcome::StableSubsided);
    let grows = |(landing, whole): &(Landing, Landing)| {
        assert_eq!(whole.outcome, Outcome::StableSubsided);
        (0..4).any(|leg| {
            let stroke = whole.max_stroke[leg] - landing.max_stroke[leg];
            let force = whole.max_strut_force[leg] - landing.max_strut_force[leg];
            stroke > 0.003 || force > 1.0
        })
    };
    stable.filter(grows).count()
}

#[test]
fn strokes_and_loads_at_rest_are_those_of_the_whole_landing() {
    let [at_verdict, at_rest] = [Stop::Verdict, Stop::Rest].map(still_growing);
    assert!(at_verdict >= 3, "{at_verdict} grow after their verdict");
    assert_eq!(at_rest, 0);
}

#[test]
fn what_stands_when_time_runs_out_is_stable() {
    let outcomes = |stop, limit| ending(stop, limit).into_iter().map(|one| one.outcome);
    let known = ending(Stop::Verdict, 15.0);
    let stand = known
        .iter()
        .filter(|one| one.outcome == Outcome::StableSubsided);
    // Half of the landings stand by then, and hardly any has settled.
    let mut ends: Vec<f64> = stand.map(|one| one.end_time).collect();
    ends.sort_by(f64::total_cmp);
    let limit = ends[ends.len() / 2] + 0.01;
    let stable = |stop| outcomes(stop, limit).filter(|one| *one == Outcome::StableSubsided);
    let [at_verdict, at_rest] = [Stop::Verdict, Stop::Rest].map(|stop| stable(stop).count());
    assert!(
        at_verdict > ends.len() / 2 && at_rest + 3 > at_verdict,
        "{at_rest} of {at_verdict}"
    );
}
