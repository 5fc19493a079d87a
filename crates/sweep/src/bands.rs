//! All bands of equal outcome between the lowest and the highest speed of a search.
//!
//! The whole range is scanned, intervals that may hide a band are looked into, and every change
//! between neighbouring landings of different class is bisected. Whatever third class a bisection
//! meets becomes a band of its own.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::outcome::{Class, Outcome};

use crate::boundary::{Boundary, Search, Transition, Trial};
use crate::hidden;

/// A range of speeds in which landings end alike.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// Lower end, ft/s: the middle of the bracket below, or the lowest speed searched.
    pub from: f64,
    /// Upper end, ft/s: the middle of the bracket above, or the highest speed searched.
    pub to: f64,
    /// How landings end in it.
    pub class: Class,
    /// How the computed landing nearest to the middle of the band ended.
    pub outcome: Outcome,
    /// Width of the bracket of the upper transition, ft/s; `None` at the end of the range.
    pub bracket_width: Option<f64>,
}

/// A landing of the search.
#[derive(Debug, Clone)]
pub(crate) struct Sample {
    /// Its horizontal speed, ft/s.
    pub(crate) speed: f64,
    pub(crate) trial: Trial,
}

impl Sample {
    pub(crate) fn class(&self) -> Class {
        self.trial.outcome.class()
    }
}

impl Search {
    /// Searches all bands with `land`, which lands at a given horizontal speed. The first
    /// transition is the one that [`Search::first_transition`] finds, unless a hidden band lies
    /// below it.
    ///
    /// # Errors
    /// Only what `land` gives up with, at once.
    pub fn all_bands<Stop>(
        &self,
        mut land: impl FnMut(f64) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        let mut sample = |speed| {
            let trial = land(speed)?;
            Ok(Sample { speed, trial })
        };
        let mut samples: Vec<Sample> = (0..self.scan_count())
            .map(|index| sample(self.scan_speed(index)))
            .collect::<Result<_, _>>()?;

        let suspects = hidden::suspects(&samples);
        let mut found = Vec::new();
        let mut finds = 0;
        for &index in &suspects {
            let look = hidden::look(&samples[index], &samples[index + 1], &mut sample)?;
            finds += u64::from(look.iter().any(|s| s.class() != samples[index].class()));
            found.extend(look);
        }
        insert(&mut samples, found);

        let mut between = Vec::new();
        for pair in samples.windows(2) {
            bisect(
                &pair[0],
                &pair[1],
                self.tolerance,
                &mut sample,
                &mut between,
            )?;
        }
        insert(&mut samples, between);

        Ok(Boundary {
            transition: first_change(&samples),
            bands: bands(&samples),
            looks: suspects.len() as u64,
            finds,
            landings: samples.len() as u64,
            evaluations: samples.iter().map(|sample| sample.trial.evaluations).sum(),
        })
    }
}

fn insert(samples: &mut Vec<Sample>, more: Vec<Sample>) {
    samples.extend(more);
    samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
}

/// Halves the interval between two landings until every change of class in it that halving meets
/// is bracketed within `tolerance`; adds the landings to `found`.
fn bisect<Stop>(
    low: &Sample,
    high: &Sample,
    tolerance: f64,
    sample: &mut impl FnMut(f64) -> Result<Sample, Stop>,
    found: &mut Vec<Sample>,
) -> Result<(), Stop> {
    let (mut low, mut high) = (low.clone(), high.clone());
    while low.class() != high.class() && high.speed - low.speed > tolerance {
        let speed = 0.5 * (low.speed + high.speed);
        if speed <= low.speed || speed >= high.speed {
            break;
        }
        let middle = sample(speed)?;
        found.push(middle.clone());
        if middle.class() == low.class() {
            low = middle;
        } else {
            if middle.class() != high.class() {
                bisect(&middle, &high, tolerance, sample, found)?;
            }
            high = middle;
        }
    }
    Ok(())
}

/// The first landing that is not stable, with the one below it.
fn first_change(samples: &[Sample]) -> Option<Transition> {
    let index = samples
        .iter()
        .position(|sample| sample.class() != Class::Stable)?;
    Some(Transition {
        to: samples[index].class(),
        low: samples[index.saturating_sub(1)].speed,
        high: samples[index].speed,
    })
}

/// Runs of landings of the same class, from end to end.
fn bands(samples: &[Sample]) -> Vec<Band> {
    let mut bands: Vec<Band> = Vec::new();
    let runs: Vec<&[Sample]> = samples.chunk_by(|a, b| a.class() == b.class()).collect();
    for (index, run) in runs.iter().enumerate() {
        let [first, last] = [&run[0], &run[run.len() - 1]];
        let next = runs.get(index + 1).map(|run| &run[0]);
        let from = bands.last().map_or(first.speed, |below| below.to);
        let to = next.map_or(last.speed, |next| 0.5 * (last.speed + next.speed));
        let middle = 0.5 * (from + to);
        let distance = |sample: &&Sample| (sample.speed - middle).abs();
        let nearest = run
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(first);
        bands.push(Band {
            from,
            to,
            class: first.class(),
            outcome: nearest.trial.outcome.clone(),
            bracket_width: next.map(|next| next.speed - last.speed),
        });
    }
    bands
}

#[cfg(test)]
#[path = "bands_tests.rs"]
mod tests;
