//! Bands of a single point.

use std::num::NonZeroUsize;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use touchdown_search::boundary::Boundary;
use touchdown_sweep::output::{bands_table, results, warnings};
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::summary::sweep_counts::SweepCounts;
use touchdown_sweep::threads::run::{Observer, Workers};

use crate::columns::by_name;
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
        workers.each_point(&sweep, &[0], 1, work, &work.cancel, &mut |_, finding| {
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
    let results = by_name(py, &results::COLUMNS, found, 0)?;
    let bands = PyList::empty(py);
    for band in bands_table::numbered(found) {
        // Their number is their place in the list.
        bands.append(by_name(py, &bands_table::COLUMNS[1..], &band, 0)?)?;
    }
    results.set_item("bands", bands)?;
    Ok(results)
}
