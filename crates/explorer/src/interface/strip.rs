//! `strip`: outcomes over a range of V_H, a few landings at a time.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use touchdown_dynamics::batch::{self, land_many};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Scene, Settings, Stop};
use touchdown_dynamics::vehicle::Vehicle;

use super::IsOver;
use super::complaint::Complaint;
use super::request::{Asked, ClassWords, class_named, class_words, read, within, written};
use super::touchdown::Touchdown;
use crate::named::Named;

/// Default and greatest number of landings per request.
const FEW: usize = 16;
const MOST: usize = 64;
/// Greatest number of known landings in a request.
const MOST_KNOWN: usize = 2000;
/// Steps of the first scan; final resolution between differing neighbours, as a division of the range.
const SCAN: usize = 32;
const RESOLUTION: f64 = 500.0;
/// Greatest speed, ft/s.
const FASTEST: f64 = 1e4;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    #[serde(default)]
    touchdown: Asked,
    from_fps: Option<f64>,
    to_fps: Option<f64>,
    #[serde(default)]
    known: Vec<Known>,
    most: Option<usize>,
    resolution_fps: Option<f64>,
}

#[derive(Deserialize)]
struct Known {
    speed_fps: f64,
    class: String,
}

#[derive(Serialize)]
struct Answer {
    landings: Vec<Told>,
    bands: Vec<Band>,
    is_done: bool,
}

#[derive(Serialize)]
struct Told {
    speed_fps: f64,
    class: String,
    outcome: String,
}

#[derive(Serialize)]
struct Band {
    from_fps: f64,
    to_fps: f64,
    #[serde(flatten)]
    class: ClassWords,
}

/// A speed, ft/s, and the class of the landing there.
type Ended = (f64, Class);

pub fn answer(named: &Named, request: &str, is_over: IsOver) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    let scene = touchdown.scene()?;
    let range = range(&touchdown, request.from_fps, request.to_fps)?;
    let width = range[1] - range[0];
    let resolution = request.resolution_fps.unwrap_or(width / RESOLUTION);
    within("resolution_fps", resolution, [1e-4 * width, width])?;
    let most = request.most.unwrap_or(FEW);
    within("most", most as f64, [1.0, MOST as f64])?;
    let mut ended = known(&request.known, range)?;

    let wanted = wanted(&ended, range, resolution);
    let is_done = wanted.len() <= most;
    let speeds = spread(&wanted, most);
    let vehicle = Arc::new(touchdown.vehicle.vehicle.clone());
    let settings = settings(&touchdown)?;
    let landings = land_at(&vehicle, &scene, &settings, &speeds, is_over)?;
    let told: Vec<Told> = (speeds.iter().zip(&landings))
        .map(|(speed, landing)| Told {
            speed_fps: *speed,
            class: landing.outcome.class().to_string(),
            outcome: landing.outcome.to_string(),
        })
        .collect();
    let new = speeds.iter().zip(&landings);
    ended.extend(new.map(|(speed, landing)| (*speed, landing.outcome.class())));
    ended.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let is_done = is_done && self::wanted(&ended, range, resolution).is_empty();
    written(&Answer {
        landings: told,
        bands: bands(&ended, range),
        is_done,
    })
}

/// Lands at all these speeds (ft/s), in lanes, which changes no bit.
///
/// # Errors
/// If the answer is no longer wanted, or a speed is not allowed.
fn land_at(
    vehicle: &Arc<Vehicle>,
    scene: &Scene,
    settings: &Settings,
    speeds: &[f64],
    is_over: IsOver,
) -> Result<Vec<Landing>, Complaint> {
    let at = |speed: &f64| {
        let moved = scene.with_horizontal_velocity(*speed);
        moved.map_err(|invalid| Complaint::value("speed_fps", speed, &invalid.allowed))
    };
    let scenes = speeds.iter().map(at).collect::<Result<Vec<Scene>, _>>()?;
    let mut landings: Vec<Option<Landing>> = vec![None; speeds.len()];
    let mut next = 0;
    land_many(
        &mut || {
            let scene = *scenes.get(next).filter(|_| !is_over())?;
            next += 1;
            Some(batch::Request {
                key: next - 1,
                vehicle: Arc::clone(vehicle),
                scene,
                settings: *settings,
            })
        },
        &mut |key, landing| landings[key] = Some(landing),
    );
    let all: Option<Vec<Landing>> = landings.into_iter().collect();
    all.ok_or_else(Complaint::over)
}

/// The range of a request, ft/s; defaults to that of the source.
///
/// # Errors
/// If it is not a valid range.
pub fn range(
    touchdown: &Touchdown,
    from: Option<f64>,
    to: Option<f64>,
) -> Result<[f64; 2], Complaint> {
    let [low, high] = touchdown.source.search;
    let from = within("from_fps", from.unwrap_or(low), [0.0, FASTEST])?;
    let to = within("to_fps", to.unwrap_or(high), [0.0, FASTEST])?;
    match to - from > 1e-3 {
        true => Ok([from, to]),
        false => Err(Complaint::value(
            "to_fps",
            to,
            &format!("more than from_fps, {from}"),
        )),
    }
}

/// Settings of landings of which only the class is needed: they end at the verdict, with the tolerance of searches
/// unless another is given.
///
/// # Errors
/// Only a fault of the program.
pub fn settings(touchdown: &Touchdown) -> Result<Settings, Complaint> {
    let settings = touchdown.settings;
    let tolerance = match touchdown.gives_solver("tolerance") {
        true => settings.tolerance(),
        false => Settings::BOUNDARY_TOLERANCE,
    };
    let of_search = settings
        .stopping_at(Stop::Verdict)
        .with_tolerance(tolerance);
    of_search.map_err(Complaint::engine)
}

fn known(known: &[Known], [from, to]: [f64; 2]) -> Result<Vec<Ended>, Complaint> {
    within("known", known.len() as f64, [0.0, MOST_KNOWN as f64])?;
    let ended = known.iter().map(|one| {
        within("known.speed_fps", one.speed_fps, [from, to])?;
        let class = class_named(&one.class).ok_or_else(|| {
            let allowed = "stable, unstable, bottomed, failure or undecided";
            Complaint::value("known.class", format!("{:?}", one.class), allowed)
        })?;
        Ok((one.speed_fps, class))
    });
    let mut ended = ended.collect::<Result<Vec<Ended>, Complaint>>()?;
    ended.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    Ok(ended)
}

/// Informative speeds: those of the first scan, then the middles between differing neighbours.
fn wanted(ended: &[Ended], [from, to]: [f64; 2], resolution: f64) -> Vec<f64> {
    let step = (to - from) / SCAN as f64;
    let scan = (0..=SCAN).map(|index| {
        if index == SCAN {
            to
        } else {
            from + step * index as f64
        }
    });
    let is_known = |speed: f64| {
        ended
            .iter()
            .any(|(known, _)| (known - speed).abs() < 1e-6 * step)
    };
    let scan: Vec<f64> = scan.filter(|speed| !is_known(*speed)).collect();
    if !scan.is_empty() {
        return scan;
    }
    let pairs = ended.windows(2);
    let differ = pairs.filter(|pair| pair[0].1 != pair[1].1 && pair[1].0 - pair[0].0 > resolution);
    differ.map(|pair| 0.5 * (pair[0].0 + pair[1].0)).collect()
}

/// At most `most` of these speeds, evenly spread.
fn spread(speeds: &[f64], most: usize) -> Vec<f64> {
    if speeds.len() <= most {
        return speeds.to_vec();
    }
    let last = (most.max(2) - 1) as f64;
    let place = |index: usize| (index as f64 * (speeds.len() - 1) as f64 / last).round() as usize;
    (0..most).map(|index| speeds[place(index)]).collect()
}

/// Runs of like landings, which meet half-way.
fn bands(ended: &[Ended], [from, to]: [f64; 2]) -> Vec<Band> {
    let runs: Vec<&[Ended]> = ended.chunk_by(|a, b| a.1 == b.1).collect();
    let mut low = from;
    let mut bands = Vec::new();
    for (index, run) in runs.iter().enumerate() {
        let high = match runs.get(index + 1) {
            Some(next) => 0.5 * (run[run.len() - 1].0 + next[0].0),
            None => to,
        };
        bands.push(Band {
            from_fps: low,
            to_fps: high,
            class: class_words(run[0].1),
        });
        low = high;
    }
    bands
}
