//! `touchdown land --cases`: one landing for each row of a table.

use std::path::Path;
use std::sync::Arc;

use touchdown_dynamics::batch::Request;
use touchdown_dynamics::scene::Settings;
use touchdown_sweep::cases;
use touchdown_sweep::run::Workers;
use touchdown_sweep::vehicle_file::VehicleFile;

use crate::failure::Failure;
use crate::land_files::place_of;
use crate::print::print;
use crate::progress::Progress;
use crate::{interrupt, summary};

/// Lands all cases and writes their results to `out`.
pub fn run(
    workers: &Workers,
    quiet: bool,
    vehicle: &VehicleFile,
    settings: &Settings,
    table: &Path,
    out: &Path,
) -> Result<(), Failure> {
    let cases = cases::read(table, vehicle, settings)?;
    let (folder, name) = place_of(out)?;
    let cancel = interrupt::flag()?;

    let progress = Progress::start("cases", cases.len(), quiet);
    let request = |key: usize| {
        let case = &cases[key];
        Request {
            key,
            vehicle: Arc::clone(&case.vehicle),
            scene: case.scene,
            settings: case.settings,
        }
    };
    let landings = workers.cases(cases.len(), request, &progress, &cancel);
    let wall_time = progress.finish();
    let landings = landings?;

    let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    let results = cases::table(&names, &landings).map_err(Failure::running)?;
    let files = folder.write_files(&[(name, results)])?;
    if !quiet {
        print(&summary::cases(
            &landings,
            wall_time,
            workers.threads(),
            &files,
        ))?;
    }
    Ok(())
}
