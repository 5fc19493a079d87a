//! The engine behind the Python package `touchdown`, which wraps it in Pythonic form (`python/touchdown`).
//!
//! Input is passed as TOML text and read by the same code as files, so that keys, units and errors are those of the
//! command line. Columns are passed as the bytes of NumPy arrays. Long calls run on their own threads
//! (`interruptible`).

mod boundary;
mod cases;
mod columns;
mod documents;
mod errors;
mod fault;
mod interruptible;
mod landing;
mod sweeps;

/// Version of the package.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The module that Python imports.
#[pyo3::pymodule]
mod _engine {
    #[pymodule_export]
    const VERSION: &str = crate::VERSION;
    #[pymodule_export]
    use crate::boundary::boundary;
    #[pymodule_export]
    use crate::cases::land_many;
    #[pymodule_export]
    use crate::documents::{
        Scene, Solver, Vehicle, bare_name_and_unit, in_units, own_vehicle, program_name, replaced,
        toml,
    };
    #[pymodule_export]
    use crate::fault::fault;
    #[pymodule_export]
    use crate::landing::{history, land, landing_columns};
    #[pymodule_export]
    use crate::sweeps::Sweep;
}
