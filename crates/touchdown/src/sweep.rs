//! `touchdown sweep`: the boundary of stable landings over grids of conditions.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use touchdown_figures::picture;
use touchdown_sweep::bands_table;
use touchdown_sweep::boundary::{Boundary, Extent};
use touchdown_sweep::deposit::Folder;
use touchdown_sweep::results::{self, Circumstances};
use touchdown_sweep::run::Workers;
use touchdown_sweep::sweep_file::Sweep;

use crate::failure::Failure;
use crate::overrides::Overrides;
use crate::progress::Progress;
use crate::say::say;
use crate::{LEGS, interrupt, overview, plot, summary, sweep_files};

const EXAMPLE: &str = "\
Example:
  touchdown sweep sweeps/figure-4-09.toml

  writes results/figure-4-09.csv, pictures and .json from a sweep file such as

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
    bands = \"first\"                                    # or \"all\": every change up to to_fps
    [solver]
    tolerance = 1e-6
    crush_rule = \"pivot-rate\"                          # or \"section\"";

/// Options of `sweep`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// Sweep files (TOML), or folders of them
    #[arg(required = true, value_name = "FILE|DIR")]
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
    #[command(flatten)]
    overrides: Overrides,
}

/// Runs `sweep`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let sweeps = options
        .overrides
        .apply(sweep_files::read(&options.files)?)?;
    let cancel = interrupt::flag()?;
    let folder = Folder::open(&options.out)?;
    let workers = Workers::start(options.threads)?;

    let points = sweeps.iter().map(|sweep| sweep.grid.count()).sum();
    let progress = Progress::start("points", points, options.quiet);
    let mut lines = Vec::with_capacity(sweeps.len());
    let mut told = String::new();
    for sweep in &sweeps {
        let start = Instant::now();
        let boundaries = workers.sweep(sweep, &progress, &cancel);
        if boundaries.is_err() {
            progress.finish();
        }
        let boundaries = boundaries?;
        let circumstances = Circumstances {
            version: env!("CARGO_PKG_VERSION"),
            threads: workers.threads(),
            wall_time: start.elapsed().as_secs_f64(),
        };
        // Results of one sweep are kept whatever becomes of the next.
        let files = folder.deposit(&results(sweep, &boundaries, circumstances)?)?;
        told = summary::sweep(sweep, &boundaries, circumstances, &files);
        lines.push(overview::Line::of(sweep, &boundaries, circumstances));
    }
    let wall_time = progress.finish();
    if options.quiet {
        return Ok(());
    }
    match lines.as_slice() {
        [_] => say(&told),
        lines => say(&overview::table(lines, wall_time, &options.out)),
    }
}

/// The result files of a sweep: tables, record and pictures.
fn results(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
    circumstances: Circumstances,
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let stem = sweep.stem();
    let table = results::table(sweep, boundaries).map_err(Failure::running)?;
    let bands = match sweep.search.extent {
        Extent::First => None,
        Extent::All => Some(bands_table::table(sweep, boundaries).map_err(Failure::running)?),
    };
    let record = format!("{:#}\n", results::record(sweep, boundaries, circumstances));
    let pictures = picture::draw(
        &String::from_utf8_lossy(&table),
        bands.as_deref().map(String::from_utf8_lossy).as_deref(),
        Some(&record),
    )
    .map_err(Failure::running)?;

    let mut files = plot::both(&stem, &pictures)?;
    files.extend(bands.map(|bands| (format!("{stem}-bands.csv"), bands)));
    files.push((format!("{stem}.json"), record.into_bytes()));
    // The table comes last: where it stands, the others do too.
    files.push((format!("{stem}.csv"), table));
    Ok(files)
}
