//! `landing`: one landing with its history and drawing data.

mod drawing;
mod events;
mod history;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use touchdown_dynamics::landing::{Instant, land_located_while};
use touchdown_dynamics::methods::IntegrationSummary;
use touchdown_dynamics::outcome::Outcome;
use touchdown_figures::unit::unit_of;
use touchdown_sweep::output::landing_report::{self, LandingReport, verdict_time};
use touchdown_sweep::output::landing_table::why;

use super::IsOver;
use super::complaint::Complaint;
use super::request::{Asked, ClassWords, class_words, read, units, written};
use super::touchdown::Touchdown;
use crate::named::Named;

use drawing::Drawing;
use events::Event;
use history::{Energies, History};

/// Default interval of instants, s, and greatest number of instants.
pub const INTERVAL: f64 = 0.01;
const MOST_INSTANTS: f64 = 20_000.0;

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Request {
    touchdown: Asked,
    units: Option<String>,
    interval_s: f64,
    history: bool,
    drawing: bool,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            touchdown: Asked::default(),
            units: None,
            interval_s: INTERVAL,
            history: true,
            drawing: true,
        }
    }
}

#[derive(Serialize)]
struct Answer {
    outcome: String,
    #[serde(flatten)]
    class: ClassWords,
    why: String,
    failure: Option<String>,
    warning: Option<String>,
    end_time_s: f64,
    verdict_time_s: f64,
    report: Value,
    /// Units of the numbers of the result, by name.
    result_units: Map<String, Value>,
    events: Vec<Event>,
    history: Option<History>,
    energies: Option<Energies>,
    drawing: Option<Drawing>,
}

pub fn answer(named: &Named, request: &str, is_over: IsOver) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = units(request.units.as_deref(), named.units)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    let scene = touchdown.scene()?;
    let wants_instants = request.history || request.drawing;
    let seconds = interval(&touchdown, request.interval_s)?;
    let seconds = if wants_instants {
        seconds
    } else {
        f64::INFINITY
    };

    let vehicle = &touchdown.vehicle.vehicle;
    let mut instants: Vec<Instant> = Vec::new();
    let mut observe = |instant: &Instant| instants.push(instant.clone());
    let settings = &touchdown.settings;
    let goes_on = || !is_over();
    let landing = land_located_while(vehicle, &scene, settings, seconds, &mut observe, goes_on);
    let landing = landing.ok_or_else(Complaint::over)?;

    let report = LandingReport {
        version: env!("CARGO_PKG_VERSION"),
        vehicle: &touchdown.vehicle,
        set: &touchdown.set,
        conditions: &touchdown.conditions,
        settings,
        landing: &landing,
        integration: &IntegrationSummary::default(),
        units,
    };
    let report = report.json();
    let result_units = (report["result"].as_object().into_iter().flatten())
        .map(|(name, _)| (name.clone(), json!(unit_of(name))))
        .collect();
    written(&Answer {
        outcome: landing.outcome.to_string(),
        class: class_words(landing.outcome.class()),
        why: why(&landing.outcome),
        failure: match &landing.outcome {
            Outcome::Failure(reason) => Some(reason.to_string()),
            _ => None,
        },
        warning: landing_report::warning(&landing, units),
        end_time_s: landing.end_time,
        verdict_time_s: verdict_time(&landing),
        report,
        result_units,
        events: events::of(&landing),
        history: request.history.then(|| History::of(&instants, units)),
        energies: request.history.then(|| Energies::of(&instants, units)),
        drawing: request
            .drawing
            .then(|| Drawing::of(vehicle, &scene, settings.rules(vehicle), &instants)),
    })
}

/// Checks the interval of instants, s.
///
/// # Errors
/// If there would be too many instants.
pub fn interval(touchdown: &Touchdown, seconds: f64) -> Result<f64, Complaint> {
    let least = touchdown.settings.time_limit() / MOST_INSTANTS;
    match seconds >= least {
        true => Ok(seconds),
        false => {
            let allowed = format!("at least {least} s, the time limit over {MOST_INSTANTS}");
            Err(Complaint::value("interval_s", seconds, &allowed))
        }
    }
}
