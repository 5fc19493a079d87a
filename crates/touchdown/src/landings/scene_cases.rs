//! `touchdown land SCENE.toml`: the cases of a scene file, each with its history.

use std::path::Path;

use touchdown_dynamics::land::land_with_summary;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_sweep::file_writer::Folder;
use touchdown_sweep::history::History;
use touchdown_sweep::landing_report;
use touchdown_sweep::output_guard::OutputGuard;
use touchdown_sweep::output_units::OutputUnits;
use touchdown_sweep::scene_file::{self, SceneCase, SceneFile};
use touchdown_sweep::{cases, method_input::method_words};

use crate::failure::Failure;
use crate::land_files::{interval, is_history};
use crate::print::print;
use crate::report::degrees;
use crate::summary;

/// Lands all cases and writes their histories, every `seconds`, and their results to a folder, in the units of the file or
/// those given.
pub fn run(
    scene: &Path,
    out: &Path,
    seconds: f64,
    overwrite: bool,
    units: Option<OutputUnits>,
) -> Result<(), Failure> {
    let SceneFile { units: own, cases } = scene_file::read(scene)?;
    let units = units.unwrap_or(own);
    for case in &cases {
        interval(seconds, case.settings.time_limit())?;
    }
    let folder = Folder::open(out)?;
    let stem = scene.file_stem().unwrap_or_default().to_string_lossy();

    let guard = OutputGuard {
        inputs: &[scene],
        overwrite,
    };
    for case in &cases {
        let file = folder.path(&format!("{stem}-{}.csv", case.name));
        guard.check(&file, is_history)?;
    }
    guard.check(&folder.path(&format!("{stem}.csv")), cases::is_table)?;

    let mut files = Vec::new();
    let mut landings = Vec::new();
    for case in &cases {
        let (landing, history) = land(case, seconds, units)?;
        files.push((format!("{stem}-{}.csv", case.name), history));
        landings.push(landing);
    }
    let names = cases.iter().map(|case| case.name.as_str());
    let results = cases::table(names.zip(&landings), units).map_err(Failure::running)?;
    files.push((format!("{stem}.csv"), results));
    let written = folder.write_files(&files)?;
    print(&text(&cases, &landings, units))?;
    for (case, landing) in cases.iter().zip(&landings) {
        if let Some(warning) = landing_report::warning(landing, units) {
            eprintln!("touchdown: warning: case {}: {warning}", case.name);
        }
    }
    print(&summary::written(&written))?;
    Ok(())
}

fn land(case: &SceneCase, seconds: f64, units: OutputUnits) -> Result<(Landing, Vec<u8>), Failure> {
    let mut history = History::new(units);
    let (vehicle, scene) = (&case.vehicle.vehicle, &case.scene);
    let mut observe = |instant: &Instant| history.add(instant);
    let (landing, _) = land_with_summary(vehicle, scene, &case.settings, seconds, &mut observe);
    Ok((landing, history.table().map_err(Failure::running)?))
}

/// The results in columns.
fn text(cases: &[SceneCase], landings: &[Landing], units: OutputUnits) -> String {
    let [length, force] = ["clearance_ft", "force_lb"].map(|name| units.quantity(name));
    let heading = [
        "case",
        "outcome",
        "end, s",
        "least angle, deg",
        &format!("clearance, {}", length.unit()),
        &format!("strut force, {}", force.unit()),
        "computed by",
    ];
    let mut lines = vec![heading.map(str::to_owned)];
    for (case, landing) in cases.iter().zip(landings) {
        let forces = landing.max_strut_force.iter();
        let greatest = forces.fold(0.0f64, |a, b| a.max(*b));
        lines.push([
            case.name.clone(),
            landing.outcome.to_string(),
            format!("{:.4}", landing.end_time),
            degrees(landing.min_stability_angle, 3),
            format!("{:.4}", length.number(landing.min_clearance)),
            format!("{:.1}", force.number(greatest)),
            method_words(&case.settings.method(), case.settings.tolerance()),
        ]);
    }
    summary::columns(&lines, &[])
}
