//! One landing.

use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyDict, PyTuple};
use touchdown_dynamics::land::{land as compute, land_observed};
use touchdown_dynamics::landing::{Instant, Landing, LegWork, land_located_while};
use touchdown_dynamics::methods::Method;
use touchdown_dynamics::outcome::Outcome;
use touchdown_sweep::history::columns;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::landing_report::warning;
use touchdown_sweep::landing_table::why;

use crate::columns::array;
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
            let told = columns(instant);
            if history.is_empty() {
                let names = told.iter().map(|(name, _)| name.clone());
                history = names.map(|name| (name, Vec::new())).collect();
            }
            for ((_, values), (_, value)) in history.iter_mut().zip(told) {
                values.push(value);
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
    let energies = &landing.energies;
    let work = |of: fn(&LegWork) -> f64| PyTuple::new(py, energies.legs.iter().map(of));
    let results = PyDict::new(py);
    let set = |name: &str, value: f64| results.set_item(name, value);
    results.set_item("outcome", landing.outcome.to_string())?;
    results.set_item("outcome_class", landing.outcome.class().to_string())?;
    results.set_item("why", why(&landing.outcome))?;
    set("end_time_s", landing.end_time)?;
    set(
        "min_stability_angle_deg",
        landing.min_stability_angle.to_degrees(),
    )?;
    set("min_stability_time_s", landing.min_stability_time)?;
    set("min_clearance_ft", landing.min_clearance)?;
    set("tilt_deg", landing.tilt.to_degrees())?;
    set("initial_kinetic_energy_ftlb", energies.initial_kinetic)?;
    set("potential_energy_change_ftlb", energies.potential_change)?;
    set("thrust_work_ftlb", energies.thrust)?;
    set("final_kinetic_energy_ftlb", energies.final_kinetic)?;
    set("energy_closure_ftlb", energies.closure())?;
    set("given_by_contact_ftlb", energies.given_by_contact())?;
    results.set_item(
        "max_strut_force_lb",
        PyTuple::new(py, landing.max_strut_force.iter())?,
    )?;
    results.set_item(
        "max_stroke_ft",
        PyTuple::new(py, landing.max_stroke.iter())?,
    )?;
    results.set_item(
        "max_stroke_share",
        PyTuple::new(py, landing.max_stroke_share.iter())?,
    )?;
    results.set_item(
        "pad_contact_s",
        PyTuple::new(py, landing.pad_contact.iter())?,
    )?;
    results.set_item(
        "block_contact_s",
        PyTuple::new(py, landing.block_contact.iter())?,
    )?;
    results.set_item("strut_work_ftlb", work(|leg| leg.strut)?)?;
    results.set_item("pad_crush_work_ftlb", work(|leg| leg.pad_crush)?)?;
    results.set_item("pad_friction_work_ftlb", work(|leg| leg.pad_friction)?)?;
    results.set_item("block_crush_work_ftlb", work(|leg| leg.block_crush)?)?;
    results.set_item("block_friction_work_ftlb", work(|leg| leg.block_friction)?)?;
    results.set_item("stop_work_ftlb", work(|leg| leg.stop)?)?;
    results.set_item("steps", landing.steps)?;
    results.set_item("derivative_evaluations", landing.evaluations)?;
    results.set_item("events", landing.events)?;
    let failure = match &landing.outcome {
        Outcome::Failure(reason) => Some(reason.to_string()),
        _ => None,
    };
    results.set_item("failure", failure)?;
    let beyond = landing.beyond.as_ref();
    results.set_item("verdict_time_s", beyond.map(|beyond| beyond.verdict_time))?;
    results.set_item("went_on_to", beyond.map(|beyond| beyond.end.to_string()))?;
    Ok(results)
}
