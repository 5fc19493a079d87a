//! A Monte Carlo of touchdowns on threads of its own: how probable is it that the Surveyor topples?
//!
//! ```text
//! cargo run --release -p touchdown-sweep --example monte_carlo -- 2000
//! ```
//!
//! Every block of landings has random numbers of its own, so that the result does not depend on the threads.

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::Normal;
use rayon::prelude::*;
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_sweep::input::readers::scene_input::NamedConditions;
use touchdown_sweep::input::readers::vehicle_file::VehicleFile;
use touchdown_sweep::summary::probabilities::wilson;

const VEHICLE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../sweeps/vehicles/surveyor-table-4-1.toml"
);
const SEED: u64 = 1966;
/// Landings of a block: more than the lanes of a thread.
const BLOCK: usize = 100;

type Fault = Box<dyn Error + Send + Sync>;
/// Numbers of landings, in the order of [`Class::ALL`].
type Counts = [u64; Class::ALL.len()];

/// Draws a touchdown.
fn touchdown(random: &mut ChaCha8Rng) -> Result<Scene, Fault> {
    Ok(NamedConditions::of([
        (
            "vertical_velocity_fps",
            random.sample(Normal::new(14.0, 1.0)?),
        ),
        ("horizontal_velocity_fps", random.random_range(0.0..13.0)),
        ("cross_slope_deg", random.random_range(0.0..360.0)),
        ("roll_deg", random.random_range(-60.0..60.0)),
        ("slope_deg", random.random_range(0.0..15.0)),
        ("friction", random.random_range(0.6..1.0)),
    ])
    .scene()?)
}

/// Lands a block of touchdowns in the lanes of one thread.
fn block(number: usize, vehicle: &Arc<Vehicle>) -> Result<Counts, Fault> {
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    random.set_stream(number as u64);
    let scenes = (0..BLOCK).map(|_| touchdown(&mut random));
    let scenes = scenes.collect::<Result<Vec<Scene>, Fault>>()?;
    let settings = Settings::default().with_tolerance(Settings::BOUNDARY_TOLERANCE)?;
    let mut requests = scenes.into_iter().enumerate().map(|(key, scene)| Request {
        key,
        vehicle: Arc::clone(vehicle),
        scene,
        settings,
    });
    let mut counts = Counts::default();
    land_many(&mut || requests.next(), &mut |_, landing| {
        counts[landing.outcome.class() as usize] += 1;
    });
    Ok(counts)
}

fn main() -> Result<(), Fault> {
    let landings: usize = match std::env::args().nth(1) {
        Some(count) => count.parse()?,
        None => 2000,
    };
    let vehicle = Arc::new(VehicleFile::read(Path::new(VEHICLE))?.vehicle);
    let blocks = (0..landings.div_ceil(BLOCK)).into_par_iter();
    let counts = blocks
        .map(|number| block(number, &vehicle))
        .try_reduce(Counts::default, |a, b| {
            Ok(std::array::from_fn(|class| a[class] + b[class]))
        })?;

    let total = counts.iter().sum();
    for (class, count) in Class::ALL.into_iter().zip(counts) {
        let [low, high] = wilson(count, total).map(|share| 100.0 * share);
        println!("{class}: {count} of {total}, {low:.2} to {high:.2} % at 95 %");
    }
    Ok(())
}
