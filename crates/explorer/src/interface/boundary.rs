//! `boundary`: the first transition at one place of a map that a page computes, as a row of the table of a sweep.

use serde::Deserialize;
use serde_json::json;
use touchdown_input::documents::column::{Cell, cells};
use touchdown_search::boundary::Extent;
use touchdown_sweep::output::results::COLUMNS;

use super::IsOver;
use super::complaint::Complaint;
use super::computed::Axes;
use super::request::{Asked, read, written};
use super::search::find;
use super::strip::range;
use super::touchdown::Touchdown;
use crate::named::Named;

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

pub fn answer(named: &Named, request: &str, is_over: IsOver) -> Result<String, Complaint> {
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
