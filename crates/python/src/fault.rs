//! A deliberate fault of the engine.

use pyo3::prelude::*;

use crate::errors::{Failure, guarded};
use crate::interruptible;

/// Panics where the engine might, so that tests of the built wheel can check the effect: while reading (`"reading"`),
/// in a landing (`"in place"`), or on a thread of a long call (`"on a thread"`).
#[pyfunction]
pub fn fault(py: Python, place: &str) -> PyResult<()> {
    let panic = || -> Result<(), Failure> { panic!("on purpose") };
    match place {
        "reading" => Ok(guarded(panic)?),
        "in place" => interruptible::in_place(py, |_| panic().ok()),
        _ => interruptible::run(py, None, move |_| panic()),
    }
}
