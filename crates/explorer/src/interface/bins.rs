//! `bins`: how landings of a sample end over bins of a column, of all and of those within ranges.

use serde::{Deserialize, Serialize};
use serde_json::json;
use touchdown_dynamics::outcome::Class;
use touchdown_sweep::summary::probabilities::wilson;
use touchdown_sweep::summary::transition_statistics::edges;

use super::complaint::Complaint;
use super::in_units::in_units;
use super::request::{asked_units, read, written};
use super::rows::{Range, Rows, number};
use super::sample::{class_place, outcome_column, sample_of};
use crate::named::Named;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    results: String,
    column: String,
    #[serde(default)]
    within: Vec<Range>,
    units: Option<String>,
}

/// Landings by class, in the order of [`Class::ALL`].
#[derive(Debug, Clone, Copy, Default)]
struct Count([u64; Class::ALL.len()]);

/// Landings counted.
#[derive(Serialize)]
struct Told {
    landings: u64,
    classes: Vec<OfClass>,
}

/// Landings of a class, and its probability with the interval at 95 %.
#[derive(Serialize)]
struct OfClass {
    landings: u64,
    probability: Option<f64>,
    low_95: f64,
    high_95: f64,
}

/// Counts of all landings and of those within the ranges.
#[derive(Clone, Copy, Default)]
struct Both {
    all: Count,
    within: Count,
}

pub fn answer(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let units = asked_units(request.units.as_deref())?;
    let results = in_units(sample_of(named, &request.results)?, units)?;
    let rows = Rows::read(&results)?;
    let column = rows.column("column", &request.column)?;
    let outcome = outcome_column(&results);
    let are_within = rows.within(&request.within)?;
    let mut sorted: Vec<f64> = (rows.rows.iter())
        .filter_map(|row| number(&row[column]))
        .collect();
    sorted.sort_by(f64::total_cmp);
    let edges = edges(&sorted);
    let mut bins = vec![Both::default(); edges.len().saturating_sub(1)];
    let mut overall = Both::default();
    for (row, is_within) in rows.rows.iter().zip(are_within) {
        let class = class_place(&row[outcome]);
        overall.add(class, is_within);
        if let Some(value) = number(&row[column]) {
            let above = edges.partition_point(|edge| *edge < value);
            // Rounding may leave the least number on the lowest edge, and the greatest above the highest.
            let last = bins.len() - 1;
            bins[above.saturating_sub(1).min(last)].add(class, is_within);
        }
    }
    let ends = edges.windows(2);
    let told = ends.zip(&bins).map(|(ends, counts)| {
        json!({
            "from": ends[0],
            "to": ends[1],
            "all": counts.all.told(),
            "within": counts.within.told(),
        })
    });
    let told: Vec<_> = told.collect();
    written(&json!({
        "column": request.column,
        "all": overall.all.told(),
        "within": overall.within.told(),
        "bins": told,
    }))
}

impl Both {
    fn add(&mut self, class: usize, is_within: bool) {
        self.all.0[class] += 1;
        self.within.0[class] += u64::from(is_within);
    }
}

impl Count {
    fn told(&self) -> Told {
        let landings: u64 = self.0.iter().sum();
        let classes = self.0.iter().map(|&hits| {
            let [low_95, high_95] = wilson(hits, landings);
            OfClass {
                landings: hits,
                probability: (landings > 0).then(|| hits as f64 / landings as f64),
                low_95,
                high_95,
            }
        });
        Told {
            landings,
            classes: classes.collect(),
        }
    }
}
