//! The engine behind the Python package `touchdown`, which wraps it in Pythonic form (`python/touchdown`).
//!
//! Input is passed as TOML text and read by the same code as files, so that keys, units and errors are those of the
//! command line. Columns are passed as the bytes of NumPy arrays. Long calls run on their own threads
//! (`interruptible`).
//!
//! | part | what |
//! |---|---|
//! | `src/documents` | dictionaries become TOML text, and that what files become: keys, units, ranges and complaints are in one place |
//! | `src/landing`, `cases`, `sweeps` | calls of the engine; columns go to and from NumPy as bytes (`columns`) |
//! | `src/interruptible` | long work on a thread of its own, while the caller's looks at signals and tells progress. A landing that does not end when told to is left to itself. A single landing is computed in place and looks at signals itself |
//! | `src/errors` | complaints and panics as exceptions; `fault` panics on purpose, for tests of the very wheel |
//! | `vehicle`, `scene`, `landing`, `boundaries`, `cases`, `sweeps` | what people import: values that never change, with docstrings and types |
//! | `reading`, `datasets` | result tables as datasets. A sweep in memory is one into a temporary folder that is read back: there is one way to make results |
//! | `_arguments` | arguments are looked at: what was given, what is allowed |
//! | `_warnings` | warnings of journals and landings, which point at whoever called the package |
//! | `_units` | results in SI, by the names and factors of the engine |
//! | `plot` | pictures with matplotlib |

mod cases;
mod columns;
mod documents;
mod errors;
mod interruptible;
mod landing;
mod sweeps;

use pyo3::prelude::*;

use errors::{Failure, guarded};

/// Version of the package.
const VERSION: &str = env!("CARGO_PKG_VERSION");

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

/// The module that Python imports.
#[pyo3::pymodule]
mod _engine {
    #[pymodule_export]
    const VERSION: &str = crate::VERSION;
    #[pymodule_export]
    use crate::cases::land_many;
    #[pymodule_export]
    use crate::columns::columns;
    #[pymodule_export]
    use crate::documents::{
        Scene, Solver, Vehicle, bare_name_and_unit, conditions, in_units, own_vehicle,
        program_name, replaced, toml,
    };
    #[pymodule_export]
    use crate::fault;
    #[pymodule_export]
    use crate::landing::{history, land};
    #[pymodule_export]
    use crate::sweeps::{Sweep, boundary};
}
