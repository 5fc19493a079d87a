//! The summary of a run: results, cost, and the files written.

use std::path::PathBuf;

use touchdown_dynamics::landing::Landing;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::{Extent, Skipped, Transition};
use touchdown_search::certainty::{Certainty, LEAST_LANDINGS};
use touchdown_search::hidden_band_checks::HiddenBandChecks;
use touchdown_sweep::output::results::Circumstances;
use touchdown_sweep::output::warnings;
pub use touchdown_sweep::output::warnings::number;
use touchdown_sweep::summary::probabilities::{Count, wilson};
use touchdown_sweep::summary::sweep_counts::SweepCounts;
use touchdown_sweep::summary::transition_statistics::{Rank, TransitionStatistics};

/// Summary of a table of cases; without a time where it was not one run.
pub fn cases(
    landings: &[Landing],
    seconds: Option<f64>,
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
    format!(
        "{}: {}\n{}{}",
        number(landings.len(), "case"),
        counted(&kinds),
        cost(landings.len() as u64, evaluations, seconds, Some(threads)),
        written(files)
    )
}

/// Summary of a sweep.
pub fn sweep(
    sweep: &Sweep,
    counts: &SweepCounts,
    circumstances: Circumstances,
    files: &[PathBuf],
    remark: Option<&str>,
) -> String {
    let mut text = format!("{}\n", sweep.title);
    match counts.outcomes {
        None => {
            let kinds = counted(&counts.kinds());
            let points = number(counts.points, "point");
            text += &format!("  {points}, first transition to: {kinds}\n");
        }
        Some(count) => {
            let is_sample = counts.probabilities.is_some();
            text += &outcomes(count, sweep.design.count(), is_sample);
        }
    }
    if let Some((point, transition)) = &counts.lowest {
        text += &lowest(transition, &sweep.place(*point), sweep.units);
    }
    if let Some(transitions) = &counts.transitions {
        text += &quantiles(transitions, sweep.units);
    }
    for warning in warnings::of_sweep(sweep, counts) {
        text += &format!("  warning: {warning}\n");
    }
    let Circumstances {
        threads, wall_time, ..
    } = circumstances;
    if sweep
        .search()
        .is_some_and(|search| search.extent == Extent::All)
    {
        text += &bands(counts);
    }
    text += &below(counts);
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
fn lowest(transition: &Transition, place: &str, units: OutputUnits) -> String {
    let quantity = units.quantity("speed_fps");
    let (told, unit) = (|speed| quantity.number(speed), quantity.unit());
    let (speed, kind) = (told(transition.speed()), transition.to);
    match (transition.low, transition.certainty) {
        (None, _) => format!(
            "  lowest V_H at or below {speed:.4} {unit} ({kind}), the lowest speed searched, at {place}\n"
        ),
        (Some(_), Certainty::Disputed(ends)) => {
            let [from, to] = ends.map(told);
            format!(
                "  lowest V_H {speed:.4} {unit} ({kind}, disputed between {from:.4} and {to:.4}) at {place}\n"
            )
        }
        (Some(_), _) => format!("  lowest V_H {speed:.4} {unit} ({kind}) at {place}\n"),
    }
}

/// Some quantiles of the transition velocities of a sample, with their intervals.
fn quantiles(transitions: &TransitionStatistics, units: OutputUnits) -> String {
    let quantity = units.quantity("speed_fps");
    let in_words = |rank: Rank| match rank {
        Rank::AtOrBelow(speed) => format!("{} or less", quantity.number(speed)),
        Rank::Speed(speed) => format!("{:.4}", quantity.number(speed)),
        Rank::Above(speed) => format!("more than {}", quantity.number(speed)),
    };
    let quantiles = transitions.quantiles(&[0.05, 0.5, 0.95]);
    let parts = quantiles.into_iter().map(|quantile| {
        let interval = match quantile.interval.map(|end| end.map(in_words)) {
            [Some(low), Some(high)] => format!("{low} to {high}"),
            [Some(low), None] => format!("from {low}"),
            [None, Some(high)] => format!("up to {high}"),
            [None, None] => "unknown".to_owned(),
        };
        let (percent, speed) = (100.0 * quantile.share, in_words(quantile.speed));
        format!("{percent} % {speed} (95 % interval {interval})")
    });
    let parts: Vec<String> = parts.collect();
    format!(
        "  V_H quantiles, {}: {}\n",
        quantity.unit(),
        parts.join(", ")
    )
}

/// Number of bands, and of the searches for hidden ones by their reason.
fn bands(counts: &SweepCounts) -> String {
    let HiddenBandChecks {
        toppling,
        righting,
        stroke,
        gaps,
        below: _,
        drawn: _,
    } = counts.checks;
    let all = counts.checks.all();
    format!(
        "  {}; {} for hidden bands, {} found: {toppling} near toppling, {righting} near \
         staying upright, {stroke} near a strut's stop, {gaps} at irregular changes\n",
        number(counts.bands, "band"),
        number(all.checks, "check"),
        all.finds
    )
}

/// Lines about the speeds below first transitions, and just above them.
fn below(counts: &SweepCounts) -> String {
    let HiddenBandChecks { below, drawn, .. } = counts.checks;
    let mut text = String::new();
    if below.checks > 0 {
        text += &format!(
            "  below first transitions: {} closer than the scan's steps lowered {}\n",
            number(below.checks, "landing"),
            number(below.finds, "transition"),
        );
    }
    if drawn.checks > 0 {
        let [_, most] = wilson(drawn.finds, drawn.checks);
        text += &format!(
            "  {} drawn at random there, {} not stable: at most {:.2} % of the speeds below are not (95 %)\n",
            number(drawn.checks, "speed"),
            drawn.finds,
            100.0 * most
        );
    }
    if counts.patchy > 0 {
        text += &format!(
            "  patchy first transitions, with stable landings up to a scan step above: {}\n",
            counts.patchy
        );
    }
    text
}

/// Landings that each shortcut of the search saved or cost, where it was used.
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
        parts.push(format!("{} left out of scans", number(left_out, "landing")));
    }
    if loose > 0 {
        parts.push(format!(
            "{} at a looser tolerance, {replaced} more to confirm changes",
            number(loose, "landing")
        ));
    }
    if interpolated != 0 {
        parts.push(format!(
            "{} fewer than by bisection",
            number(interpolated, "landing")
        ));
    }
    if untested > 0 {
        let least = untested * LEAST_LANDINGS;
        parts.push(format!(
            "{} not tested, as their margins run through zero (at least {least} landings)",
            number(untested, "transition")
        ));
    }
    match parts.as_slice() {
        [] => String::new(),
        parts => format!("  shortcuts: {}\n", parts.join("; ")),
    }
}

/// How landings ended, of a sample with intervals at 95 %.
fn outcomes(count: Count, asked: usize, is_sample: bool) -> String {
    let share = |name: &str, hits: u64| {
        if !is_sample {
            return format!("  {name} {hits}\n");
        }
        let [low, high] = wilson(hits, count.landings).map(|share| 100.0 * share);
        let percent = 100.0 * hits as f64 / count.landings.max(1) as f64;
        format!("  {name} {hits}: {percent:.2} % (95 % interval {low:.2} to {high:.2} %)\n")
    };
    let early = match count.landings < asked as u64 {
        true => format!(" of {asked}, enough for the interval width asked for"),
        false => String::new(),
    };
    format!(
        "  {}{early}\n{}{}{}{}{}",
        number(count.landings, "landing"),
        share("toppled", count.toppled),
        share("bottomed", count.bottomed),
        share("undecided", count.undecided),
        share("not computed", count.failed),
        share("not stable (all of these)", count.landings - count.stable()),
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
    let work = format!(
        "{}, {}",
        number(landings, "landing"),
        number(evaluations, "derivative evaluation")
    );
    let (Some(seconds), Some(threads)) = (seconds, threads) else {
        return format!("{work}\n");
    };
    let rate = landings as f64 / seconds.max(1e-9);
    let threads = number(threads, "thread");
    format!("{work}, {seconds:.2} s on {threads}: {rate:.0} landings/s\n")
}

/// Rows of cells in columns, those of the numbers in `right` flush right.
pub fn columns<const COUNT: usize>(rows: &[[String; COUNT]], right: &[usize]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
    let widths: [usize; COUNT] = std::array::from_fn(|column| width(column).unwrap_or(0));
    let line = |row: &[String; COUNT]| {
        let cells = row.iter().zip(widths).enumerate();
        let cells = cells.map(|(column, (cell, width))| match right.contains(&column) {
            true => format!("{cell:>width$}"),
            false => format!("{cell:<width$}"),
        });
        format!("{}\n", cells.collect::<Vec<_>>().join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}

/// The files of a run; of very many the first and the last.
pub fn written(files: &[PathBuf]) -> String {
    const SHOWN: usize = 100;
    let names: Vec<String> = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    match &names[..] {
        [first, .., last] if names.len() > SHOWN => {
            format!("written: {first} to {last}, {} files\n", names.len())
        }
        names => format!("written: {}\n", names.join(", ")),
    }
}
