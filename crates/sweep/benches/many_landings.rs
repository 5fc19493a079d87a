//! How long many landings take: a thousand of them, and all bands of the level-vehicle grid.
//!
//! ```text
//! cargo bench -p touchdown-sweep                      # some minutes
//! cargo bench -p touchdown-sweep -- thousand_landings
//! ```
//!
//! On one thread and on every core. What that means is printed below it: the error of the landings,
//! and of the transitions against the converged ones of the reference and a scan by 0.02 ft/s.

use std::error::Error;
use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

use divan::Bencher;
use divan::counter::ItemsCount;
use serde::Deserialize;
use touchdown_dynamics::batch::Request;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::{CrushRule, Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::measured_scenes::level_grid;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::Boundary;
use touchdown_sweep::threads::run::{RunError, Workers};

const ONE_THREAD: &str = "one thread";
const THREADS: [&str; 2] = [ONE_THREAD, "every core"];
const LANDINGS: usize = 1000;
/// Highest V_H of the thousand landings, ft/s.
const FASTEST: f64 = 25.0;
const CONVERGED: f64 = 1e-9;
/// Angles from the end of long, bouncing landings are not reproducible.
const QUANTILES: [(&str, f64); 2] = [("median", 0.5), ("90 %", 0.9)];

/// What has been found out about errors, to be told after the times.
static ERRORS: Mutex<Vec<String>> = Mutex::new(Vec::new());

fn main() {
    divan::main();
    for line in ERRORS.lock().unwrap_or_else(PoisonError::into_inner).iter() {
        println!("{line}");
    }
}

/// Tells an error once, whatever the number of threads.
fn tell(found: Result<String, Box<dyn Error>>) {
    let line = found.unwrap_or_else(|error| error.to_string());
    let mut told = ERRORS.lock().unwrap_or_else(PoisonError::into_inner);
    if !told.contains(&line) {
        told.push(line);
    }
}

fn workers(threads: &str) -> Result<Workers, RunError> {
    Workers::start(NonZeroUsize::new(1).filter(|_| threads == ONE_THREAD))
}

fn repository(path: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

type Landings = (Arc<Vehicle>, Vec<Scene>);

/// Landings of the level grid at one speed after another.
fn landings() -> Result<Landings, Box<dyn Error>> {
    let vehicle = VehicleFile::read(&repository("sweeps/vehicles/surveyor-table-4-1.toml"))?;
    let grid = level_grid(false)?;
    let scenes = (0..LANDINGS).map(|k| {
        let speed = FASTEST * k as f64 / LANDINGS as f64;
        grid[k % grid.len()].with_horizontal_velocity(speed)
    });
    Ok((Arc::new(vehicle.vehicle), scenes.collect::<Result<_, _>>()?))
}

fn land(
    (vehicle, scenes): &Landings,
    workers: &Workers,
    tolerance: f64,
) -> Result<Vec<Landing>, Box<dyn Error>> {
    let limit = Settings::DEFAULT_TIME_LIMIT;
    let settings = Settings::new(tolerance, limit, CrushRule::default())?;
    let never = AtomicBool::new(false);
    let request = |key: usize| Request {
        key,
        vehicle: Arc::clone(vehicle),
        scene: scenes[key],
        settings,
    };
    Ok(workers.cases(scenes.len(), request, &(), &never)?)
}

/// A thousand level landings at the tolerance of boundary searches.
#[divan::bench(args = THREADS, sample_count = 1, sample_size = 1)]
fn thousand_landings(bencher: Bencher, threads: &str) {
    let measured = || {
        let workers = workers(threads)?;
        let landings = landings()?;
        let mut found = Ok(Vec::new());
        bencher
            .counter(ItemsCount::new(LANDINGS))
            .bench_local(|| found = land(&landings, &workers, Settings::BOUNDARY_TOLERANCE));
        let converged = land(&landings, &Workers::start(None)?, CONVERGED)?;
        Ok(landing_errors(&found?, &converged))
    };
    tell(measured());
}

fn landing_errors(found: &[Landing], converged: &[Landing]) -> String {
    let pairs = || found.iter().zip(converged);
    let others = pairs().filter(|(a, b)| a.outcome.class() != b.outcome.class());
    let mut errors: Vec<f64> = pairs()
        .map(|(a, b)| (a.min_stability_angle - b.min_stability_angle).abs())
        .collect();
    errors.sort_by(f64::total_cmp);
    let mut line = format!(
        "landings at a tolerance of {:e}: {} of {LANDINGS} outcomes unlike those at {CONVERGED:e}; \
         least stability angle off by",
        Settings::BOUNDARY_TOLERANCE,
        others.count(),
    );
    for (name, quantile) in QUANTILES {
        let error = errors.get((quantile * errors.len() as f64) as usize);
        let degrees = error.map_or(f64::NAN, |error| error.to_degrees());
        // Writing into a string cannot fail.
        let _ = write!(line, " {degrees:.1e} deg ({name})");
    }
    line
}

/// All bands of the 143 points of `crates/lab/sweeps/level-grid.toml`.
#[divan::bench(args = THREADS, sample_count = 1, sample_size = 1)]
fn level_vehicle_grid(bencher: Bencher, threads: &str) {
    let measured = || {
        let workers = workers(threads)?;
        let sweep: Sweep = Sweep::read(&repository("crates/lab/sweeps/level-grid.toml"))?;
        let points: Vec<usize> = (0..sweep.design.count()).collect();
        let mut found = Ok(Vec::new());
        bencher
            .counter(ItemsCount::new(points.len()))
            .bench_local(|| found = workers.points(&sweep, &points));
        let found = found?;
        let points: Vec<Point> = points
            .iter()
            .zip(&found)
            .filter_map(|(&point, finding)| {
                let coordinates = sweep.design.coordinates(point);
                Some(Point {
                    place: [coordinates[0], coordinates[1]],
                    boundary: finding.boundary()?,
                })
            })
            .collect();
        grid_errors(&points)
    };
    tell(measured());
}

/// A point of the grid: cross-slope and roll (deg), and what was found there.
struct Point<'f> {
    place: [f64; 2],
    boundary: &'f Boundary,
}

/// A row of `crates/dynamics/tests/reference/transitions.csv`.
#[derive(Deserialize)]
struct Converged {
    cross_slope_deg: f64,
    roll_deg: f64,
    first_transition_fps: Option<f64>,
}

/// A row of `crates/lab/results/fine-bands.csv`.
#[derive(Deserialize)]
struct FineBand {
    cross_slope_deg: f64,
    roll_deg: f64,
    from_fps: f64,
    to_fps: f64,
    outcome: String,
}

fn table<T: for<'de> Deserialize<'de>>(path: &str) -> Result<Vec<T>, Box<dyn Error>> {
    let mut reader = csv::Reader::from_path(repository(path))?;
    Ok(reader.deserialize().collect::<Result<_, _>>()?)
}

fn grid_errors(points: &[Point]) -> Result<String, Box<dyn Error>> {
    let at = |cross_slope: f64, roll: f64| {
        let place = [cross_slope, roll];
        points.iter().find(|point| point.place == place)
    };
    let mut errors = Vec::new();
    let mut unlike = 0;
    let reference = "crates/dynamics/tests/reference/transitions.csv";
    for row in table::<Converged>(reference)? {
        let Some(point) = at(row.cross_slope_deg, row.roll_deg) else {
            continue;
        };
        let found = point.boundary.transition.map(|found| found.speed());
        match (found, row.first_transition_fps) {
            (Some(found), Some(converged)) => errors.push((found - converged).abs()),
            (None, None) => {}
            _ => unlike += 1,
        }
    }
    errors.sort_by(f64::total_cmp);
    let [median, worst] = match errors.as_slice() {
        [] => [f64::NAN; 2],
        sorted => [sorted[sorted.len() / 2], sorted[sorted.len() - 1]],
    };
    let fine = table::<FineBand>("crates/lab/results/fine-bands.csv")?;
    let missed = fine.iter().filter(|band| {
        let found = at(band.cross_slope_deg, band.roll_deg).is_some_and(|point| {
            point.boundary.bands.iter().any(|b| {
                let overlaps = b.from <= band.to_fps && b.to >= band.from_fps;
                overlaps && format!("{:?}", b.class).eq_ignore_ascii_case(&band.outcome)
            })
        });
        !found
    });
    Ok(format!(
        "grid: {} of the converged first transitions off by {median:.1e} ft/s (median), {worst:.1e} \
         ft/s (worst), {unlike} missed or made up; {} of the {} bands of a scan by 0.02 ft/s missed",
        errors.len(),
        missed.count(),
        fine.len(),
    ))
}
