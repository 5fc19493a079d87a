//! The search of a sweep at one touchdown; `boundary`: the first transition that it finds at one place of a map that a page
//! computes, as a row of the table of a sweep.

use std::sync::Arc;

use futures::executor::block_on;
use serde::Deserialize;
use serde_json::json;
use touchdown_dynamics::landing::land_located_while;
use touchdown_input::documents::column::{Cell, cells};
use touchdown_search::boundary::{Boundary, Extent, Search};
use touchdown_search::certainty::Doubt;
use touchdown_search::refine::Refinement;
use touchdown_search::search_range::Scan;
use touchdown_search::trial::{Scales, Trial};
use touchdown_search::variation::Variation;
use touchdown_sweep::output::results::COLUMNS;

use super::IsOver;
use super::complaint::Complaint;
use super::computed::Axes;
use super::request::{Asked, read, written};
use super::strip::{range, settings};
use super::touchdown::Touchdown;
use crate::named::Named;

/// Number of scan steps, and width of a bracket, ft/s.
const SCAN: f64 = 100.0;
const TOLERANCE: f64 = 1e-3;

/// Searches a range of V_H, ft/s.
///
/// # Errors
/// If the answer is no longer wanted, or the touchdown is not allowed.
pub fn find(
    touchdown: &Touchdown,
    [from, to]: [f64; 2],
    extent: Extent,
    is_over: IsOver,
) -> Result<Boundary, Complaint> {
    let scene = touchdown.scene()?;
    let settings = settings(touchdown)?;
    let vehicle = Arc::new(touchdown.vehicle.vehicle.clone());
    let scales = Scales::of(&vehicle, &scene);
    let search = Search {
        from,
        to,
        scan_step: (to - from) / SCAN,
        parts_below: Search::PARTS_BELOW,
        tolerance: TOLERANCE,
        extent,
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
    block_on(search.boundary(at))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    #[serde(default)]
    touchdown: Asked,
    axes: Axes,
    place: [f64; 2],
    from_fps: Option<f64>,
    to_fps: Option<f64>,
}

pub fn boundary(named: &Named, request: &str, is_over: IsOver) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    request.axes.check()?;
    let place = request.axes.names().zip(request.place);
    let values = place.map(|(name, value)| (name.to_owned(), json!(value)));
    let touchdown = Touchdown::of(named, &request.touchdown.with(values))?;
    let range = range(&touchdown, request.from_fps, request.to_fps)?;
    let found = find(&touchdown, range, Extent::First, is_over)?;
    let legs = touchdown.vehicle.vehicle.leg_count();
    let row = (request.place.into_iter().map(Cell::Number)).chain(cells(&COLUMNS, &found, legs));
    let row: Vec<String> = row.map(|cell| cell.to_string()).collect();
    written(&json!({"heading": request.axes.heading(), "row": row.join(",")}))
}
