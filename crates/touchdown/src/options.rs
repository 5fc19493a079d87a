//! Options that several commands share.

pub mod overrides;
pub mod solver_options;
pub mod touchdown_options;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use touchdown_input::documents::output_units::OutputUnits;

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
