//! Units of what a command writes and prints.

use clap::{Args, ValueEnum};
use touchdown_sweep::output_units::OutputUnits;

/// Units by name.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Units {
    /// Foot, slug, pound and degree
    #[value(name = "US")]
    Us,
    /// Metre, kilogram and newton
    #[value(name = "SI")]
    Si,
}

/// The option of commands that write and print results.
#[derive(Debug, Args)]
pub struct UnitsOption {
    /// Units of what is written and printed; angles are in degrees in both [default: those of the input file, or
    /// else US]
    #[arg(
        long,
        value_enum,
        value_name = "UNITS",
        ignore_case = true,
        help_heading = "Output"
    )]
    units: Option<Units>,
}

impl UnitsOption {
    /// The units, if they are given.
    pub fn given(&self) -> Option<OutputUnits> {
        self.units.map(|units| match units {
            Units::Us => OutputUnits::Us,
            Units::Si => OutputUnits::Si,
        })
    }
}
