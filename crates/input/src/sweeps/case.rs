//! The full input of one point of a sweep, with the values of the point set.
//!
//! Values are written into the documents as read, and changed documents are read again, so that every check applies to
//! every point.

use std::sync::Arc;

use thiserror::Error;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use crate::documents::document::{Document, Value};
use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::points::parameter::{Home, Parameter};
use crate::readers::scene_input::{HORIZONTAL_VELOCITY, NamedConditions, SceneFault};
use crate::readers::vehicle_file::{self, VehicleFile};
use crate::readers::{search_input, settings_input};
use crate::sweeps::sweep::{Job, SWEEP, Sweep};

/// Input of one point.
#[derive(Debug, Clone)]
pub struct Case {
    /// The vehicle.
    pub vehicle: Arc<Vehicle>,
    /// The scene; in a boundary sweep, at the lowest speed of the search.
    pub scene: Scene,
    /// The job.
    pub job: Job,
    /// Settings of landings.
    pub settings: Settings,
}

/// Reason why a point has no valid input.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CaseFault {
    /// A condition of the scene is missing or not allowed.
    #[error(transparent)]
    Scene(SceneFault),
    /// A fault in another part of the input.
    #[error("{error}")]
    Input {
        /// The part.
        part: Home,
        /// The fault.
        error: InputError,
    },
}

impl Sweep {
    /// Checks that the sensitivities can be computed.
    pub(crate) fn check_sensitivity(&self) -> Result<(), InputError> {
        let refuse =
            |complaint: String| Err(InputError::other(complaint).at(self.document.place()));
        if !self.sensitivity.is_empty() && self.search().is_none() {
            return refuse("sensitivity: not used with job = \"outcome\"".to_owned());
        }
        let valueless = |parameter: &&Parameter| self.value(0, parameter).is_none();
        match self.sensitivity.iter().find(valueless) {
            Some(parameter) => refuse(format!(
                "sensitivity to {}: the parameter has no value: expected a number that the sweep file or the \
                 vehicle file gives",
                parameter.name()
            )),
            None => Ok(()),
        }
    }

    /// Builds the input of a point.
    ///
    /// # Errors
    /// If values that are valid one by one are not valid together.
    pub fn case(&self, point: usize) -> Result<Case, CaseFault> {
        self.case_at(&self.design.coordinates(point))
    }

    /// Builds the input at coordinates, one for each axis.
    ///
    /// # Errors
    /// If it is not valid.
    pub fn case_at(&self, coordinates: &[f64]) -> Result<Case, CaseFault> {
        self.case_of(&self.axes, coordinates)
    }

    /// Builds the input of a point with another value, in its unit, for one parameter.
    ///
    /// # Errors
    /// If it is not valid.
    pub fn case_with(
        &self,
        point: usize,
        parameter: &Parameter,
        value: f64,
    ) -> Result<Case, CaseFault> {
        let mut axes = self.axes.clone();
        let mut coordinates = self.design.coordinates(point);
        match axes.iter().position(|axis| axis == parameter) {
            // The value is in the unit of the parameter, which may differ from that of the axis.
            Some(axis) => {
                axes[axis] = parameter.clone();
                coordinates[axis] = value;
            }
            None => {
                axes.push(parameter.clone());
                coordinates.push(value);
            }
        }
        self.case_of(&axes, &coordinates)
    }

    /// Value of a number of scene or vehicle at a point, if any, in the parameter's unit.
    pub fn value(&self, point: usize, parameter: &Parameter) -> Option<f64> {
        let coordinates = self.design.coordinates(point);
        let value = match parameter.home() {
            Home::Scene => {
                let conditions = self.conditions(&self.axes, &coordinates).resolved();
                let mut named = conditions.into_iter();
                named.find_map(|(name, value)| (name == parameter.program_name()).then_some(value))
            }
            Home::Vehicle => {
                let document = &self.vehicle.document;
                let document = written(document, &self.axes, Home::Vehicle, &coordinates);
                vehicle_file::number(&document, parameter.path())
            }
            Home::Sweep => None,
        };
        value.map(|value| parameter.in_own_unit(value))
    }

    fn case_of(&self, axes: &[Parameter], coordinates: &[f64]) -> Result<Case, CaseFault> {
        let (job, settings) = self.job_and_settings(axes, coordinates)?;
        let mut conditions = self.conditions(axes, coordinates);
        if let Job::Boundary(search) = job {
            conditions.set(HORIZONTAL_VELOCITY, search.from);
        }
        let vehicle = self.vehicle_at(axes, coordinates)?;
        Ok(Case {
            scene: conditions
                .scene_for(&vehicle, &settings)
                .map_err(CaseFault::Scene)?,
            vehicle,
            job,
            settings,
        })
    }

    fn conditions(&self, axes: &[Parameter], coordinates: &[f64]) -> NamedConditions {
        let mut conditions = self.fixed;
        for (axis, value) in axes.iter().zip(coordinates) {
            if axis.home() == Home::Scene {
                conditions.set(axis.program_name(), axis.to_program(*value));
            }
        }
        conditions
    }

    fn vehicle_at(
        &self,
        axes: &[Parameter],
        coordinates: &[f64],
    ) -> Result<Arc<Vehicle>, CaseFault> {
        if !varies(axes, Home::Vehicle) {
            return Ok(Arc::new(self.vehicle.vehicle.clone()));
        }
        let document = written(&self.vehicle.document, axes, Home::Vehicle, coordinates);
        VehicleFile::from_document(document)
            .map(|file| Arc::new(file.vehicle))
            .map_err(in_part(Home::Vehicle))
    }

    fn job_and_settings(
        &self,
        axes: &[Parameter],
        coordinates: &[f64],
    ) -> Result<(Job, Settings), CaseFault> {
        if !varies(axes, Home::Sweep) {
            return Ok((self.job, self.settings));
        }
        let document = written(&self.document, axes, Home::Sweep, coordinates);
        let read = || {
            let root = Section::root(&document, &SWEEP)?;
            let job = match self.job {
                Job::Boundary(_) => Job::Boundary(search_input::search(&root)?),
                outcome => outcome,
            };
            Ok((job, settings_input::settings(&root, self.job.stop())?))
        };
        read().map_err(in_part(Home::Sweep))
    }
}

fn varies(axes: &[Parameter], part: Home) -> bool {
    axes.iter().any(|axis| axis.home() == part)
}

fn in_part(part: Home) -> impl Fn(InputError) -> CaseFault {
    move |error| CaseFault::Input { part, error }
}

/// A document with the coordinates that belong to it set.
pub(crate) fn written(
    document: &Document,
    axes: &[Parameter],
    part: Home,
    coordinates: &[f64],
) -> Document {
    let mut document = document.clone();
    for (axis, coordinate) in axes.iter().zip(coordinates) {
        if axis.home() != part {
            continue;
        }
        let value = match axis.word(*coordinate) {
            Some(word) => Value::Text(word.to_owned()),
            None => Value::Number(axis.to_program(*coordinate)),
        };
        document.write(axis.path(), value);
    }
    document
}
