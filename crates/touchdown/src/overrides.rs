//! Options of `sweep` that hold instead of what sweep files say, for one study more than they tell.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use touchdown_dynamics::scene::CrushRule;
use touchdown_sweep::boundary::Extent;
use touchdown_sweep::sweep_file::Sweep;
use touchdown_sweep::vehicle_file::VehicleFile;

use crate::LEGS;
use crate::failure::Failure;
use crate::solver_options::rule;

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
    /// Puts what was given into the sweeps.
    ///
    /// # Errors
    /// When the vehicle file cannot be used.
    pub fn apply(&self, sweeps: &mut [Sweep<LEGS>]) -> Result<(), Failure> {
        let vehicle = match &self.vehicle {
            Some(file) => Some(VehicleFile::read(file)?),
            None => None,
        };
        for sweep in sweeps {
            if let Some(vehicle) = &vehicle {
                sweep.vehicle = vehicle.clone();
            }
            if let Some(rule) = self.crush_rule {
                sweep.settings = sweep.settings.with_crush_rule(rule);
            }
            if let Some(bands) = self.bands {
                sweep.search.extent = match bands {
                    Bands::First => Extent::First,
                    Bands::All => Extent::All,
                };
            }
        }
        Ok(())
    }
}
