//! `bands`: bands over a range of V_H with their certainty, as found by a sweep.

use std::sync::Arc;

use futures::executor::block_on;
use serde::{Deserialize, Serialize};
use serde_json::json;
use touchdown_dynamics::landing::land_located_while;
use touchdown_sweep::boundary::{self, Boundary, Extent, Search};
use touchdown_sweep::certainty::{Certainty, Doubt};
use touchdown_sweep::refine::Refinement;
use touchdown_sweep::search_range::Scan;
use touchdown_sweep::trial::{Scales, Trial};
use touchdown_sweep::variation::Variation;

use super::IsOver;
use super::classes::{ClassWords, class_words};
use super::complaint::Complaint;
use super::request::{Asked, read, written};
use super::strip::{range, settings};
use super::touchdown::Touchdown;
use crate::named::Named;

/// Number of scan steps, and width of a bracket, ft/s.
const SCAN: f64 = 100.0;
const TOLERANCE: f64 = 1e-3;

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
    let scene = touchdown.scene()?;
    let [from, to] = range(&touchdown, request.from_fps, request.to_fps)?;
    let settings = settings(&touchdown)?;
    let vehicle = Arc::new(touchdown.vehicle.vehicle.clone());
    let scales = Scales::of(&vehicle, &scene);
    let search = Search {
        from,
        to,
        scan_step: (to - from) / SCAN,
        parts_below: Search::PARTS_BELOW,
        tolerance: TOLERANCE,
        extent: Extent::All,
        scan: Scan::default(),
        scan_looseness: 1.0,
        refinement: Refinement::Margin,
        doubt: Doubt::default(),
        kept: 0.0,
    };
    let at = async |speed: f64, variation: Variation| -> Result<Trial, Complaint> {
        let moved = (scene.with_horizontal_velocity(speed)).map_err(Complaint::engine)?;
        let (scene, settings) = variation.of(&moved, &settings).map_err(Complaint::engine)?;
        let (none, goes_on) = (&mut |_: &_| {}, || !is_over());
        let landing = land_located_while(&vehicle, &scene, &settings, f64::INFINITY, none, goes_on);
        let landing = landing.ok_or_else(Complaint::over)?;
        Ok(Trial::of(
            landing,
            &scales,
            settings.tolerance(),
            search.kept,
        ))
    };
    let found = block_on(search.boundary(at))?;
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
