//! A transition on a knife edge of contact, which landings at 3e-5 misplace by more than their bracket.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::Path;

use touchdown_input::points::design::Design;
use touchdown_input::points::grid::Grid;
use touchdown_input::points::levels::Levels;
use touchdown_input::sweeps::sweep::Job;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::certainty::Certainty;
use touchdown_sweep::output::results;
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::Workers;

/// Tipped by 9 deg at an azimuth of 22.5 deg, level, cross-slope 180 deg: 11.4631 ft/s at 3e-5, converged 11.4668.
#[test]
fn a_disputed_transition_is_searched_again_until_it_holds_and_the_table_tells_how_tightly() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-23.toml");
    let mut sweep = Sweep::read(Path::new(path)).unwrap();
    let azimuths = Levels::list(vec![22.5, 45.0]).unwrap();
    sweep.design = Design::Grid(Grid::new(vec![(azimuths, None)]).unwrap());
    if let Job::Boundary(search) = &mut sweep.job {
        search.extent = Default::default();
    }
    let found = Workers::start(None)
        .unwrap()
        .points(&sweep, &[0, 1])
        .unwrap();
    let heading = results::heading(&sweep);
    let row = |point: usize| results::row(&sweep, point, &found[point]);
    let cell = |point: usize, column: &str| {
        let index = heading.iter().position(|one| one.name == column).unwrap();
        row(point)[index].to_string()
    };
    let transitions = found.iter().map(|finding| match finding {
        Finding::Boundary(boundary) => boundary.transition.unwrap(),
        other => panic!("a boundary was asked: {other:?}"),
    });
    let [resolved, ordinary] = transitions.collect::<Vec<_>>()[..] else {
        panic!("two points");
    };
    assert!((resolved.speed() - 11.4668).abs() < 5e-4, "{resolved:?}");
    assert_eq!(resolved.certainty, Certainty::Certain);
    assert!(resolved.high - resolved.low.unwrap() <= 0.001);
    assert!((1e-9..=1e-6).contains(&resolved.tolerance), "{resolved:?}");
    assert_eq!(
        cell(0, "solver_tolerance"),
        format!("{:e}", resolved.tolerance)
    );
    assert_eq!(cell(0, "certainty"), "certain");
    assert_eq!(ordinary.tolerance, 3e-5);
    assert_eq!(cell(1, "solver_tolerance"), "3e-5");
}
