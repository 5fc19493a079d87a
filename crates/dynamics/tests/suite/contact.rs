//! Contact at the face of footpads and the ends of blocks, which only takes energy.

use proptest::prelude::*;
use rayon::prelude::*;

use crate::common::random::{fixed_list, usual_conditions};
use crate::common::scenes::history;
use crate::common::{even_inertia, surveyor_leg};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::record::Instant;
use touchdown_dynamics::rules::{ContactRule, CrushRule};
use touchdown_dynamics::scene::{Conditions, Scene, Settings};
use touchdown_dynamics::vehicle::{Leg, Vehicle};

/// A landing that is hard to account for: any number of legs, pads up to 30 times as stiff, little friction or much.
fn wild() -> impl Strategy<Value = (Vehicle, Scene)> {
    let legs = (3usize..9, 0.0..1.0, 0.3..1.0);
    let conditions = (
        usual_conditions(),
        0.0..1.0,
        prop::array::uniform3(-1.0..1.0),
    );
    (legs, conditions).prop_map(
        |((legs, stiffness, inertia), (conditions, friction, spin)): (
            (usize, f64, f64),
            (Conditions, f64, [f64; 3]),
        )| {
            let azimuths = (0..legs).map(|leg| 360.0 * leg as f64 / legs as f64);
            let legs: Vec<Leg> = azimuths
                .map(|azimuth| {
                    let mut design = surveyor_leg(azimuth);
                    design.footpad.crush_pressure *= 30f64.powf(stiffness);
                    design.footpad.inertia *= inertia;
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
        },
    )
}

/// The most that contact of any pad or block has given since first contact, at any of these instants, ft·lb.
fn given(instants: &[Instant]) -> f64 {
    let works = instants.iter().flat_map(|instant| {
        instant.legs.iter().flat_map(|leg| {
            let work = &leg.work;
            [
                work.pad_crush + work.pad_friction,
                work.block_crush + work.block_friction,
            ]
        })
    });
    works.fold(0.0, |worst: f64, work| worst.max(-work))
}

fn landed(
    vehicle: &Vehicle,
    scene: &Scene,
    rule: ContactRule,
    tolerance: f64,
) -> (Landing, Vec<Instant>) {
    let settings = Settings::new(tolerance, 9.0, CrushRule::Section)
        .unwrap()
        .with_contact_rule(rule)
        .beyond_verdict();
    history(vehicle, scene, &settings, 0.01)
}

#[test]
fn explore() {
    let tolerance: f64 = std::env::var("TOL").map_or(1e-6, |t| t.parse().unwrap());
    let cases = fixed_list(&wild(), 100);
    let rows: Vec<_> = cases
        .par_iter()
        .map(|(vehicle, scene)| {
            let row = [ContactRule::Pivot, ContactRule::Face].map(|rule| {
                let (landing, instants) = landed(vehicle, scene, rule, tolerance);
                let scale = landing.energies.initial_kinetic;
                (
                    landing.evaluations,
                    landing.steps,
                    landing.events,
                    given(&instants) / scale,
                    landing.energies.closure() / scale,
                    landing.end_time,
                    format!(
                        "{} {:?}",
                        landing.outcome,
                        landing.beyond.map(|b| b.end.to_string())
                    ),
                )
            });
            row
        })
        .collect();
    for (k, [p, f]) in rows.iter().enumerate() {
        println!(
            "{k} legs {} mu {:.2} C {:.0}\n  P {:?}\n  F {:?}",
            cases[k].0.legs().len(),
            cases[k].1.conditions().pad_friction,
            cases[k].0.legs()[0].design().footpad.crush_pressure / 1578.8,
            p,
            f
        );
    }
}
