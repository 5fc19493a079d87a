use super::*;
use crate::boundary::Extent;
use crate::certainty::Doubt;
use crate::landings_on_request::at_once;
use crate::refine::Refinement;
use crate::trial::{Margins, Trial};
use futures::executor::block_on;

const SEARCH: Search = Search {
    from: 0.0,
    to: 25.0,
    scan_step: 0.25,
    parts_below: 1,
    tolerance: 0.001,
    extent: Extent::All,
    scan: Scan::Skipping,
    scan_looseness: 1.0,
    refinement: Refinement::Margin,
    doubt: Doubt::None,
    kept: 0.0,
};

fn landing(speed: f64, trial: Trial) -> Sample {
    Sample {
        trial,
        ..Sample::example(speed, 1.0)
    }
}

/// Scans landings with a duration and class for each speed; returns them.
fn samples(search: Search, to_first: bool, land: impl Fn(f64) -> (f64, Class)) -> Vec<Sample> {
    let sample = at_once(|speed| {
        let (duration, class) = land(speed);
        let mut trial = Trial {
            duration,
            ..Trial::example(class, 1)
        };
        trial.margins.bottoming = Some(0.5);
        trial.margins.toppling = Some(if class == Class::Stable { 0.9 } else { -0.9 });
        landing(speed, trial)
    });
    block_on(search.scanned(to_first, &sample)).unwrap()
}

/// Speeds of such a scan.
fn scan(search: Search, to_first: bool, land: impl Fn(f64) -> (f64, Class)) -> Vec<f64> {
    let samples = samples(search, to_first, land).into_iter();
    samples.map(|sample| sample.speed).collect()
}

#[test]
fn a_full_scan_takes_every_step_up_to_what_it_looks_for() {
    let full = Search {
        scan: Scan::Full,
        ..SEARCH
    };
    let topples_at_10 = |v: f64| {
        let class = if v < 10.0 {
            Class::Stable
        } else {
            Class::Unstable
        };
        (0.5, class)
    };
    assert_eq!(scan(full, false, topples_at_10).len(), 101);
    assert_eq!(scan(full, true, topples_at_10).len(), 41);
}

#[test]
fn quiet_stretches_are_passed_over_and_changes_found_in_the_same_step() {
    let land = |v: f64| match v {
        v if v < 10.0 => (0.5, Class::Stable),
        v if v < 11.4 => (3.0, Class::Stable),
        v if v < 12.0 => (3.0, Class::Unstable),
        _ => (1.0, Class::Unstable),
    };
    let speeds = scan(SEARCH, false, land);
    assert!(speeds.len() < 40, "{}", speeds.len());
    for step in 40..=48 {
        assert!(speeds.contains(&(0.25 * f64::from(step))), "{step}");
    }
    assert_eq!(speeds.last(), Some(&25.0));
    let first = scan(SEARCH, true, land);
    assert!(first.contains(&11.25) && first.contains(&11.5));
    assert_eq!(first.last(), Some(&12.0));
}

/// Margins that may fall to zero between two landings are followed, however soon those end.
#[test]
fn small_margins_are_not_passed_over() {
    let count = |margin: f64| {
        let sample = at_once(|speed| {
            let mut trial = Trial::example(Class::Stable, 1);
            trial.duration = 0.5;
            trial.margins.bottoming = Some(0.5);
            trial.margins.toppling = Some(margin);
            landing(speed, trial)
        });
        let samples = block_on(SEARCH.scanned(false, &sample)).unwrap();
        samples.len()
    };
    // A margin of 0.2 rad² is passed over where landings are less than 2 ft/s apart.
    assert_eq!([0.9, 0.21, 0.02].map(count), [8, 14, 101]);
}

#[test]
fn long_landings_are_never_passed_over() {
    assert_eq!(scan(SEARCH, false, |_| (3.0, Class::Stable)).len(), 101);
    let odd = Search { to: 1.1, ..SEARCH };
    assert_eq!(scan(odd, false, |_| (3.0, Class::Stable)).len(), 6);
    assert_eq!(scan(odd, false, |_| (1.0, Class::Stable)), [0.0, 1.1]);
}

#[test]
fn landings_next_to_a_stop_and_failures_are_never_passed_over() {
    let count = |to_first, class, margin| {
        let sample = at_once(|speed| {
            let mut trial = Trial::example(class, 1);
            trial.duration = 0.5;
            trial.margins.bottoming = Some(margin);
            trial.margins.toppling = Some(0.9);
            landing(speed, trial)
        });
        let samples = block_on(SEARCH.scanned(to_first, &sample)).unwrap();
        samples.len()
    };
    for class in [Class::Stable, Class::Unstable, Class::Bottomed] {
        // 0.04 of the stroke is enough where landings are less than 1.33 ft/s apart, 0.007 nowhere.
        for (margin, landings) in [(0.06, 8), (0.04, 26), (0.007, 101), (-0.04, 26), (-0.06, 8)] {
            assert_eq!(
                count(false, class, margin),
                landings,
                "{class:?} at {margin}"
            );
        }
    }
    // To the first transition 0.04 is enough where they are 2 ft/s apart.
    for (margin, landings) in [(0.06, 8), (0.04, 14), (0.004, 101)] {
        assert_eq!(count(true, Class::Stable, margin), landings, "{margin}");
    }
    let fails = |_| (0.5, Class::Failure);
    assert_eq!(scan(SEARCH, false, fails).len(), 101);
}

/// Struts on both sides of a stop are never clear of it.
#[test]
fn landings_on_both_sides_of_a_stop_are_not_passed_over() {
    let trials = [0.045, -0.045, 0.06].map(|bottoming| {
        let margins = Margins {
            toppling: Some(0.9),
            bottoming: Some(bottoming),
        };
        Trial {
            margins,
            ..Trial::example(Class::Stable, 1)
        }
    });
    let clear = |a: usize, b: usize| are_clear([&trials[a], &trials[b]], 0.03);
    assert!(clear(0, 0) && clear(1, 1) && clear(0, 2));
    assert!(!clear(0, 1));
}

/// If only the first transition is sought, long landings on a line with their neighbours are skipped.
#[test]
fn long_landings_on_a_line_are_passed_over_below_the_first_transition() {
    let count = |to_first, bend: f64| {
        let sample = at_once(|speed: f64| {
            let mut trial = Trial::example(Class::Stable, 1);
            trial.duration = 3.0;
            trial.least_angle = 0.5 - 0.01 * speed - bend * speed * speed;
            trial.margins = Margins {
                toppling: Some(0.9),
                bottoming: Some(0.5),
            };
            landing(speed, trial)
        });
        let samples = block_on(SEARCH.scanned(to_first, &sample)).unwrap();
        samples.len()
    };
    // Eight at strides of 4 ft/s, and one in the middle of each; the last stride is shorter.
    assert_eq!(count(true, 0.0), 15);
    assert_eq!(count(false, 0.0), 101);
    // A bend of 0.08 rad over 4 ft/s is one of 0.005 rad over 1 ft/s; one of 4 rad shows in every step.
    assert_eq!(count(true, 0.02), 51);
    assert_eq!(count(true, 1.0), 101);
}

#[test]
fn what_is_left_out_is_what_a_full_scan_takes_more() {
    let land = |v: f64| match v {
        v if v < 8.0 => (0.5, Class::Stable),
        v if v < 9.6 => (3.0, Class::Stable),
        _ => (1.0, Class::Unstable),
    };
    for to in [25.0, 24.9, 10.0, 7.0] {
        for to_first in [false, true] {
            let skipping = Search { to, ..SEARCH };
            let scan = Scan::Full;
            let full = samples(Search { scan, ..skipping }, to_first, land).len();
            let samples = samples(skipping, to_first, land);
            let left_out = full as i64 - samples.len() as i64;
            assert_eq!(skipping.left_out(to_first, &samples), left_out);
        }
    }
}
