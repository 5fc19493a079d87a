use super::super::checks::tests::{landed, settings};
use super::*;

const CHATTERING: Outcome = Outcome::Failure(Failure::Chattering);

#[test]
fn kinds_are_counted_and_the_extremes_are_kept() {
    let mut account = Account::of(&settings());
    let inclined = |leg| Outcome::Failure(Failure::PadInclination { leg });
    let mut long = landed(Outcome::Bottomed { leg: 2 }, 0.0);
    long.steps = 30;
    account.add(0, &landed(Outcome::Bottomed { leg: 0 }, -2e-3));
    account.add(1, &long);
    account.add(2, &landed(inclined(0), 50.0));
    account.add(3, &landed(CHATTERING, 0.0));
    assert_eq!(account.verdict(), None);
    let summary = account.summary();
    for line in [
        "50.0000 %  bottomed (2)",
        "25.0000 %  no law: loaded footpad inclined more than 65 deg (1)",
        "25.0000 %  failure: contact laws chatter without advancing in time (1)",
        "energy account open by at most 2.0e-5 of the energy involved (landing 0), 2.0e-5 in the median",
        "by at most 2.0e-3 ft lb, 2.0e-3 ft lb in the median",
        "at most 30 steps (landing 1)",
        "20 evaluations of the equations of motion on average",
    ] {
        assert!(summary.contains(line), "{line}: {summary}");
    }
    let kept: Vec<usize> = account.reasons().into_keys().collect();
    assert_eq!(kept, [0, 1, 2, 3]);
}

#[test]
fn a_landing_that_makes_no_sense_is_one_too_many() {
    let mut account = Account::of(&settings());
    let mut nowhere = landed(Outcome::UnstableYaw, 0.0);
    nowhere.min_clearance = f64::NAN;
    account.add(4, &nowhere);
    let verdict = account.verdict().unwrap();
    assert_eq!(verdict, "the results of 1 wild landing are invalid");
    let summary = account.summary();
    assert!(
        summary.contains("landing 4: min_clearance_ft is NaN"),
        "{summary}"
    );
    assert_eq!(account.reasons()[&4][0], "min_clearance_ft is NaN");
}

#[test]
fn failures_have_to_stay_rare() {
    let mut account = Account::of(&settings());
    for number in 0..500 {
        let outcome = match number % 100 {
            0 => CHATTERING,
            _ => Outcome::StableSubsided,
        };
        account.add(number, &landed(outcome, 0.0));
    }
    assert_eq!(account.verdict(), None);
    account.add(500, &landed(CHATTERING, 0.0));
    let verdict = account.verdict().unwrap();
    assert!(
        verdict.starts_with("6 wild landings ended without a result"),
        "{verdict}"
    );
    assert!(verdict.ends_with("at most 5 may"), "{verdict}");
}
