//! Bands narrower than the scan step are found by what landings on both sides of them tell: how close
//! a strut comes to its stop, and how little a landing topples.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::Path;

use touchdown_dynamics::outcome::Class;
use touchdown_sweep::boundary::Boundary;
use touchdown_sweep::findings::Finding;
use touchdown_sweep::hidden_band_checks::CheckCounts;
use touchdown_sweep::library::{Library, Source};
use touchdown_sweep::run::Workers;
use touchdown_sweep::sweep_file::Sweep;

const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");

const SKIPPING: &str = "scan = \"skipping\"\nscan_looseness = 10\n";

/// All bands straight down a slope of 15 deg, searched by 0.25 ft/s with such a scan.
fn search(vertical_velocity: f64, roll: f64, scan: &str) -> Boundary {
    let text = format!(
        "title = \"Straight downhill\"\nvehicle = \"v.toml\"\n[scene]\nslope_deg = 15\n\
         friction = 1\ncross_slope_deg = 180\nvertical_velocity_fps = {vertical_velocity}\n[axes]\n\
         roll_deg = [{roll}]\n[search]\nfrom_fps = 0\nto_fps = 25\nscan_step_fps = 0.25\n\
         tolerance_fps = 0.001\nbands = \"all\"\n{scan}"
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
        assert!(
            matches!(bands[..], [[from, to]] if (14.2..14.29).contains(&from) && (14.29..14.5).contains(&to)),
            "{bands:?}"
        );
    }
}
