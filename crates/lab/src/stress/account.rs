//! The account of wild landings: how they ended, and which of them to keep as cases.

use std::collections::BTreeMap;
use std::fmt::Write;

use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::{Failure, Outcome};
use touchdown_dynamics::scene::Settings;

use super::case_table::Reasons;
use super::checks::LandingChecks;
use touchdown::terminal::summary::number as number_of;

/// Landings kept of every kind of failure, and of those with invalid results.
const KEPT: usize = 10_000;
/// Landings kept where the model has no law, as examples.
const EXAMPLES: usize = 10;
/// Complaints that are listed one by one.
const LISTED: usize = 20;
/// Landings of which one may end without a result, and how many may in a run however short.
const ONE_FAILURE_PER: u64 = 100;
const LEAST_FAILURES_ALLOWED: u64 = 3;

/// Wild landings, added up one by one.
#[derive(Debug)]
pub struct Account {
    checks: LandingChecks,
    landings: u64,
    evaluations: u64,
    kinds: BTreeMap<String, Kind>,
    /// By how much accounts of energy stay open.
    open: Vec<Open>,
    /// Most steps, and their landing.
    steps: Option<(u64, usize)>,
    invalid: u64,
    /// The first landings with invalid results, and what is wrong with them.
    complaints: Vec<(usize, String)>,
}

/// By how much the account of energy of a landing stays open.
#[derive(Debug, Clone, Copy)]
struct Open {
    energy_ftlb: f64,
    /// Of the energy involved.
    part: f64,
    landing: usize,
}

/// Landings with the same kind of end.
#[derive(Debug, Default)]
struct Kind {
    count: u64,
    end: End,
    /// The first of them.
    first: Vec<usize>,
}

/// Ends with and without a result.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    #[default]
    Result,
    /// Where the model has no law.
    BeyondModel,
    /// Where it has one, and the computation failed.
    Failed,
}

impl Account {
    /// An account without landings; they are computed with these settings.
    pub fn of(settings: &Settings) -> Self {
        Self {
            checks: LandingChecks::of(settings),
            landings: 0,
            evaluations: 0,
            kinds: BTreeMap::new(),
            open: Vec::new(),
            steps: None,
            invalid: 0,
            complaints: Vec::new(),
        }
    }

    /// Adds a landing by its number.
    pub fn add(&mut self, number: usize, landing: &Landing) {
        self.landings += 1;
        self.evaluations += landing.evaluations;
        let (end, name) = kind(&landing.outcome);
        let kind = self.kinds.entry(name).or_default();
        kind.count += 1;
        kind.end = end;
        let kept = match end {
            End::Result => 0,
            End::BeyondModel => EXAMPLES,
            End::Failed => KEPT,
        };
        if kind.first.len() < kept {
            kind.first.push(number);
        }
        let steps = landing.steps;
        if self.steps.is_none_or(|(most, _)| steps > most) {
            self.steps = Some((steps, number));
        }
        if let Some([energy_ftlb, part]) = self.checks.open(landing) {
            self.open.push(Open {
                energy_ftlb,
                part,
                landing: number,
            });
        }
        if let Some(complaint) = self.checks.complaint(landing) {
            self.invalid += 1;
            if self.complaints.len() < KEPT {
                self.complaints.push((number, complaint));
            }
        }
    }

    /// What is wrong with them all, if anything is.
    pub fn verdict(&self) -> Option<String> {
        let failed = self.failed();
        let most = LEAST_FAILURES_ALLOWED.max(self.landings / ONE_FAILURE_PER);
        match self.invalid {
            0 if failed <= most => None,
            0 => Some(format!(
                "{failed} wild landings ended without a result; at most {most} may"
            )),
            count => Some(format!(
                "the results of {} are invalid",
                number_of(count, "wild landing")
            )),
        }
    }

    /// The account that is most open, in parts of the energy involved.
    fn most_open(&self) -> Option<&Open> {
        // The first of those that are equally open.
        let all = self.open.iter().rev();
        all.max_by(|a, b| a.part.total_cmp(&b.part))
    }

    fn failed(&self) -> u64 {
        let failed = self.kinds.values().filter(|kind| kind.end == End::Failed);
        failed.map(|kind| kind.count).sum()
    }

    /// The account as text.
    pub fn summary(&self) -> String {
        let landings = self.landings.max(1) as f64;
        let mut text = String::new();
        let mut kinds: Vec<(&String, &Kind)> = self.kinds.iter().collect();
        kinds.sort_by_key(|(_, kind)| (kind.end, std::cmp::Reverse(kind.count)));
        // Writing to a text cannot fail.
        for (name, kind) in kinds {
            let percent = 100.0 * kind.count as f64 / landings;
            let _ = writeln!(text, "  {percent:8.4} %  {name} ({})", kind.count);
        }
        if let Some(most) = self.most_open() {
            let median = |of: fn(&Open) -> f64| median(self.open.iter().map(of).collect());
            let _ = writeln!(
                text,
                "  energy account open by at most {:.1e} of the energy involved (landing {}), {:.1e} in the median;\n  \
                 by at most {:.1e} ft lb, {:.1e} ft lb in the median",
                most.part,
                most.landing,
                median(|open| open.part),
                self.open
                    .iter()
                    .map(|open| open.energy_ftlb)
                    .fold(0.0, f64::max),
                median(|open| open.energy_ftlb),
            );
        }
        if let Some((steps, number)) = self.steps {
            let _ = writeln!(text, "  at most {steps} steps (landing {number})");
        }
        let mean = self.evaluations as f64 / landings;
        let _ = writeln!(
            text,
            "  {mean:.0} evaluations of the equations of motion on average"
        );
        match self.invalid {
            0 => text += "  every value is a number, every energy account closes\n",
            count => {
                let _ = writeln!(text, "  invalid results: {count}");
                for (number, complaint) in self.complaints.iter().take(LISTED) {
                    let _ = writeln!(text, "    landing {number}: {complaint}");
                }
            }
        }
        text
    }

    /// The landings worth landing again: those that are invalid or failed, some beyond the model, and
    /// the extremes.
    pub fn reasons(&self) -> Reasons {
        let mut reasons = Reasons::new();
        let mut keep = |number, why: &str| {
            let whys: &mut Vec<String> = reasons.entry(number).or_default();
            whys.push(why.to_owned());
        };
        for (name, kind) in &self.kinds {
            for number in &kind.first {
                keep(*number, name);
            }
        }
        for (number, complaint) in &self.complaints {
            keep(*number, complaint);
        }
        if let Some(most) = self.most_open() {
            keep(most.landing, "account of energy most open");
        }
        if let Some((_, number)) = self.steps {
            keep(number, "most steps");
        }
        reasons
    }
}

/// The middle number, the greater of two; NaN of none.
fn median(mut numbers: Vec<f64>) -> f64 {
    let middle = numbers.len() / 2;
    numbers.sort_unstable_by(f64::total_cmp);
    numbers.get(middle).copied().unwrap_or(f64::NAN)
}

/// How a landing ended, whichever leg it was.
fn kind(outcome: &Outcome) -> (End, String) {
    match outcome {
        Outcome::Bottomed { .. } => (End::Result, "bottomed".to_owned()),
        Outcome::BottomedPad { .. } => (End::Result, "bottomed pad".to_owned()),
        Outcome::BottomedBlock { .. } => (End::Result, "bottomed block".to_owned()),
        Outcome::Failure(Failure::PadInclination { .. }) => (
            End::BeyondModel,
            "no law: loaded footpad inclined more than 65 deg".to_owned(),
        ),
        Outcome::Failure(failure) => (End::Failed, format!("failure: {failure}")),
        other => (End::Result, other.to_string()),
    }
}

#[cfg(test)]
#[path = "account_tests.rs"]
mod tests;
