//! The 400 random reference landings, at the reference's own tolerance and at the default one.

use std::sync::Arc;

use crate::common::complaints::Complaints;
use crate::common::{Row, landing_case, reference, settings, side_by_side};
use rayon::prelude::*;
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::Settings;

/// Landings that end later bounce, and are sensitive to the last digit, s.
const BOUNCING: f64 = 2.5;

/// Within the time by which the end may be off the CG descends by no more than this is worth, ft·lb.
const DESCENT: f64 = 0.1;

/// Greatest strut forces are within this, lb: the reference's are those at the ends of its own short steps.
const FORCE: f64 = 1.0;

/// Case whose late stability angle no tolerance settles: it chatters through thousands of events.
/// Others within 0.2 deg; this one is known to no better than its own scatter.
const UNSETTLED: &str = "216";
const SCATTER_DEG: f64 = 0.3;

fn compare(row: &Row, landing: &Landing) -> Complaints {
    let mut complaints = Complaints::default();
    if row.text("marginal") == "1" {
        return complaints;
    }
    let name = format!("case {}", row.text("case"));
    let early = row.number("end_time_s") < BOUNCING;
    let outcome = landing.outcome.to_string();
    complaints.same(&name, "outcome", outcome.as_str(), row.text("outcome"));

    let mut near = |column: &str, value: f64, limit: f64| {
        complaints.near(&name, column, value, row.number(column), limit);
    };
    let angle = landing.min_stability_angle.to_degrees();
    if early {
        near("end_time_s", landing.end_time, 1e-3);
        near("min_stability_angle_deg", angle, 0.01);
    }
    let energies = &landing.energies;
    near(
        "initial_kinetic_energy_ftlb",
        energies.initial_kinetic,
        1e-5,
    );
    for (leg, (pad, block)) in (landing.pad_contact.iter())
        .zip(&landing.block_contact)
        .enumerate()
    {
        let contact = |time: &Option<f64>| time.unwrap_or(-1.0);
        near(&format!("pad_contact_{}_s", leg + 1), contact(pad), 1e-5);
        near(
            &format!("block_contact_{}_s", leg + 1),
            contact(block),
            1e-5,
        );
    }
    // The reference leaves out the end state, so a vehicle still descending there differs a little.
    near("min_clearance_ft", landing.min_clearance, 1e-3);
    for (leg, force) in landing.max_strut_force.iter().enumerate() {
        near(&format!("max_strut_force_{}_lb", leg + 1), *force, FORCE);
    }
    if early {
        near(
            "potential_energy_change_ftlb",
            energies.potential_change,
            DESCENT,
        );
    } else {
        complaints.near(
            &name,
            "late end",
            landing.end_time,
            row.number("end_time_s"),
            0.1,
        );
        complaints.near(
            &name,
            "late angle",
            angle,
            row.number("min_stability_angle_deg"),
            if row.text("case") == UNSETTLED {
                SCATTER_DEG
            } else {
                0.2
            },
        );
    }
    complaints
}

/// Lands the first `count` of them.
fn compare_first(count: usize, tolerance: f64) {
    let rows = reference("landings.csv");
    assert_eq!(rows.len(), 400);
    let complaints: Vec<_> = rows[..count]
        .par_chunks(200)
        .flat_map_iter(|rows| {
            let requests = rows.iter().enumerate().map(|(key, row)| {
                let (vehicle, scene) = landing_case(row);
                Request {
                    key,
                    vehicle: Arc::new(vehicle),
                    scene,
                    settings: settings(tolerance),
                }
            });
            let landings = side_by_side(requests);
            rows.iter()
                .zip(landings)
                .map(|(row, landing)| compare(row, &landing))
        })
        .collect();
    complaints.into_iter().collect::<Complaints>().settle();
}

#[test]
fn at_the_tolerance_of_the_reference() {
    compare_first(100, 1e-9);
}

#[test]
fn at_the_default_tolerance() {
    compare_first(400, Settings::DEFAULT_TOLERANCE);
}

/// The proof that the reference's number for the unsettled case is one of many.
#[test]
fn one_case_is_unsettled() {
    let rows = reference("landings.csv");
    let row = rows.iter().find(|row| row.text("case") == UNSETTLED);
    let (vehicle, scene) = landing_case(row.unwrap());
    let angles: Vec<f64> = [1e-6, 1e-7, 1e-8, 1e-9, 1e-10]
        .iter()
        .map(|&tolerance| land(&vehicle, &scene, &settings(tolerance)))
        .inspect(|landing| assert!(landing.events > 1000, "{}", landing.events))
        .map(|landing| landing.min_stability_angle.to_degrees())
        .collect();
    let differences: Vec<f64> = angles.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
    println!("{angles:?}");
    // Tightened tenfold four times, the angle moves as much at the end as at the start; were it
    // converging, the last differences would be a hundredth and a thousandth of the first.
    assert!(
        differences[2..].iter().any(|&d| d > 0.05),
        "{differences:?}"
    );
    assert!(
        differences.iter().all(|&d| d < SCATTER_DEG),
        "{differences:?}"
    );
}

/// The proof that the reference's end of one landing, which subsides on the verge of not yet doing so, is
/// itself out by most of the 1e-3 s that are allowed: tightened tenfold, and again, the end stays, elsewhere.
#[test]
fn one_end_of_the_reference_has_not_converged() {
    let rows = reference("landings.csv");
    let row = rows.iter().find(|row| row.text("case") == "308").unwrap();
    let (vehicle, scene) = landing_case(row);
    let [at_8, at_9, at_10, at_11] = [1e-8, 1e-9, 1e-10, 1e-11]
        .map(|tolerance| land(&vehicle, &scene, &settings(tolerance)).end_time);
    println!("{at_8} {at_9} {at_10} {at_11}");
    assert!((at_9 - at_8).abs() < 1e-4);
    assert!((at_10 - at_9).abs() < 1e-6);
    assert!((at_11 - at_10).abs() < 1e-6);
    let off = at_11 - row.number("end_time_s");
    assert!((8e-4..9e-4).contains(&off), "{off:e}");
}
