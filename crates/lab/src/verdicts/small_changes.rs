//! Whether small changes of a lander change the outcome of a landing well below its first transition.

use std::collections::BTreeMap;
use std::sync::Arc;

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::vehicle::{Leg, Vehicle};
use touchdown_sweep::output::file_writer::Folder;

use super::draw::{Draw, HIGHEST, Stock, like};
use super::{LIMIT, Options, land_all, of_all_draws, settings};
use touchdown::terminal::{Failure, print};

/// Speeds at which the first transition is looked for: so many, so far apart, ft/s.
const SPEEDS: u32 = 16;
const APART: f64 = HIGHEST / SPEEDS as f64;
/// Share of the speed of the first transition up to which landings are changed.
const SHARE: f64 = 2.0 / 3.0;
/// Closer looks for a first transition of landers whose outcome a change has changed, until one is found: speeds are no
/// farther apart than this, ft/s, and so many at least.
const CLOSE: f64 = 0.01 / 0.3048;
const CLOSE_SPEEDS: [f64; 2] = [300.0, 6000.0];
/// Changes: a millimetre in ft, a gram in slug.
const LENGTH: f64 = 1e-3 / 0.3048;
const MASS: f64 = 1e-3 / 14.593_902_937_206_364;
const CHANGES: [&str; 3] = ["CG 1 mm aside", "1 g more", "first footpad 1 mm higher"];
/// A landing and those with each change.
const ALIKE: usize = 1 + CHANGES.len();

/// Motions have parted once their CGs are so far apart, ft, and that is looked for at such intervals, s.
const PARTED: f64 = 10.0 * LENGTH;
const LOOK: f64 = 1e-3;

/// A landing whose outcome a small change has changed.
struct Difference {
    number: u64,
    kinds: [&'static str; 4],
    legs: usize,
    /// Lowest speed at which the lander is not stable, and speed of the landing, ft/s.
    transition: f64,
    speed: f64,
    /// Lowest speed at which a closer look finds it not stable, if that makes the landing one near a transition, ft/s.
    closer: Option<f64>,
    change: &'static str,
    outcomes: [Outcome; 2],
    /// When the motions part, s.
    parting: f64,
}

/// What small changes of landings came to.
#[derive(Default)]
struct Sum {
    /// Landings that were changed.
    landings: u64,
    /// Landers that are not stable at any speed.
    never_stable: u64,
    differences: Vec<Difference>,
}

/// Runs `verdicts --small-changes`.
pub(super) fn run(
    options: &Options,
    stock: &Stock,
    folder: &Folder,
    count: u64,
) -> Result<(), Failure> {
    let name = "small-changes.csv";
    let keep = |sums: &[Sum]| {
        let all: Vec<&Difference> = sums.iter().flat_map(|sum| &sum.differences).collect();
        let file = (name.to_owned(), table(&all).into_bytes());
        folder.write_files(&[file]).map(|_| ())
    };
    let landed = of_all_draws(
        options,
        stock,
        count,
        |draws| Ok(vec![changed(draws)?]),
        keep,
    )?;
    let mut sum = Sum::default();
    for part in landed.all {
        sum.landings += part.landings;
        sum.never_stable += part.never_stable;
        sum.differences.extend(part.differences);
    }
    sum.differences
        .sort_by_key(|difference| (difference.number, difference.change));
    let all: Vec<&Difference> = sum.differences.iter().collect();
    let files = [(name.to_owned(), table(&all).into_bytes())];
    let written = folder.write_files(&files)?;
    let mut by_change: BTreeMap<&str, usize> = CHANGES.map(|change| (change, 0)).into();
    for difference in &all {
        *by_change.entry(difference.change).or_default() += 1;
    }
    let near = all
        .iter()
        .filter(|difference| difference.closer.is_some())
        .count();
    let lines = by_change
        .iter()
        .map(|(change, count)| format!("  {count:>7}  outcomes differ: {change}\n"));
    let left = all.len() - near;
    print(&format!(
        "{} landings, seed {}, model version {MODEL_VERSION}, {:.0} s; {} landers more are stable at no speed\n{}  {near:>7}  of these are nearer to a transition by a closer look, {left} are not\n  {}",
        sum.landings,
        options.seed,
        landed.time.as_secs_f64(),
        sum.never_stable,
        lines.collect::<String>(),
        touchdown::terminal::summary::written(&written),
    ))?;
    match left {
        0 => Ok(()),
        _ => Err(Failure::running(format!(
            "{left} outcomes differ well below a transition"
        ))),
    }
}

/// Lands landers with as many legs with and without small changes.
fn changed(draws: &[Draw]) -> Result<Sum, Failure> {
    let mut sum = Sum::default();
    // Each landing is followed by those with changes.
    let mut landings = Vec::new();
    let mut found = Vec::new();
    for (draw, transition) in draws.iter().zip(transitions(draws)?) {
        if transition == 0.0 {
            sum.never_stable += 1;
            continue;
        }
        // The speed that was drawn is spread evenly from 0 to the highest.
        let drawn = draw.scene.conditions().horizontal_velocity;
        let speed = SHARE * transition * drawn / HIGHEST;
        found.push((draw, transition, speed));
        for vehicle in variants(&draw.vehicle).map_err(Failure::running)? {
            landings.push(draw.at_speed(speed, vehicle).map_err(Failure::running)?);
        }
    }
    sum.landings = found.len() as u64;
    let settings = settings(LIMIT)?;
    let outcomes = land_all(landings.iter().map(|draw| (draw, settings)));
    let alike = landings.chunks(ALIKE).zip(outcomes.chunks(ALIKE));
    for ((draw, transition, speed), (landings, outcomes)) in found.into_iter().zip(alike) {
        for (index, change) in (1..).zip(CHANGES) {
            let both = [0, index].map(|landing| outcomes[landing].outcome.clone());
            if both[0].class() == both[1].class() {
                continue;
            }
            sum.differences.push(Difference {
                number: draw.number,
                kinds: draw.kinds(),
                legs: draw.vehicle.leg_count(),
                transition,
                speed,
                closer: closer_transition(draw, speed / SHARE)?,
                change,
                outcomes: both,
                parting: parting([&landings[0], &landings[index]])?,
            });
        }
    }
    Ok(sum)
}

/// Lowest of the speeds at which each lander is not stable, ft/s.
fn transitions(draws: &[Draw]) -> Result<Vec<f64>, Failure> {
    let settings = settings(LIMIT)?;
    let mut found: Vec<Option<f64>> = draws.iter().map(|_| None).collect();
    for step in 0..SPEEDS {
        let speed = APART * f64::from(step);
        let left: Vec<usize> = (0..draws.len())
            .filter(|&index| found[index].is_none())
            .collect();
        let moving: Result<Vec<Draw>, Invalid> = (left.iter())
            .map(|&index| draws[index].at_speed(speed, Arc::clone(&draws[index].vehicle)))
            .collect();
        let landed = land_all(
            moving
                .map_err(Failure::running)?
                .iter()
                .map(|draw| (draw, settings)),
        );
        for (index, landing) in left.into_iter().zip(landed) {
            if landing.outcome.class() != Class::Stable {
                found[index] = Some(speed);
            }
        }
    }
    Ok(found
        .into_iter()
        .map(|speed| speed.unwrap_or(HIGHEST))
        .collect())
}

/// Lowest of closely spaced speeds below a limit (ft/s) at which a lander is not stable, ft/s.
fn closer_transition(draw: &Draw, limit: f64) -> Result<Option<f64>, Failure> {
    for least in CLOSE_SPEEDS {
        let step = CLOSE.min(limit / least);
        let speeds = (0..).map(|count| step * f64::from(count));
        let speeds: Vec<f64> = speeds.take_while(|speed| *speed < limit).collect();
        let found = first_not_stable(draw, &speeds)?;
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// The first of some speeds (ft/s) at which a lander is not stable.
fn first_not_stable(draw: &Draw, speeds: &[f64]) -> Result<Option<f64>, Failure> {
    let settings = settings(LIMIT)?;
    let landings: Result<Vec<Draw>, Invalid> = (speeds.iter())
        .map(|&speed| draw.at_speed(speed, Arc::clone(&draw.vehicle)))
        .collect();
    let landings = landings.map_err(Failure::running)?;
    let landed = land_all(landings.iter().map(|draw| (draw, settings)));
    let first = landed
        .iter()
        .position(|landing| landing.outcome.class() != Class::Stable);
    Ok(first.map(|index| speeds[index]))
}

/// A vehicle without and with each of the changes.
fn variants(vehicle: &Arc<Vehicle>) -> Result<[Arc<Vehicle>; ALIKE], Invalid> {
    let (mass, height) = (vehicle.mass(), vehicle.center_of_gravity_height());
    let [x, y] = vehicle.center_of_gravity_offset();
    let legs = vehicle.hinged_legs().to_vec();
    let aside = like(vehicle, mass, height, legs.clone())?;
    let heavier = like(vehicle, mass + MASS, height, legs.clone())?;
    let mut design = legs[0].design().clone();
    design.footpad.height -= LENGTH;
    let mut shorter = legs;
    shorter[0] = Leg::new(design)?;
    let shorter = like(vehicle, mass, height, shorter)?;
    Ok([
        Arc::clone(vehicle),
        Arc::new(aside.with_center_of_gravity_offset([x + LENGTH, y])?),
        Arc::new(heavier.with_center_of_gravity_offset([x, y])?),
        Arc::new(shorter.with_center_of_gravity_offset([x, y])?),
    ])
}

/// When two motions part, s; the earlier end of those that do not.
fn parting(draws: [&Draw; 2]) -> Result<f64, Failure> {
    let settings = settings(LIMIT)?;
    let [a, b] = draws.map(|draw| {
        let mut places = Vec::new();
        let mut observe = |instant: &Instant| places.push((instant.time, instant.position));
        land_observed(&draw.vehicle, &draw.scene, &settings, LOOK, &mut observe);
        places
    });
    let apart = (a.iter().zip(&b)).find(|((_, a), (_, b))| (a - b).norm() > PARTED);
    let last = a.len().min(b.len()) - 1;
    Ok(apart.map_or(a[last].0, |((time, _), _)| *time))
}

/// Landings whose outcomes differ as a table.
fn table(differences: &[&Difference]) -> String {
    let rows = differences.iter().map(|difference| {
        let [without, with] = &difference.outcomes;
        format!(
            "{},{},{},{:.4},{},{:.4},{},{without},{with},{:.3}\n",
            difference.number,
            difference.kinds.join(","),
            difference.legs,
            difference.transition,
            difference
                .closer
                .map_or(String::new(), |speed| format!("{speed:.4}")),
            difference.speed,
            difference.change,
            difference.parting,
        )
    });
    "landing,place,lander,ground,engine,legs,transition_fps,closer_transition_fps,horizontal_velocity_fps,change,outcome,outcome_with_change,parting_s\n"
        .to_owned()
        + &rows.collect::<String>()
}
