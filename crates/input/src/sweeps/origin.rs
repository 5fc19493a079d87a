//! The files from which a sweep was read, kept so that it can be read again.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::documents::input_error::InputError;
use crate::documents::library::{Library, Source};
use crate::points::set_value::SetValue;
use crate::readers::vehicle_file::VehicleFile;
use crate::sweeps::overrides::Overrides;
use crate::sweeps::sweep::{OverrideNames, Sweep};

/// The files from which a sweep was read, and what replaced their values.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    sweep: PathBuf,
    // Name in the files since the first version.
    #[serde(rename = "instead")]
    overrides: OverrideNames,
    sources: Vec<Source>,
}

impl Origin {
    /// The origin of a sweep.
    pub fn of(sweep: &Sweep) -> Self {
        Self {
            sweep: sweep.path.clone(),
            overrides: sweep.overrides.clone(),
            sources: sweep.sources.clone(),
        }
    }

    /// The sweep file, as named on the command line.
    pub fn path(&self) -> &Path {
        &self.sweep
    }

    /// Reads the sweep from the copies of its files.
    ///
    /// # Errors
    /// If the copies were altered.
    pub fn sweep(&self) -> Result<Sweep, InputError> {
        let overrides = &self.overrides;
        let library = Library::Copies(&self.sources);
        let read_vehicle = |path: &PathBuf| VehicleFile::read_from(path, library);
        let set_value = |(name, text): &(String, String)| SetValue::new(name, text);
        let with = Overrides {
            vehicle: overrides.vehicle.as_ref().map(read_vehicle).transpose()?,
            words: overrides.words.clone(),
            set: overrides
                .set
                .iter()
                .map(set_value)
                .collect::<Result<_, _>>()?,
            sensitivity: overrides.sensitivity.clone(),
            units: overrides.units,
        };
        Sweep::read_from(&self.sweep, library)?.with(&with)
    }
}
