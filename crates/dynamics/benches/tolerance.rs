//! Run time against error: what a tolerance costs and what it buys, as CSV on standard output.
//!
//!     cargo bench -p touchdown-dynamics --bench tolerance > results/tolerance.csv
//!
//! Forty landings of the Table 4-1 vehicle around the toppling boundary (level, slope 15 deg,
//! V_V 14 ft/s, cross-slopes 180 to 160 deg, rolls -20 to 10 deg), one thread, each against itself at
//! tolerance 1e-11; then the transition velocity of five grid points against the same.

#[path = "../tests/common/mod.rs"]
mod common;

use std::time::Instant as Clock;

use common::{level_scene, table_4_1};
use touchdown_dynamics::landing::{land, land_observed};
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::record::Instant;
use touchdown_dynamics::scene::{CrushRule, Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

const CONVERGED: f64 = 1e-11;

fn settings(tolerance: f64, time_limit: f64) -> Settings {
    Settings::new(tolerance, time_limit, CrushRule::PivotRate).unwrap()
}

/// State after one second, or none where the landing ended before.
fn after_one_second(vehicle: &Vehicle<3>, scene: &Scene, tolerance: f64) -> Option<Instant<3>> {
    let mut last = None;
    land_observed(vehicle, scene, &settings(tolerance, 1.0), 1.0, |instant| {
        last = (instant.time == 1.0).then(|| instant.clone());
    });
    last
}

/// First velocity at which the vehicle topples, between `low` (stable) and `high` (not), ft/s.
fn transition(vehicle: &Vehicle<3>, point: [f64; 2], bracket: [f64; 2], tolerance: f64) -> f64 {
    let [mut low, mut high] = bracket;
    while high - low > 1e-6 {
        let middle = 0.5 * (low + high);
        let scene = level_scene(point[0], point[1], middle);
        match land(vehicle, &scene, &settings(tolerance, 40.0))
            .outcome
            .class()
        {
            Class::Stable => low = middle,
            _ => high = middle,
        }
    }
    0.5 * (low + high)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn worst(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn main() {
    // `cargo test --benches` asks for a trial run.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let vehicle = table_4_1();
    let scenes: Vec<Scene> = (0..40)
        .map(|k| {
            let (cross_slope, roll) = (
                180.0 - 5.0 * f64::from(k % 5),
                -20.0 + 10.0 * f64::from(k % 4),
            );
            level_scene(cross_slope, roll, 10.9 + 0.025 * f64::from(k))
        })
        .collect();
    let converged: Vec<_> = scenes
        .iter()
        .map(|scene| after_one_second(&vehicle, scene, CONVERGED))
        .collect();
    let points = [
        [180.0, 0.0],
        [180.0, -20.0],
        [170.0, -10.0],
        [160.0, 10.0],
        [130.0, -20.0],
    ];
    let brackets = points.map(|[cross_slope, roll]| {
        let class = |speed: f64| {
            let scene = level_scene(cross_slope, roll, speed);
            land(&vehicle, &scene, &settings(1e-6, 40.0))
                .outcome
                .class()
        };
        let high = (1..=100)
            .map(|k| 0.25 * f64::from(k))
            .find(|&v| class(v) != Class::Stable);
        high.map(|high| [high - 0.25, high])
    });
    let boundaries = |tolerance: f64| -> Vec<f64> {
        points
            .iter()
            .zip(brackets)
            .filter_map(|(&point, bracket)| {
                bracket.map(|bracket| transition(&vehicle, point, bracket, tolerance))
            })
            .collect()
    };
    let exact = boundaries(CONVERGED);

    println!(
        "tolerance,median_us_per_landing,mean_us_per_landing,mean_steps,mean_derivative_evaluations,\
         median_position_error_at_1s_ft,worst_position_error_at_1s_ft,\
         median_pitch_error_at_1s_deg,worst_pitch_error_at_1s_deg,worst_transition_error_fps"
    );
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
        let (mut times, mut steps, mut evaluations) = (Vec::new(), 0, 0);
        for scene in &scenes {
            let clock = Clock::now();
            let landing = land(&vehicle, scene, &settings(tolerance, 40.0));
            times.push(clock.elapsed().as_secs_f64() * 1e6);
            steps += landing.steps;
            evaluations += landing.evaluations;
        }
        let (mut position, mut pitch) = (Vec::new(), Vec::new());
        for (scene, exact) in scenes.iter().zip(&converged) {
            let (Some(exact), Some(found)) = (exact, after_one_second(&vehicle, scene, tolerance))
            else {
                continue;
            };
            position.push((found.position - exact.position).norm());
            let turned = found.attitude.euler().pitch - exact.attitude.euler().pitch;
            pitch.push(turned.abs().to_degrees());
        }
        let off: Vec<f64> = boundaries(tolerance)
            .iter()
            .zip(&exact)
            .map(|(found, exact)| (found - exact).abs())
            .collect();
        let count = scenes.len() as f64;
        println!(
            "{tolerance:e},{:.0},{:.0},{:.0},{:.0},{:.1e},{:.1e},{:.1e},{:.1e},{:.1e}",
            median(times.clone()),
            times.iter().sum::<f64>() / count,
            steps as f64 / count,
            evaluations as f64 / count,
            median(position.clone()),
            worst(&position),
            median(pitch.clone()),
            worst(&pitch),
            worst(&off),
        );
    }
}
