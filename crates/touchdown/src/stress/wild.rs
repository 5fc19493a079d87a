//! Landings of vehicles and touchdowns drawn at random.

use std::path::Path;
use std::time::Duration;

use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_dynamics::scene::Settings;
use touchdown_sweep::findings::Finding;
use touchdown_sweep::header::Header;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::journal::{InOrder, Journal, Opened};
use touchdown_sweep::library::{Library, Source};
use touchdown_sweep::run::RunError;
use touchdown_sweep::shard::Shard;
use touchdown_sweep::sweep_file::Sweep;

use super::account::Account;
use super::case_table::{self, Reasons};
use super::watchdog::Watchdog;
use super::{Bench, SURVEYOR, SURVEYOR_FILE};
use crate::failure::Failure;
use crate::print::print;
use crate::progress::Progress;
use crate::summary;

const SWEEP: &str = include_str!("../../../../sweeps/stress/wild.toml");
/// Names of what is written.
const JOURNAL: &str = "stress-wild.journal";
const CASES: &str = "stress-cases.csv";
const VEHICLE: &str = "stress-vehicle.toml";
/// Longest time for a landing: several times what it needs with the most steps and in a full batch.
const LONGEST_RUN: Duration = Duration::from_secs(300);

/// The sweep that comes with the program, with another count, seed and tolerance.
pub fn sweep(count: u64, seed: u32, settings: Settings) -> Result<Sweep, InputError> {
    const FILE: &str = "sweeps/stress/wild.toml";
    let scene = SWEEP.split("[sample]").next().unwrap_or(SWEEP);
    let text = format!(
        "{scene}[sample]\ndesign = \"monte-carlo\"\ncount = {count}\nseed = {seed}\n\
         [solver]\ntolerance = {}\n",
        settings.tolerance()
    );
    let file = Path::new(FILE);
    let source = |path: &Path, text: &str| Source {
        path: path.to_owned(),
        text: text.to_owned(),
    };
    let beside = file.parent().unwrap_or(Path::new(""));
    let sources = [
        source(file, &text),
        source(&beside.join("..").join(SURVEYOR_FILE), SURVEYOR),
    ];
    Sweep::read_from(file, Library::Copies(&sources))
}

/// Computes the landings and prints the account.
pub fn run(bench: &Bench, sweep: &Sweep) -> Result<(), Failure> {
    let options = bench.options;
    let count = sweep.design.count();
    let path = bench.folder.path(JOURNAL);
    let header = Header::new(sweep, env!("CARGO_PKG_VERSION"), Shard::WHOLE);
    let mut opened = Journal::open(&path, &header.map_err(Failure::running)?)?;
    for warning in &opened.warnings {
        eprintln!("touchdown: {warning}");
    }
    let earlier = opened.done.len();
    let wall_time = land(bench, sweep, &mut opened)?.as_secs_f64();

    let records = opened.journal.into_records()?;
    let mut results = InOrder::new(vec![records], count, &options.out)?;
    let mut account = Account::of(&sweep.settings);
    for point in 0..count {
        let bytes = results.result(point)?;
        match bytes.as_deref().and_then(Finding::decode) {
            Some(Finding::Landing { outcome, cells, .. }) => account.add(point, &outcome, &cells),
            _ => {
                let complaint = format!("there is no result of landing {point}");
                return Err(Failure::running(complaint));
            }
        }
    }
    let files = write(bench, sweep, &account.reasons())?;
    results.remove_journals()?;

    let now = count - earlier;
    let rate = now as f64 / wall_time.max(1e-9);
    print(&format!(
        "{count} wild landings, seed {}, tolerance {:e}, model version {MODEL_VERSION}; {now} of them in this run on {}, \
         in {wall_time:.0} s: {rate:.0} landings/s\n{}  {files}",
        options.seed,
        sweep.settings.tolerance(),
        summary::number(bench.workers.threads(), "thread"),
        account.summary(),
    ))?;
    match account.verdict() {
        None => Ok(()),
        Some(verdict) => Err(Failure::running(format!("{verdict}; {}", kept(bench)))),
    }
}

/// Computes what is not in the journal; the time that it took.
fn land(bench: &Bench, sweep: &Sweep, opened: &mut Opened) -> Result<Duration, Failure> {
    let progress = Progress::start("landings", sweep.design.count(), bench.options.quiet);
    progress.skip(opened.done.len());
    let guard = Watchdog::before(&progress);
    let give_up = |landings: &[usize], why: &str| {
        let reasons = landings
            .iter()
            .map(|number| (*number, vec![why.to_owned()]));
        let place = match write(bench, sweep, &reasons.collect()) {
            Ok(_) => kept(bench),
            Err(error) => format!("the table of cases could not be written: {error}"),
        };
        format!("landings {landings:?}: {why}; {place}")
    };
    let on_timeout = |landings: &[usize]| {
        let why = format!("not finished within {} s", LONGEST_RUN.as_secs());
        eprintln!("touchdown: {}", give_up(landings, &why));
        // No thread can be made to leave a landing.
        std::process::exit(1);
    };
    let ran = guard.over(LONGEST_RUN, on_timeout, || {
        let workers = bench.workers;
        workers.sweep(sweep, Shard::WHOLE, opened, &guard, bench.cancel)
    });
    let wall_time = progress.finish();
    match ran {
        Ok(Ok(())) => Ok(wall_time),
        Ok(Err(RunError::Cancelled)) => Err(Failure::Interrupted(format!(
            "finished landings are kept in {}: run the command again to continue",
            bench.folder.path(JOURNAL).display()
        ))),
        Ok(Err(other)) => Err(other.into()),
        Err(beside) => Err(Failure::running(give_up(
            &beside,
            "panicked, or another one of the same batch did",
        ))),
    }
}

/// Writes cases and their vehicle; the files in words.
fn write(bench: &Bench, sweep: &Sweep, reasons: &Reasons) -> Result<String, Failure> {
    let cases = case_table::written(sweep, reasons).map_err(Failure::running)?;
    let files = [
        (CASES.to_owned(), cases),
        (VEHICLE.to_owned(), SURVEYOR.as_bytes().to_vec()),
    ];
    Ok(summary::written(&bench.folder.write_files(&files)?))
}

/// Where the cases are.
fn kept(bench: &Bench) -> String {
    format!("listed in {}", bench.folder.path(CASES).display())
}
