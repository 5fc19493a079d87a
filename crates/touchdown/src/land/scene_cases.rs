//! `touchdown land SCENE.toml`: the cases of a scene file, each with its history.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use touchdown_dynamics::landing::Landing;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::readers::method_input::method_words;
use touchdown_input::sweeps::scene_file::{self, SceneCase, SceneFile};
use touchdown_sweep::output::file_writer::{Draft, Folder};
use touchdown_sweep::output::history::History;
use touchdown_sweep::output::output_guard::OutputGuard;
use touchdown_sweep::output::{case_results, landing_report};
use touchdown_sweep::threads::run::Observer;

use crate::observed::{Observed, ended, interval, is_history};
use crate::progress::Progress;
use crate::report::degrees;
use crate::terminal::{Failure, print};
use crate::{interrupt, summary};

/// Time after which progress is shown.
const SHOWN_AFTER: Duration = Duration::from_secs(2);

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
    let table = format!("{stem}.csv");
    guard.check(&folder.path(&table), |line| {
        case_results::is_table(Path::new(&table), line)
    })?;

    let (cancel, start) = (interrupt::flag()?, Instant::now());
    let mut progress: Option<Progress> = None;
    let (mut written, mut landings) = (Vec::new(), Vec::new());
    for (done, case) in cases.iter().enumerate() {
        if progress.is_none() && start.elapsed() > SHOWN_AFTER {
            let shown = Progress::start("cases", cases.len(), false);
            shown.skip(done);
            progress = Some(shown);
        }
        // A history is kept once its case has landed, whatever becomes of the others.
        let draft = folder.draft(&format!("{stem}-{}.csv", case.name))?;
        let (landing, draft) = land(case, seconds, units, draft, &cancel)?;
        written.extend(Draft::put_in_place(vec![draft])?);
        landings.push(landing);
        if let Some(progress) = &progress {
            progress.point(done);
        }
    }
    if let Some(progress) = &progress {
        progress.finish();
    }
    let names = cases.iter().map(|case| case.name.as_str());
    let rows = names.zip(&landings);
    let results = case_results::csv_table(rows, units).map_err(Failure::running)?;
    written.extend(folder.write_files(&[(table, results)])?);
    print(&text(&cases, &landings, units))?;
    for (case, landing) in cases.iter().zip(&landings) {
        if let Some(warning) = landing_report::warning(landing, units) {
            eprintln!("touchdown: warning: case {}: {warning}", case.name);
        }
    }
    print(&summary::written(&written))?;
    Ok(())
}

/// Lands a case and writes its history.
fn land(
    case: &SceneCase,
    seconds: f64,
    units: OutputUnits,
    draft: Draft,
    cancel: &AtomicBool,
) -> Result<(Landing, Draft), Failure> {
    let path = draft.place().to_owned();
    let mut history = History::new(draft, units);
    let observed = Observed {
        vehicle: &case.vehicle.vehicle,
        scene: &case.scene,
        settings: &case.settings,
        interval: seconds,
    };
    let (landing, _) = observed.land(&mut |instant| history.add(instant), cancel)?;
    Ok((landing, ended(history, path)?))
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
