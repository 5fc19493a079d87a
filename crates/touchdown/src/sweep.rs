//! `touchdown sweep`: the boundary of stable landings over grids of conditions.

pub mod axis_words;
mod dry_run;
pub mod estimate;
mod overview;
pub mod sweep_results;

use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::thread::{self, ScopedJoinHandle};
use std::time::Instant;

use clap::Args;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::journal::kept;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::result_files;
use touchdown_sweep::output::results::Circumstances;
use touchdown_sweep::threads::run::Workers;
use touchdown_sweep::threads::runner::{self, Runner, Task};

use crate::options::OverrideOptions;
use crate::progress::Progress;
use crate::terminal::{Failure, print};
use crate::{interrupt, summary};
use sweep_results::{Format, Written};

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
    [axes]                                             # what varies; the first varies slowest
    roll_deg = { from = -60, to = 60, step = 5 }       # or a list: [0, 15, 30]
    [search]                                           # of the horizontal velocity
    from_fps = 0
    to_fps = 25
    scan_step_fps = 0.25                               # upward scan to the first change,
    tolerance_fps = 0.001                              # then halving to this width
    bands = \"first\"                                    # or \"all\": every change up to to_fps
    [sensitivity]                                      # optional: dV_H/dp and a tornado chart
    parameters = [\"friction\", \"vehicle.strut.preload_lb\"]
    [solver]
    tolerance = 3e-5
    crush_rule = \"pivot-rate\"                          # or \"section\"";

/// Options of `sweep`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// Sweep files (TOML), or folders of them
    #[arg(required = true, value_name = "FILE|DIR")]
    files: Vec<PathBuf>,
    /// Folder for the results, created if missing
    #[arg(long, value_name = "DIR", default_value = "results")]
    out: PathBuf,
    /// Threads; results do not depend on their number [default: one for each core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Check the input of every sweep and estimate its time and size from a few sample points; write
    /// nothing
    #[arg(long)]
    dry_run: bool,
    /// Continue an interrupted run, but do not start one (without this option a run does either)
    #[arg(long)]
    resume: bool,
    /// Compute one of COUNT parts into a journal for `touchdown merge`: 3/16 is the third of sixteen
    /// parts
    #[arg(long, value_name = "NUMBER/COUNT")]
    shard: Option<Shard>,
    /// Form of the tables
    #[arg(long, value_name = "FORMAT", default_value = "csv")]
    format: Format,
    /// Also replace results of other input, and files that are no results of a sweep; take no points
    /// over from a smaller sample
    #[arg(long)]
    overwrite: bool,
    /// Print nothing but errors
    #[arg(long)]
    quiet: bool,
    #[command(flatten)]
    overrides: OverrideOptions,
}

/// Runs `sweep`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let sweeps = options.overrides.apply(read_sweeps(&options.files)?)?;
    let shard = options.shard.unwrap_or(Shard::WHOLE);
    check_budgets(&sweeps, shard)?;
    if options.dry_run {
        let told = dry_run::tell(&sweeps, shard, options)?;
        return print(&told);
    }
    let cancel = interrupt::flag()?;
    let workers = Workers::start(options.threads)?;
    let folder = Folder::open(&options.out)?;
    for sweep in &sweeps {
        result_files::check_places(sweep, &folder, options.overwrite)?;
        let has_parquet = options.format == Format::Parquet;
        let version = env!("CARGO_PKG_VERSION");
        if !options.quiet && result_files::are_there(sweep, &folder, version, has_parquet) {
            let table = folder.path(&format!("{}.csv", sweep.stem()));
            let table = table.display();
            eprintln!("{table}: holds the results of this input, which are computed again");
        }
    }

    // How many points a map has is found out round by round.
    let known_before = sweeps.iter().filter(|sweep| sweep.map().is_none());
    let points = known_before.map(|sweep| shard.len(sweep.design.count()));
    let progress = Progress::start("points", points.sum(), options.quiet);
    let invocation = Invocation {
        options,
        folder: &folder,
        workers: &workers,
        progress: &progress,
        cancel: &cancel,
    };
    let mut lines = Vec::with_capacity(sweeps.len());
    let mut told = String::new();
    // One table tells of sweeps in either unit.
    let units = sweeps.first().map_or(OutputUnits::Us, |sweep| sweep.units);
    let done = invocation.run(&sweeps, shard).inspect_err(|_| {
        progress.finish();
    })?;
    for (sweep, done) in sweeps.iter().zip(done) {
        match done {
            Done::Whole(results) => {
                told = summary::sweep(
                    sweep,
                    &results.counts,
                    results.circumstances,
                    &results.files,
                    results.remark.as_deref(),
                );
                lines.push(overview::Line::of(
                    sweep,
                    &results.counts,
                    results.circumstances,
                    units,
                ));
            }
            Done::Shard(text) => told += &text,
        }
    }
    let wall_time = progress.finish();
    if options.quiet {
        return Ok(());
    }
    match lines.as_slice() {
        [] | [_] => print(&told),
        lines => print(&overview::table(lines, wall_time, &options.out, units)),
    }
}

/// Reads all sweeps that a command line names, before anything is run.
///
/// # Errors
/// When one of them cannot be used, or two would have results of the same name.
fn read_sweeps(paths: &[PathBuf]) -> Result<Vec<Sweep>, InputError> {
    let mut sweeps: Vec<Sweep> = Vec::with_capacity(paths.len());
    for file in files(paths)? {
        let sweep = Sweep::read(&file)?;
        if let Some(other) = sweeps.iter().find(|other| other.stem() == sweep.stem()) {
            let complaint = format!(
                "has the same name as {}: expected names that differ, as results are named \
                 after them",
                other.path.display()
            );
            return Err(InputError::in_file(&file, complaint));
        }
        sweeps.push(sweep);
    }
    Ok(sweeps)
}

/// The paths with every folder replaced by the TOML files in it, in the order of their names;
/// folders in it, such as that of the vehicles, are left alone.
fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, InputError> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            files.extend(sweep_files_in(path)?);
        } else {
            files.push(path.clone());
        }
    }
    Ok(files)
}

fn sweep_files_in(folder: &Path) -> Result<Vec<PathBuf>, InputError> {
    let unreadable = |error: std::io::Error| InputError::unreadable(folder, error);
    let mut found = Vec::new();
    for entry in folder.read_dir().map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.is_file() && path.extension().is_some_and(|ending| ending == "toml") {
            found.push(path);
        }
    }
    if found.is_empty() {
        let complaint = "has no sweep files: expected at least one file *.toml";
        return Err(InputError::in_file(folder, complaint));
    }
    found.sort();
    Ok(found)
}

/// Checks that no shard has to know what others have spent.
fn check_budgets(sweeps: &[Sweep], shard: Shard) -> Result<(), InputError> {
    let has_budget = |sweep: &&Sweep| sweep.map().is_some_and(|map| map.rules.budget.is_some());
    match sweeps.iter().find(has_budget) {
        Some(sweep) if shard != Shard::WHOLE => Err(InputError::in_file(
            &sweep.path,
            "map.budget_landings: a budget is shared out over the whole map, so that no shard of it can be computed \
             alone: allowed with --shard is map.error_fps without a budget",
        )),
        _ => Ok(()),
    }
}

/// State that all sweeps of an invocation share.
struct Invocation<'n> {
    options: &'n Options,
    folder: &'n Folder,
    workers: &'n Workers,
    progress: &'n Progress,
    cancel: &'n AtomicBool,
}

/// What a sweep came to.
enum Done {
    Whole(Box<Written>),
    /// A shard has a journal only; in words.
    Shard(String),
}

/// A sweep that was computed.
struct Computed {
    points: runner::Computed,
    circumstances: Circumstances<'static>,
}

impl Invocation<'_> {
    /// Runs sweeps one after another. The results of each are written while the next is computed, and kept whatever
    /// becomes of that.
    fn run(&self, sweeps: &[Sweep], shard: Shard) -> Result<Vec<Done>, Failure> {
        thread::scope(|scope| {
            let mut done = Vec::with_capacity(sweeps.len());
            let mut writing = None;
            for sweep in sweeps {
                let computed = self.compute(sweep, shard);
                done.extend(writing.take().map(written).transpose()?);
                let computed = computed?;
                writing = Some(scope.spawn(|| self.write(sweep, shard, computed)));
            }
            done.extend(writing.map(written).transpose()?);
            Ok(done)
        })
    }

    fn journal(&self, sweep: &Sweep, shard: Shard) -> PathBuf {
        self.folder.path(&shard.journal(&sweep.stem()))
    }

    /// Computes a sweep, or a shard of it, into its journal.
    fn compute(&self, sweep: &Sweep, shard: Shard) -> Result<Computed, Failure> {
        let start = Instant::now();
        let path = self.journal(sweep, shard);
        if self.options.resume && !path.exists() {
            let complaint = "there is nothing to resume: run without --resume to begin";
            return Err(InputError::in_file(&path, complaint).into());
        }
        let runner = Runner {
            workers: self.workers,
            folder: self.folder,
            observer: self.progress,
            cancel: self.cancel,
            version: env!("CARGO_PKG_VERSION"),
        };
        let task = Task::Sweep(sweep, shard);
        let (run, taken) = match self.options.overwrite {
            true => (runner.begin(task)?, 0),
            false => runner.begin_or_grow(task)?,
        };
        for warning in run.warnings() {
            eprintln!("touchdown: {warning}");
        }
        let earlier = run.earlier();
        let of_all = match sweep.map() {
            Some(_) => String::new(),
            None => format!(" of {}", shard.len(sweep.design.count())),
        };
        if earlier > taken && !self.options.quiet {
            let earlier = earlier - taken;
            eprintln!("{earlier}{of_all} points are in {}", path.display());
        }
        if taken > 0 && !self.options.quiet {
            eprintln!("took {taken}{of_all} points from {}", kept(&path).display());
        }
        let points = run.compute()?;
        // Time and threads of a run that went on with another's work say nothing of the whole.
        let is_one_run = earlier == 0;
        let circumstances = Circumstances {
            version: env!("CARGO_PKG_VERSION"),
            threads: is_one_run.then(|| self.workers.threads()),
            wall_time: is_one_run.then(|| start.elapsed().as_secs_f64()),
        };
        Ok(Computed {
            points,
            circumstances,
        })
    }

    /// Writes the results of a sweep; those of a shard stay in its journal.
    fn write(&self, sweep: &Sweep, shard: Shard, computed: Computed) -> Result<Done, Failure> {
        if shard != Shard::WHOLE {
            let points = match sweep.map() {
                Some(_) => "all its".to_owned(),
                None => shard.len(sweep.design.count()).to_string(),
            };
            return Ok(Done::Shard(format!(
                "{}\n  shard {shard}: {points} points, kept in {}; `touchdown merge` makes results \
                 of all shards\n",
                sweep.title,
                self.journal(sweep, shard).display()
            )));
        }
        let Computed {
            points,
            circumstances,
        } = computed;
        let mut results = points.results()?;
        let (folder, format) = (self.folder, self.options.format);
        let written = (self.workers)
            .within(|| sweep_results::write(sweep, &mut results, folder, circumstances, format))?;
        results.end_journal(sweep)?;
        Ok(Done::Whole(Box::new(written)))
    }
}

/// What the thread that writes a sweep came to.
fn written(thread: ScopedJoinHandle<Result<Done, Failure>>) -> Result<Done, Failure> {
    thread.join().unwrap_or_else(|panic| resume_unwind(panic))
}
