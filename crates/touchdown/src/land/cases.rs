//! `touchdown land --cases`: one landing for each row of a table.

use std::path::Path;

use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::Settings;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::cases::{self, CaseTable};
use touchdown_search::contact_warnings::ContactWarnings;
use touchdown_sweep::journal::InOrder;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::{case_results, warnings};
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::Workers;
use touchdown_sweep::threads::runner::{Runner, Task};

use crate::progress::Progress;
use crate::terminal::{Failure, print};
use crate::{interrupt, summary};

/// Lands all cases and writes their results to `out`. Until then they are in a journal beside it, from which an
/// interrupted run goes on.
pub fn run(
    workers: &Workers,
    quiet: bool,
    vehicle: &VehicleFile,
    settings: &Settings,
    table: &Path,
    out: &Path,
    units: OutputUnits,
) -> Result<(), Failure> {
    let table = workers.within(|| cases::read(table, vehicle, settings))?;
    let (folder, name) = Folder::and_name(out)?;
    let cancel = interrupt::flag()?;

    let count = table.len();
    let progress = Progress::start("cases", count, quiet);
    let runner = Runner {
        workers,
        folder: &folder,
        observer: &progress,
        cancel: &cancel,
        version: env!("CARGO_PKG_VERSION"),
    };
    let run = runner.begin(Task::Cases(&table, &name))?;
    for warning in run.warnings() {
        eprintln!("touchdown: {warning}");
    }
    let earlier = run.earlier();
    if earlier > 0 && !quiet {
        eprintln!(
            "{earlier} of {count} cases are in {}",
            run.journal().display()
        );
    }
    let computed = run.compute();
    let wall_time = progress.finish();
    let mut results = computed?.results()?;
    let landings = landings(&table, &mut results)?;
    let names: Vec<String> = (0..count).map(|row| table.name(row)).collect();
    let rows = names.iter().map(String::as_str).zip(&landings);
    let written = case_results::table(out, rows, units, &table.input).map_err(Failure::running)?;
    let files = folder.write_files(&[(name, written)])?;
    results.remove_journals()?;
    let rows = names.iter().zip(&landings);
    let rows = rows.map(|(name, landing)| (format!("case {name}"), ContactWarnings::of(landing)));
    for warning in warnings::of_cases(rows, units) {
        eprintln!("touchdown: warning: {warning}");
    }
    if !quiet {
        // The time of a run that went on with another's work says nothing of the whole.
        let seconds = (earlier == 0).then_some(wall_time.as_secs_f64());
        print(&summary::cases(
            &landings,
            seconds,
            workers.threads(),
            &files,
        ))?;
    }
    Ok(())
}

/// How all cases ended, in their order.
fn landings(table: &CaseTable, results: &mut InOrder) -> Result<Vec<Landing>, Failure> {
    let landing = |row: usize| {
        let bytes = results.result(row)?;
        let finding = bytes.as_deref().and_then(Finding::decode);
        let name = table.name(row);
        let landing = finding.and_then(Finding::landing);
        landing.ok_or_else(|| Failure::running(format!("there is no result of case {name}")))
    };
    (0..table.len()).map(landing).collect()
}
