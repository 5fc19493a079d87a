//! Errors as exceptions of the package.

use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::journal::JournalError;
use touchdown_sweep::output::file_writer::WriteError;
use touchdown_sweep::output::tables::TablesError;
use touchdown_sweep::threads::run::RunError;

/// Reason why a call has no result.
#[derive(Debug)]
pub enum Failure {
    /// The input is invalid.
    Input(InputError),
    /// Files cannot be read or written.
    Files(String),
    /// Anything else.
    Engine(String),
}

impl Failure {
    /// A fault of the engine.
    pub fn engine(error: impl fmt::Display) -> Self {
        Self::Engine(error.to_string())
    }

    /// The message of a panic.
    pub fn of_panic(panic: &(dyn Any + Send)) -> Self {
        let said = (panic.downcast_ref::<String>().map(String::as_str))
            .or_else(|| panic.downcast_ref::<&str>().copied());
        Self::Engine(format!(
            "the engine failed, which is a fault of it: {}",
            said.unwrap_or("it said nothing")
        ))
    }
}

/// Error about a file that must not be overwritten, with the option as spelled in Python.
pub fn in_the_way(error: InputError) -> InputError {
    InputError::other(error.to_string().replace("--overwrite", "overwrite=True"))
}

/// Runs work and turns a panic into a failure.
pub fn guarded<T, E>(work: impl FnOnce() -> Result<T, E>) -> Result<T, Failure>
where
    Failure: From<E>,
{
    // Nothing that the work could leave half done outlives it.
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(result) => Ok(result?),
        Err(panic) => Err(Failure::of_panic(&*panic)),
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        match error.is_of_files() {
            true => Self::Files(error.to_string()),
            false => Self::Input(error),
        }
    }
}

impl From<JournalError> for Failure {
    fn from(error: JournalError) -> Self {
        match error {
            JournalError::Different { .. } => Self::Input(InputError::other(error.to_string())),
            other => Self::Files(other.to_string()),
        }
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        Self::Files(error.to_string())
    }
}

impl From<TablesError> for Failure {
    fn from(error: TablesError) -> Self {
        match error {
            TablesError::Journal(error) => error.into(),
            TablesError::Deposit(error) => error.into(),
            point => Self::engine(point),
        }
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        match error {
            RunError::Journal(error) => error.into(),
            RunError::Point { .. } | RunError::TooManyThreads { .. } => {
                Self::Input(InputError::other(error.to_string()))
            }
            other => Self::engine(other),
        }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| match failure {
            Failure::Input(error) => {
                let subject = error.subject();
                let arguments = (
                    error.to_string(),
                    subject.map(|subject| subject.key.clone()),
                    subject.and_then(|subject| subject.value.clone()),
                    subject.map(|subject| subject.allowed.clone()),
                );
                exception(py, "InputError", arguments)
            }
            Failure::Files(said) => PyOSError::new_err(said),
            Failure::Engine(said) => exception(py, "EngineError", (said,)),
        })
    }
}

/// An exception of the package.
fn exception<'py>(
    py: Python<'py>,
    name: &str,
    arguments: impl pyo3::call::PyCallArgs<'py>,
) -> PyErr {
    let class = (py.import("touchdown.errors")).and_then(|errors| errors.getattr(name));
    match class.and_then(|class| class.call1(arguments)) {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}
