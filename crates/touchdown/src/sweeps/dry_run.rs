//! `touchdown sweep --dry-run`: what a night will take, before it begins.

use std::time::{Duration, Instant};

use touchdown_sweep::findings::Finding;
use touchdown_sweep::journal;
use touchdown_sweep::refined_grid::{MapRules, RefinedGrid};
use touchdown_sweep::results;
use touchdown_sweep::rounds::Rounds;
use touchdown_sweep::run::Workers;
use touchdown_sweep::shard::Shard;
use touchdown_sweep::sweep_file::Sweep;

use crate::failure::Failure;

/// Time that is spent on computing points as a sample of the others.
const CALIBRATION: Duration = Duration::from_secs(3);
/// Most points computed as a sample.
const MOST_CALIBRATED: usize = 256;
/// Most points whose input is checked.
const MOST_CHECKED: usize = 10_000;

/// What a sweep, or a shard of it, will take; in words.
pub fn tell(sweep: &Sweep, shard: Shard, workers: &Workers) -> Result<String, Failure> {
    // Of a map, the points that are wanted first; those of a shard that its cells share with others are its own too.
    let first_round = sweep.map().map(|map| Rounds::new(map, shard).next_round());
    let points = match &first_round {
        Some(first) => first.len(),
        None => shard.len(sweep.design.count()),
    };
    let point_of = |index: usize| match &first_round {
        Some(first) => first[index],
        None => shard.point(index),
    };
    let checked = spread(points, MOST_CHECKED);
    for &index in &checked {
        let point = point_of(index);
        sweep.case(point).map_err(|fault| {
            Failure::running(format!("the point {}: {fault}", sweep.place(point)))
        })?;
    }
    let start = Instant::now();
    let mut sample = Vec::new();
    let mut findings = Vec::new();
    let mut size = workers.threads().min(points);
    while sample.len() < size {
        // Points in between those that are done, as far as that is possible.
        let more: Vec<usize> = spread(points, size)
            .into_iter()
            .map(point_of)
            .filter(|point| !sample.contains(point))
            .collect();
        findings.extend(workers.points(sweep, &more)?);
        sample.extend(more);
        let is_long = start.elapsed() > CALIBRATION / 2;
        if is_long || size >= MOST_CALIBRATED || size == points {
            break;
        }
        size = (2 * size).min(points);
    }
    let seconds = start.elapsed().as_secs_f64();
    let each = points as f64 / findings.len().max(1) as f64;
    let landings: u64 = findings.iter().map(Finding::landings).sum();
    let journal: usize = (findings.iter())
        .map(|finding| journal::record_length(finding.encode().len()))
        .sum();
    let rows = sample.iter().zip(&findings);
    let table: usize = rows
        .map(|(point, found)| results::row(sweep, *point, found).join(",").len() + 1)
        .sum();
    let of_map = sweep
        .map()
        .map(|map| refinement(map, each * landings as f64, each * seconds));
    Ok(format!(
        "{}\n  {points} points over {}; the input of {} was checked\n  from {} points that were \
         computed: about {:.0} landings, {} on {} threads, {} of journal, {} of table\n",
        sweep.title,
        axes(sweep),
        checked.len(),
        findings.len(),
        landings as f64 * each,
        duration(seconds * each),
        workers.threads(),
        bytes(journal as f64 * each),
        bytes(table as f64 * each),
    ) + &of_map.unwrap_or_default())
}

/// What is known beforehand of the refinement of a map whose first level takes so many landings and seconds.
fn refinement(map: &RefinedGrid, landings: f64, seconds: f64) -> String {
    let MapRules { error, budget, .. } = map.rules;
    let until = match budget {
        Some(budget) => {
            let all = seconds * budget as f64 / landings.max(1.0);
            format!(
                "until {budget} landings are spent, in about {}",
                duration(all)
            )
        }
        None => format!("until errors are below {error} ft/s, however many points that takes"),
    };
    let error = match (error, budget) {
        (error, Some(_)) if error > 0.0 => format!(", or until errors are below {error} ft/s"),
        _ => String::new(),
    };
    format!("  that is the first level of the map; it is refined {until}{error}\n")
}

fn axes(sweep: &Sweep) -> String {
    let names: Vec<&str> = sweep.axes.iter().map(|axis| axis.name()).collect();
    names.join(", ")
}

/// `most` of the numbers below `count`, or all, evenly spread.
fn spread(count: usize, most: usize) -> Vec<usize> {
    let shown = count.min(most);
    // In the middle of as many equal parts.
    let middle =
        |part: usize| ((2 * part + 1) as u128 * count as u128 / (2 * shown) as u128) as usize;
    (0..shown).map(middle).collect()
}

fn duration(seconds: f64) -> String {
    match seconds {
        short if short < 120.0 => format!("{short:.0} s"),
        long if long < 2.0 * 3600.0 => format!("{:.0} min", long / 60.0),
        night if night < 48.0 * 3600.0 => format!("{:.1} h", night / 3600.0),
        days => format!("{:.1} days", days / 86_400.0),
    }
}

fn bytes(count: f64) -> String {
    match count {
        few if few < 1e6 => format!("{:.0} kB", (few / 1e3).ceil()),
        some if some < 1e9 => format!("{:.0} MB", some / 1e6),
        many => format!("{:.1} GB", many / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_choice_is_spread_over_all() {
        assert_eq!(spread(3, 10), [0, 1, 2]);
        assert_eq!(spread(10, 5), [1, 3, 5, 7, 9]);
        assert_eq!(spread(usize::MAX, 1).len(), 1);
        assert_eq!(spread(0, 5), [0; 0]);
    }

    #[test]
    fn long_times_and_sizes_are_told_in_long_units() {
        assert_eq!(duration(30.0), "30 s");
        assert_eq!(duration(36_000.0), "10.0 h");
        assert_eq!(bytes(1234.0), "2 kB");
        assert_eq!(bytes(2.5e9), "2.5 GB");
    }
}
