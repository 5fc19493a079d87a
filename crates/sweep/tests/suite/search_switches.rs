//! With every skip a search finds what it finds without any, with fewer landings, where no step of the
//! scan holds more than one change. The whole level-vehicle grid: `crates/lab/scripts/skips.py`.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::{Path, PathBuf};

use touchdown_dynamics::outcome::Class;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::points::design::Design;
use touchdown_input::points::grid::Grid;
use touchdown_input::points::levels::Levels;
use touchdown_input::sweeps::sweep_file::{Job, Sweep};
use touchdown_search::boundary::{Boundary, Extent};
use touchdown_search::certainty::{Certainty, Doubt};
use touchdown_search::refine::Refinement;
use touchdown_search::scan::Scan;
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::Workers;

/// A sweep of Phase II at some values of its axis.
fn sweep(name: &str, values: &[f64]) -> Sweep {
    let sweeps = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps");
    let mut sweep: Sweep = Sweep::read(&PathBuf::from(sweeps).join(name)).unwrap();
    let levels = Levels::list(values.to_vec()).unwrap();
    sweep.design = Design::Grid(Grid::new(vec![(levels, None)]).unwrap());
    sweep
}

/// Where struts begin to bottom, at one cross-slope and roll (deg) and vertical velocities (ft/s).
fn strut_stops(cross_slope: f64, roll: f64, vertical_velocities: &[f64]) -> Sweep {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../crates/lab/sweeps/strut-stops.toml"
    );
    let mut sweep: Sweep = Sweep::read(&PathBuf::from(path)).unwrap();
    let axes = [&[cross_slope], &[roll], vertical_velocities]
        .map(|values| (Levels::list(values.to_vec()).unwrap(), None));
    sweep.design = Design::Grid(Grid::new(axes.to_vec()).unwrap());
    sweep
}

/// What a search does to be quick.
#[derive(Clone, Copy)]
struct Skips {
    scan: Scan,
    scan_looseness: f64,
    refinement: Refinement,
    doubt: Doubt,
}

const NONE: Skips = Skips {
    scan: Scan::Full,
    scan_looseness: 1.0,
    refinement: Refinement::Bisection,
    doubt: Doubt::All,
};
const ALL: Skips = Skips {
    scan: Scan::Skipping,
    scan_looseness: 10.0,
    refinement: Refinement::Margin,
    doubt: Doubt::Doubtful,
};

fn search(sweep: &Sweep, extent: Extent, skips: Skips) -> Vec<Boundary> {
    let mut sweep = sweep.clone();
    let Job::Boundary(search) = &mut sweep.job else {
        panic!("the sweeps of Phase II ask for boundaries");
    };
    search.extent = extent;
    search.scan = skips.scan;
    search.scan_looseness = skips.scan_looseness;
    search.refinement = skips.refinement;
    search.doubt = skips.doubt;
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
        .map(|band| {
            (
                band.from,
                band.to,
                band.class,
                band.bracket.map(|bracket| bracket.width),
            )
        })
        .collect()
}

/// Transitions by their margins are called certain without a test; any other is tested alike.
fn agree(quick: Certainty, plain: Certainty) -> bool {
    quick == plain || quick == Certainty::Certain
}

fn landings(boundaries: &[Boundary]) -> u64 {
    boundaries.iter().map(|boundary| boundary.landings).sum()
}

/// Toppling at all tipped and level orientations, re-entrant outcomes, bottoming struts.
fn sweeps() -> [Sweep; 6] {
    [
        sweep("figure-4-09.toml", &[-20.0, 30.0, 60.0]),
        sweep("figure-4-11.toml", &[10.0]),
        sweep("figure-4-15.toml", &[-50.0, 0.0]),
        sweep("figure-4-23.toml", &[90.0]),
        sweep("figure-4-25.toml", &[37.5]),
        sweep("figure-4-06.toml", &[0.0, 160.0]),
    ]
}

#[test]
fn all_bands_are_the_same() {
    let mut totals = [0, 0];
    for sweep in sweeps() {
        let plain = search(&sweep, Extent::All, NONE);
        let quick = search(&sweep, Extent::All, ALL);
        let outlines = |found: &[Boundary]| found.iter().map(outline).collect::<Vec<_>>();
        assert_eq!(outlines(&quick), outlines(&plain), "{}", sweep.title);
        let pairs = quick.iter().zip(&plain);
        for (quick, plain) in pairs.flat_map(|(quick, plain)| quick.bands.iter().zip(&plain.bands))
        {
            assert!(agree(quick.certainty, plain.certainty), "{quick:?}");
        }
        totals[0] += landings(&plain);
        totals[1] += landings(&quick);
    }
    assert!(4 * totals[1] < 3 * totals[0], "{totals:?}");
}

/// Stable landings between landings that just bottom a strut, as those do between stable ones: neither tells of the
/// other by its angle or by how soon it ends.
#[test]
fn bands_between_landings_next_to_a_stop_are_not_passed_over() {
    let sweep = strut_stops(60.0, 30.0, &[19.0]);
    let scan = Skips {
        refinement: Refinement::Bisection,
        doubt: Doubt::None,
        ..NONE
    };
    let [plain, quick] = [Scan::Full, Scan::Skipping]
        .map(|kind| search(&sweep, Extent::All, Skips { scan: kind, ..scan }));
    let outlines = |found: &[Boundary]| found.iter().map(outline).collect::<Vec<_>>();
    assert_eq!(outlines(&quick), outlines(&plain));
    let is_between = |bands: &[(f64, f64, Class, Option<f64>)]| {
        let classes = [0, 1, 2].map(|k| bands[k].2);
        classes == [Class::Bottomed, Class::Stable, Class::Bottomed]
    };
    assert!(outline(&plain[0]).windows(3).any(is_between));
    assert!(landings(&quick) < landings(&plain));
}

#[test]
fn first_transitions_are_the_same() {
    for sweep in sweeps() {
        let [plain, quick] = [NONE, ALL].map(|skips| {
            let doubt = Doubt::None;
            search(&sweep, Extent::First, Skips { doubt, ..skips })
        });
        let transitions =
            |found: &[Boundary]| found.iter().map(|b| b.transition).collect::<Vec<_>>();
        assert_eq!(transitions(&quick), transitions(&plain), "{}", sweep.title);
        assert!(landings(&quick) < landings(&plain), "{}", sweep.title);
    }
}

/// What a search with every skip finds, to the bit, of a vehicle with this gravity and a scene with this line.
fn found_in_gravity(of_vehicle: &str, of_scene: &str) -> Vec<Vec<u8>> {
    const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
    let vehicle = SURVEYOR.replace("gravity_fps2 = 5.31", of_vehicle);
    assert_ne!(vehicle, SURVEYOR);
    let text = format!(
        "title = \"Downhill\"\nvehicle = \"v.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
         cross_slope_deg = 180\nslope_deg = 15\nfriction = 1\n{of_scene}\n[axes]\nroll_deg = [0, 25, 50]\n\
         [search]\nfrom_fps = 2\nto_fps = 20\nscan_step_fps = 0.5\ntolerance_fps = 0.01\nbands = \"all\"\n\
         scan = \"skipping\"\nscan_looseness = 10\nrefinement = \"margin\"\n"
    );
    let source = |path: &str, text: String| Source {
        path: path.into(),
        text,
    };
    let sources = [source("s.toml", text), source("v.toml", vehicle)];
    let sweep = Sweep::read_from(Path::new("s.toml"), Library::Copies(&sources)).unwrap();
    let found = Workers::start(None).unwrap().points(&sweep, &[0, 1, 2]);
    let found = found.unwrap();
    let skipped = |found: &Finding| found.boundary().unwrap().skipped;
    assert!(found.iter().any(|found| skipped(found).left_out > 0));
    assert!(found.iter().any(|found| skipped(found).interpolated > 0));
    found.iter().map(Finding::encode).collect()
}

/// Margins are told by the gravity in which the vehicle falls, wherever it stands.
#[test]
fn gravity_of_the_scene_is_searched_as_that_of_the_vehicle() {
    let of_scene = found_in_gravity("gravity_fps2 = 0.5", "gravity_fps2 = 12.5");
    assert_eq!(of_scene, found_in_gravity("gravity_fps2 = 12.5", ""));
    let by_name = found_in_gravity("gravity_fps2 = 0.5", "gravity = \"mars\"");
    assert_eq!(by_name, found_in_gravity("gravity_mps2 = 3.71", ""));
    assert_ne!(of_scene, by_name);
}
