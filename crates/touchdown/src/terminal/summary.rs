//! A run in short: what came out, what it cost, and where the results are.

use std::path::PathBuf;

use touchdown_sweep::boundary::{Extent, Transition};
use touchdown_sweep::certainty::{Certainty, LEAST_LANDINGS};
use touchdown_sweep::findings::Finding;
use touchdown_sweep::hidden_band_checks::HiddenBandChecks;
use touchdown_sweep::probabilities::{Count, wilson};
use touchdown_sweep::results::Circumstances;
use touchdown_sweep::skipped::Skipped;
use touchdown_sweep::sweep_counts::SweepCounts;
use touchdown_sweep::sweep_file::Sweep;

/// A table of cases in short; without a time where it was not one run.
pub fn cases(
    findings: &[Finding],
    seconds: Option<f64>,
    threads: usize,
    files: &[PathBuf],
) -> String {
    let mut kinds: Vec<(String, usize)> = Vec::new();
    for finding in findings {
        let Finding::Landing { outcome, .. } = finding else {
            continue;
        };
        let kind = outcome.to_string();
        match kinds.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, count)) => *count += 1,
            None => kinds.push((kind, 1)),
        }
    }
    kinds.sort();
    let evaluations = findings.iter().map(Finding::evaluations).sum();
    format!(
        "{}: {}\n{}{}",
        number(findings.len(), "case"),
        counted(&kinds),
        cost(findings.len() as u64, evaluations, seconds, Some(threads)),
        written(files)
    )
}

/// A sweep in short.
pub fn sweep(
    sweep: &Sweep,
    counts: &SweepCounts,
    circumstances: Circumstances,
    files: &[PathBuf],
    remark: Option<&str>,
) -> String {
    let mut text = format!("{}\n", sweep.title);
    match &counts.probabilities {
        None => {
            let kinds = counted(&counts.kinds());
            let points = number(counts.points, "point");
            text += &format!("  {points}, first transition to: {kinds}\n");
        }
        Some(known) => text += &outcomes(known.overall, sweep.design.count()),
    }
    if let Some((point, transition)) = &counts.lowest {
        text += &lowest(transition, &sweep.place(*point));
    }
    text += &warnings(sweep, counts);
    let Circumstances {
        threads, wall_time, ..
    } = circumstances;
    if sweep
        .search()
        .is_some_and(|search| search.extent == Extent::All)
    {
        text += &bands(counts);
    }
    let [asked, smooth] = counts.slopes;
    if asked > 0 {
        text += &format!("  sensitivities: {smooth} of {asked} have a derivative\n");
    }
    text += &skipped(&counts.skipped);
    text += &format!(
        "  {}",
        cost(counts.landings, counts.evaluations, wall_time, threads)
    );
    text += &format!("  {}", written(files));
    if let Some(remark) = remark {
        text += &format!("  {remark}\n");
    }
    text
}

/// The lowest first transition, and how well it is known.
fn lowest(transition: &Transition, place: &str) -> String {
    let (speed, kind) = (transition.speed(), transition.to);
    match (transition.low, transition.certainty) {
        (None, _) => format!(
            "  lowest V_H at or below {speed:.4} ft/s ({kind}), the lowest speed searched, at {place}\n"
        ),
        (Some(_), Certainty::Disputed([from, to])) => format!(
            "  lowest V_H {speed:.4} ft/s ({kind}, disputed between {from:.4} and {to:.4}) at {place}\n"
        ),
        (Some(_), _) => format!("  lowest V_H {speed:.4} ft/s ({kind}) at {place}\n"),
    }
}

/// What numbers of a sweep do not tell by themselves: landings without a result, transitions that are no more than
/// bounds, or that the smallest changes move.
fn warnings(sweep: &Sweep, counts: &SweepCounts) -> String {
    let mut text = String::new();
    let mut warn = |points: usize, what: &str| {
        if points > 0 {
            text += &format!("  warning: at {} {what}\n", number(points, "point"));
        }
    };
    warn(
        counts.at_or_below,
        "landings are not stable at the lowest speed searched: V_H lies at or below it",
    );
    let limit = sweep.settings.time_limit();
    warn(
        counts.with_undecided,
        &format!("some landings are undecided: they still moved at time_limit_s = {limit}"),
    );
    warn(
        counts.with_failures,
        "some landings could not be computed: they end as failure",
    );
    warn(
        counts.disputed,
        "the first transition is disputed: the smallest changes move it by more than its bracket",
    );
    if let Some(known) = &counts.probabilities {
        let undecided = known.overall.undecided;
        if undecided > 0 {
            text += &format!(
                "  warning: {} undecided: still moving at time_limit_s = {limit}, counted as not stable\n",
                number(undecided as usize, "landing")
            );
        }
    }
    text
}

/// A number of things in words.
pub fn number(count: usize, thing: &str) -> String {
    match count {
        1 => format!("1 {thing}"),
        _ => format!("{count} {thing}s"),
    }
}

/// Bands, and looks for hidden ones by what led to them.
fn bands(counts: &SweepCounts) -> String {
    let HiddenBandChecks {
        toppling,
        righting,
        stroke,
        gaps,
    } = counts.checks;
    let all = counts.checks.all();
    format!(
        "  {} bands; {} looks for hidden ones found {}: {toppling} near toppling, {righting} near \
         staying upright, {stroke} near a strut's stop, {gaps} at irregular changes\n",
        counts.bands, all.checks, all.finds
    )
}

/// What each skip came to that did anything.
fn skipped(skipped: &Skipped) -> String {
    let Skipped {
        left_out,
        loose,
        replaced,
        interpolated,
        untested,
    } = *skipped;
    let mut parts = Vec::new();
    if left_out != 0 {
        parts.push(format!("{left_out} landings left out of scans"));
    }
    if loose > 0 {
        parts.push(format!(
            "{loose} at a looser tolerance, for {replaced} more"
        ));
    }
    if interpolated != 0 {
        parts.push(format!("{interpolated} fewer than by halving"));
    }
    if untested > 0 {
        let least = untested * LEAST_LANDINGS;
        parts.push(format!(
            "{untested} transitions not tested, as margins tell that they are certain ({least} landings or more)"
        ));
    }
    match parts.as_slice() {
        [] => String::new(),
        parts => format!("  skipped: {}\n", parts.join("; ")),
    }
}

/// How landings ended, with intervals at 95 %.
fn outcomes(count: Count, asked: usize) -> String {
    let share = |name: &str, hits: u64| {
        let [low, high] = wilson(hits, count.landings).map(|share| 100.0 * share);
        let percent = 100.0 * hits as f64 / count.landings.max(1) as f64;
        format!("  {name} {hits}: {percent:.2} %, at 95 % between {low:.2} and {high:.2} %\n")
    };
    let early = match count.landings < asked as u64 {
        true => format!(" of {asked}, which are enough"),
        false => String::new(),
    };
    format!(
        "  {} landings{early}\n{}{}{}{}{}",
        count.landings,
        share("toppled", count.toppled),
        share("bottomed a strut", count.bottomed),
        share("undecided", count.undecided),
        share("not computed", count.failed),
        share(
            "not stable, all of these together",
            count.landings - count.stable()
        ),
    )
}

/// Numbers of each kind, in words.
pub fn counted(kinds: &[(String, usize)]) -> String {
    let parts: Vec<String> = kinds
        .iter()
        .map(|(kind, count)| format!("{count} {kind}"))
        .collect();
    parts.join(", ")
}

fn cost(landings: u64, evaluations: u64, seconds: Option<f64>, threads: Option<usize>) -> String {
    let work = format!("{landings} landings, {evaluations} derivative evaluations");
    let (Some(seconds), Some(threads)) = (seconds, threads) else {
        return format!("{work}\n");
    };
    let rate = landings as f64 / seconds.max(1e-9);
    let threads = match threads {
        1 => "one thread".to_owned(),
        many => format!("{many} threads"),
    };
    format!("{work}, {seconds:.2} s on {threads}: {rate:.0} landings/s\n")
}

/// The files of a run.
pub fn written(files: &[PathBuf]) -> String {
    let names: Vec<String> = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    format!("written: {}\n", names.join(", "))
}
