use std::cell::RefCell;
use std::convert::Infallible;

use super::*;
use crate::bands::first_transition_tests::SEARCH;
use crate::boundary::{Boundary, Extent};
use crate::trial::Trial;
use futures::executor::block_on;

/// Searches landings that topple over a `width` from a speed that depends on the tolerance, with no telling margins;
/// returns the boundary and the tolerances used.
fn find(extent: Extent, from: impl Fn(f64, f64) -> f64, width: f64) -> (Boundary, Vec<f64>) {
    let search = Search {
        extent,
        doubt: Doubt::Doubtful,
        ..SEARCH
    };
    let seen = RefCell::new(Vec::new());
    let land = async |speed: f64, variation| {
        let (tolerance, tilt) = match variation {
            Variation::At { tolerance, tilt } => (tolerance, tilt),
            _ => (3e-5, 0.0),
        };
        if !seen.borrow().contains(&tolerance) {
            seen.borrow_mut().push(tolerance);
        }
        let from = from(tolerance, tilt);
        let class = match (from..from + width).contains(&speed) {
            true => Class::Unstable,
            false => Class::Stable,
        };
        let trial = Trial::example(class, 1);
        Ok::<_, Infallible>(Trial { tolerance, ..trial })
    };
    let Ok(found) = block_on(search.boundary(land));
    (found, seen.into_inner())
}

#[test]
fn a_bracket_beside_the_transition_is_found_again_at_the_first_tolerance_that_holds() {
    for extent in [Extent::First, Extent::All] {
        // Off by 0.03 ft/s at 3e-5, by 0.003 at 1e-6, then by less than a bracket.
        let (found, tolerances) = find(extent, |tolerance, _| 11.4 + 1e3 * tolerance, 5.0);
        let transition = found.transition.unwrap();
        assert_eq!(transition.certainty, Certainty::Certain);
        assert!(tolerances.contains(&1e-6), "{tolerances:?}");
        assert!(transition.tolerance < 1e-6, "{transition:?}");
        assert!((transition.speed() - 11.4).abs() < 1e-3, "{transition:?}");
        assert!(transition.high - transition.low.unwrap() <= SEARCH.tolerance);
        assert_eq!(found.disputed, 0);
        // The upper end of the toppling band moves as much.
        let changes = if extent == Extent::All { 2 } else { 1 };
        assert_eq!(found.searched_again, changes);
        if let [below, above, _] = found.bands.as_slice() {
            assert_eq!((below.to, above.from), (transition.speed(), below.to));
            assert_eq!(below.bracket.unwrap().tolerance, transition.tolerance);
            assert!((above.to - 16.4).abs() < 1e-3);
        }
    }
}

#[test]
fn what_the_tolerance_does_not_move_is_not_searched_again() {
    let (found, tolerances) = find(Extent::All, |_, _| 11.4, 5.0);
    assert_eq!(tolerances, [3e-5, 0.1 * 3e-5]);
    assert_eq!((found.searched_again, found.disputed), (0, 0));
    assert_eq!(found.transition.unwrap().tolerance, 3e-5);
}

#[test]
fn what_a_tilt_moves_at_every_tolerance_is_disputed_with_its_interval() {
    let (found, tolerances) = find(Extent::All, |_, tilt| 11.4 + 1e4 * tilt, 5.0);
    let transition = found.transition.unwrap();
    let Certainty::Disputed([low, high]) = transition.certainty else {
        panic!("{transition:?}");
    };
    assert!(low <= 11.4 && 11.41 <= high, "{low} to {high}");
    assert!(high - low < 0.05, "{low} to {high}");
    assert_eq!(transition.tolerance, 1e-9);
    assert!(tolerances.contains(&1e-9));
    assert_eq!((found.searched_again, found.disputed), (2, 2));
}

#[test]
fn a_band_that_vanishes_at_tighter_tolerances_stays_disputed() {
    // A sliver of two landings of the lattice, which no tilt moves.
    let width = 0.002;
    let (found, _) = find(
        Extent::All,
        |tolerance, _| if tolerance < 1e-5 { 99.0 } else { 11.249 },
        width,
    );
    assert_eq!(found.bands.len(), 3);
    assert_eq!((found.searched_again, found.disputed), (0, 2));
}

#[test]
fn no_speed_is_kept_twice_where_a_bracket_ends_at_a_landing_of_the_scan() {
    let scanned = [(10.0, 1.0), (11.0, 1.0), (12.0, -1.0), (13.0, -1.0)]
        .map(|(speed, margin)| Sample::example(speed, margin));
    let again = |index: usize| {
        let mut sample = scanned[index].clone();
        sample.trial.tolerance = 1e-6;
        sample
    };
    let test = Tested {
        ends: Some([again(1), again(2)]),
        certainty: Certainty::Certain,
        is_spared: false,
        landings: 2,
        evaluations: 2,
    };
    let kept = with_brackets(&[&scanned[..2], &scanned[2..]], &[test]);
    let [first, .., last] = scanned.clone();
    assert_eq!(kept, [first, again(1), again(2), last]);
}
