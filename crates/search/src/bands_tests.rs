use super::*;
use crate::boundary::Extent;
use crate::certainty::Doubt;
use crate::refine::Refinement;
use crate::scan::Scan;
use crate::trial::Margins;
use futures::executor::block_on;
use futures::future::poll_fn;
use std::cell::Cell;
use std::convert::Infallible;
use std::task::Poll;
use touchdown_dynamics::outcome::{Class, Outcome};

const SEARCH: Search = Search {
    from: 0.0,
    to: 25.0,
    scan_step: 0.25,
    parts_below: 1,
    tolerance: 0.001,
    extent: Extent::All,
    scan: Scan::Full,
    scan_looseness: 1.0,
    refinement: Refinement::Bisection,
    doubt: Doubt::None,
    kept: 0.0,
};

fn survey(class: impl Fn(f64) -> Class) -> Boundary {
    let Ok(found) = block_on(
        SEARCH.boundary(async |speed, _| Ok::<_, Infallible>(Trial::example(class(speed), 10))),
    );
    found
}

fn re_entrant(v: f64) -> Class {
    match v {
        v if v < 12.1 => Class::Stable,
        v if v < 16.3 => Class::Unstable,
        v if v < 20.0 => Class::Stable,
        _ => Class::Bottomed,
    }
}

#[test]
fn bands_cover_the_range_without_gaps() {
    let found = survey(re_entrant);
    let classes: Vec<Class> = found.bands.iter().map(|band| band.class).collect();
    assert_eq!(
        classes,
        [
            Class::Stable,
            Class::Unstable,
            Class::Stable,
            Class::Bottomed
        ]
    );
    assert_eq!((found.bands[0].from, found.bands[3].to), (0.0, 25.0));
    for (pair, at) in found.bands.windows(2).zip([12.1, 16.3, 20.0]) {
        assert_eq!(pair[0].to, pair[1].from);
        assert!((pair[0].to - at).abs() <= 0.0005, "{pair:?}");
        assert!(pair[0].bracket.unwrap().width <= 0.001);
    }
    assert_eq!(found.bands[3].bracket, None);
    assert_eq!(found.bands[1].outcome, Outcome::UnstablePitch);
    assert_eq!(
        (found.landings, found.checks.gaps.checks),
        (101 + 3 * (8 + 2), 3)
    );
}

#[test]
fn first_transition_is_the_same_in_both_extents() {
    let first = Search {
        extent: Extent::First,
        ..SEARCH
    };
    let Ok(alone) = block_on(
        first.boundary(async |speed, _| Ok::<_, Infallible>(Trial::example(re_entrant(speed), 10))),
    );
    assert_eq!(survey(re_entrant).transition, alone.transition);
    assert!(alone.bands.is_empty());
}

#[test]
fn a_third_class_inside_a_bracket_is_a_band_of_its_own() {
    let found = survey(|v| match v {
        v if v < 12.1 => Class::Stable,
        v if v < 12.2 => Class::Bottomed,
        _ => Class::Unstable,
    });
    assert_eq!(found.bands.len(), 3);
    let bottomed = &found.bands[1];
    assert_eq!(bottomed.class, Class::Bottomed);
    assert!((bottomed.from - 12.1).abs() <= 0.0005 && (bottomed.to - 12.2).abs() <= 0.0005);
    assert_eq!(found.transition.unwrap().to, Class::Bottomed);
}

#[test]
fn a_band_narrower_than_the_scan_step_is_found_by_its_dip() {
    let angle = |v: f64| 0.2 * ((v - 13.1).abs() - 0.02);
    let Ok(found) = block_on(SEARCH.boundary(async |speed, _| {
        let class = if angle(speed) > 0.0 {
            Class::Stable
        } else {
            Class::Unstable
        };
        let least_angle = angle(speed).max(0.0);
        let margins = Margins {
            toppling: Some(least_angle * least_angle),
            bottoming: None,
        };
        Ok::<_, Infallible>(Trial {
            least_angle,
            margins,
            ..Trial::example(class, 1)
        })
    }));
    assert_eq!(found.checks.toppling.finds, 1);
    assert!(found.checks.all().checks <= 5, "{:?}", found.checks);
    let band = &found.bands[1];
    assert!((band.from - 13.08).abs() <= 0.0005 && (band.to - 13.12).abs() <= 0.0005);
    assert!((found.transition.unwrap().speed() - 13.08).abs() <= 0.0005);
}

#[test]
fn one_class_is_one_band_and_not_stable_at_the_start_a_transition_there() {
    let found = survey(|_| Class::Failure);
    assert_eq!(found.bands.len(), 1);
    assert_eq!((found.bands[0].from, found.bands[0].to), (0.0, 25.0));
    let transition = found.transition.unwrap();
    assert_eq!((transition.low, transition.high), (None, 0.0));
    assert_eq!(survey(|_| Class::Stable).transition, None);
}

/// Yields once.
async fn later() {
    let mut has_waited = false;
    let wait = poll_fn(|context| {
        if has_waited {
            return Poll::Ready(());
        }
        has_waited = true;
        context.waker().wake_by_ref();
        Poll::Pending
    });
    wait.await;
}

#[test]
fn a_search_asks_for_many_landings_at_once_but_not_all_and_finds_the_same() {
    let margin = |v: f64| (v - 12.1) * (v - 16.3) * (v - 20.0) * -0.01;
    for (scan, scan_step) in [
        (Scan::Full, 0.25),
        (Scan::Skipping, 0.25),
        (Scan::Full, 0.01),
    ] {
        let search = Search {
            scan,
            scan_step,
            doubt: Doubt::All,
            scan_looseness: 10.0,
            ..SEARCH
        };
        let trial = |speed: f64| Sample::example(speed, margin(speed)).trial;
        let [waiting, most] = [Cell::new(0), Cell::new(0)];
        let Ok(found) = block_on(search.boundary(async |speed, _| {
            waiting.set(waiting.get() + 1);
            most.set(most.get().max(waiting.get()));
            later().await;
            waiting.set(waiting.get() - 1);
            Ok::<_, Infallible>(trial(speed))
        }));
        let Ok(alone) =
            block_on(search.boundary(async |speed, _| Ok::<_, Infallible>(trial(speed))));
        assert_eq!(found, alone);
        assert_eq!(found.bands.len(), 4);
        // Not of more at once for a finer scan: each takes room.
        assert!((7..=32).contains(&most.get()), "{}", most.get());
    }
}
