use super::*;
use crate::landings_on_request::at_once;
use crate::trial::Trial;
use futures::executor::block_on;

const HALVINGS: usize = 8;

/// Bracket of the change between 0 and 0.25, and the number of landings.
fn bracket(refinement: Refinement, sample: impl Fn(f64) -> Sample) -> ([f64; 2], usize) {
    let narrowing = Narrowing {
        refinement,
        tolerance: 0.001,
        to_all: true,
    };
    let (low, high) = (sample(0.0), sample(0.25));
    let land = at_once(&sample);
    let narrowed = block_on(narrowing.between(&low, &high, &land)).unwrap();
    let mut samples = narrowed.samples;
    assert!(narrowed.ends.is_empty());
    let landings = samples.len() - 2 * narrowed.checks.checks as usize;
    let interpolated = match refinement {
        Refinement::Bisection => 0,
        Refinement::Margin => HALVINGS as i64 - landings as i64,
    };
    assert_eq!(narrowed.interpolated, interpolated);
    samples.extend([low, high]);
    samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    let mut changes = samples
        .windows(2)
        .filter(|pair| pair[0].class() != pair[1].class());
    let change = changes.next().unwrap();
    assert!(changes.next().is_none());
    ([change[0].speed, change[1].speed], landings)
}

/// The bracket is the same by both methods; landings that interpolation took.
fn both(margin: impl Fn(f64) -> f64) -> usize {
    let sample = |speed| Sample::example(speed, margin(speed));
    let (halved, landings) = bracket(Refinement::Bisection, sample);
    assert_eq!(landings, HALVINGS);
    let (interpolated, landings) = bracket(Refinement::Margin, sample);
    assert_eq!(interpolated, halved);
    landings
}

#[test]
fn a_straight_margin_takes_the_two_ends_of_the_bracket() {
    for at in 1..250 {
        let place = 0.001 * f64::from(at);
        assert!(both(|v| place - v) <= 2, "{place}");
        assert!(both(|v| v - place) <= 2, "{place}");
    }
}

#[test]
fn bent_margins_take_few_landings_and_jumps_no_more_than_the_slack() {
    for at in 1..250 {
        let place = 0.001 * f64::from(at);
        assert!(both(|v| (place - v) * (1.0 + 3.0 * v)) <= 5, "{place}");
        let kinked = |v: f64| (place - v) * if v < place { 1.0 } else { 3.0 };
        let jumping = |v: f64| if v < place { 0.04 - 0.1 * v } else { -0.3 };
        for landings in [both(kinked), both(jumping)] {
            assert!(landings <= HALVINGS + SLACK as usize, "{place}");
        }
    }
}

#[test]
fn landings_without_a_margin_are_halved() {
    let sample = |speed: f64| Sample {
        trial: Trial::example(Sample::example(speed, 0.1 - speed).class(), 1),
        ..Sample::example(speed, 0.0)
    };
    let halved = bracket(Refinement::Bisection, sample);
    assert_eq!(bracket(Refinement::Margin, sample), halved);
}

#[test]
fn an_irregular_interval_is_looked_at_again() {
    // Topples from 0.04 to 0.16 and from 0.2 on; the first guess falls between.
    let margin = |v: f64| match v {
        v if v < 0.04 => 0.2,
        v if v < 0.16 => -0.1,
        v if v < 0.2 => 0.05,
        _ => -0.05,
    };
    for refinement in [Refinement::Margin, Refinement::Bisection] {
        let narrowing = Narrowing {
            refinement,
            tolerance: 0.001,
            to_all: true,
        };
        let land = at_once(|speed| Sample::example(speed, margin(speed)));
        let (low, high) = (Sample::example(0.0, 0.2), Sample::example(0.25, -0.05));
        let narrowed = block_on(narrowing.between(&low, &high, &land)).unwrap();
        let mut samples = narrowed.samples;
        samples.extend([low, high]);
        samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        let mut changes = samples
            .windows(2)
            .filter(|pair| pair[0].class() != pair[1].class());
        assert!((changes.next().unwrap()[0].speed - 0.04).abs() < 0.001);
    }
}

/// Scan landings at the ends of a change are computed again if the change lies next to them, and only then.
#[test]
fn ends_of_a_scan_are_landed_at_again_beside_a_change() {
    let ends_at = |place: f64, loose_place: f64| {
        let narrowing = Narrowing {
            refinement: Refinement::Margin,
            tolerance: 0.001,
            to_all: true,
        };
        let [low, high] = [0.0, 0.25].map(|speed| Sample {
            is_loose: true,
            ..Sample::example(speed, loose_place - speed)
        });
        let land = at_once(|speed| Sample::example(speed, place - speed));
        let narrowed = block_on(narrowing.between(&low, &high, &land)).unwrap();
        let ends = narrowed.ends.iter();
        ends.map(|end| (end.speed, end.class())).collect::<Vec<_>>()
    };
    let (stable, unstable) = (Class::Stable, Class::Unstable);
    assert_eq!(ends_at(0.1, 0.1), []);
    assert_eq!(ends_at(0.1, 0.2), []);
    assert_eq!(ends_at(0.0005, 0.1), [(0.0, stable)]);
    assert_eq!(ends_at(-0.1, 0.1), [(0.0, unstable)]);
    assert_eq!(ends_at(0.3, 0.1), [(0.25, stable)]);
}
