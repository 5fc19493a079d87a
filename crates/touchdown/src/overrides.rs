//! Options of `sweep` that hold instead of what sweep files say, for one study more than they tell.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use touchdown_dynamics::scene::CrushRule;
use touchdown_sweep::boundary::Extent;
use touchdown_sweep::refine::Refinement;
use touchdown_sweep::scan::Scan;
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
    /// Scan every step, or skip those between quiet landings
    #[arg(long, value_name = "SCAN")]
    scan: Option<ScanName>,
    /// Narrow brackets by interpolating margins, or by halving
    #[arg(long, value_name = "HOW")]
    refinement: Option<RefinementName>,
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
    /// Every step but between quiet landings
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
            if let Some(scan) = self.scan {
                sweep.search.scan = match scan {
                    ScanName::Full => Scan::Full,
                    ScanName::Skipping => Scan::Skipping,
                };
            }
            if let Some(refinement) = self.refinement {
                sweep.search.refinement = match refinement {
                    RefinementName::Margin => Refinement::Margin,
                    RefinementName::Bisection => Refinement::Bisection,
                };
            }
        }
        Ok(())
    }
}
