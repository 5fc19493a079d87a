//! `touchdown sweep`: the boundary of stable landings over grids of conditions.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;
use touchdown_figures::boundary_profile;
use touchdown_sweep::boundary::Boundary;
use touchdown_sweep::deposit::Folder;
use touchdown_sweep::input_error::{InputError, Place};
use touchdown_sweep::results::{self, Circumstances};
use touchdown_sweep::run::Workers;
use touchdown_sweep::sweep_file::Sweep;

use crate::caption::caption;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::say::say;
use crate::{LEGS, interrupt, summary};

const EXAMPLE: &str = "\
Example:
  touchdown sweep sweeps/figure-4-09.toml

  writes results/figure-4-09.csv, .svg (for one axis) and .json from a sweep file such as

    title = \"Figure 4-9: V_H versus roll, cross-slope 180 deg\"
    vehicle = \"vehicles/surveyor-table-4-1.toml\"      # relative to this file
    [scene]                                            # what stays the same
    vertical_velocity_fps = 14
    cross_slope_deg = 180                              # 180 is straight downhill, 0 uphill
    slope_deg = 15
    friction = 1.0
    [axes]                                             # what varies, the first slowest
    roll_deg = { from = -60, to = 60, step = 5 }       # or a list: [0, 15, 30]
    [search]                                           # of the horizontal velocity
    from_fps = 0
    to_fps = 25
    scan_step_fps = 0.25                               # upward scan to the first change,
    tolerance_fps = 0.001                              # then halving to this width
    [solver]
    tolerance = 1e-6
    crush_rule = \"pivot-rate\"                          # or \"section\"";

/// Options of `sweep`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// Sweep files (TOML)
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Folder for the results, made if it is not there
    #[arg(long, value_name = "DIR", default_value = "results")]
    out: PathBuf,
    /// Threads; results do not depend on their number [default: one for each core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Print nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// Runs `sweep`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let sweeps = read(&options.files)?;
    let cancel = interrupt::flag()?;
    let folder = Folder::open(&options.out)?;
    let workers = Workers::start(options.threads)?;
    for sweep in &sweeps {
        let progress = Progress::start("points", sweep.grid.count(), options.quiet);
        let boundaries = workers.sweep(sweep, &progress, &cancel);
        let wall_time = progress.finish();
        let boundaries = boundaries?;
        let circumstances = Circumstances {
            version: env!("CARGO_PKG_VERSION"),
            threads: workers.threads(),
            wall_time: wall_time.as_secs_f64(),
        };
        let files = folder.deposit(&results(sweep, &boundaries, circumstances)?)?;
        if !options.quiet {
            say(&summary::sweep(sweep, &boundaries, circumstances, &files))?;
        }
    }
    Ok(())
}

/// Reads all sweep files before anything is run.
fn read(files: &[PathBuf]) -> Result<Vec<Sweep<LEGS>>, InputError> {
    let mut sweeps: Vec<Sweep<LEGS>> = Vec::with_capacity(files.len());
    for file in files {
        let sweep = Sweep::read(file)?;
        if let Some(other) = sweeps.iter().find(|other| other.stem() == sweep.stem()) {
            let complaint = format!(
                "has the same name as {}: allowed are names that differ, as results are named \
                 after them",
                other.path.display()
            );
            return Err(InputError::other(complaint).at(Place::file(file)));
        }
        sweeps.push(sweep);
    }
    Ok(sweeps)
}

/// The result files of a sweep: table, record, and for one axis a picture.
fn results(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
    circumstances: Circumstances,
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let stem = sweep.stem();
    let table = results::table(sweep, boundaries).map_err(Failure::running)?;
    let mut files = Vec::new();
    if sweep.grid.axes().len() == 1 {
        let text = String::from_utf8_lossy(&table);
        let picture = boundary_profile::draw(&text, &caption(sweep)).map_err(Failure::running)?;
        files.push((format!("{stem}.svg"), picture.into_bytes()));
    }
    let record = format!("{:#}\n", results::record(sweep, boundaries, circumstances));
    files.push((format!("{stem}.json"), record.into_bytes()));
    // The table comes last: where it stands, the others do too.
    files.push((format!("{stem}.csv"), table));
    Ok(files)
}
