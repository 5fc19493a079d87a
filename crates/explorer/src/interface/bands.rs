//! `bands`: bands over a range of V_H with their certainty, as found by a sweep.

use serde::{Deserialize, Serialize};
use serde_json::json;
use touchdown_search::boundary::{self, Boundary, Extent};
use touchdown_search::certainty::Certainty;

use super::IsOver;
use super::complaint::Complaint;
use super::request::{Asked, ClassWords, class_words, read, written};
use super::search::find;
use super::strip::range;
use super::touchdown::Touchdown;
use crate::named::Named;

#[derive(Deserialize, Default)]
#[serde(default, deny_unknown_fields)]
struct Request {
    touchdown: Asked,
    from_fps: Option<f64>,
    to_fps: Option<f64>,
}

#[derive(Serialize)]
struct Band {
    from_fps: f64,
    to_fps: f64,
    #[serde(flatten)]
    class: ClassWords,
    outcome: String,
    bracket_width_fps: Option<f64>,
    certainty: Option<&'static str>,
    disputed_fps: Option<[f64; 2]>,
    solver_tolerance: Option<f64>,
}

pub fn answer(named: &Named, request: &str, is_over: IsOver) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    let range = range(&touchdown, request.from_fps, request.to_fps)?;
    let found = find(&touchdown, range, Extent::All, is_over)?;
    let bands: Vec<Band> = found.bands.iter().map(band).collect();
    written(&json!({
        "bands": bands,
        "first_transition": first_transition(&found),
        "landings": found.landings,
    }))
}

fn band(band: &boundary::Band) -> Band {
    Band {
        from_fps: band.from,
        to_fps: band.to,
        class: class_words(band.class),
        outcome: band.outcome.to_string(),
        bracket_width_fps: band.bracket.map(|bracket| bracket.width),
        certainty: word(band.certainty),
        disputed_fps: disputed(band.certainty),
        solver_tolerance: band.bracket.map(|bracket| bracket.tolerance),
    }
}

fn first_transition(found: &Boundary) -> serde_json::Value {
    let Some(transition) = &found.transition else {
        return serde_json::Value::Null;
    };
    json!({
        "to": transition.to.to_string(),
        "speed_fps": transition.speed(),
        "low_fps": transition.low,
        "high_fps": transition.high,
        "certainty": word(transition.certainty),
        "disputed_fps": disputed(transition.certainty),
        "stable_landings_below": found.stable_below,
        "patchy": found.patchy.map(|patchy| json!({
            "to_fps": patchy.to,
            "landings": patchy.landings,
            "not_stable": patchy.not_stable,
        })),
    })
}

fn word(certainty: Certainty) -> Option<&'static str> {
    match certainty {
        Certainty::Untested => None,
        Certainty::Certain => Some("certain"),
        Certainty::Disputed(_) => Some("disputed"),
    }
}

fn disputed(certainty: Certainty) -> Option<[f64; 2]> {
    match certainty {
        Certainty::Disputed(range) => Some(range),
        _ => None,
    }
}
