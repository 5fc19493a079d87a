//! Options that several commands share, and those that replace what sweep files say.

pub mod solver_options;
pub mod touchdown_options;

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use touchdown_dynamics::rules::{CrushRule, Rules};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::set_value::SetValue;
use touchdown_input::readers::choice::word;
use touchdown_input::readers::settings_input::{CRUSH_RULES, RULES};
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::overrides::Overrides;
use touchdown_input::sweeps::sweep_file::Sweep;

use solver_options::choice;

/// Units by name.
pub fn units() -> impl TypedValueParser<Value = OutputUnits> {
    let known = [
        PossibleValue::new("US").help("Foot, slug, pound and degree"),
        PossibleValue::new("SI").help("Metre, kilogram and newton"),
    ];
    PossibleValuesParser::new(known).map(|name| {
        // One of the two, in letters of either case.
        OutputUnits::named(&name.to_uppercase()).unwrap_or_default()
    })
}

/// The option of commands that write and print results.
#[derive(Debug, Args)]
pub struct UnitsOption {
    /// Units of what is written and printed; angles are in degrees in both [default: those of the input file, or
    /// else US]
    #[arg(
        id = "units",
        long = "units",
        value_parser = units(),
        value_name = "UNITS",
        ignore_case = true,
        help_heading = "Output"
    )]
    pub given: Option<OutputUnits>,
}

/// Replacements of values of the sweep files.
#[derive(Debug, Args)]
#[command(next_help_heading = "Replacing values of the sweep files")]
pub struct OverrideOptions {
    /// Vehicle file (TOML)
    #[arg(long, value_name = "FILE")]
    vehicle: Option<PathBuf>,
    /// Set one value by its dotted name, e.g. vehicle.strut.preload_lb=200 or slope_deg=10; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = SetValue::parse)]
    set: Vec<SetValue>,
    /// Rules by which vehicles land: "1966" or "physical"
    #[arg(long, value_name = "RULES", value_parser = choice(&RULES))]
    rules: Option<Rules>,
    /// Crush rule: "pivot-rate" or "section"
    #[arg(long, value_name = "RULE", value_parser = choice(&CRUSH_RULES))]
    crush_rule: Option<CrushRule>,
    /// Search for the first transition, or the whole range for bands
    #[arg(long, value_name = "BANDS", value_parser = words([
        ("first", "Up to the first transition"), ("all", "The whole range")]))]
    bands: Option<String>,
    /// Land at every step of the scan, or skip steps between quiet landings
    #[arg(long, value_name = "SCAN", value_parser = words([
        ("full", "Every step"), ("skipping", "Without the steps between quiet landings")]))]
    scan: Option<String>,
    /// Narrow brackets by interpolating margins or by halving
    #[arg(long, value_name = "HOW", value_parser = words([
        ("margin", "Interpolation of margins"), ("bisection", "Halving")]))]
    refinement: Option<String>,
    /// Parameters, by their dotted names and separated by commas, for which dV_H/dp is computed at every
    /// point; with a tornado chart
    #[arg(long, value_name = "PARAMETERS", value_delimiter = ',')]
    sensitivity: Vec<String>,
    #[command(flatten)]
    units: UnitsOption,
}

/// Words of sweep files, each with its meaning.
fn words<const COUNT: usize>(words: [(&'static str, &'static str); COUNT]) -> PossibleValuesParser {
    words
        .map(|(word, meaning)| PossibleValue::new(word).help(meaning))
        .into()
}

impl OverrideOptions {
    /// The sweeps with what was given put into them.
    ///
    /// # Errors
    /// When the vehicle file cannot be used, or what was given varies in a sweep.
    pub fn apply(&self, sweeps: Vec<Sweep>) -> Result<Vec<Sweep>, InputError> {
        let vehicle = self.vehicle.as_deref().map(VehicleFile::read).transpose()?;
        let rules = self.rules.map(|rules| word(&RULES, rules).to_owned());
        let rule = self
            .crush_rule
            .map(|rule| word(&CRUSH_RULES, rule).to_owned());
        let words = [
            ("solver.rules", rules),
            ("solver.crush_rule", rule),
            ("search.bands", self.bands.clone()),
            ("search.scan", self.scan.clone()),
            ("search.refinement", self.refinement.clone()),
        ];
        let given = |(key, word): (&str, Option<String>)| Some((key.to_owned(), word?));
        let overrides = Overrides {
            vehicle,
            set: self.set.clone(),
            words: words.into_iter().filter_map(given).collect(),
            sensitivity: self.sensitivity.clone(),
            units: self.units.given,
        };
        sweeps
            .into_iter()
            .map(|sweep| sweep.with(&overrides))
            .collect()
    }
}
