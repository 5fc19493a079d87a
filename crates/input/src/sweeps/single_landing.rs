//! Touchdown and settings of a single landing, each from its own document.

use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use crate::documents::document::Document;
use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::readers::scene_input::{self, NamedConditions, SceneFault};
use crate::readers::settings_input;
use crate::sweeps::sweep_file::locate_condition;

/// Conditions of a touchdown, and the document that gives them under the keys of a table `[scene]`.
#[derive(Debug, Clone)]
pub struct Touchdown {
    document: Document,
    conditions: NamedConditions,
}

impl Touchdown {
    /// Reads the conditions from a document. Missing ones are reported only by [`Touchdown::scene_for`].
    ///
    /// # Errors
    /// Names an unknown key, or the first value that is not allowed.
    pub fn from_document(document: Document) -> Result<Self, InputError> {
        let scene = Section::root(&document, &scene_input::scene_keys())?;
        let conditions = NamedConditions::read(&scene)?;
        let mut complete = conditions;
        while let Err(fault) = complete.scene() {
            match fault.value {
                // Missing conditions are not an error yet.
                None if complete.get(fault.name).is_none() => complete.set(fault.name, 0.0),
                _ => return Err(locate_condition(&fault, &scene, &[])),
            }
        }
        Ok(Self {
            document,
            conditions,
        })
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The conditions by name.
    pub fn conditions(&self) -> &NamedConditions {
        &self.conditions
    }

    /// Builds the scene for a vehicle and settings.
    ///
    /// # Errors
    /// Names a condition that is missing, or that the vehicle or the settings do not support.
    pub fn scene_for(&self, vehicle: &Vehicle, settings: &Settings) -> Result<Scene, InputError> {
        let complain =
            |fault: SceneFault| match Section::root(&self.document, &scene_input::scene_keys()) {
                Ok(scene) => locate_condition(&fault, &scene, &[]),
                Err(error) => error,
            };
        self.conditions
            .scene_for(vehicle, settings)
            .map_err(complain)
    }
}

/// Reads the settings of a landing from a document that holds only a table `[solver]`.
///
/// # Errors
/// Names the first key that is unknown or has a value that is not allowed.
pub fn settings(document: &Document) -> Result<Settings, InputError> {
    settings_input::settings_of_landing(&Section::root(document, &["solver"])?)
}
