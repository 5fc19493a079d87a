//! `touchdown-lab work-precision`: error and run time against the tolerance.

mod landings;
mod report;
mod transitions;

use std::path::PathBuf;

use clap::Args;
use touchdown_dynamics::scene::Settings;
use touchdown_figures::picture::{self, Choices, Source};
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::measured_scenes::{level_grid, near_boundary};
use touchdown_sweep::output::file_writer::Folder;

use landings::Landings;
use touchdown::terminal::{Failure, print, print_paths};
use transitions::Transitions;

/// Tolerance of the landings that all others are measured against.
const CONVERGED: f64 = 1e-11;
const TOLERANCES: [f64; 8] = [1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 1e-6, 1e-7, 1e-8];
const QUICK_TOLERANCES: [f64; 3] = [1e-3, 1e-4, 1e-6];

const MORE: &str = "\
Everything is in feet and pounds, the units of the report whose landings are computed.

Computes level landings of one vehicle on a slope of 15 deg at 14 ft/s at several tolerances and compares
them with the same landings at 1e-11:
  forty landings around the toppling boundary: time and evaluations on one thread, errors of
  position, pitch and least stability angle; times are the least of five, measured in turns;
  first transitions of the level grid (cross-slope 80 to 180 deg, roll -60 to 60 deg): error of V_H.

Writes work-precision.csv, a picture of errors against run time (work-precision.svg) and one
against evaluations (work-precision-evaluations.svg). Takes minutes; with --quick, half a
minute.";

/// Options of `work-precision`.
#[derive(Debug, Args)]
#[command(after_help = MORE)]
pub struct Options {
    /// Use fewer tolerances, landings and transitions
    #[arg(long)]
    quick: bool,
    /// Folder for the table and the pictures
    #[arg(long, value_name = "DIR", default_value = "crates/lab/results")]
    out: PathBuf,
    /// Vehicle file (TOML)
    #[arg(
        long,
        value_name = "FILE",
        default_value = "sweeps/vehicles/surveyor-table-4-1.toml"
    )]
    vehicle: PathBuf,
}

/// Runs `work-precision`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let vehicle = VehicleFile::read(&options.vehicle)?.vehicle;
    let folder = Folder::open(&options.out)?;
    let tolerances: &[f64] = if options.quick {
        &QUICK_TOLERANCES
    } else {
        &TOLERANCES
    };
    eprintln!("computing converged landings and transitions");
    let landings = near_boundary(options.quick).map_err(Failure::running)?;
    let landings = Landings::converged(&vehicle, landings)?;
    let transitions = level_grid(options.quick).map_err(Failure::running)?;
    let transitions = Transitions::converged(&vehicle, transitions)?;
    eprintln!("measuring times of landings, all tolerances in turns");
    let times = landings.times(tolerances)?;
    let mut rows = Vec::new();
    for (index, (&tolerance, times)) in tolerances.iter().zip(&times).enumerate() {
        eprintln!(
            "tolerance {tolerance:e}, {} of {}",
            index + 1,
            tolerances.len()
        );
        rows.push(report::Row {
            tolerance,
            landings: landings.measure(tolerance, times)?,
            transitions: transitions.measure(tolerance)?,
        });
    }
    print(&report::text(&rows))?;
    let table = report::csv(&rows);
    let source = Source {
        table: &table,
        ..Source::default()
    };
    let pictures = picture::draw(&source, &Choices::default()).map_err(Failure::running)?;
    let mut files = crate::as_files("work-precision", pictures);
    files.push(("work-precision.csv".to_owned(), table.into_bytes()));
    print_paths(&folder.write_files(&files)?)
}

/// Settings of the program but for the tolerance.
fn settings(tolerance: f64) -> Result<Settings, Failure> {
    (Settings::default().with_tolerance(tolerance)).map_err(Failure::running)
}
