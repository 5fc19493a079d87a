//! Options of `sweep` that hold instead of what sweep files say, for one study more than they tell.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use touchdown_dynamics::scene::CrushRule;
use touchdown_sweep::boundary::Extent;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::instead::Instead;
use touchdown_sweep::sweep_file::Sweep;
use touchdown_sweep::vehicle_file::VehicleFile;

use crate::LEGS;
use crate::land::rule;

/// What holds instead of the sweep files.
#[derive(Debug, Args)]
#[command(next_help_heading = "Instead of what the sweep files say")]
pub struct Overrides {
    /// Vehicle file (TOML)
    #[arg(long, value_name = "FILE")]
    vehicle: Option<PathBuf>,
    /// When an element may crush further: "pivot-rate" or "section"
    #[arg(long, value_name = "RULE", value_parser = rule)]
    crush_rule: Option<CrushRule>,
    /// Search up to the first transition, or all of them
    #[arg(long, value_name = "BANDS")]
    bands: Option<Bands>,
}

/// Extents of a search by name.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Bands {
    /// Up to the first transition
    First,
    /// The whole range
    All,
}

impl Overrides {
    /// The sweeps with what was given put into them.
    ///
    /// # Errors
    /// When the vehicle file cannot be used, or what was given varies in a sweep.
    pub fn apply(&self, sweeps: Vec<Sweep<LEGS>>) -> Result<Vec<Sweep<LEGS>>, InputError> {
        let vehicle = self.vehicle.as_deref().map(VehicleFile::read).transpose()?;
        let instead = Instead {
            vehicle,
            crush_rule: self.crush_rule,
            extent: self.bands.map(|bands| match bands {
                Bands::First => Extent::First,
                Bands::All => Extent::All,
            }),
        };
        sweeps
            .into_iter()
            .map(|sweep| sweep.with(&instead))
            .collect()
    }
}
