//! `touchdown land`: one landing, with `--cases` one for each row of a table, or the cases of a scene file.

mod cases;
pub mod observed;
pub mod report;
mod scene_cases;

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use clap::Args;
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::scene::Settings;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::points::parameter::Home;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_sweep::output::case_results;
use touchdown_sweep::output::file_writer::{Draft, Folder};
use touchdown_sweep::output::history::History;
use touchdown_sweep::output::landing_report::{self, LandingReport};
use touchdown_sweep::output::output_guard::OutputGuard;
use touchdown_sweep::threads::run::Workers;

use crate::interrupt;
use crate::observed::{Observed, ended, interval, is_history};
use crate::options::UnitsOption;
use crate::solver_options::SolverOptions;
use crate::terminal::{Failure, print};
use crate::touchdown_options::{TouchdownOptions, finite};

const USAGE: &str = "\
touchdown land --vehicle <FILE> [OPTIONS]
       touchdown land --vehicle <FILE> --cases <FILE> --out <FILE> [OPTIONS]
       touchdown land <SCENE.toml> --out <DIR> [OPTIONS]";

const EXAMPLES: &str = "\
Examples:
  The baseline of the 1966 report, straight down a slope of 15 deg:
    touchdown land --vehicle sweeps/vehicles/surveyor-table-4-1.toml \\
      --vertical-velocity 14 --horizontal-velocity 11.25 --cross-slope 180 \\
      --slope 15 --friction 1.0 --history baseline.csv

  The sample run of the report by the report's own integrator:
    touchdown land --vehicle sweeps/vehicles/surveyor-sample-deck.toml --method report \\
      --vertical-velocity 14.24567 --horizontal-velocity 9.27685 --cross-slope 180 \\
      --slope 15 --pitch 5 --friction 0.8

  One landing for each row of a table. Required columns are vertical_velocity_fps,
  horizontal_velocity_fps, cross_slope_deg, slope_deg and friction; others, such as roll_deg or
  vehicle.strut.preload_lb, replace defaults and numbers of the vehicle file:
    touchdown land --vehicle sweeps/vehicles/surveyor-table-4-1.toml \\
      --cases cases.csv --out outcomes.csv

  The cases of a scene file, each with its history. A case lists only what differs from the case
  before:
    touchdown land scene.toml --out landings
  with scene.toml:
    vehicle = \"vehicles/surveyor-table-4-1.toml\"    # relative to this file
    [scene]                                          # and [solver], as in a sweep file
    vertical_velocity_fps = 14
    horizontal_velocity_fps = 11.25
    cross_slope_deg = 180
    slope_deg = 15
    friction = 1.0
    [[case]]                                         # the scene itself
    name = \"baseline\"
    [[case]]
    horizontal_velocity_fps = 11.5
    [[case]]                                         # still at 11.5 ft/s
    vehicle.strut.preload_lb = 200
    solver.crush_rule = \"section\"";

/// Options of `land`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, override_usage = USAGE)]
pub struct Options {
    /// Scene file (TOML): a touchdown, and `[[case]]` tables that list only what differs from the case
    /// before
    #[arg(
        value_name = "SCENE.toml",
        requires = "out",
        group = "history_output",
        conflicts_with_all = ["TouchdownOptions", "SolverOptions", "vehicle", "cases", "json"]
    )]
    scene: Option<PathBuf>,
    /// Vehicle file (TOML)
    #[arg(long, value_name = "FILE", required_unless_present = "scene")]
    vehicle: Option<PathBuf>,
    /// Set one value of the vehicle, the touchdown or the solver by its dotted name, e.g. vehicle.strut.preload_lb=200 or
    /// solver.tolerance=1e-8; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = Assignment::parse, conflicts_with = "scene")]
    set: Vec<Assignment>,
    #[command(flatten)]
    touchdown: TouchdownOptions,
    #[command(flatten)]
    solver: SolverOptions,
    /// Write motion, loads, deformations and energies over time to this CSV file
    #[arg(
        long,
        value_name = "FILE",
        conflicts_with = "cases",
        group = "history_output",
        help_heading = "Output"
    )]
    history: Option<PathBuf>,
    /// Time between the rows of a history, s
    #[arg(long, value_name = "S", default_value_t = 0.01, requires = "history_output",
          value_parser = finite, allow_hyphen_values = true, help_heading = "Output")]
    interval: f64,
    /// Print the result as JSON
    #[arg(long, conflicts_with = "cases", help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    units: UnitsOption,
    /// Compute one landing for each row of this CSV table
    #[arg(
        long,
        value_name = "FILE",
        requires = "out",
        conflicts_with = "TouchdownOptions",
        help_heading = "Many landings"
    )]
    pub cases: Option<PathBuf>,
    /// File for the results of --cases, CSV or, if it ends so, .parquet; folder for the results and histories of a scene file
    #[arg(long, value_name = "PATH", help_heading = "Many landings")]
    pub out: Option<PathBuf>,
    /// Also replace existing files that are not earlier results of this command
    #[arg(long, help_heading = "Output")]
    overwrite: bool,
    /// Threads for --cases [default: one for each core]
    #[arg(
        long,
        value_name = "N",
        requires = "cases",
        help_heading = "Many landings"
    )]
    pub threads: Option<NonZeroUsize>,
    /// Show no progress of --cases
    #[arg(long, requires = "cases", help_heading = "Many landings")]
    pub quiet: bool,
}

/// Runs `land`.
pub fn run(options: &Options) -> Result<(), Failure> {
    if let (Some(scene), Some(out)) = (&options.scene, &options.out) {
        let units = options.units.given;
        return scene_cases::run(scene, out, options.interval, options.overwrite, units);
    }
    let units = options.units.given.unwrap_or_default();
    let settings = options.solver.settings_with(&options.set)?;
    let Some(vehicle_path) = &options.vehicle else {
        return Err(InputError::missing("--vehicle", "a vehicle file").into());
    };
    assignment::check_once(&options.set)?;
    let vehicle = assignment::set_vehicle(&VehicleFile::read(vehicle_path)?, &options.set)?;
    for one in &options.set {
        match one.parameter().home() {
            Home::Vehicle => {}
            Home::Scene if options.cases.is_none() => {}
            Home::Scene => {
                return Err(one
                    .refuse("with --cases the table gives the touchdown")
                    .into());
            }
            Home::Sweep if one.is_of_solver() => {}
            Home::Sweep => {
                let complaint = "expected a key of the vehicle, the touchdown or the solver";
                return Err(one.refuse(complaint).into());
            }
        }
    }
    let inputs: Vec<&Path> = (std::iter::once(vehicle_path).chain(&options.cases))
        .map(PathBuf::as_path)
        .collect();
    let guard = OutputGuard {
        inputs: &inputs,
        overwrite: options.overwrite,
    };
    match (&options.cases, &options.out) {
        (Some(cases), Some(out)) => {
            let workers = Workers::start(options.threads)?;
            guard.check(out, |line| case_results::is_table(out, line))?;
            let (quiet, vehicle) = (options.quiet, &vehicle);
            cases::run(&workers, quiet, vehicle, &settings, cases, out, units)
        }
        (None, Some(_)) => {
            let complaint = "--out requires --cases or a scene file";
            Err(InputError::other(complaint).into())
        }
        _ => {
            if let Some(history) = &options.history {
                guard.check(history, is_history)?;
            }
            land_once(options, &vehicle, &settings, units)
        }
    }
}

fn land_once(
    options: &Options,
    vehicle: &VehicleFile,
    settings: &Settings,
    units: OutputUnits,
) -> Result<(), Failure> {
    let conditions = options.touchdown.with(&options.set)?;
    let scene = options
        .touchdown
        .scene(&conditions, &options.set, &vehicle.vehicle, settings)?;
    // No observations are needed without a history.
    let interval = match options.history {
        Some(_) => interval(options.interval, settings.time_limit())?,
        None => f64::INFINITY,
    };
    let observed = Observed {
        vehicle: &vehicle.vehicle,
        scene: &scene,
        settings,
        interval,
    };
    let (landing, integration) = match options
        .history
        .as_deref()
        .map(Folder::and_name)
        .transpose()?
    {
        None => observed.land(&mut |_| {}, &AtomicBool::new(false))?,
        Some((folder, name)) => {
            let mut history = History::new(folder.draft(&name)?, units);
            let landed =
                observed.land(&mut |instant| history.add(instant), &*interrupt::flag()?)?;
            Draft::put_in_place(vec![ended(history, folder.path(&name))?])?;
            landed
        }
    };
    let report = LandingReport {
        version: env!("CARGO_PKG_VERSION"),
        vehicle,
        set: &options.set,
        conditions: &conditions,
        settings,
        landing: &landing,
        integration: &integration,
        units,
    };
    print(&match options.json {
        true => format!("{:#}\n", report.json()),
        false => report::text(&report),
    })?;
    if let Some(warning) = landing_report::warning(&landing, units) {
        eprintln!("touchdown: warning: {warning}");
    }
    match &landing.outcome {
        Outcome::Failure(reason) => Err(Failure::running(format!(
            "the landing could not be computed beyond {} s: {reason}",
            landing.end_time
        ))),
        _ => Ok(()),
    }
}
