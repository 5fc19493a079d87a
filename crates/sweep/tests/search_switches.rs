//! Skipping and interpolation find what the full scan and halving find, with fewer landings, where no
//! step of the scan holds more than one change.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::PathBuf;

use touchdown_dynamics::outcome::Class;
use touchdown_sweep::boundary::{Boundary, Extent};
use touchdown_sweep::certainty::Doubt;
use touchdown_sweep::design::Design;
use touchdown_sweep::findings::Finding;
use touchdown_sweep::grid::Grid;
use touchdown_sweep::levels::Levels;
use touchdown_sweep::refine::Refinement;
use touchdown_sweep::run::Workers;
use touchdown_sweep::scan::Scan;
use touchdown_sweep::sweep_file::{Job, Sweep};

/// A sweep of Phase II at some values of its axis.
fn sweep(name: &str, values: &[f64]) -> Sweep<3> {
    let sweeps = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps");
    let mut sweep: Sweep<3> = Sweep::read(&PathBuf::from(sweeps).join(name)).unwrap();
    let levels = Levels::list(values.to_vec()).unwrap();
    sweep.design = Design::Grid(Grid::new(vec![(levels, None)]).unwrap());
    sweep
}

fn search(sweep: &Sweep<3>, extent: Extent, scan: Scan, refinement: Refinement) -> Vec<Boundary> {
    let mut sweep = sweep.clone();
    let Job::Boundary(search) = &mut sweep.job else {
        panic!("the sweeps of Phase II ask for boundaries");
    };
    search.extent = extent;
    search.scan = scan;
    search.refinement = refinement;
    search.doubt = Doubt::None;
    let workers = Workers::start(None).unwrap();
    let points: Vec<usize> = (0..sweep.design.count()).collect();
    let boundary = |found| match found {
        Finding::Boundary(boundary) => boundary,
        _ => panic!("a boundary was asked"),
    };
    let found = workers.points(&sweep, &points).unwrap();
    found.into_iter().map(boundary).collect()
}

type Outline = Vec<(f64, f64, Class, Option<f64>)>;

fn outline(boundary: &Boundary) -> Outline {
    let bands = boundary.bands.iter();
    bands
        .map(|band| (band.from, band.to, band.class, band.bracket_width))
        .collect()
}

fn landings(boundaries: &[Boundary]) -> u64 {
    boundaries.iter().map(|boundary| boundary.landings).sum()
}

/// Toppling at all tipped and level orientations, re-entrant outcomes, bottoming struts.
fn sweeps() -> [Sweep<3>; 6] {
    [
        sweep("figure-4-09.toml", &[-20.0, 0.0, 5.0, 30.0, 60.0]),
        sweep("figure-4-11.toml", &[-10.0, 0.0, 10.0]),
        sweep("figure-4-15.toml", &[-50.0, 0.0]),
        sweep("figure-4-23.toml", &[-112.5, -67.5, 90.0]),
        sweep("figure-4-25.toml", &[37.5]),
        sweep("figure-4-06.toml", &[0.0, 60.0, 160.0]),
    ]
}

#[test]
fn all_bands_are_the_same() {
    let mut totals = [0, 0];
    for sweep in sweeps() {
        let plain = search(&sweep, Extent::All, Scan::Full, Refinement::Bisection);
        let quick = search(&sweep, Extent::All, Scan::Skipping, Refinement::Margin);
        let outlines = |found: &[Boundary]| found.iter().map(outline).collect::<Vec<_>>();
        assert_eq!(outlines(&quick), outlines(&plain), "{}", sweep.title);
        totals[0] += landings(&plain);
        totals[1] += landings(&quick);
    }
    assert!(5 * totals[1] < 3 * totals[0], "{totals:?}");
}

#[test]
fn first_transitions_are_the_same() {
    for sweep in sweeps() {
        let plain = search(&sweep, Extent::First, Scan::Full, Refinement::Bisection);
        let quick = search(&sweep, Extent::First, Scan::Skipping, Refinement::Margin);
        let transitions =
            |found: &[Boundary]| found.iter().map(|b| b.transition).collect::<Vec<_>>();
        assert_eq!(transitions(&quick), transitions(&plain), "{}", sweep.title);
        assert!(landings(&quick) < landings(&plain), "{}", sweep.title);
    }
}
