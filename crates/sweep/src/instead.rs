//! What holds instead of what a sweep file says, for one study more than it tells.

use std::path::PathBuf;

use touchdown_dynamics::scene::CrushRule;

use crate::boundary::Extent;
use crate::case;
use crate::document::Value;
use crate::input_error::InputError;
use crate::key_path::KeyPath;
use crate::parameter::Home;
use crate::search_input::{self, extent_name};
use crate::section::Section;
use crate::settings_input::{self, crush_rule_name};
use crate::sweep_file::{Job, SWEEP, Sweep};
use crate::vehicle_file::VehicleFile;

/// What holds instead of a sweep file's own.
#[derive(Debug, Clone, Default)]
pub struct Instead<const LEGS: usize> {
    /// The vehicle.
    pub vehicle: Option<VehicleFile<LEGS>>,
    /// When an element may crush further.
    pub crush_rule: Option<CrushRule>,
    /// How much of the range is searched.
    pub extent: Option<Extent>,
}

/// What was given instead, by the names of files and words.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Given {
    pub(crate) vehicle: Option<PathBuf>,
    pub(crate) crush_rule: Option<String>,
    pub(crate) bands: Option<String>,
}

impl<const LEGS: usize> Sweep<LEGS> {
    /// The sweep with something instead of what its file says.
    ///
    /// # Errors
    /// When what varies would be replaced, or does not fit the vehicle.
    pub fn with(mut self, instead: &Instead<LEGS>) -> Result<Self, InputError> {
        if let (Job::Outcome { .. }, Some(extent)) = (self.job, instead.extent) {
            let name = extent_name(extent);
            let complaint = format!("bands = {name:?}: says nothing where job = \"outcome\"");
            return Err(InputError::other(complaint).at(self.document.place()));
        }
        let words = [
            ("solver.crush_rule", instead.crush_rule.map(crush_rule_name)),
            ("search.bands", instead.extent.map(extent_name)),
        ];
        for (name, word) in words {
            let (Some(word), Some(path)) = (word, KeyPath::parse(name)) else {
                continue;
            };
            if self.axes.iter().any(|axis| axis.name() == name) {
                let complaint = format!("{name} = {word:?}: varies in this sweep");
                return Err(InputError::other(complaint).at(self.document.place()));
            }
            self.document.write(&path, Value::Text(word.to_owned()));
        }
        let [crush_rule, bands] = words.map(|(_, word)| word.map(str::to_owned));
        let first = self.design.coordinates(0);
        let document = case::written(&self.document, &self.axes, Home::Sweep, &first);
        let root = Section::root(&document, &SWEEP)?;
        if let Job::Boundary(search) = &mut self.job {
            *search = search_input::search(&root)?;
        }
        self.settings = settings_input::settings(&root)?;
        if let Some(vehicle) = &instead.vehicle {
            self.vehicle = vehicle.clone();
            self.check_case_by_case()?;
            self.sources.push(vehicle.document.source());
        }
        self.instead = Given {
            vehicle: instead
                .vehicle
                .as_ref()
                .map(|file| file.document.path().to_owned()),
            crush_rule,
            bands,
        };
        Ok(self)
    }

    fn check_case_by_case(&self) -> Result<(), InputError> {
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

    #[test]
    fn words_given_instead_hold_and_may_not_vary() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-09.toml");
        let sweep: Sweep<3> = Sweep::read(Path::new(path)).unwrap();
        let instead = Instead {
            crush_rule: Some(CrushRule::Section),
            extent: Some(Extent::First),
            ..Instead::default()
        };
        let mut changed = sweep.with(&instead).unwrap();
        assert_eq!(changed.settings.crush_rule(), CrushRule::Section);
        assert_eq!(changed.search().unwrap().extent, Extent::First);
        assert_eq!(
            changed.case(3).unwrap().settings.crush_rule(),
            CrushRule::Section
        );
        changed.axes[0] = crate::parameter::Parameter::named("solver.crush_rule", 3).unwrap();
        let complaint = changed.with(&instead).unwrap_err().to_string();
        assert!(complaint.contains("varies in this sweep"), "{complaint}");
    }
}
