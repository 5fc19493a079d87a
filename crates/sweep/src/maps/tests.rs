//! Maps of known surfaces.

use touchdown_input::points::grid::Grid;
use touchdown_input::points::levels::Levels;
use touchdown_input::points::refined_grid::{MapRules, RefinedGrid};

use crate::journal::shard::Shard;
use crate::maps::height::Height;
use crate::maps::resampled::Resampled;
use crate::maps::rounds::Rounds;
use crate::maps::surface_pieces::MapSurface;

/// Four by four cells of ten units, with sides divided down to an eighth of a unit or less.
fn grid(rules: MapRules) -> RefinedGrid {
    let axis = || (Levels::range(0.0, 40.0, 10.0).unwrap(), None);
    let first = Grid::new(vec![axis(), axis()]).unwrap();
    RefinedGrid::new(first, &[(0, 64), (1, 64)], rules).unwrap()
}

const RULES: MapRules = MapRules {
    error: 0.05,
    jump: 0.3,
    budget: None,
    grid_steps: 16,
};

/// A bowl that ends on a circle about (18, 21) and steps up beyond a slanting line.
fn bowl([x, y]: [f64; 2]) -> Option<f64> {
    let radius = from_middle([x, y]);
    let step = if beyond_line([x, y]) > 0.0 { 1.0 } else { 0.0 };
    (radius < RIM).then_some(11.0 + 0.004 * radius * radius + step)
}

const RIM: f64 = 15.3;

fn from_middle([x, y]: [f64; 2]) -> f64 {
    (x - 18.0).hypot(y - 21.0)
}

fn beyond_line([x, y]: [f64; 2]) -> f64 {
    (y - 22.3 - 0.4 * (x - 18.0)) / 1.0f64.hypot(0.4)
}

/// Refines until no points are wanted; returns the points in the order of the requests.
fn refine(rounds: &mut Rounds, surface: impl Fn([f64; 2]) -> Option<f64>) -> Vec<usize> {
    let mut asked = Vec::new();
    loop {
        let round = rounds.next_round();
        if round.is_empty() {
            return asked;
        }
        for point in &round {
            let at = rounds.map().coordinates(*point);
            let speed = surface([at[0], at[1]]);
            rounds.learn_height(*point, Height { speed, bands: 0 }, 10);
        }
        asked.extend(round);
    }
}

#[test]
fn a_bowl_is_known_within_the_error_and_its_edges_within_their_width() {
    let grid = grid(RULES);
    let mut rounds = Rounds::new(&grid, Shard::WHOLE);
    let points = refine(&mut rounds, bowl).len();
    // As fine a grid as the edges would have four times 64 by 64 places and more.
    assert!((100..900).contains(&points), "{points}");
    let surface = &MapSurface::all(&rounds)[0];
    let mut near_edges = 0;
    for place in surface.resampled() {
        let [rim, line] = [from_middle(place.at) - RIM, beyond_line(place.at)];
        if rim.abs() < 0.3 || line.abs() < 0.3 {
            near_edges += 1;
            continue;
        }
        match (bowl(place.at), place.speed) {
            (Some(expected), Some(found)) => {
                assert!(
                    (expected - found).abs() < 3.0 * RULES.error,
                    "{place:?}: {expected}"
                );
            }
            (None, None) => {}
            (expected, _) => panic!("{place:?}: {expected:?}"),
        }
    }
    assert!(near_edges < 600, "{near_edges}");
    let edges = surface.edges();
    let mut lengths = [0.0, 0.0];
    for edge in &edges {
        let kind = edge.kind.name();
        let off = |at: [f64; 2]| match kind {
            "end" => from_middle(at) - RIM,
            _ => beyond_line(at),
        };
        for point in &edge.points {
            assert!(off(point.at).abs() < 0.3, "{kind} {point:?}");
        }
        for ends in edge.points.windows(2) {
            let [a, b] = [ends[0].at, ends[1].at];
            let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
            assert!(off(middle).abs() < 0.4, "{kind} {middle:?}");
            lengths[usize::from(kind == "jump")] += (a[0] - b[0]).hypot(a[1] - b[1]);
        }
    }
    let around = 2.0 * std::f64::consts::PI * RIM;
    assert!((lengths[0] / around - 1.0).abs() < 0.05, "{lengths:?}");
    assert!((20.0..32.0).contains(&lengths[1]), "{lengths:?}");
}

#[test]
fn shards_want_together_what_the_whole_map_wants() {
    let grid = grid(RULES);
    let mut whole = refine(&mut Rounds::new(&grid, Shard::WHOLE), bowl);
    let mut together = Vec::new();
    for number in 1..=3 {
        let shard = Shard::new(number, 3).unwrap();
        together.extend(refine(&mut Rounds::new(&grid, shard), bowl));
    }
    whole.sort_unstable();
    together.sort_unstable();
    together.dedup();
    assert_eq!(whole, together);
}

#[test]
fn a_plane_takes_nothing_but_the_middles_of_its_cells() {
    let grid = grid(RULES);
    let mut rounds = Rounds::new(&grid, Shard::WHOLE);
    let points = refine(&mut rounds, |[x, y]| Some(11.0 + 0.1 * x - 0.2 * y));
    assert_eq!(points.len(), 5 * 5 + 4 * 4);
    let surface = &MapSurface::all(&rounds)[0];
    assert_eq!(surface.resampled().len(), 65 * 65);
    assert!(surface.edges().is_empty());
}

/// A surface that curves, with no edge.
fn dome([x, y]: [f64; 2]) -> Option<f64> {
    let [u, v] = [x - 17.0, y - 23.0];
    Some(12.0 + 0.003 * u * u - 0.002 * v * v + 0.001 * u * v)
}

#[test]
fn between_points_the_surface_follows_its_curvature() {
    let grid = grid(RULES);
    let mut rounds = Rounds::new(&grid, Shard::WHOLE);
    refine(&mut rounds, dome);
    let surface = &MapSurface::all(&rounds)[0];
    let off = |place: &Resampled| (place.speed.unwrap() - dome(place.at).unwrap()).abs();
    let curved = surface.resampled().iter().map(off).fold(0.0, f64::max);
    let flat = surface.parts.iter().flat_map(|part| &part.pieces);
    let sides = |[a, b, c]: [crate::maps::pieces::Corner; 3]| [[a, b], [b, c]];
    let flat = flat.flat_map(|piece| piece.triangles().flat_map(sides));
    let flat = flat.map(|[a, b]| {
        let at = surface.coordinates(crate::maps::cell::middle(a.at, b.at));
        (0.5 * (a.speed + b.speed) - dome(at).unwrap()).abs()
    });
    let flat = flat.fold(0.0, f64::max);
    // A quarter is left of what planes are off by.
    assert!(curved < 0.3 * flat, "{curved}, {flat}");
}

#[test]
fn a_budget_ends_the_refinement_and_goes_where_errors_are() {
    let rules = |budget| MapRules {
        error: 0.0,
        budget: Some(budget),
        ..RULES
    };
    let points = |budget| {
        let grid = grid(rules(budget));
        let mut rounds = Rounds::new(&grid, Shard::WHOLE);
        let points = refine(&mut rounds, bowl);
        assert_eq!(rounds.landings(), 10 * points.len() as u64);
        let at = |point: &usize| grid.coordinates(*point);
        points.iter().map(at).collect::<Vec<_>>()
    };
    let found = points(2000);
    assert_eq!(found.len(), 200);
    let outside = found
        .iter()
        .filter(|at| from_middle([at[0], at[1]]) > 1.5 * RIM);
    assert!(outside.count() < 40);
    // The first level is computed whatever the budget.
    assert_eq!(points(1).len(), 25);
}

#[test]
fn cells_coarser_than_asked_are_counted() {
    let error = 0.002;
    let coarse = |budget| {
        let rules = MapRules {
            error,
            budget,
            ..RULES
        };
        let grid = grid(rules);
        let mut rounds = Rounds::new(&grid, Shard::WHOLE);
        refine(&mut rounds, dome);
        rounds.coarse_cells()
    };
    // All middles are known: corners are higher on average by (0.003 - 0.002) · 5².
    let ended = coarse(Some(410));
    assert_eq!([ended.cells, ended.coarse], [16; 2]);
    assert!((ended.worst - 0.025).abs() < 1e-9, "{ended:?}");
    let whole = coarse(None);
    assert_eq!([whole.coarse as f64, whole.worst], [0.0; 2]);
    assert!(whole.cells > 16);
    // Without their middles nothing is known of them.
    assert_eq!(coarse(Some(1)).coarse, 16);
}

#[test]
fn a_larger_budget_shows_no_worse_edge() {
    let wrong = |budget| {
        let grid = grid(MapRules {
            error: 0.02,
            budget: Some(budget),
            ..RULES
        });
        let mut rounds = Rounds::new(&grid, Shard::WHOLE);
        refine(&mut rounds, bowl);
        let is_wrong = |place: &Resampled| {
            let is_near = (from_middle(place.at) - RIM).abs() < 0.3;
            !is_near && bowl(place.at).is_some() != place.speed.is_some()
        };
        let places = MapSurface::all(&rounds)[0].resampled();
        places.iter().filter(|place| is_wrong(place)).count()
    };
    // From where the sides of the first level have been searched.
    let counts: Vec<usize> = (12..50).map(|hundreds| wrong(100 * hundreds)).collect();
    assert!(counts.is_sorted_by(|a, b| a >= b), "{counts:?}");
    assert_eq!(counts.last(), Some(&0));
}
