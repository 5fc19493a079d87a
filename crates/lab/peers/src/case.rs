//! What Python sees: the landings that are compared.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant as Clock;

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use touchdown_dynamics::land::{land, land_observed};
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::measured_scenes::near_boundary;

use crate::integrator::{Integrator, settings};
use crate::plain_landing::{PlainLanding, Until};
use crate::variables::{COUNT, position_and_pitch, state};

/// Position (ft) and pitch (deg).
type Seen = ([f64; 3], f64);

/// A touchdown of a vehicle.
#[pyclass(frozen)]
pub struct Case {
    vehicle: Arc<Vehicle>,
    scene: Scene,
}

/// The forty landings around the boundary (ten when quick) of the vehicle in a file.
#[pyfunction]
pub fn cases(vehicle: PathBuf, quick: bool) -> PyResult<Vec<Case>> {
    let vehicle = Arc::new(VehicleFile::read(&vehicle).map_err(refused)?.vehicle);
    let scenes = near_boundary(quick).map_err(refused)?;
    let case = |scene| Case {
        vehicle: Arc::clone(&vehicle),
        scene,
    };
    Ok(scenes.into_iter().map(case).collect())
}

#[pymethods]
impl Case {
    /// Lands: time it took (µs), evaluations, class of the outcome.
    fn land(&self, integrator: &str, tolerance: f64) -> PyResult<(f64, u64, String)> {
        let integrator = named(integrator, tolerance)?;
        let clock = Clock::now();
        let (evaluations, class) = match integrator {
            Integrator::Peer(integrate, tolerance) => {
                let mut landing = self.plain(Until::Outcome)?;
                integrate(&mut landing, tolerance).map_err(PyRuntimeError::new_err)?;
                (landing.evaluations(), landing.class())
            }
            Integrator::Own(settings) => {
                let landing = land(&self.vehicle, &self.scene, &settings);
                (landing.evaluations, landing.outcome.class())
            }
        };
        let time = 1e6 * clock.elapsed().as_secs_f64();
        Ok((time, evaluations, word(class)))
    }

    /// What is seen at a time (s), if the landing lasts so long; for a peer whatever happens before.
    fn seen_at(&self, integrator: &str, tolerance: f64, time: f64) -> PyResult<Option<Seen>> {
        match named(integrator, tolerance)? {
            Integrator::Peer(integrate, tolerance) => {
                let mut landing = self.plain(Until::Time(time))?;
                let y = integrate(&mut landing, tolerance).map_err(PyRuntimeError::new_err)?;
                Ok(Some(position_and_pitch(&state(&y))))
            }
            Integrator::Own(settings) => {
                let mut seen = None;
                let mut observe = |instant: &Instant| {
                    if (instant.time - time).abs() < 1e-9 {
                        let pitch = instant.attitude.euler().pitch.to_degrees();
                        seen = Some((instant.position.into(), pitch));
                    }
                };
                land_observed(&self.vehicle, &self.scene, &settings, time, &mut observe);
                Ok(seen)
            }
        }
    }

    /// The landing for an integrator of Python: to its outcome, or to a time (s).
    #[pyo3(signature = (time=None))]
    fn plain_landing(&self, time: Option<f64>) -> PyResult<PlainCase> {
        let until = time.map_or(Until::Outcome, Until::Time);
        Ok(PlainCase(Box::new(self.plain(until)?)))
    }
}

impl Case {
    fn plain(&self, until: Until) -> PyResult<PlainLanding> {
        let settings = settings(Settings::DEFAULT_TOLERANCE).map_err(refused)?;
        Ok(PlainLanding::new(
            &self.vehicle,
            &self.scene,
            &settings,
            until,
        ))
    }
}

/// A landing whose right-hand side an integrator of Python takes.
// Python aligns its objects to 16 bytes; a landing has registers of more in it.
#[pyclass(unsendable)]
pub struct PlainCase(Box<PlainLanding>);

#[pymethods]
impl PlainCase {
    /// Variables at first contact.
    fn start<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.0.start())
    }

    /// Time to integrate to, s.
    fn last(&self) -> f64 {
        self.0.last()
    }

    /// The right-hand side.
    fn derivative<'py>(
        &self,
        py: Python<'py>,
        _time: f64,
        y: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mut slope = vec![0.0; COUNT];
        self.0.derivative(y.as_slice()?, &mut slope);
        Ok(slope.into_pyarray(py))
    }

    /// Takes note of an accepted step that ends at `y`; whether it ends the landing.
    fn accept(&mut self, y: PyReadonlyArray1<'_, f64>) -> PyResult<bool> {
        Ok(self.0.accept(y.as_slice()?))
    }

    /// Evaluations so far.
    fn evaluations(&self) -> u64 {
        self.0.evaluations()
    }

    /// Class of the outcome.
    fn outcome(&self) -> String {
        word(self.0.class())
    }

    /// What is seen at variables `y`.
    fn seen(&self, y: PyReadonlyArray1<'_, f64>) -> PyResult<Seen> {
        Ok(position_and_pitch(&state(y.as_slice()?)))
    }
}

fn named(integrator: &str, tolerance: f64) -> PyResult<Integrator> {
    let known = Integrator::named(integrator, tolerance).map_err(refused)?;
    known.ok_or_else(|| PyValueError::new_err(format!("{integrator}: no such integrator")))
}

fn word(class: Class) -> String {
    format!("{class:?}").to_lowercase()
}

fn refused(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}
