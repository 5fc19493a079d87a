//! The report's integrator against what the report printed with it, and against the converged
//! answer.

use crate::common::{Row, reference, sample_deck, scenes, settings, table_4_1};
use nalgebra::Vector3;
use rayon::prelude::*;
use touchdown_dynamics::land::land_with_summary;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::methods::{ErrorControl, ErrorLimits, IntegrationSummary, Method};
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

fn report(scale: f64, first_interval: f64) -> Settings {
    let limits = ErrorLimits::default().scaled(scale);
    let control = ErrorControl::new(limits, first_interval, ErrorControl::LEAST_INTERVAL).unwrap();
    settings(Settings::DEFAULT_TOLERANCE).with_method(Method::Report(control))
}

/// First intervals that differ by nothing that matters, s.
fn first_intervals(count: usize) -> impl IndexedParallelIterator<Item = f64> {
    (0..count)
        .into_par_iter()
        .map(move |k| 0.0003 + 0.0006 * (k as f64 + 0.5) / count as f64)
}

fn sample_run(settings: &Settings) -> (Landing, IntegrationSummary) {
    land_with_summary(
        &sample_deck(),
        &scenes::sample_run(),
        settings,
        f64::INFINITY,
        &mut |_| {},
    )
}

fn printed(quantity: &str) -> f64 {
    let rows = reference("sample-1966.csv");
    let row = rows.iter().find(|row| row.text("quantity") == quantity);
    row.unwrap().number("printed_1966")
}

/// Whether a run is the one printed in 1966.
fn is_as_printed((landing, summary): &(Landing, IntegrationSummary)) -> bool {
    let angle = landing.min_stability_angle.to_degrees();
    landing.outcome == Outcome::StableRockback
        && (landing.end_time - 2.82).abs() < 0.02
        && (angle - 14.5).abs() < 0.2
        && summary.intervals.abs_diff(537) <= 45
}

#[test]
fn the_printed_branch_is_one_run_in_some() {
    let runs: Vec<_> = first_intervals(200)
        .map(|first| sample_run(&report(1.0, first)))
        .collect();
    let printed_branch: Vec<_> = runs.iter().filter(|run| is_as_printed(run)).collect();
    let share = printed_branch.len() as f64 / runs.len() as f64;
    println!("{} of {} runs", printed_branch.len(), runs.len());
    assert!((0.1..0.3).contains(&share), "{share}");

    // Chosen by their number of intervals, the runs have mean intervals on either side of the print.
    let mut mean_intervals: Vec<f64> = printed_branch
        .iter()
        .map(|(_, summary)| summary.mean_interval())
        .collect();
    mean_intervals.sort_by(f64::total_cmp);
    let middle = mean_intervals[mean_intervals.len() / 2];
    assert!(
        (middle - printed("average_interval_s")).abs() < 0.0002,
        "{middle}"
    );

    // On that branch everything else printed agrees too.
    for (landing, summary) in printed_branch {
        let near = |name: &str, value: f64, limit: f64| {
            let expected = printed(name);
            assert!((value - expected).abs() < limit, "{name}: {value}");
        };
        near("min_clearance_ft", landing.min_clearance, 0.002);
        near("pad_contact_2_s", landing.pad_contact[1].unwrap(), 0.01);
        near("block_contact_3_s", landing.block_contact[2].unwrap(), 0.01);
        // Most intervals lie between 1 and 10 ms, and half or so need no cut.
        assert!((300..400).contains(&summary.by_decade[2]), "{summary:?}");
        assert!(
            summary.by_cuts[0] * 5 > summary.intervals * 2,
            "{summary:?}"
        );
        // 4.1.4: the link rates restrict the interval most, the angular velocities much less.
        let count =
            |variables: std::ops::Range<usize>| -> u64 { summary.critical[variables].iter().sum() };
        let (links, body) = (count(6..9), count(18..21));
        assert!(links > 4 * body && body > 40, "{summary:?}");
    }
}

#[test]
fn the_account_adds_up() {
    let (landing, summary) = sample_run(&report(1.0, ErrorControl::FIRST_INTERVAL));
    assert_eq!(summary.intervals, landing.steps);
    assert_eq!(summary.by_decade.iter().sum::<u64>(), summary.intervals);
    assert_eq!(summary.by_cuts.iter().sum::<u64>(), summary.intervals);
    assert!((summary.time - landing.end_time).abs() < 1e-9);
    let limits = ErrorLimits::default();
    for (variable, limit) in [(6, limits.link_rate), (12, limits.velocity)] {
        let (sum, of_absolutes) = (summary.arithmetic[variable], summary.absolute[variable]);
        assert!(sum.abs() <= of_absolutes && of_absolutes > 0.0);
        // Less than what is allowed per second over all the time.
        assert!(of_absolutes < limit * landing.end_time, "{variable}");
    }
    // A start, three evaluations for the whole interval and seven for each pair of halves.
    let cuts: u64 = (0..)
        .zip(summary.by_cuts)
        .map(|(cuts, intervals)| cuts * intervals)
        .sum();
    let evaluations = summary.intervals * 11 + cuts * 7 + 1;
    assert_eq!(landing.evaluations, evaluations);
}

#[test]
fn tighter_limits_lead_to_the_converged_branch() {
    let (landing, _) = sample_run(&report(1e-4, ErrorControl::FIRST_INTERVAL));
    let converged = reference("sample-1966.csv");
    let converged = |quantity: &str| {
        let row = converged.iter().find(|r| r.text("quantity") == quantity);
        row.map(|row: &Row| row.number("converged_listing_rule"))
            .unwrap()
    };
    let angle = landing.min_stability_angle.to_degrees();
    assert!((angle - converged("min_stability_angle_deg")).abs() < 0.05);
    assert!((landing.end_time - converged("end_time_s")).abs() < 1e-3);
}

/// Mean interval and error of the CG's position at 1 s (ft), as geometric means over runs that
/// differ in their first interval.
fn typical_error(vehicle: &Vehicle, scene: &Scene, scale: f64, exact: &Vector3<f64>) -> (f64, f64) {
    let runs: Vec<(f64, f64)> = first_intervals(4)
        .map(|first| {
            let mut track = Vec::new();
            let mut observe = |instant: &Instant| track.push(instant.position);
            let settings = report(scale, first);
            let (_, summary) = land_with_summary(vehicle, scene, &settings, 0.1, &mut observe);
            (summary.mean_interval(), (track[10] - exact).norm())
        })
        .collect();
    let typical = |values: &dyn Fn(&(f64, f64)) -> f64| {
        let sum: f64 = runs.iter().map(|run| values(run).ln()).sum();
        (sum / runs.len() as f64).exp()
    };
    (typical(&|run| run.0), typical(&|run| run.1))
}

#[test]
fn the_observed_order_is_far_below_four() {
    // The pads' angular acceleration is held over an interval, and laws change inside intervals.
    for (name, vehicle, scene) in [
        ("sample run", sample_deck(), scenes::sample_run()),
        ("Table 4-3", table_4_1(), scenes::table_4_3()),
    ] {
        let mut exact = Vec::new();
        let mut observe = |instant: &Instant| exact.push(instant.position);
        land_with_summary(&vehicle, &scene, &settings(1e-10), 0.1, &mut observe);
        let [(coarse, error), (fine, smaller)] =
            [1e-1, 1e-4].map(|scale| typical_error(&vehicle, &scene, scale, &exact[10]));
        let order = (error / smaller).ln() / (coarse / fine).ln();
        println!(
            "{name}: {error:.2e} ft at {coarse:.2e} s, {smaller:.2e} ft at {fine:.2e} s: \
             order {order:.2}"
        );
        assert!((0.2..0.8).contains(&order), "{name}: {order}");
    }
}

#[test]
fn table_4_3_is_what_this_integrator_gives() {
    let scene = scenes::table_4_3();
    let runs: Vec<Vec<Vector3<f64>>> = first_intervals(24)
        .map(|first| {
            let mut velocities = Vec::new();
            let mut observe = |instant: &Instant| velocities.push(instant.velocity);
            land_with_summary(
                &table_4_1(),
                &scene,
                &report(1.0, first),
                0.02,
                &mut observe,
            );
            velocities
        })
        .collect();
    for row in &reference("table-4-3.csv") {
        let time = row.number("time_s");
        for (column, axis) in [("x_velocity_fps", 0), ("y_velocity_fps", 1)] {
            let values = runs
                .iter()
                .map(|run| run[(time / 0.02).round() as usize][axis]);
            let (least, greatest) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |ends, v| {
                (ends.0.min(v), ends.1.max(v))
            });
            let text = row.text(column);
            let digits = text.len() - text.find('.').unwrap() - 1;
            // The last digit is cut off as often as rounded.
            let rounding = 10f64.powi(-(digits as i32));
            let value = row.number(column);
            println!("{time} {column} {value}: {least:.4} to {greatest:.4}");
            assert!(
                value > least - rounding && value < greatest + rounding,
                "{time} s, {column}: {value}, not {least} to {greatest}"
            );
        }
    }
}
