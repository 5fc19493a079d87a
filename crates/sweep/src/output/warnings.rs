//! Warnings of results that are less than they seem, in words.

use std::fmt::Display;

use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::sweeps::sweep::Sweep;
use touchdown_search::contact_warnings::ContactWarnings;

use crate::output::landing_report;
use crate::summary::sweep_counts::SweepCounts;

/// Warnings of a sweep: landings without a result, transitions that are only bounds, or that the smallest changes move, and
/// contact.
pub fn of_sweep(sweep: &Sweep, counts: &SweepCounts) -> Vec<String> {
    let mut told = Vec::new();
    let mut warn = |points: usize, what: &str| {
        if points > 0 {
            told.push(format!("at {} {what}", number(points, "point")));
        }
    };
    warn(
        counts.at_or_below,
        "landings are not stable at the lowest speed searched: V_H lies at or below it",
    );
    let limit = sweep.settings.time_limit();
    warn(
        counts.with_undecided,
        &format!(
            "some landings are undecided: they slide on, or still moved at time_limit_s = {limit}"
        ),
    );
    warn(
        counts.with_failures,
        "some landings could not be computed: they end as failure",
    );
    warn(
        counts.disputed,
        "the first transition is disputed: small changes of the input move it by more than its bracket",
    );
    let map = counts.coarse_cells;
    if map.coarse > 0 {
        let quantity = sweep.units.quantity("speed_fps");
        let sought = sweep.map().map_or(0.0, |map| map.rules.error);
        told.push(format!(
            "{} of {} of the map are coarser than asked, as its budget is spent: estimated errors up to {:.2}, not {}, {}",
            map.coarse,
            number(map.cells, "cell"),
            quantity.number(map.worst),
            quantity.number(sought),
            quantity.unit(),
        ));
    }
    if let Some((most, energy)) = counts.most_given {
        told.push(format!(
            "at {}, most at {}: {}",
            number(counts.with_given, "point"),
            sweep.place(most),
            landing_report::given_by_contact(energy, sweep.units)
        ));
    }
    for (points, what) in [
        (counts.with_crushed_through, landing_report::CRUSHED_THROUGH),
        (counts.with_beyond_table, landing_report::BEYOND_TABLE),
    ] {
        if points > 0 {
            told.push(format!("at {}: {what}", number(points, "point")));
        }
    }
    let undecided = counts.outcomes.map_or(0, |count| count.undecided);
    if undecided > 0 {
        told.push(format!(
            "{} undecided: sliding, or still moving at time_limit_s = {limit}, counted as not stable",
            number(undecided, "landing")
        ));
    }
    told
}

/// Warnings of contact in the rows of a table of cases, each with its place in words.
pub fn of_cases(
    rows: impl Iterator<Item = (String, ContactWarnings)>,
    units: OutputUnits,
) -> Vec<String> {
    let rows: Vec<(String, ContactWarnings)> = rows.collect();
    let told = |is_told: fn(&ContactWarnings) -> bool| {
        rows.iter().filter(move |(_, warnings)| is_told(warnings))
    };
    let mut all = Vec::new();
    let given = || told(|warnings| warnings.given > 0.0);
    if let Some((most, warnings)) = given().max_by(|(_, a), (_, b)| a.given.total_cmp(&b.given)) {
        all.push(format!(
            "in {}, most in {most}: {}",
            number(given().count(), "case"),
            landing_report::given_by_contact(warnings.given, units)
        ));
    }
    let mut tell = |is_told: fn(&ContactWarnings) -> bool, what: &str| {
        if let Some((first, _)) = told(is_told).next() {
            let cases = number(told(is_told).count(), "case");
            all.push(format!("in {cases}, first in {first}: {what}"));
        }
    };
    tell(
        |warnings| warnings.is_crushed_through,
        landing_report::CRUSHED_THROUGH,
    );
    tell(
        |warnings| warnings.is_beyond_table,
        landing_report::BEYOND_TABLE,
    );
    all
}

/// A number of things, with the plural where it is needed.
pub fn number(count: impl Display, thing: &str) -> String {
    let count = count.to_string();
    match count.as_str() {
        "1" => format!("1 {thing}"),
        _ => format!("{count} {thing}s"),
    }
}
