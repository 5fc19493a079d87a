//! The engine behind the Python package `touchdown`, which makes of it the shapes that people expect
//! (`python/touchdown`).
//!
//! Input comes as TOML text, read by the same code as files, so that keys, units and complaints are those of the command
//! line. Columns come and go as the bytes of NumPy's arrays. Whatever takes long runs on a thread of its own
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

/// The module that Python imports.
#[pyo3::pymodule]
mod _engine {
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use crate::boundary::boundary;
    #[pymodule_export]
    use crate::cases::land_many;
    #[pymodule_export]
    use crate::documents::{
        Scene, Solver, Vehicle, bare_name_and_unit, in_units, own_vehicle, program_name, toml,
    };
    #[pymodule_export]
    use crate::fault::fault;
    #[pymodule_export]
    use crate::landing::{history, land};
    #[pymodule_export]
    use crate::sweeps::Sweep;
}
