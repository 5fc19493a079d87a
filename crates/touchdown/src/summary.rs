//! A run in short: what came out, what it cost, and where the results are.

use std::path::PathBuf;
use std::time::Duration;

use touchdown_dynamics::landing::Landing;
use touchdown_sweep::boundary::{Boundary, Extent, Transition};
use touchdown_sweep::results::{Circumstances, count_by_kind};
use touchdown_sweep::sweep_file::Sweep;

/// A table of cases in short.
pub fn cases<const LEGS: usize>(
    landings: &[Landing<LEGS>],
    wall_time: Duration,
    threads: usize,
    files: &[PathBuf],
) -> String {
    let mut kinds: Vec<(String, usize)> = Vec::new();
    for landing in landings {
        let kind = landing.outcome.to_string();
        match kinds.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, count)) => *count += 1,
            None => kinds.push((kind, 1)),
        }
    }
    kinds.sort();
    let evaluations = landings.iter().map(|landing| landing.evaluations).sum();
    let seconds = wall_time.as_secs_f64();
    format!(
        "{} cases: {}\n{}{}",
        landings.len(),
        counted(&kinds),
        cost(landings.len() as u64, evaluations, seconds, threads),
        written(files)
    )
}

/// A sweep in short.
pub fn sweep<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
    circumstances: Circumstances,
    files: &[PathBuf],
) -> String {
    let mut text = format!("{}\n", sweep.title);
    let kinds = counted(&count_by_kind(boundaries));
    text += &format!(
        "  {} points, first transition to: {kinds}\n",
        boundaries.len()
    );
    if let Some((transition, place)) = lowest(sweep, boundaries) {
        let (speed, kind) = (transition.speed(), transition.to);
        text += &format!("  lowest V_H {speed:.4} ft/s ({kind}) at {place}\n");
    }
    let landings = boundaries.iter().map(|boundary| boundary.landings).sum();
    let evaluations = boundaries.iter().map(|boundary| boundary.evaluations).sum();
    let Circumstances {
        threads, wall_time, ..
    } = circumstances;
    let looks: u64 = boundaries.iter().map(|boundary| boundary.looks).sum();
    if sweep.search.extent == Extent::All {
        let bands: usize = boundaries.iter().map(|boundary| boundary.bands.len()).sum();
        let finds: u64 = boundaries.iter().map(|boundary| boundary.finds).sum();
        text += &format!("  {bands} bands; {looks} looks for hidden ones found {finds}\n");
    }
    text += &format!("  {}", cost(landings, evaluations, wall_time, threads));
    text += &format!("  {}", written(files));
    text
}

/// The lowest first transition of a sweep and its coordinates in words.
pub fn lowest<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
) -> Option<(Transition, String)> {
    let (point, transition) = boundaries
        .iter()
        .enumerate()
        .filter_map(|(point, boundary)| Some((point, boundary.transition?)))
        .min_by(|(_, a), (_, b)| a.speed().total_cmp(&b.speed()))?;
    Some((transition, sweep.place(point)))
}

/// Numbers of each kind, in words.
pub fn counted(kinds: &[(String, usize)]) -> String {
    let parts: Vec<String> = kinds
        .iter()
        .map(|(kind, count)| format!("{count} {kind}"))
        .collect();
    parts.join(", ")
}

fn cost(landings: u64, evaluations: u64, seconds: f64, threads: usize) -> String {
    let rate = landings as f64 / seconds.max(1e-9);
    let threads = match threads {
        1 => "one thread".to_owned(),
        many => format!("{many} threads"),
    };
    format!(
        "{landings} landings, {evaluations} derivative evaluations, {seconds:.2} s on {threads}: \
         {rate:.0} landings/s\n"
    )
}

fn written(files: &[PathBuf]) -> String {
    let names: Vec<String> = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    format!("written: {}\n", names.join(", "))
}
