//! Maps over one axis with known bands.

use touchdown_dynamics::outcome::Class;
use touchdown_input::points::grid::Grid;
use touchdown_input::points::levels::Levels;
use touchdown_input::points::refined_grid::{MapRules, RefinedGrid};

use crate::journal::shard::Shard;
use crate::maps::edges::{EdgeKind, of_profiles};
use crate::maps::height::{Height, SpeedBands};
use crate::maps::rounds::Rounds;

/// Four intervals of ten units, divided down to 10/64 of a unit.
fn grid(rules: MapRules) -> RefinedGrid {
    let axis = (Levels::range(0.0, 40.0, 10.0).unwrap(), None);
    RefinedGrid::new(Grid::new(vec![axis]).unwrap(), &[(0, 64)], rules).unwrap()
}

const RULES: MapRules = MapRules {
    error: 0.02,
    jump: 0.3,
    budget: None,
    grid_steps: 1,
};

/// Places where the transition jumps, where a stable band begins above it, and where both end.
const JUMP: f64 = 7.3;
const BAND: f64 = 18.9;
const END: f64 = 31.7;

fn transition(x: f64) -> f64 {
    11.0 + 0.004 * (x - 15.0) * (x - 15.0) + if x < JUMP { 1.0 } else { 0.0 }
}

fn bands(x: f64) -> SpeedBands {
    let (stable, unstable) = (Class::Stable, Class::Unstable);
    let from = transition(x);
    match x {
        x if x > END => SpeedBands::new(&[stable], &[]),
        x if x > BAND => {
            let transitions = [from, from + 1.0, 18.0 + 0.01 * x * x];
            SpeedBands::new(&[stable, unstable, stable, unstable], &transitions)
        }
        _ => SpeedBands::new(&[stable, unstable], &[from]),
    }
}

/// Refines until no points are wanted or the budget is spent, at ten landings a point; returns the points in the order
/// of the requests.
fn refine(rounds: &mut Rounds) -> Vec<usize> {
    let mut asked = Vec::new();
    loop {
        let round = rounds.next_round();
        if round.is_empty() {
            return asked;
        }
        for point in &round {
            let x = rounds.map().coordinates(*point)[0];
            let height = Height {
                speed: (x <= END).then(|| transition(x)),
                bands: 0,
            };
            rounds.learn_height(*point, height, 10);
            rounds.learn_bands(*point, bands(x));
        }
        asked.extend(round);
    }
}

/// Known places, in order.
fn known(rounds: &Rounds) -> Vec<f64> {
    let points = rounds.points().into_iter();
    points
        .map(|point| rounds.map().coordinates(point)[0])
        .collect()
}

#[test]
fn transitions_are_known_within_the_error_and_edges_within_their_width() {
    let grid = grid(RULES);
    let mut rounds = Rounds::new(&grid, Shard::WHOLE);
    refine(&mut rounds);
    let known = known(&rounds);
    assert!(known.len() < 60, "{}", known.len());
    for pair in known.windows(2) {
        let [low, high] = [bands(pair[0]), bands(pair[1])];
        let halfway = bands(0.5 * (pair[0] + pair[1])).off_halfway(&low, &high);
        let is_edge = low.leap(&high) > RULES.jump && pair[1] - pair[0] < 0.4;
        // What is known in the middle is within the error, and a parabola is four times as close to its halves.
        assert!(
            halfway < 0.3 * RULES.error || is_edge,
            "{pair:?}: {halfway}"
        );
    }
    let edges: Vec<_> = of_profiles(&rounds).collect();
    let expected = [
        (JUMP, EdgeKind::Jump),
        (BAND, EdgeKind::Bands),
        (END, EdgeKind::End),
    ];
    assert_eq!(edges.len(), expected.len(), "{edges:?}");
    for ((map, edge), (at, kind)) in edges.into_iter().zip(expected) {
        assert_eq!((map, edge.kind), (0, kind));
        assert!((edge.at - at).abs() < edge.within, "{edge:?}");
        assert!(edge.within < 0.2, "{edge:?}");
        let [low, high] = edge.speeds;
        assert!(
            low < high || kind == EdgeKind::End && high.is_none(),
            "{edge:?}"
        );
    }
}

#[test]
fn a_budget_goes_where_the_transitions_bend_and_end() {
    let budget = Some(250);
    let grid = grid(MapRules {
        budget,
        error: 0.0,
        ..RULES
    });
    let mut rounds = Rounds::new(&grid, Shard::WHOLE);
    refine(&mut rounds);
    assert!(
        (200..=260).contains(&rounds.landings()),
        "{}",
        rounds.landings()
    );
    // Beyond the end there is nothing to be found.
    let beyond = known(&rounds).iter().filter(|x| **x > END + 2.0).count();
    assert!(beyond <= 3, "{beyond}");
}

#[test]
fn shards_want_together_what_the_whole_map_wants() {
    let grid = grid(RULES);
    let mut whole = refine(&mut Rounds::new(&grid, Shard::WHOLE));
    let mut together = Vec::new();
    for number in 1..=3 {
        let shard = Shard::new(number, 3).unwrap();
        together.extend(refine(&mut Rounds::new(&grid, shard)));
    }
    whole.sort_unstable();
    together.sort_unstable();
    together.dedup();
    assert_eq!(whole, together);
}
