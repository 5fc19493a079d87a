//! `touchdown-lab verdicts`: whether anything that follows a verdict contradicts it.

mod draw;
mod small_changes;

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use clap::Args;
use rayon::prelude::*;
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::scene::{Settings, Stop};
use touchdown_sweep::output::file_writer::{Folder, WriteError};
use touchdown_sweep::threads::run::Observer;

use draw::{Choice, Draw, Stock};

use touchdown::terminal::progress::Progress;
use touchdown::terminal::{Failure, interrupt, print};

const EXAMPLES: &str = "\
Examples:
  touchdown-lab verdicts                         # 20000 landings: a quarter of an hour on two cores
  touchdown-lab verdicts --landings 500          # a short run
  touchdown-lab verdicts --landing 1234          # one of them, in full
  touchdown-lab verdicts --soil --out soil       # the same landings on soil
  touchdown-lab verdicts --static-friction --out static   # with feet that stick where they would slide
  touchdown-lab verdicts --three-struts --landings 1000 --out three-struts   # tripods and cantilevers
  touchdown-lab verdicts --small-changes 10000   # whether a millimetre or a gram changes an outcome

Landers with three to eight legs, with equal and with unequal legs, touch down on even and on rough ground, on the Moon, on Mars,
on the Earth and on Ceres, at up to 4 m/s each way, with and without thrust, under physical rules. Each goes on for 60 s
beyond its verdict, those called toppled until they lie on their side. A verdict is contradicted
  - of a landing called stable, if the vehicle ends tilted by more than 60 deg, if a strut, pad or block bottoms, or if it ends
    sliding at more than 0.1 m/s;
  - of a landing called toppled, if the vehicle ends standing.

Small changes: a lander of that kind is landed at every quarter of a metre per second sideways until it is no longer stable; then
at a speed drawn between 0 and two thirds of that, and again with its CG 1 mm to the side, with 1 g more, and with its first
footpad 1 mm higher. small-changes.csv lists every landing whose outcome differs. Its lander is landed at 300 speeds and more, at
most a centimetre per second apart, and if need be at 6000: if it is not stable at less than one and a half times the speed of the
landing, the landing is one near a transition.

verdicts.csv lists the verdicts by kind, verdict-exceptions.csv every landing that contradicts its own.

The tables are written anew every thousand landings, so that Ctrl-C loses no more.

Exit code 0 if there is no contradiction and no difference well below a transition, 1 if there is any.";

/// How long landings go on beyond their verdict, s.
const BEYOND: f64 = 60.0;
/// The same of those called toppled: each in turn until the vehicle lies on its side, s.
const WAITS: [f64; 4] = [1.0, 3.0, 10.0, BEYOND];
/// Tilt of a vehicle that lies on its side, rad.
const LIES: f64 = 80.0 * std::f64::consts::PI / 180.0;
/// Time limit of a verdict, s: on Ceres a lander that bounces flies for half a minute.
const LIMIT: f64 = 120.0;
/// Tilt beyond which a vehicle no longer stands, rad.
const FALLEN: f64 = 60.0 * std::f64::consts::PI / 180.0;
/// Speed above which a vehicle slides at the end, ft/s, and the time over which that is measured, s.
const DRIFT: f64 = 0.1 / 0.3048;
const DRIFTS: f64 = 10.0;
/// Landings at a time between two looks for an interruption.
const CHUNK: u64 = 1000;
/// Landings side by side on one thread.
const GROUP: usize = 64;

/// Interval of a printed course, s.
const COURSE: f64 = 0.05;

/// Options of `verdicts`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Number of landings
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    landings: u64,
    /// Land this one alone and print all that it came to
    #[arg(long, value_name = "NUMBER", conflicts_with = "landings")]
    landing: Option<u64>,
    /// Instead, land so many at up to two thirds of the speed of their first transition, and again with small changes
    #[arg(long, value_name = "N", conflicts_with_all = ["landings", "landing"])]
    small_changes: Option<u64>,
    /// Land on soil of 5 to 200 kPa at 5 cm in place of rock
    #[arg(long)]
    soil: bool,
    /// Draw sliding friction from 0.05 to 0.5, and static friction of up to five times as much
    #[arg(long)]
    static_friction: bool,
    /// Land on tripods and cantilevers in place of hinged legs
    #[arg(long, conflicts_with = "small_changes")]
    three_struts: bool,
    /// Seed of the random numbers; the same seed gives the same landings
    #[arg(long, value_name = "N", default_value_t = 1966)]
    seed: u64,
    /// Folder for the tables, created if missing
    #[arg(
        long,
        value_name = "DIR",
        default_value = "crates/lab/results/verdicts"
    )]
    out: PathBuf,
    /// Threads [default: one for each core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
}

/// What became of a landing.
struct Fate {
    number: u64,
    /// Kinds of place, lander, ground and engine.
    kinds: [&'static str; 4],
    legs: usize,
    verdict: Outcome,
    verdict_time: f64,
    evaluations: u64,
    /// How it went on, unless nothing follows its verdict.
    beyond: Option<Landing>,
    /// Mean horizontal speed at the end, ft/s.
    drift: f64,
    contradiction: Option<&'static str>,
}

impl Fate {
    /// What becomes of landings of landers with as many legs.
    fn of_all(draws: &[Draw]) -> Result<Vec<Self>, Failure> {
        let first = settings(LIMIT)?;
        let verdicts = land_all(draws.iter().map(|draw| (draw, first)));
        let mut beyond: Vec<Option<Landing>> = draws.iter().map(|_| None).collect();
        for wait in WAITS {
            let is_due = |index: &usize| match verdicts[*index].outcome.class() {
                Class::Stable => wait == BEYOND,
                // What lies on its side stays there.
                Class::Unstable => (beyond[*index].as_ref()).is_none_or(|seen| seen.tilt < LIES),
                _ => false,
            };
            let due: Vec<usize> = (0..draws.len()).filter(is_due).collect();
            let landings: Result<Vec<(&Draw, Settings)>, Failure> = (due.iter())
                .map(|&index| {
                    let settings = settings(verdicts[index].end_time + wait)?;
                    Ok((&draws[index], settings.stopping_at(Stop::Time)))
                })
                .collect();
            for (index, landing) in due.into_iter().zip(land_all(landings?.into_iter())) {
                beyond[index] = Some(landing);
            }
        }
        (draws.iter().zip(verdicts).zip(beyond))
            .map(|((draw, landing), beyond)| Self::new(draw, landing, beyond))
            .collect()
    }

    fn new(draw: &Draw, landing: Landing, beyond: Option<Landing>) -> Result<Self, Failure> {
        let mut fate = Self {
            number: draw.number,
            kinds: draw.kinds(),
            legs: draw.vehicle.leg_count(),
            verdict: landing.outcome,
            verdict_time: landing.end_time,
            evaluations: landing.evaluations,
            beyond,
            drift: 0.0,
            contradiction: None,
        };
        if let Some(beyond) = &fate.beyond {
            let energy = beyond.energies.final_kinetic;
            // Links and bodies may tremble faster than the vehicle drifts.
            if (2.0 * energy / draw.vehicle.mass()).sqrt() > DRIFT {
                fate.drift = drift(draw, beyond.end_time)?;
            }
            fate.contradiction = contradiction(&fate.verdict, beyond, fate.drift);
        }
        Ok(fate)
    }

    fn end(&self) -> String {
        let end = self
            .beyond
            .as_ref()
            .and_then(|landing| landing.beyond.as_ref());
        end.map_or(String::new(), |beyond| beyond.end.to_string())
    }
}

/// Lands landers with as many legs side by side.
fn land_all<'d>(landings: impl Iterator<Item = (&'d Draw, Settings)>) -> Vec<Landing> {
    let mut landed = BTreeMap::new();
    let mut requests = landings.enumerate().map(|(key, (draw, settings))| Request {
        key,
        vehicle: Arc::clone(&draw.vehicle),
        scene: draw.scene,
        settings,
    });
    land_many(&mut || requests.next(), &mut |key, landing| {
        landed.insert(key, landing);
    });
    landed.into_values().collect()
}

/// Mean horizontal speed over the last seconds of a landing that goes on to a time (s), ft/s.
fn drift(draw: &Draw, end: f64) -> Result<f64, Failure> {
    let mut places = Vec::new();
    let mut observe = |instant: &Instant| {
        if instant.time >= end - DRIFTS {
            places.push((instant.time, instant.position));
        }
    };
    let settings = settings(end)?.stopping_at(Stop::Time);
    land_observed(&draw.vehicle, &draw.scene, &settings, 1.0, &mut observe);
    Ok(match places[..] {
        [(from, a), .., (to, b)] if to > from => (b - a).xy().norm() / (to - from),
        _ => 0.0,
    })
}

/// Settings of landings that end as soon as their verdict is known, as those of searches do.
fn settings(limit: f64) -> Result<Settings, Failure> {
    (Settings::default().stopping_at(Stop::Verdict))
        .with_time_limit(limit)
        .and_then(|settings| settings.with_tolerance(Settings::BOUNDARY_TOLERANCE))
        .map_err(Failure::running)
}

/// How what follows a verdict contradicts it, if it does.
fn contradiction(verdict: &Outcome, landing: &Landing, drift: f64) -> Option<&'static str> {
    let end = &landing.beyond.as_ref()?.end;
    let has_fallen = landing.tilt > FALLEN;
    match verdict.class() {
        Class::Stable if has_fallen => Some("stable then fallen"),
        Class::Stable if end.class() == Class::Bottomed => Some("stable then bottomed"),
        Class::Stable if drift > DRIFT => Some("stable then sliding"),
        Class::Unstable if !has_fallen && drift < DRIFT && *end == Outcome::TimeExpired => {
            Some("toppled then standing")
        }
        _ => None,
    }
}

/// Runs `verdicts`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let stock = Stock::read(Choice {
        on_soil: options.soil,
        with_static_friction: options.static_friction,
        on_three_struts: options.three_struts,
    })?;
    if let Some(number) = options.landing {
        let draw = stock.draw(options.seed, number);
        let draw = [draw];
        let [fate] = &Fate::of_all(&draw)?[..] else {
            return Err(Failure::running("nothing landed"));
        };
        let [draw] = draw;
        return print(&format!(
            "{:#?}\n{:#?}\n{}\n{:?}\nverdict {} at {} s, then {}: tilt {:.1} deg, {:.3} ft/s\n{:#?}\n",
            draw.vehicle,
            draw.scene,
            course(&draw, fate.verdict_time + BEYOND)?,
            fate.kinds,
            fate.verdict,
            fate.verdict_time,
            fate.end(),
            fate.beyond
                .as_ref()
                .map_or(0.0, |landing| landing.tilt.to_degrees()),
            fate.drift,
            fate.beyond,
        ));
    }
    let folder = Folder::open(&options.out)?;
    if let Some(count) = options.small_changes {
        return small_changes::run(options, &stock, &folder, count);
    }
    let tables = |fates: &[Fate]| {
        let counted = ("verdicts.csv".to_owned(), counts(fates).into_bytes());
        let listed = exceptions(fates).into_bytes();
        [counted, ("verdict-exceptions.csv".to_owned(), listed)]
    };
    let keep = |fates: &[Fate]| folder.write_files(&tables(fates)).map(|_| ());
    let landed = of_all_draws(options, &stock, options.landings, Fate::of_all, keep)?;
    let (count, time) = (options.landings, landed.time);
    let mut fates = landed.all;
    fates.sort_by_key(|fate| fate.number);
    let written = folder.write_files(&tables(&fates))?;
    let contradicted = fates
        .iter()
        .filter(|fate| fate.contradiction.is_some())
        .count();
    print(&format!(
        "{count} landings, seed {}, model version {MODEL_VERSION}, {:.0} s\n{}  {}",
        options.seed,
        time.as_secs_f64(),
        summary(&fates),
        touchdown::terminal::summary::written(&written),
    ))?;
    if contradicted == 0 {
        Ok(())
    } else {
        Err(Failure::running(format!(
            "{contradicted} verdicts are contradicted"
        )))
    }
}

/// What came of random landings.
struct Landed<T> {
    /// In any order.
    all: Vec<T>,
    time: Duration,
}

/// Lands so many random landers, a group with as many legs after another; every thousand what is finished is given to `keep`.
fn of_all_draws<T: Send>(
    options: &Options,
    stock: &Stock,
    count: u64,
    of_group: impl Fn(&[Draw]) -> Result<Vec<T>, Failure> + Sync,
    keep: impl Fn(&[T]) -> Result<(), WriteError>,
) -> Result<Landed<T>, Failure> {
    let cancel = interrupt::flag()?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.map_or(0, NonZeroUsize::get))
        .build()
        .map_err(Failure::running)?;
    let points = usize::try_from(count).map_err(Failure::running)?;
    let progress = Progress::start("landings", points, options.quiet);
    let mut all = Vec::new();
    let mut from = 0;
    while from < count {
        if cancel.load(Ordering::Relaxed) {
            let kept = format!("the first {from} landings are in the tables");
            return Err(Failure::Interrupted(kept));
        }
        let to = count.min(from + CHUNK);
        let numbers: Vec<u64> = (from..to).collect();
        let chunk: Result<Vec<Vec<T>>, Failure> = pool.install(|| {
            let draws = numbers
                .par_iter()
                .map(|number| stock.draw(options.seed, *number));
            let mut draws: Vec<Draw> = draws.collect();
            draws.sort_by_key(|draw| draw.vehicle.leg_count());
            let alike = draws.chunk_by(|a, b| a.vehicle.leg_count() == b.vehicle.leg_count());
            let groups = alike.flat_map(|group| group.chunks(GROUP));
            (groups.collect::<Vec<_>>().into_par_iter())
                .map(|group| {
                    let done = of_group(group)?;
                    for draw in group {
                        progress.landing();
                        progress.point(draw.number as usize);
                    }
                    Ok(done)
                })
                .collect()
        });
        all.extend(chunk?.into_iter().flatten());
        keep(&all)?;
        from = to;
    }
    Ok(Landed {
        all,
        time: progress.finish(),
    })
}

/// The course of a landing as lines.
fn course(draw: &Draw, limit: f64) -> Result<String, Failure> {
    let mut lines =
        "  time, s  sigma, deg  tilt, deg  height, ft  speed, ft/s  pads and struts, lb\n"
            .to_owned();
    let settings = settings(limit)?.stopping_at(Stop::Time);
    let mut observe = |instant: &Instant| {
        let loads = instant
            .legs
            .iter()
            .map(|leg| format!(" {:.0}/{:.0}", leg.pad_normal, leg.strut_force));
        lines += &format!(
            "{:9.3} {:11.3} {:10.3} {:11.4} {:12.5} {}\n",
            instant.time,
            instant.stability_angle.to_degrees(),
            instant.attitude.tip().tip.to_degrees(),
            -instant.position.z,
            instant.velocity.norm(),
            loads.collect::<String>(),
        );
    };
    land_observed(&draw.vehicle, &draw.scene, &settings, COURSE, &mut observe);
    Ok(lines)
}

/// Verdicts and contradictions, most frequent first.
fn summary(fates: &[Fate]) -> String {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for fate in fates {
        *counts
            .entry(format!(
                "{} ({})",
                fate.verdict.class(),
                word(&fate.verdict)
            ))
            .or_default() += 1;
        if let Some(contradiction) = fate.contradiction {
            *counts.entry(format!("! {contradiction}")).or_default() += 1;
        }
    }
    let stable: Vec<&Fate> = (fates.iter())
        .filter(|fate| fate.verdict.class() == Class::Stable)
        .collect();
    let mean = |number: fn(&Fate) -> f64| {
        stable.iter().map(|fate| number(fate)).sum::<f64>() / stable.len().max(1) as f64
    };
    let lines: String = counts
        .iter()
        .map(|(kind, count)| format!("  {count:>7}  {kind}\n"))
        .collect();
    lines
        + &format!(
            "  stable landings: {:.3} s and {:.0} evaluations on average\n",
            mean(|fate| fate.verdict_time),
            mean(|fate| fate.evaluations as f64),
        )
}

/// An outcome without the number of a leg.
fn word(outcome: &Outcome) -> String {
    let word = outcome.to_string();
    match word.rsplit_once('-') {
        Some((kind, number)) if number.parse::<usize>().is_ok() => kind.to_owned(),
        _ => word,
    }
}

/// Verdicts by kind as a table.
fn counts(fates: &[Fate]) -> String {
    let mut counts: BTreeMap<([&str; 4], String), [usize; 2]> = BTreeMap::new();
    for fate in fates {
        let [all, contradicted] = counts.entry((fate.kinds, word(&fate.verdict))).or_default();
        *all += 1;
        *contradicted += usize::from(fate.contradiction.is_some());
    }
    let rows = counts
        .iter()
        .map(|((kinds, verdict), [all, contradicted])| {
            format!("{},{verdict},{all},{contradicted}\n", kinds.join(","))
        });
    "place,lander,ground,engine,verdict,landings,contradicted\n".to_owned()
        + &rows.collect::<String>()
}

/// Landings that contradict their verdicts as a table.
fn exceptions(fates: &[Fate]) -> String {
    let rows = fates.iter().filter_map(|fate| {
        let contradiction = fate.contradiction?;
        let beyond = fate.beyond.as_ref()?;
        Some(format!(
            "{},{},{},{},{:.4},{contradiction},{},{:.4},{:.2},{:.4}\n",
            fate.number,
            fate.kinds.join(","),
            fate.legs,
            fate.verdict,
            fate.verdict_time,
            fate.end(),
            beyond.end_time,
            beyond.tilt.to_degrees(),
            fate.drift,
        ))
    });
    "landing,place,lander,ground,engine,legs,verdict,verdict_time_s,contradiction,end,end_time_s,tilt_deg,drift_fps\n"
        .to_owned()
        + &rows.collect::<String>()
}
