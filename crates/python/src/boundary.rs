//! Bands of a single point.

use std::num::NonZeroUsize;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use touchdown_sweep::boundary::{Band, Boundary};
use touchdown_sweep::certainty::Certainty;
use touchdown_sweep::findings::Finding;
use touchdown_sweep::results::transition_name;
use touchdown_sweep::run::{Observer, Workers};
use touchdown_sweep::sweep_counts::SweepCounts;
use touchdown_sweep::warnings;

use crate::errors::Failure;
use crate::interruptible;
use crate::sweeps::Sweep;

/// Searches the boundary at the first point of a sweep; returns the result and its warnings.
#[pyfunction]
pub fn boundary<'py>(
    py: Python<'py>,
    sweep: &Sweep,
    threads: Option<NonZeroUsize>,
    watch: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
    let sweep = sweep.0.clone();
    let (found, told) = interruptible::run(py, watch, move |work| {
        let workers = Workers::start(threads)?;
        work.more(1);
        let mut found = None;
        workers.each_point(&sweep, &[0], 1, work, &work.cancel, |_, finding| {
            found = Some(finding);
        })?;
        let mut counts = SweepCounts::of(&sweep);
        if let Some(finding) = &found {
            counts.add(&sweep, 0, finding);
        }
        match found {
            Some(Finding::Boundary(boundary)) => {
                Ok((boundary, warnings::of_sweep(&sweep, &counts)))
            }
            _ => Err(Failure::Engine("the search gave no boundary".to_owned())),
        }
    })?;
    Ok((results(py, &found)?, told))
}

fn results<'py>(py: Python<'py>, found: &Boundary) -> PyResult<Bound<'py, PyDict>> {
    let transition = found.transition.as_ref();
    let results = PyDict::new(py);
    results.set_item("first_transition_to", transition_name(found))?;
    results.set_item("first_transition_fps", transition.map(|one| one.speed()))?;
    let low = match transition {
        Some(transition) => transition.low,
        None => Some(found.searched_to),
    };
    results.set_item("bracket_low_fps", low)?;
    results.set_item("bracket_high_fps", transition.map(|one| one.high))?;
    set_certainty(
        &results,
        transition.map_or(Certainty::Untested, |one| one.certainty),
    )?;
    results.set_item("solver_tolerance", transition.map(|one| one.tolerance))?;
    results.set_item("landings", found.landings)?;
    results.set_item("derivative_evaluations", found.evaluations)?;
    let bands = PyList::empty(py);
    for one in &found.bands {
        bands.append(band(py, one)?)?;
    }
    results.set_item("bands", bands)?;
    Ok(results)
}

fn band<'py>(py: Python<'py>, band: &Band) -> PyResult<Bound<'py, PyDict>> {
    let told = PyDict::new(py);
    told.set_item("from_fps", band.from)?;
    told.set_item("to_fps", band.to)?;
    told.set_item("outcome", band.class.to_string())?;
    told.set_item("kind", band.outcome.to_string())?;
    told.set_item("bracket_width_fps", band.bracket.map(|one| one.width))?;
    set_certainty(&told, band.certainty)?;
    told.set_item("solver_tolerance", band.bracket.map(|one| one.tolerance))?;
    Ok(told)
}

fn set_certainty(told: &Bound<PyDict>, certainty: Certainty) -> PyResult<()> {
    let [word, ..] = certainty.cells();
    let disputed = match certainty {
        Certainty::Disputed(range) => Some(range),
        _ => None,
    };
    told.set_item("certainty", Some(word).filter(|word| !word.is_empty()))?;
    told.set_item("disputed_from_fps", disputed.map(|[from, _]| from))?;
    told.set_item("disputed_to_fps", disputed.map(|[_, to]| to))
}
