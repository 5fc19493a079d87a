//! What holds instead of what a sweep file says, for one study more than it tells.

use crate::case;
use crate::document::Value;
use crate::input_error::InputError;
use crate::key_path::KeyPath;
use crate::parameter::Home;
use crate::section::Section;
use crate::sensitivity_input;
use crate::sweep::{Job, OverrideNames, SWEEP, Sweep};
use crate::vehicle_file::LEGS;
use crate::vehicle_file::VehicleFile;
use crate::{search_input, settings_input};

/// What holds instead of a sweep file's own.
#[derive(Debug, Clone, Default)]
pub struct Overrides {
    /// The vehicle.
    pub vehicle: Option<VehicleFile>,
    /// Words of `[search]` and `[solver]`, by their dotted keys.
    pub words: Vec<(String, String)>,
    /// Parameters on which the transition's dependence is asked; the file's where there are none.
    pub sensitivity: Vec<String>,
}

impl Sweep {
    /// The sweep with something instead of what its file says.
    ///
    /// # Errors
    /// When what varies would be replaced, says nothing in this sweep, or does not fit the vehicle.
    pub fn with(mut self, overrides: &Overrides) -> Result<Self, InputError> {
        for (name, word) in &overrides.words {
            let refuse = |complaint: &str| {
                let complaint = format!("{name} = {word:?}: {complaint}");
                InputError::other(complaint).at(self.document.place())
            };
            if self.axes.iter().any(|axis| axis.name() == name) {
                return Err(refuse("varies in this sweep"));
            }
            if name.starts_with("search.") && self.search().is_none() {
                return Err(refuse("says nothing where job = \"outcome\""));
            }
            if let Some(path) = KeyPath::parse(name) {
                self.document.write(&path, Value::Text(word.clone()));
            }
        }
        let first = self.design.coordinates(0);
        let document = case::written(&self.document, &self.axes, Home::Sweep, &first);
        let root = Section::root(&document, &SWEEP)?;
        if let Job::Boundary(search) = &mut self.job {
            *search = search_input::search(&root)?;
        }
        self.settings = settings_input::settings(&root)?;
        if let Some(vehicle) = &overrides.vehicle {
            self.vehicle = vehicle.clone();
            // It was made on the vehicle of the sweep file.
            self.statement = None;
            self.check_points()?;
            self.sources.push(vehicle.document.source());
        }
        if !overrides.sensitivity.is_empty() {
            self.sensitivity = sensitivity_input::named(&overrides.sensitivity, LEGS)?;
        }
        self.check_sensitivity()?;
        let path = |file: &VehicleFile| file.document.path().to_owned();
        self.overrides = OverrideNames {
            vehicle: overrides.vehicle.as_ref().map(path),
            words: overrides.words.clone(),
            sensitivity: overrides.sensitivity.clone(),
        };
        Ok(self)
    }

    fn check_points(&self) -> Result<(), InputError> {
        for coordinates in self.design.probes() {
            self.case_at(&coordinates).map_err(|fault| {
                let complaint = format!("with another vehicle: {fault}");
                InputError::other(complaint).at(self.document.place())
            })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use touchdown_dynamics::scene::CrushRule;

    use crate::boundary::Extent;

    #[test]
    fn words_given_instead_hold_and_may_not_vary() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-09.toml");
        let sweep: Sweep = Sweep::read(Path::new(path)).unwrap();
        let word = |key: &str, word: &str| (key.to_owned(), word.to_owned());
        let mut overrides = Overrides {
            vehicle: None,
            sensitivity: Vec::new(),
            words: vec![
                word("solver.crush_rule", "section"),
                word("search.bands", "first"),
            ],
        };
        let mut changed = sweep.with(&overrides).unwrap();
        assert_eq!(changed.search().unwrap().extent, Extent::First);
        let settings = changed.case(3).unwrap().settings;
        assert_eq!(settings.crush_rule(), CrushRule::Section);
        changed.axes[0] = crate::parameter::Parameter::named("solver.crush_rule", 3).unwrap();
        let complaint = changed.clone().with(&overrides).unwrap_err().to_string();
        assert!(complaint.contains("varies in this sweep"), "{complaint}");
        overrides.words = vec![word("search.bands", "both")];
        let complaint = changed.with(&overrides).unwrap_err().to_string();
        assert!(complaint.contains("search.bands = \"both\""), "{complaint}");
    }
}
