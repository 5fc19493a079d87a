//! Values from the command line that replace those of a sweep file.

use crate::documents::document::Value;
use crate::documents::input_error::InputError;
use crate::documents::key_path::KeyPath;
use crate::documents::output_units::OutputUnits;
use crate::documents::section::Section;
use crate::points::assignment::{self, Assignment};
use crate::points::design::Design;
use crate::points::parameter::{Home, Parameter};
use crate::points::sample_input::{self, Sampled};
use crate::points::sensitivity_input;
use crate::points::set_value::{SampleNumber, SetValue};
use crate::readers::scene_input::HORIZONTAL_VELOCITY;
use crate::readers::vehicle_file::VehicleFile;
use crate::readers::{search_input, settings_input};
use crate::sweeps::case;
use crate::sweeps::sweep::{Job, OverrideNames, SWEEP, Sweep};

/// Replacements for values of a sweep file.
#[derive(Debug, Clone, Default)]
pub struct Overrides {
    /// The vehicle.
    pub vehicle: Option<VehicleFile>,
    /// Words of `[search]` and `[solver]`, by their dotted keys.
    pub words: Vec<(String, String)>,
    /// Values of parameters that do not vary, and numbers of `[sample]`.
    pub set: Vec<SetValue>,
    /// Parameters of sensitivities; if empty, those of the file apply.
    pub sensitivity: Vec<String>,
    /// Units of results.
    pub units: Option<OutputUnits>,
}

impl Sweep {
    /// Replaces some of the input of the sweep.
    ///
    /// # Errors
    /// If a replaced parameter varies, if the sweep does not use it, or if a point of the sweep becomes invalid.
    pub fn with(mut self, overrides: &Overrides) -> Result<Self, InputError> {
        for (name, word) in &overrides.words {
            let refuse = |complaint: &str| {
                let complaint = format!("{name} = {word:?}: {complaint}");
                InputError::other(complaint).at(self.document.place())
            };
            if self.axes.iter().any(|axis| axis.name() == name) {
                return Err(refuse("this parameter varies in the sweep"));
            }
            if name.starts_with("search.") && self.search().is_none() {
                return Err(refuse("not used with job = \"outcome\""));
            }
            if let Some(path) = KeyPath::parse(name) {
                self.document.write(&path, Value::Text(word.clone()));
            }
        }
        let (mut set, mut numbers) = (Vec::new(), Vec::new());
        for one in &overrides.set {
            match one {
                SetValue::Parameter(one) => set.push(one.clone()),
                SetValue::Sample(one) => numbers.push(one),
            }
        }
        self.set(&set)?;
        self.set_sample(&numbers)?;
        let first = self.design.coordinates(0);
        let document = case::written(&self.document, &self.axes, Home::Sweep, &first);
        let root = Section::root(&document, &SWEEP)?;
        if let Job::Boundary(search) = &mut self.job {
            *search = search_input::search(&root)?;
        }
        self.settings = settings_input::settings(&root, self.job.stop())?;
        if let Some(vehicle) = &overrides.vehicle {
            self.vehicle = vehicle.clone();
            self.sources.push(vehicle.document.source());
        }
        self.vehicle = assignment::set_vehicle(&self.vehicle, &set)?;
        if overrides.vehicle.is_some() || !overrides.set.is_empty() {
            // The statement referred to the input of the sweep file.
            self.statement = None;
            self.check_legs()?;
            self.check_points()?;
        }
        if !overrides.sensitivity.is_empty() {
            self.sensitivity = sensitivity_input::named(&overrides.sensitivity, self.leg_count())?;
        }
        self.check_sensitivity()?;
        self.units = overrides.units.unwrap_or(self.units);
        let path = |file: &VehicleFile| file.document.path().to_owned();
        self.overrides = OverrideNames {
            vehicle: overrides.vehicle.as_ref().map(path),
            words: overrides.words.clone(),
            set: overrides.set.iter().map(SetValue::said).collect(),
            sensitivity: overrides.sensitivity.clone(),
            units: overrides.units,
        };
        Ok(self)
    }

    /// Sets conditions of the scene and numbers of the sweep file; only checks those of the vehicle.
    fn set(&mut self, set: &[Assignment]) -> Result<(), InputError> {
        assignment::check_once(set)?;
        for one in set {
            let name = one.parameter().program_name();
            if self.axes.contains(one.parameter()) {
                return Err(one.refuse("this parameter varies in the sweep"));
            }
            let searches = self.search().is_some();
            if searches && name == HORIZONTAL_VELOCITY {
                return Err(one.refuse("the sweep searches the horizontal velocity"));
            }
            if !searches && name.starts_with("search.") {
                return Err(one.refuse("not used with job = \"outcome\""));
            }
            if one.parameter().home() == Home::Sweep {
                self.document.write(one.path(), one.value());
            }
        }
        let names: Vec<&str> = (set.iter())
            .map(|one| one.parameter().program_name())
            .collect();
        self.fixed.replace_attitude_form(&names);
        assignment::set_conditions(&mut self.fixed, set);
        Ok(())
    }

    /// Sets numbers of `[sample]`, and draws its points anew.
    fn set_sample(&mut self, numbers: &[&SampleNumber]) -> Result<(), InputError> {
        for (index, one) in numbers.iter().enumerate() {
            if numbers[..index]
                .iter()
                .any(|other| other.name() == one.name())
            {
                return Err(one.refuse("set twice: expected once"));
            }
            let Design::Sample(_) = self.design else {
                return Err(one.refuse("the sweep has no table [sample]"));
            };
            if one.name() == "sample.stop_at_interval_width" && self.search().is_some() {
                return Err(one.refuse("is used with job = \"outcome\" only"));
            }
            if let Some((path, value)) = one.entry() {
                self.document.write(&path, value);
            }
        }
        if let (Design::Sample(sample), false) = (&self.design, numbers.is_empty()) {
            let root = Section::root(&self.document, &SWEEP)?;
            let Sampled { sample, enough } = sample_input::drawn_again(&root, sample)?;
            self.design = Design::Sample(sample);
            if let Job::Outcome { enough: before } = &mut self.job {
                *before = enough;
            }
        }
        Ok(())
    }

    /// Checks that the vehicle has the legs named in axes and sensitivities.
    fn check_legs(&self) -> Result<(), InputError> {
        let legs = self.leg_count();
        let is_absent = |one: &&Parameter| Parameter::named(one.name(), legs).is_none();
        match self.axes.iter().chain(&self.sensitivity).find(is_absent) {
            Some(parameter) => {
                let said = format!("{}: the vehicle has {legs} legs", parameter.name());
                Err(InputError::other(said).at(self.document.place()))
            }
            None => Ok(()),
        }
    }

    fn check_points(&self) -> Result<(), InputError> {
        for coordinates in self.design.probes() {
            self.case_at(&coordinates).map_err(|fault| {
                let complaint = format!("with the values of the command line: {fault}");
                InputError::other(complaint).at(self.document.place())
            })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweeps::sweep_file::tests::figure_4_09;
    use touchdown_dynamics::scene::CrushRule;

    use touchdown_search::boundary::Extent;

    #[test]
    fn words_given_instead_hold_and_may_not_vary() {
        let sweep = figure_4_09();
        let word = |key: &str, word: &str| (key.to_owned(), word.to_owned());
        let mut overrides = Overrides {
            words: vec![
                word("solver.crush_rule", "section"),
                word("search.bands", "first"),
            ],
            ..Overrides::default()
        };
        let mut changed = sweep.with(&overrides).unwrap();
        assert_eq!(changed.search().unwrap().extent, Extent::First);
        let settings = changed.case(3).unwrap().settings;
        assert_eq!(settings.rule_choices().crush, Some(CrushRule::Section));
        changed.axes[0] =
            crate::points::parameter::Parameter::named("solver.crush_rule", 3).unwrap();
        let complaint = changed.clone().with(&overrides).unwrap_err().to_string();
        assert!(
            complaint.contains("this parameter varies in the sweep"),
            "{complaint}"
        );
        overrides.words = vec![word("search.bands", "both")];
        let complaint = changed.with(&overrides).unwrap_err().to_string();
        assert!(complaint.contains("search.bands = \"both\""), "{complaint}");
    }
}
