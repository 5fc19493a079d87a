//! One landing.

use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyDict};
use touchdown_dynamics::land::{land as compute, land_observed};
use touchdown_dynamics::landing::{Instant, Landing, land_located_while};
use touchdown_dynamics::methods::Method;
use touchdown_input::documents::history_columns::{names, values};
use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::output::landing_report::warning;
use touchdown_sweep::output::landing_table::{self, why};

use crate::columns::{array, by_name};
use crate::documents::{Scene, Solver, Vehicle, output_units};
use crate::errors::{Failure, guarded};
use crate::interruptible;

/// Most instants of a history, as on the command line.
const LONGEST_HISTORY: f64 = 1e7;

/// Computes a landing: results by name and an optional warning, in these units.
#[pyfunction]
pub fn land<'py>(
    py: Python<'py>,
    vehicle: &Vehicle,
    scene: &Scene,
    solver: &Solver,
    units: &str,
) -> PyResult<(Bound<'py, PyDict>, Option<String>)> {
    let units = output_units(units)?;
    let touchdown = scene_for(vehicle, scene, solver)?;
    let settings = solver.0;
    let landed = match settings.method() {
        // In place: starting a thread takes longer than many landings.
        Method::Located => interruptible::in_place(py, |goes_on| {
            let (lander, none) = (&vehicle.vehicle, &mut |_: &Instant| {});
            land_located_while(lander, &touchdown, &settings, f64::INFINITY, none, goes_on)
        }),
        _ => {
            let lander = vehicle.vehicle.clone();
            interruptible::run(py, None, move |_| {
                Ok(compute(&lander, &touchdown, &settings))
            })
        }
    };
    let landed = landed?;
    Ok((results(py, &landed)?, warning(&landed, units)))
}

/// Computes the history of a landing: columns by name, with an instant every `interval` seconds.
#[pyfunction]
pub fn history<'py>(
    py: Python<'py>,
    vehicle: &Vehicle,
    scene: &Scene,
    solver: &Solver,
    interval: f64,
    units: &str,
) -> PyResult<Vec<(String, Bound<'py, PyByteArray>)>> {
    let (units, settings) = (output_units(units)?, solver.0);
    let least = settings.time_limit() / LONGEST_HISTORY;
    if !(interval >= least && interval > 0.0 && interval.is_finite()) {
        let allowed =
            format!("a finite number of at least {least:e} s, a ten-millionth of the time limit");
        return Err(Failure::from(InputError::value("dt", interval, &allowed)).into());
    }
    let touchdown = scene_for(vehicle, scene, solver)?;
    let lander = vehicle.vehicle.clone();
    let history = interruptible::run(py, None, move |_| {
        let mut history: Vec<(String, Vec<f64>)> = Vec::new();
        let mut observe = |instant: &Instant| {
            if history.is_empty() {
                let names = names(instant).into_iter();
                history = names.map(|name| (name, Vec::new())).collect();
            }
            for ((_, column), value) in history.iter_mut().zip(values(instant)) {
                column.push(value);
            }
        };
        land_observed(&lander, &touchdown, &settings, interval, &mut observe);
        Ok(history)
    })?;
    let in_units = history.into_iter().map(|(name, mut values)| {
        let quantity = units.quantity(&name);
        for value in &mut values {
            *value = quantity.number(*value);
        }
        (quantity.name().to_owned(), array(py, &values))
    });
    Ok(in_units.collect())
}

fn scene_for(
    vehicle: &Vehicle,
    scene: &Scene,
    solver: &Solver,
) -> Result<touchdown_dynamics::scene::Scene, Failure> {
    guarded(|| scene.0.scene_for(&vehicle.vehicle, &solver.0))
}

/// Results of a landing in program units, by name.
fn results<'py>(py: Python<'py>, landing: &Landing) -> PyResult<Bound<'py, PyDict>> {
    let legs = landing.leg_count();
    let results = by_name(py, &landing_table::COLUMNS, landing, legs)?;
    results.update(by_name(py, &landing_table::OF_REPORTS, landing, legs)?.as_mapping())?;
    results.set_item("outcome_class", landing.outcome.class().to_string())?;
    results.set_item("why", why(&landing.outcome))?;
    let beyond = landing.beyond.as_ref();
    results.set_item("verdict_time_s", beyond.map(|beyond| beyond.verdict_time))?;
    results.set_item("went_on_to", beyond.map(|beyond| beyond.end.to_string()))?;
    Ok(results)
}
