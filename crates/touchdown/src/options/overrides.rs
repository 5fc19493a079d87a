//! Options of `sweep` that replace what sweep files say.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use touchdown_dynamics::scene::CrushRule;
use touchdown_sweep::assignment::Assignment;
use touchdown_sweep::choice;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::overrides::Overrides;
use touchdown_sweep::settings_input::CRUSH_RULES;
use touchdown_sweep::sweep_file::Sweep;
use touchdown_sweep::vehicle_file::VehicleFile;

use crate::solver_options::rule;
use crate::units::UnitsOption;

/// What replaces the values of the sweep files.
#[derive(Debug, Args)]
#[command(next_help_heading = "Replacing values of the sweep files")]
pub struct OverrideOptions {
    /// Vehicle file (TOML)
    #[arg(long, value_name = "FILE")]
    vehicle: Option<PathBuf>,
    /// Set one value by its dotted name, e.g. vehicle.strut.preload_lb=200 or slope_deg=10; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = Assignment::parse)]
    set: Vec<Assignment>,
    /// Crush rule: "pivot-rate" or "section"
    #[arg(long, value_name = "RULE", value_parser = rule)]
    crush_rule: Option<CrushRule>,
    /// Find the first transition, or every band of the range
    #[arg(long, value_name = "BANDS")]
    bands: Option<Bands>,
    /// Land at every step of the scan, or skip steps between quiet landings
    #[arg(long, value_name = "SCAN")]
    scan: Option<ScanName>,
    /// Narrow brackets by interpolating margins or by halving
    #[arg(long, value_name = "HOW")]
    refinement: Option<RefinementName>,
    /// Parameters, by their dotted names and separated by commas, for which dV_H/dp is computed at every
    /// point; with a tornado chart
    #[arg(long, value_name = "PARAMETERS", value_delimiter = ',')]
    sensitivity: Vec<String>,
    #[command(flatten)]
    units: UnitsOption,
}

/// Extents of a search by name.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Bands {
    /// Up to the first transition
    First,
    /// The whole range
    All,
}

/// Scans by name.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum ScanName {
    /// Every step
    Full,
    /// Without the steps between quiet landings
    Skipping,
}

/// Ways to narrow brackets by name.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum RefinementName {
    /// Interpolation of margins
    Margin,
    /// Halving
    Bisection,
}

impl OverrideOptions {
    /// The sweeps with what was given put into them.
    ///
    /// # Errors
    /// When the vehicle file cannot be used, or what was given varies in a sweep.
    pub fn apply(&self, sweeps: Vec<Sweep>) -> Result<Vec<Sweep>, InputError> {
        let vehicle = self.vehicle.as_deref().map(VehicleFile::read).transpose()?;
        let rule = self
            .crush_rule
            .map(|rule| choice::word(&CRUSH_RULES, rule).to_owned());
        let words = [
            ("solver.crush_rule", rule),
            ("search.bands", self.bands.and_then(word)),
            ("search.scan", self.scan.and_then(word)),
            ("search.refinement", self.refinement.and_then(word)),
        ];
        let given = |(key, word): (&str, Option<String>)| Some((key.to_owned(), word?));
        let overrides = Overrides {
            vehicle,
            set: self.set.clone(),
            words: words.into_iter().filter_map(given).collect(),
            sensitivity: self.sensitivity.clone(),
            units: self.units.given(),
        };
        sweeps
            .into_iter()
            .map(|sweep| sweep.with(&overrides))
            .collect()
    }
}

/// The word of an option's value, which sweep files use too.
fn word(value: impl ValueEnum) -> Option<String> {
    Some(value.to_possible_value()?.get_name().to_owned())
}
