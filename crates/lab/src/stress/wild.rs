//! Landings of vehicles and touchdowns drawn at random.

use std::time::Duration;

use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_sweep::journal::InOrder;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::runner::{Runner, Task};

use super::Bench;
use super::account::Account;
use super::case_table::{self, Reasons};
use super::watchdog::Watchdog;
use super::wild_sweep::WildSweep;
use touchdown::terminal::progress::Progress;
use touchdown::terminal::summary;
use touchdown::terminal::{Failure, print};

/// Names of what is written.
const CASES: &str = "stress-cases.csv";
/// Longest time for a landing: several times what it needs with the most steps and in a full batch.
const LONGEST_RUN: Duration = Duration::from_secs(300);

/// Computes the landings and prints their accounts.
pub fn run(bench: &Bench, sweeps: &[WildSweep]) -> Result<(), Failure> {
    // Journals stay until all is written.
    let mut journals = Vec::new();
    let mut accounts = Vec::new();
    for wild in sweeps {
        let count = wild.sweep.design.count();
        let (mut results, now, wall_time) = land(bench, wild)?;
        let account = account(wild, &mut results)?;
        let wall_time = wall_time.as_secs_f64();
        let rate = now as f64 / wall_time.max(1e-9);
        print(&format!(
            "{count} wild landings of {}, seed {}, tolerance {:e}, model version {MODEL_VERSION}; {now} of them in \
             this run on {}, in {wall_time:.0} s: {rate:.0} landings/s\n{}",
            wild.title(),
            bench.options.seed,
            wild.sweep.settings.tolerance(),
            summary::number(bench.workers.threads(), "thread"),
            account.summary(),
        ))?;
        accounts.push((wild, account));
        journals.push(results);
    }
    let kept_cases = accounts
        .iter()
        .map(|(wild, account)| (*wild, account.reasons()));
    let files = write(bench, &kept_cases.collect::<Vec<_>>())?;
    print(&format!("  {files}"))?;
    for results in journals {
        results.remove_journals()?;
    }
    let verdicts = accounts.iter().filter_map(|(wild, account)| {
        let verdict = account.verdict()?;
        Some(format!("{}: {verdict}", wild.title()))
    });
    match verdicts.collect::<Vec<_>>().join("; ").as_str() {
        "" => Ok(()),
        verdicts => Err(Failure::running(format!("{verdicts}; {}", kept(bench)))),
    }
}

/// Adds up all landings of a vehicle.
fn account(wild: &WildSweep, results: &mut InOrder) -> Result<Account, Failure> {
    let mut account = Account::of(&wild.sweep.settings);
    for point in 0..wild.sweep.design.count() {
        let bytes = results.result(point)?;
        match bytes.as_deref().and_then(Finding::decode) {
            Some(Finding::Landing(landing)) => account.add(point, &landing),
            _ => {
                let complaint = format!("there is no result of landing {point}");
                return Err(Failure::running(complaint));
            }
        }
    }
    Ok(account)
}

/// Computes what is not in the journal: the results, and how many landings that took in what time.
fn land(bench: &Bench, wild: &WildSweep) -> Result<(InOrder, usize, Duration), Failure> {
    let count = wild.sweep.design.count();
    let progress = Progress::start("landings", count, bench.options.quiet);
    let guard = Watchdog::before(&progress);
    let runner = Runner {
        workers: bench.workers,
        folder: bench.folder,
        observer: &guard,
        cancel: bench.cancel,
        version: env!("CARGO_PKG_VERSION"),
    };
    let run = runner.begin(Task::Sweep(&wild.sweep, Shard::WHOLE))?;
    for warning in run.warnings() {
        eprintln!("touchdown: {warning}");
    }
    let now = count - run.earlier();
    let give_up = |landings: &[usize], why: &str| {
        let reasons = landings
            .iter()
            .map(|number| (*number, vec![why.to_owned()]));
        let place = match write(bench, &[(wild, reasons.collect())]) {
            Ok(_) => kept(bench),
            Err(error) => format!("the table of cases could not be written: {error}"),
        };
        format!("{}, landings {landings:?}: {why}; {place}", wild.title())
    };
    let on_timeout = |landings: &[usize]| {
        let why = format!("not finished within {} s", LONGEST_RUN.as_secs());
        eprintln!("touchdown: {}", give_up(landings, &why));
        // No thread can be made to leave a landing.
        std::process::exit(1);
    };
    let computed = guard.over(LONGEST_RUN, on_timeout, || run.compute());
    let wall_time = progress.finish();
    let computed = computed
        .map_err(|beside: Vec<usize>| {
            give_up(&beside, "panicked, or another one of the same batch did")
        })
        .map_err(Failure::running)?;
    Ok((computed?.results()?, now, wall_time))
}

/// Writes cases and their vehicles; the files in words.
fn write(bench: &Bench, kept: &[(&WildSweep, Reasons)]) -> Result<String, Failure> {
    let cases = case_table::written(kept).map_err(Failure::running)?;
    let vehicle = |wild: &WildSweep| (wild.vehicle_file(), wild.vehicle.clone().into_bytes());
    let vehicles = kept.iter().map(|(wild, _)| vehicle(wild));
    let files: Vec<_> = [(CASES.to_owned(), cases)]
        .into_iter()
        .chain(vehicles)
        .collect();
    Ok(summary::written(&bench.folder.write_files(&files)?))
}

/// Where the cases are.
fn kept(bench: &Bench) -> String {
    format!("listed in {}", bench.folder.path(CASES).display())
}
