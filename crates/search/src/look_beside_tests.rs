use std::cell::{Cell, RefCell};
use std::convert::Infallible;

use futures::executor::block_on;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::bands::first_transition_tests::SEARCH;
use crate::boundary::{Boundary, Extent};
use crate::certainty::Doubt;
use crate::refine::Refinement;
use crate::search_range::Scan;
use crate::trial::{Margins, Trial};
use crate::variation::Variation;

const CLOSER: Search = Search {
    parts_below: 2,
    ..SEARCH
};

/// The boundary of landings that topple at such speeds, and the speeds landed at. No margin decides.
fn found(search: Search, topples: impl Fn(f64) -> bool) -> (Boundary, Vec<f64>) {
    let speeds = RefCell::new(Vec::new());
    let found: Result<_, Infallible> = block_on(search.boundary(async |speed, _| {
        speeds.borrow_mut().push(speed);
        let class = match topples(speed) {
            true => Class::Unstable,
            false => Class::Stable,
        };
        Ok(Trial::example(class, 1))
    }));
    let Ok(boundary) = found;
    (boundary, speeds.into_inner())
}

#[test]
fn the_share_of_a_stretch_is_that_of_its_speeds() {
    let step = SEARCH.scan_step;
    // From 11.4 ft/s on, the lower part of every 30th of a scan step topples, up to two and a half steps above.
    for share in [0.2, 0.5, 0.8] {
        let topples = |speed: f64| {
            let parts = (speed - 11.4) * 30.0 / step;
            parts >= 75.0 || (parts >= 0.0 && parts.fract() < share)
        };
        let (boundary, _) = found(CLOSER, topples);
        let speed = boundary.transition.unwrap().speed();
        let patchy = boundary.patchy.unwrap();
        let [least, end] = [speed, patchy.to].map(|speed| (speed - 11.4) / step);
        assert!(
            least > -0.01 && least < 0.5 && end > 2.5 && end < 3.6,
            "{least} {end}"
        );
        let all = 10_000;
        let part = (patchy.to - speed) / f64::from(all);
        let count = (0..all)
            .filter(|index| topples(speed + part * (f64::from(*index) + 0.5)))
            .count();
        let expected = count as f64 / f64::from(all);
        let found = patchy.not_stable as f64 / patchy.landings as f64;
        // At 95 %.
        let scatter = 1.96 * (expected * (1.0 - expected) / patchy.landings as f64).sqrt();
        assert!((found - expected).abs() < scatter, "{found} {expected}");
    }
}

#[test]
fn a_sharp_transition_is_not_patchy_and_a_sliver_is() {
    let step = SEARCH.scan_step;
    for extent in [Extent::First, Extent::All] {
        let search = Search { extent, ..CLOSER };
        assert_eq!(found(search, |speed| speed >= 11.4).0.patchy, None);
        let sliver = [11.4, 11.4 + 0.7 * step];
        let (boundary, _) = found(search, |speed| speed >= sliver[0] && speed < sliver[1]);
        let patchy = boundary.patchy.unwrap();
        assert_eq!([patchy.landings, patchy.not_stable], [16, 11]);
        // Without the closer search nothing is looked at.
        let coarse = Search {
            parts_below: 1,
            ..search
        };
        assert_eq!(
            found(coarse, |speed| (11.4..11.5).contains(&speed))
                .0
                .patchy,
            None
        );
    }
}

#[test]
fn slivers_just_below_are_followed_down() {
    let step = SEARCH.scan_step;
    let part = step / 16.0;
    // Slivers as wide as the distance of landings, the next one always within a step.
    let starts = [11.4, 11.4 - 0.7 * step, 11.4 - 1.3 * step];
    let topples = |speed: f64| {
        speed >= 11.4 || { starts.iter() }
            .any(|start| (*start..start + 1.01 * part).contains(&speed))
    };
    let (boundary, _) = found(CLOSER, topples);
    let speed = boundary.transition.unwrap().speed();
    assert!((speed - starts[2]).abs() < SEARCH.tolerance, "{speed}");
    assert!(boundary.patchy.is_some());
}

#[test]
fn the_drawn_speed_lowers_a_transition_and_follows_from_the_lowest_landing() {
    // Topples at all speeds below 11.4 ft/s that are no parts of a scan step.
    let part = SEARCH.scan_step / 32.0;
    let topples = |speed: f64| {
        let parts = (speed - SEARCH.from) / part;
        speed >= 11.4 || (speed < 11.0 && (parts - parts.round()).abs() > 1e-6)
    };
    let (boundary, speeds) = found(CLOSER, topples);
    assert_eq!(boundary.checks.drawn.finds, 1);
    let drawn = *speeds
        .iter()
        .find(|speed| topples(**speed) && **speed < 11.0)
        .unwrap();
    assert!(boundary.transition.unwrap().speed() <= drawn);
    assert_eq!(found(CLOSER, topples).1, speeds);
    let (stable, _) = found(CLOSER, |_| false);
    assert_eq!(
        [stable.checks.drawn.checks, stable.checks.drawn.finds],
        [1, 0]
    );
    assert_eq!(stable.stable_below, stable.landings);
}

/// Landings that end otherwise at another tolerance are searched to an end, in whatever parts of a step.
#[test]
fn a_search_ends_however_the_tolerance_decides() {
    for (seed, extent) in (0..200).flat_map(|seed| [(seed, Extent::First), (seed, Extent::All)]) {
        let search = Search {
            extent,
            parts_below: 8,
            scan_looseness: 10.0,
            to: 14.0,
            scan: Scan::Skipping,
            refinement: Refinement::Margin,
            doubt: Doubt::Doubtful,
            ..SEARCH
        };
        let count = Cell::new(0);
        let landed: Result<_, Infallible> = block_on(search.boundary(async |speed, variation| {
            count.set(count.get() + 1);
            assert!(count.get() < 20_000, "no end with seed {seed}");
            let part = (speed / (0.17 * SEARCH.scan_step)) as u64;
            let is_loose = u64::from(variation != Variation::Unchanged);
            let seed = 1_000 * seed + 2 * part + is_loose;
            let chance: f64 = ChaCha8Rng::seed_from_u64(seed).random();
            let class = match chance * (speed - 9.0) / 2.0 {
                chance if chance > 0.7 => Class::Unstable,
                chance if chance > 0.6 => Class::Bottomed,
                _ => Class::Stable,
            };
            let toppling = match class {
                Class::Unstable => -0.1 * chance,
                _ => 0.1 * chance,
            };
            let margins = Margins {
                toppling: Some(toppling),
                bottoming: None,
            };
            Ok(Trial {
                margins,
                ..Trial::example(class, 1)
            })
        }));
        let Ok(boundary) = landed;
        assert!(boundary.transition.is_some());
        assert_eq!(boundary.landings, count.get());
    }
}
