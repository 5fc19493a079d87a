use super::*;
use crate::certainty::{Doubt, LEAST_LANDINGS};
use crate::refine::Refinement;
use crate::search_range::{Extent, Scan};
use crate::trial::{Sample, Trial};
use futures::executor::block_on;
use std::convert::Infallible;
use touchdown_dynamics::outcome::Class;

pub(crate) const SEARCH: Search = Search {
    from: 0.0,
    to: 25.0,
    scan_step: 0.25,
    parts_below: 1,
    tolerance: 0.001,
    extent: Extent::First,
    scan: Scan::Full,
    scan_looseness: 1.0,
    refinement: Refinement::Bisection,
    doubt: Doubt::None,
    kept: 0.0,
};

fn find(search: Search, class: impl Fn(f64) -> Class) -> Boundary {
    let found: Result<_, Infallible> =
        block_on(search.boundary(async |speed, _| Ok(Trial::example(class(speed), 10))));
    match found {
        Ok(boundary) => boundary,
    }
}

#[test]
fn single_boundary_is_bracketed_within_tolerance() {
    let boundary = find(SEARCH, |v| {
        if v < 11.4 {
            Class::Stable
        } else {
            Class::Unstable
        }
    });
    let found = boundary.transition.unwrap();
    assert_eq!(found.to, Class::Unstable);
    let low = found.low.unwrap();
    assert!(low < 11.4 && 11.4 <= found.high);
    assert!(found.high - low <= 0.001);
    assert_eq!(
        (boundary.landings, boundary.checks.all().checks),
        (47 + 8 + 2, 1)
    );
    assert_eq!(boundary.evaluations, 570);
    assert!(boundary.landings <= SEARCH.most_landings());
}

#[test]
fn re_entrant_outcomes_give_the_first_change() {
    let boundary = find(SEARCH, |v| match v {
        v if v < 12.1 => Class::Stable,
        v if v < 16.3 => Class::Unstable,
        v if v < 20.0 => Class::Stable,
        _ => Class::Bottomed,
    });
    let found = boundary.transition.unwrap();
    assert_eq!(found.to, Class::Unstable);
    assert!((found.speed() - 12.1).abs() <= 0.0005);
}

#[test]
fn class_is_that_of_the_final_upper_end() {
    // The scan meets toppling at 12.25, but bottoming comes first.
    let boundary = find(SEARCH, |v| match v {
        v if v < 12.1 => Class::Stable,
        v if v < 12.2 => Class::Bottomed,
        _ => Class::Unstable,
    });
    assert_eq!(boundary.transition.unwrap().to, Class::Bottomed);
}

#[test]
fn not_stable_at_the_start_is_a_transition_there() {
    let boundary = find(SEARCH, |_| Class::Failure);
    let found = boundary.transition.unwrap();
    assert_eq!(
        (found.to, found.low, found.high),
        (Class::Failure, None, 0.0)
    );
    assert_eq!((found.speed(), boundary.landings), (0.0, 1));
}

#[test]
fn none_when_all_is_stable_and_the_upper_end_is_looked_at() {
    assert_eq!(find(SEARCH, |_| Class::Stable).transition, None);
    let odd = Search { to: 1.1, ..SEARCH };
    assert_eq!(odd.scan_count(), 6);
    assert_eq!(odd.scan_speed(5), 1.1);
    let boundary = find(odd, |v| {
        if v < 1.05 {
            Class::Stable
        } else {
            Class::Unstable
        }
    });
    assert!((boundary.transition.unwrap().speed() - 1.05).abs() <= 0.0005);
}

#[test]
fn stops_when_told_to() {
    let landings = std::cell::Cell::new(0);
    let stopped = block_on(SEARCH.boundary(async |_, _| {
        landings.set(landings.get() + 1);
        if landings.get() > 3 {
            Err("stop")
        } else {
            Ok(Trial::example(Class::Stable, 1))
        }
    }));
    assert_eq!((stopped, landings.get()), (Err("stop"), 4));
}

#[test]
fn a_transition_that_margins_make_certain_is_counted_as_untested() {
    let find = |doubt| {
        let search = Search { doubt, ..SEARCH };
        let land =
            async |speed, _| Ok::<_, Infallible>(Sample::example(speed, 1.4 - 0.1 * speed).trial);
        let Ok(found) = block_on(search.boundary(land));
        found
    };
    let [all, doubtful] = [Doubt::All, Doubt::Doubtful].map(find);
    assert_eq!(all.transition, doubtful.transition);
    assert_eq!((all.tests, doubtful.tests), (2, 0));
    assert_eq!((all.skipped.untested, doubtful.skipped.untested), (0, 1));
    assert_eq!(all.landings - doubtful.landings, LEAST_LANDINGS);
}
