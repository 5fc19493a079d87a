//! Bands narrower than the scan step are found by what landings on both sides of them tell: how close
//! a strut comes to its stop, and how little a landing topples.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::Path;

use touchdown_dynamics::outcome::Class;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::Boundary;
use touchdown_search::hidden_band_checks::CheckCounts;
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::Workers;

const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");

const SKIPPING: &str = "scan = \"skipping\"\nscan_looseness = 10\n";

/// All bands straight down a slope of 15 deg, searched by 0.25 ft/s with such a scan.
fn search(vertical_velocity: f64, roll: f64, scan: &str) -> Boundary {
    let conditions = format!("cross_slope_deg = 180\nvertical_velocity_fps = {vertical_velocity}");
    found(&conditions, roll, &format!("bands = \"all\"\n{scan}"))
}

/// The result of a search by 0.25 ft/s on a slope of 15 deg.
fn found(conditions: &str, roll: f64, search: &str) -> Boundary {
    let text = format!(
        "title = \"Bands\"\nvehicle = \"v.toml\"\n[scene]\nslope_deg = 15\nfriction = 1\n{conditions}\n\
         [axes]\nroll_deg = [{roll}]\n[search]\nfrom_fps = 0\nto_fps = 25\nscan_step_fps = 0.25\n\
         tolerance_fps = 0.001\n{search}"
    );
    let source = |path: &str, text: &str| Source {
        path: path.into(),
        text: text.to_owned(),
    };
    let sources = [source("s.toml", &text), source("v.toml", SURVEYOR)];
    let sweep: Sweep = Sweep::read_from(Path::new("s.toml"), Library::Copies(&sources)).unwrap();
    let found = Workers::start(None).unwrap().points(&sweep, &[0]).unwrap();
    match &found[0] {
        Finding::Boundary(boundary) => boundary.clone(),
        other => panic!("a boundary was asked: {other:?}"),
    }
}

/// Bands of a class narrower than half the scan step.
fn narrow(boundary: &Boundary, class: Class) -> Vec<[f64; 2]> {
    let bands = boundary.bands.iter();
    bands
        .filter(|band| band.class == class && band.to - band.from < 0.125)
        .map(|band| [band.from, band.to])
        .collect()
}

#[test]
fn a_strut_that_comes_close_to_its_stop_betrays_a_band_in_which_it_bottoms() {
    let found = search(18.0, 30.0, SKIPPING);
    assert_eq!(
        found.checks.stroke,
        CheckCounts {
            checks: 1,
            finds: 1
        }
    );
    let bands = narrow(&found, Class::Bottomed);
    assert!(
        matches!(bands[..], [[from, to]] if (15.5..15.66).contains(&from) && (15.66..15.75).contains(&to)),
        "{bands:?}"
    );
}

#[test]
fn a_vehicle_that_hardly_topples_betrays_a_band_in_which_it_does_not() {
    let full = search(14.0, 35.0, "");
    assert_eq!(full.checks.righting.finds, 1);
    for found in [full, search(14.0, 35.0, SKIPPING)] {
        let bands = narrow(&found, Class::Stable);
        let is_betrayed =
            |[from, to]: &[f64; 2]| (14.2..14.29).contains(from) && (14.29..14.5).contains(to);
        assert!(bands.iter().any(is_betrayed), "{bands:?}");
    }
}

/// The vehicle topples at 11.64 to 11.73 ft/s. At 10.75 and at 11.75 ft/s it keeps 23 and 12 deg; but the line through the
/// margins at 9.75 and 10.75 ft/s runs through zero between them.
#[test]
fn a_margin_that_runs_out_betrays_a_band_below_the_transition() {
    let first = |parts: u32| {
        let conditions = "cross_slope_deg = 147.5\nvertical_velocity_fps = 14";
        let search = format!("{SKIPPING}parts_below = {parts}");
        found(conditions, -25.0, &search)
    };
    let [coarse, close] = [1, 8].map(first);
    let speed = |boundary: &Boundary| boundary.transition.unwrap().speed();
    assert!((11.9..12.0).contains(&speed(&coarse)));
    assert!((11.62..11.66).contains(&speed(&close)));
    assert_eq!(close.checks.below.finds, 1);
    assert!(close.checks.below.checks < 25);
    // Of the half foot per second above it, 0.09 topple at its lower end and 0.19 at its upper one.
    let patchy = close.patchy.unwrap();
    assert!((12.13..12.16).contains(&patchy.to), "{patchy:?}");
    assert_eq!([patchy.landings, patchy.not_stable], [32, 18]);
    assert_eq!(coarse.patchy, None);
}
