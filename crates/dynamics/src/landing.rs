//! One landing: integrate from first contact until an outcome, and report.

mod account;
pub mod critical_feet;
pub mod energy;
mod events;
mod hidden_forces;
mod hull;
mod kinks;
mod peaks;
mod ranges;
pub mod record;
mod rest;
mod simulation;
pub mod stability;
mod steadiness;
mod step_attempt;
mod stiffness;
mod three_struts;
mod thrust;
mod toppling;
pub mod touchdown;
mod trajectory;
mod verdict;
mod within;

use crate::outcome::{Class, Outcome};
use crate::scene::{Scene, Settings};
use crate::vehicle::{Legs, Vehicle};

use record::Beyond;

pub(crate) use account::final_rates;
pub(crate) use simulation::{NextStart, Simulation};
pub(crate) use step_attempt::{StepKind, TakeStep, Workspace};

pub use record::{
    Energies, FinalRates, HingedPosture, Instant, Landing, LegInstant, LegPosture, LegWork,
    ThreeStrutPosture,
};

/// Times and receiver of reports.
pub(crate) struct History<'o> {
    interval: f64,
    reported: u64,
    /// Time last reported, s.
    last: f64,
    observe: &'o mut dyn FnMut(&Instant),
}

impl<'o> History<'o> {
    /// Reports every `interval` seconds.
    fn new(interval: f64, observe: &'o mut dyn FnMut(&Instant)) -> Self {
        Self {
            interval,
            reported: 0,
            last: f64::NEG_INFINITY,
            observe,
        }
    }

    /// Next time to report at, s.
    fn next(&self) -> f64 {
        if self.reported == 0 {
            0.0
        } else {
            self.interval * self.reported as f64
        }
    }

    fn report(&mut self, instant: &Instant) {
        (self.observe)(instant);
        self.last = instant.time;
        self.reported += 1;
    }
}

/// A landing under way, whatever the legs of its vehicle.
trait UnderWay {
    /// Judges the touchdown and prepares the first step.
    fn begin(&mut self) -> Result<(), Outcome>;
    /// Takes a step.
    fn step(&mut self) -> Result<(), Outcome>;
    /// Returns whether all footpads have touched.
    fn stands_on_all_feet(&self) -> bool;
    /// Reports the end of the landing.
    fn report_end(&mut self);
    /// Its result.
    fn result(&self, outcome: Outcome) -> Landing;
}

/// The result of a landing that ended with this outcome, by its `account` of an outcome. One that went on beyond the verdict that
/// was `noted` has that verdict. One that ends otherwise than stable at the time at which it `topples` (s), its CG beyond the feet,
/// has toppled.
fn with_verdict(
    noted: Option<(Outcome, f64)>,
    topples: Option<f64>,
    outcome: Outcome,
    settings: &Settings,
    account: impl FnOnce(Outcome) -> Landing,
) -> Landing {
    let toppled = topples
        .filter(|_| outcome.class() != Class::Stable)
        .map(|time| (Outcome::UnstableToppled, time));
    match noted.or(toppled) {
        None => account(outcome),
        Some((verdict, _)) if !settings.goes_on() => account(verdict),
        Some((verdict, verdict_time)) => Landing {
            beyond: Some(Beyond {
                verdict_time,
                end: outcome,
            }),
            ..account(verdict)
        },
    }
}

/// A landing on hinged legs, computed alone.
struct Alone<'o> {
    simulation: Simulation<'o>,
    workspace: Workspace<f64>,
}

impl UnderWay for Alone<'_> {
    fn begin(&mut self) -> Result<(), Outcome> {
        self.simulation.begin()
    }

    fn step(&mut self) -> Result<(), Outcome> {
        self.simulation.step(&mut self.workspace)
    }

    fn stands_on_all_feet(&self) -> bool {
        let contacts = &self.simulation.trajectory.pad_contact;
        contacts.iter().all(Option::is_some)
    }

    fn report_end(&mut self) {
        self.simulation.trajectory.report_end();
    }

    fn result(&self, outcome: Outcome) -> Landing {
        self.simulation.result(outcome)
    }
}

/// Follows a landing to its outcome, and returns its result. Ends sooner once `goes_on`, asked before every step whether all
/// footpads have touched by now, says no; what there is then has no outcome, which is [`Outcome::TimeExpired`], and is an
/// error.
fn follow(
    mut landing: impl UnderWay,
    mut goes_on: impl FnMut(bool) -> bool,
) -> Result<Landing, Box<Landing>> {
    let mut stepped = landing.begin();
    loop {
        match stepped {
            Err(outcome) => {
                landing.report_end();
                return Ok(landing.result(outcome));
            }
            Ok(()) if goes_on(landing.stands_on_all_feet()) => stepped = landing.step(),
            Ok(()) => return Err(Box::new(landing.result(Outcome::TimeExpired))),
        }
    }
}

/// Follows the landing of a vehicle as [`follow`] does. An infinite `interval` (s) reports nothing.
fn land_while(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
    goes_on: impl FnMut(bool) -> bool,
) -> Result<Landing, Box<Landing>> {
    let history = interval
        .is_finite()
        .then(|| History::new(interval, observe));
    match vehicle.legs() {
        Legs::Hinged(_) => {
            let simulation = Simulation::new(vehicle, scene, settings, history);
            let workspace = Workspace::new(&simulation.trajectory.motion);
            let landing = Alone {
                simulation,
                workspace,
            };
            follow(landing, goes_on)
        }
        Legs::ThreeStrut(legs) => {
            let landing = three_struts::Simulation::new(vehicle, legs, scene, settings, history);
            follow(landing, goes_on)
        }
    }
}

/// Computes a landing with its events located. Reports its state every `interval` seconds from first contact on, and at
/// the end.
pub fn land_located(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> Landing {
    let landed = land_while(vehicle, scene, settings, interval, observe, |_| true);
    landed.unwrap_or_else(|unfinished| *unfinished)
}

/// Like [`land_located`], but returns `None` once `goes_on`, asked before every step, says no. An infinite `interval`
/// (s) reports nothing.
pub fn land_located_while(
    vehicle: &Vehicle,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
    mut goes_on: impl FnMut() -> bool,
) -> Option<Landing> {
    land_while(vehicle, scene, settings, interval, observe, |_| goes_on()).ok()
}

/// Computes a landing with its events located, until all footpads have touched. If it has not ended by then, its
/// outcome is [`Outcome::TimeExpired`].
pub fn land_until_all_pads_touch(vehicle: &Vehicle, scene: &Scene, settings: &Settings) -> Landing {
    let never = f64::INFINITY;
    let landed = land_while(vehicle, scene, settings, never, &mut |_| {}, |stands| {
        !stands
    });
    landed.unwrap_or_else(|unfinished| *unfinished)
}
