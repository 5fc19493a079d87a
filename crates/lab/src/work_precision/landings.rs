//! Cost and error of single landings, on one thread.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant as Clock;

use rayon::prelude::*;
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::land::{land, land_observed};
use touchdown_dynamics::record::Instant;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use super::{CONVERGED, settings};
use touchdown::terminal::Failure;

/// Times at which trajectories are compared, in intervals of 0.1 s.
const COMPARED: [usize; 2] = [3, 10];
const INTERVAL: f64 = 0.1;
/// How often the landings are repeated in lanes.
const REPEATED: usize = 5;
/// Times that all tolerances are timed, one after the other.
const ROUNDS: usize = 5;

/// Landings with their converged answers.
pub struct Landings<'v> {
    vehicle: &'v Vehicle,
    scenes: Vec<Scene>,
    converged: Vec<LandingResult>,
}

/// What is compared of a landing.
struct LandingResult {
    /// At the compared times, where the landing lasts that long.
    instants: [Option<Instant>; 2],
    /// Least stability angle, deg.
    least_angle: f64,
}

/// Least times of landings at one tolerance, µs.
pub struct Times {
    /// Of each landing alone.
    alone: Vec<f64>,
    /// Mean in the lanes of registers.
    in_lanes: f64,
    /// Share of the lanes that were filled.
    occupancy: f64,
}

impl Times {
    /// Nothing timed yet.
    fn unknown(landings: usize) -> Self {
        Self {
            alone: vec![f64::INFINITY; landings],
            in_lanes: f64::INFINITY,
            occupancy: 0.0,
        }
    }
}

/// What a tolerance costs, and the error of what it gives: median and worst.
pub struct Measured {
    /// Time of a landing, µs: median and mean.
    pub time: [f64; 2],
    /// The same, mean, side by side in the lanes of registers.
    pub time_in_lanes: f64,
    /// Share of the lanes that were taken.
    pub occupancy: f64,
    /// Steps, evaluations and events of a landing, mean.
    pub steps: f64,
    /// Evaluations of the equations of motion, whole or in part.
    pub evaluations: f64,
    /// Changes of the active piece of a law.
    pub events: f64,
    /// Error of position at 0.3 s and 1 s, ft.
    pub position: [[f64; 2]; 2],
    /// Error of pitch at 0.3 s and 1 s, deg.
    pub pitch: [[f64; 2]; 2],
    /// Error of the least stability angle, deg.
    pub least_angle: [f64; 2],
}

impl<'v> Landings<'v> {
    /// Lands with the tightest tolerance.
    pub fn converged(vehicle: &'v Vehicle, scenes: Vec<Scene>) -> Result<Self, Failure> {
        let converged = scenes
            .par_iter()
            .map(|scene| result_of(vehicle, scene, CONVERGED))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            vehicle,
            scenes,
            converged,
        })
    }

    /// Times landings at all tolerances in turns, so that a machine that is busy for a while slows all of them, and
    /// keeps the least time of each.
    pub fn times(&self, tolerances: &[f64]) -> Result<Vec<Times>, Failure> {
        let mut least: Vec<Times> = (tolerances.iter())
            .map(|_| Times::unknown(self.scenes.len()))
            .collect();
        for _ in 0..ROUNDS {
            for (&tolerance, least) in tolerances.iter().zip(&mut least) {
                let settings = settings(tolerance)?;
                for (scene, least) in self.scenes.iter().zip(&mut least.alone) {
                    let clock = Clock::now();
                    black_box(land(self.vehicle, scene, &settings));
                    *least = least.min(clock.elapsed().as_secs_f64() * 1e6);
                }
                let (in_lanes, occupancy) = self.measure_in_lanes(&settings);
                least.in_lanes = least.in_lanes.min(in_lanes);
                least.occupancy = occupancy;
            }
        }
        Ok(least)
    }

    /// Lands with a tolerance and compares; the `times` are of this tolerance.
    pub fn measure(&self, tolerance: f64, times: &Times) -> Result<Measured, Failure> {
        let settings = settings(tolerance)?;
        let mut sums = [0; 3];
        for scene in &self.scenes {
            let landing = land(self.vehicle, scene, &settings);
            let counts = [landing.steps, landing.evaluations, landing.events];
            sums.iter_mut().zip(counts).for_each(|(sum, n)| *sum += n);
        }
        let computed: Vec<LandingResult> = self
            .scenes
            .par_iter()
            .map(|scene| result_of(self.vehicle, scene, tolerance))
            .collect::<Result<_, _>>()?;
        let pairs = || computed.iter().zip(&self.converged);
        let at = |time: usize, error: fn(&Instant, &Instant) -> f64| {
            let errors = pairs().filter_map(|(one, other)| {
                Some(error(
                    one.instants[time].as_ref()?,
                    other.instants[time].as_ref()?,
                ))
            });
            median_and_worst(errors.collect())
        };
        let position = |one: &Instant, other: &Instant| (one.position - other.position).norm();
        let pitch = |one: &Instant, other: &Instant| {
            let [one, other] = [one, other].map(|instant| instant.attitude.euler().pitch);
            (one - other).abs().to_degrees()
        };
        let count = self.scenes.len() as f64;
        let [steps, evaluations, events] = sums.map(|sum| sum as f64 / count);
        Ok(Measured {
            time: [
                median_and_worst(times.alone.clone())[0],
                times.alone.iter().sum::<f64>() / count,
            ],
            time_in_lanes: times.in_lanes,
            occupancy: times.occupancy,
            steps,
            evaluations,
            events,
            position: [at(0, position), at(1, position)],
            pitch: [at(0, pitch), at(1, pitch)],
            least_angle: median_and_worst(
                pairs()
                    .map(|(one, other)| (one.least_angle - other.least_angle).abs())
                    .collect(),
            ),
        })
    }
}

impl Landings<'_> {
    /// Mean time of a landing in the lanes of registers, µs, and the share of lanes that were taken, over so many
    /// landings that few of them are the last ones.
    fn measure_in_lanes(&self, settings: &Settings) -> (f64, f64) {
        let scenes = self
            .scenes
            .iter()
            .cycle()
            .take(REPEATED * self.scenes.len());
        let count = scenes.clone().count() as f64;
        let vehicle = Arc::new(self.vehicle.clone());
        let mut requests = scenes.enumerate().map(|(key, scene)| Request {
            key,
            vehicle: Arc::clone(&vehicle),
            scene: *scene,
            settings: *settings,
        });
        let clock = Clock::now();
        let occupancy = land_many(&mut || requests.next(), &mut |_, landing| {
            black_box(landing);
        });
        let time = clock.elapsed().as_secs_f64() * 1e6;
        (time / count, occupancy.share())
    }
}

fn result_of(vehicle: &Vehicle, scene: &Scene, tolerance: f64) -> Result<LandingResult, Failure> {
    let mut instants = [None, None];
    let mut count = 0;
    let settings = settings(tolerance)?;
    let mut observe = |instant: &Instant| {
        // The end of a landing is reported too, but not at a full interval.
        let is_regular = (instant.time - INTERVAL * count as f64).abs() < 1e-9;
        if let (true, Some(k)) = (is_regular, COMPARED.iter().position(|&n| n == count)) {
            instants[k] = Some(instant.clone());
        }
        count += 1;
    };
    let landing = land_observed(vehicle, scene, &settings, INTERVAL, &mut observe);
    Ok(LandingResult {
        instants,
        least_angle: landing.min_stability_angle.to_degrees(),
    })
}

/// Median and greatest of some errors; not a number where there are none.
pub fn median_and_worst(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    match errors.as_slice() {
        [] => [f64::NAN; 2],
        sorted => [sorted[sorted.len() / 2], sorted[sorted.len() - 1]],
    }
}
