//! `touchdown verdicts`: whether anything that follows a verdict contradicts it.

mod draw;

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

use clap::Args;
use rayon::prelude::*;
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::scene::Settings;
use touchdown_sweep::file_writer::Folder;
use touchdown_sweep::run::Observer;

use draw::{Draw, ENGINES, GROUNDS, LANDERS, PLACES, Stock};

use crate::failure::Failure;
use crate::interrupt;
use crate::print::print;
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  touchdown verdicts                         # 20000 landings: a quarter of an hour on two cores
  touchdown verdicts --landings 500          # a short run
  touchdown verdicts --landing 1234          # one of them, in full

Landers with three to eight legs, with equal and with unequal legs, touch down on even and on rough ground, on the Moon, on Mars,
on the Earth and on Ceres, at up to 4 m/s each way, with and without thrust, under physical rules. Each goes on for 60 s
beyond its verdict. A verdict is contradicted
  - of a landing called stable, if the vehicle ends tilted by more than 60 deg, if a strut, pad or block bottoms, or if it ends
    sliding at more than 0.1 m/s;
  - of a landing called toppled, if the vehicle ends standing.

verdicts.csv lists the verdicts by kind, verdict-exceptions.csv every landing that contradicts its own.

Exit code 0 if none does, 1 if any.";

/// How long landings go on beyond their verdict, s.
const BEYOND: f64 = 60.0;
/// Time limit of a verdict, s: on Ceres a lander that bounces flies for half a minute.
const LIMIT: f64 = 120.0;
/// Tilt beyond which a vehicle no longer stands, rad.
const FALLEN: f64 = 60.0 * std::f64::consts::PI / 180.0;
/// Speed above which a vehicle at the end is not at rest, ft/s.
const SLIDES: f64 = 0.1 / 0.3048;
/// Landings at a time between two looks for an interruption.
const CHUNK: u64 = 200;

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
    /// Seed of the random numbers; the same seed gives the same landings
    #[arg(long, value_name = "N", default_value_t = 1966)]
    seed: u64,
    /// Folder for the tables, created if missing
    #[arg(long, value_name = "DIR", default_value = "results")]
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
    speed: f64,
    contradiction: Option<&'static str>,
}

impl Fate {
    fn of(stock: &Stock, seed: u64, number: u64) -> Result<Self, Failure> {
        let draw = stock.draw(seed, number);
        let Draw { vehicle, scene, .. } = &draw;
        let settings = settings(LIMIT)?;
        let first = land(vehicle, scene, &settings);
        let goes_on = matches!(first.outcome.class(), Class::Stable | Class::Unstable);
        let beyond = if goes_on {
            let limit = self::settings(first.end_time + BEYOND)?;
            Some(land(vehicle, scene, &limit.beyond_verdict()))
        } else {
            None
        };
        let speed = beyond.as_ref().map_or(0.0, |landing| {
            (2.0 * landing.energies.final_kinetic / vehicle.mass()).sqrt()
        });
        Ok(Self {
            number,
            kinds: [
                PLACES[draw.place].0,
                LANDERS[draw.lander],
                GROUNDS[draw.ground],
                ENGINES[draw.engine],
            ],
            legs: vehicle.legs().len(),
            contradiction: beyond
                .as_ref()
                .and_then(|beyond| contradiction(&first.outcome, beyond, speed)),
            verdict: first.outcome,
            verdict_time: first.end_time,
            evaluations: first.evaluations,
            beyond,
            speed,
        })
    }

    fn end(&self) -> String {
        let end = self
            .beyond
            .as_ref()
            .and_then(|landing| landing.beyond.as_ref());
        end.map_or(String::new(), |beyond| beyond.end.to_string())
    }
}

/// How landings are computed.
fn settings(limit: f64) -> Result<Settings, Failure> {
    (Settings::default().with_time_limit(limit))
        .and_then(|settings| settings.with_tolerance(Settings::BOUNDARY_TOLERANCE))
        .map_err(Failure::running)
}

/// How what follows a verdict contradicts it, if it does.
fn contradiction(verdict: &Outcome, landing: &Landing, speed: f64) -> Option<&'static str> {
    let end = &landing.beyond.as_ref()?.end;
    let has_fallen = landing.tilt > FALLEN;
    match verdict.class() {
        Class::Stable if has_fallen => Some("stable, then fallen"),
        Class::Stable if end.class() == Class::Bottomed => Some("stable, then bottomed"),
        Class::Stable if speed > SLIDES => Some("stable, then sliding"),
        Class::Unstable if !has_fallen && speed < SLIDES && *end == Outcome::TimeExpired => {
            Some("toppled, then standing")
        }
        _ => None,
    }
}

/// Runs `verdicts`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let stock = Stock::read()?;
    if let Some(number) = options.landing {
        let draw = stock.draw(options.seed, number);
        let fate = Fate::of(&stock, options.seed, number)?;
        return print(&format!(
            "{:#?}\n{:#?}\n{:?}\nverdict {} at {} s, then {}: tilt {:.1} deg, {:.3} ft/s\n{:#?}\n",
            draw.vehicle,
            draw.scene,
            fate.kinds,
            fate.verdict,
            fate.verdict_time,
            fate.end(),
            fate.beyond
                .as_ref()
                .map_or(0.0, |landing| landing.tilt.to_degrees()),
            fate.speed,
            fate.beyond,
        ));
    }
    let folder = Folder::open(&options.out)?;
    let cancel = interrupt::flag()?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.map_or(0, NonZeroUsize::get))
        .build()
        .map_err(Failure::running)?;
    let count = usize::try_from(options.landings).map_err(Failure::running)?;
    let progress = Progress::start("landings", count, options.quiet);
    let mut fates = Vec::new();
    let mut from = 0;
    while from < options.landings {
        if cancel.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted("nothing was written".to_owned()));
        }
        let to = options.landings.min(from + CHUNK);
        let chunk: Result<Vec<Fate>, Failure> = pool.install(|| {
            (from..to)
                .into_par_iter()
                .map(|number| {
                    let fate = Fate::of(&stock, options.seed, number);
                    progress.landing();
                    progress.point(number as usize);
                    fate
                })
                .collect()
        });
        fates.extend(chunk?);
        from = to;
    }
    let time = progress.finish();
    let files = [
        ("verdicts.csv".to_owned(), counts(&fates).into_bytes()),
        (
            "verdict-exceptions.csv".to_owned(),
            exceptions(&fates).into_bytes(),
        ),
    ];
    let written = folder.write_files(&files)?;
    let contradicted = fates
        .iter()
        .filter(|fate| fate.contradiction.is_some())
        .count();
    print(&format!(
        "{count} landings, seed {}, model version {MODEL_VERSION}, {:.0} s\n{}  {}",
        options.seed,
        time.as_secs_f64(),
        summary(&fates),
        crate::summary::written(&written),
    ))?;
    if contradicted == 0 {
        Ok(())
    } else {
        Err(Failure::running(format!(
            "{contradicted} verdicts are contradicted"
        )))
    }
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
            fate.speed,
        ))
    });
    "landing,place,lander,ground,engine,legs,verdict,verdict_time_s,contradiction,end,end_time_s,tilt_deg,speed_fps\n"
        .to_owned()
        + &rows.collect::<String>()
}
