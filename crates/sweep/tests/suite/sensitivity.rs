//! Derivatives of the transition velocity: against differences of ordinary sweeps, and against what
//! symmetry and the scaling of forces demand of them.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::Path;

use touchdown_input::documents::library::{Library, Source};
use touchdown_input::sweeps::overrides::Overrides;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::sensitivity::{Dependence, Slope};
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::Workers;

const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
/// The same without products of inertia: its right side is the mirror image of its left.
const MIRRORED: &str = include_str!("../../../../sweeps/vehicles/surveyor-no-products.toml");

const CONDITIONS: [(&str, f64); 5] = [
    ("vertical_velocity_fps", 14.0),
    ("cross_slope_deg", 180.0),
    ("slope_deg", 15.0),
    ("friction", 1.0),
    ("roll_deg", 5.0),
];
/// What the solver leaves open of a transition around 11 ft/s at the customary tolerance, ft/s.
const SCATTER: f64 = 3e-5 * 11.0;

/// A sweep over the values of one axis.
fn sweep(vehicle: &str, axis: &str, values: &[f64], bracket: f64) -> Sweep {
    let scene: String = CONDITIONS
        .iter()
        .filter(|(name, _)| *name != axis)
        .map(|(name, value)| format!("{name} = {value}\n"))
        .collect();
    let text = format!(
        "title = \"Straight downhill\"\nvehicle = \"v.toml\"\n[scene]\n{scene}[axes]\n\
         {axis} = {values:?}\n[search]\nfrom_fps = 10\nto_fps = 13\nscan_step_fps = 0.25\n\
         tolerance_fps = {bracket}\nrefinement = \"margin\"\n"
    );
    let source = |path: &str, text: &str| Source {
        path: path.into(),
        text: text.to_owned(),
    };
    let sources = [source("s.toml", &text), source("v.toml", vehicle)];
    Sweep::read_from(Path::new("s.toml"), Library::Copies(&sources)).unwrap()
}

/// What is found at the first points.
fn find(sweep: &Sweep, points: usize) -> Vec<Finding> {
    let points: Vec<usize> = (0..points).collect();
    Workers::start(None)
        .unwrap()
        .points(sweep, &points)
        .unwrap()
}

/// Dependences at a roll angle, deg, one for each parameter.
fn slopes(vehicle: &str, roll: f64, parameters: &[&str]) -> Vec<Slope> {
    let overrides = Overrides {
        sensitivity: parameters.iter().map(|name| (*name).to_owned()).collect(),
        ..Overrides::default()
    };
    let sweep = sweep(vehicle, "roll_deg", &[roll], 1e-3);
    match find(&sweep.with(&overrides).unwrap(), 1).remove(0) {
        Finding::Sensitive { sensitivity, .. } => sensitivity.slopes,
        other => panic!("{other:?}"),
    }
}

/// Derivative and error of a dependence that is smooth.
fn derivative(slope: &Slope) -> [f64; 2] {
    match slope.dependence {
        Dependence::Smooth { derivative, error } => [derivative, error],
        other => panic!("{other:?}"),
    }
}

#[test]
fn derivatives_are_differences_of_ordinary_sweeps() {
    let cases = [
        ("friction", 1.0, 0.03),
        ("vehicle.strut.compression_damping", 54.0, 1.5),
        ("slope_deg", 15.0, 0.8),
    ];
    let found = slopes(SURVEYOR, 5.0, &cases.map(|(name, ..)| name));
    for ((name, value, reach), slope) in cases.into_iter().zip(&found) {
        let ends = sweep(SURVEYOR, name, &[value - reach, value + reach], 1e-5);
        let speeds: Vec<f64> = find(&ends, 2)
            .iter()
            .map(|found| found.boundary().unwrap().transition.unwrap().speed())
            .collect();
        let direct = (speeds[1] - speeds[0]) / (2.0 * reach);
        let [found, error] = derivative(slope);
        let known = error + SCATTER / reach;
        assert!((found - direct).abs() <= known, "{name}: {found} {direct}");
        assert!(known < 0.1 * direct.abs(), "{name}: {found} ± {error}");
    }
}

/// A CG on the centreline has an offset of 0, and so have products of inertia of a lander with mirrored sides.
#[test]
fn lengths_and_products_of_inertia_that_are_zero_have_a_derivative_too() {
    let cases = [
        ("vehicle.center_of_gravity_offset_y_ft", 0.05, 0.1),
        ("vehicle.inertia_slug_ft2.xy", 2.0, 3e-3),
    ];
    let found = slopes(MIRRORED, 5.0, &cases.map(|(name, ..)| name));
    for ((name, reach, most), slope) in cases.into_iter().zip(&found) {
        let ends = sweep(MIRRORED, &format!("{name:?}"), &[-reach, reach], 1e-5);
        let speeds: Vec<f64> = find(&ends, 2)
            .iter()
            .map(|found| found.boundary().unwrap().transition.unwrap().speed())
            .collect();
        let direct = (speeds[1] - speeds[0]) / (2.0 * reach);
        let [found, error] = derivative(slope);
        let known = error + SCATTER / reach;
        assert!(
            (found - direct).abs() <= known,
            "{name}: {found} {direct} ± {known}"
        );
        assert!(
            known < most && most < found.abs(),
            "{name}: {found} ± {known}"
        );
    }
}

/// Straight downhill at roll 0, legs 2 and 3 of a lander without products of inertia are mirror images,
/// and nothing is gained by turning to either side. Legs together do what all do.
#[test]
fn mirrored_legs_weigh_alike_and_all_together_as_much_as_the_whole() {
    let own = |leg: usize| format!("vehicle.legs[{leg}].strut.spring_constant_lb_per_ft");
    let [first, second, third] = [own(1), own(2), own(3)];
    let all = "vehicle.strut.spring_constant_lb_per_ft";
    let found = slopes(
        MIRRORED,
        0.0,
        &[all, &first, &second, &third, "cross_slope_deg"],
    );
    let [all, first, second, third, across] = [0, 1, 2, 3, 4].map(|i| derivative(&found[i]));
    let near = |a: f64, b: f64, error: f64| assert!((a - b).abs() <= error, "{a} {b} ± {error}");
    near(second[0], third[0], second[1] + third[1]);
    let parts = [first, second, third];
    let sum: f64 = parts.iter().map(|part| part[0]).sum();
    let error: f64 = parts.iter().map(|part| part[1]).sum();
    near(all[0], sum, all[1] + error);
    assert!(all[1] + error < 0.3 * all[0], "{all:?} {parts:?}");
    near(across[0], 0.0, across[1]);
}

/// Masses and forces all multiplied by one factor leave the motion as it is: what V_H gains by each, for
/// the same part of it, adds up to nothing (Euler's theorem on homogeneous functions).
#[test]
fn what_all_masses_and_forces_do_adds_up_to_nothing() {
    let parameters = [
        ("vehicle.mass_slug", 20.0),
        ("vehicle.inertia_slug_ft2.xx", 138.12),
        ("vehicle.inertia_slug_ft2.yy", 134.29),
        ("vehicle.inertia_slug_ft2.zz", 145.78),
        ("vehicle.inertia_slug_ft2.xy", 6.81),
        ("vehicle.inertia_slug_ft2.xz", -5.87),
        ("vehicle.inertia_slug_ft2.yz", 2.57),
        ("vehicle.linkage.inertia_slug_ft2", 1.347),
        ("vehicle.strut.structural_stiffness_lb_per_ft", 1e5),
        ("vehicle.strut.preload_lb", 185.0),
        ("vehicle.strut.spring_constant_lb_per_ft", 3600.0),
        ("vehicle.strut.compression_damping", 54.0),
        ("vehicle.strut.rebound_damping", 864.0),
        ("vehicle.footpad.crush_pressure_psf", 1578.8),
        ("vehicle.footpad.inertia_slug_ft2", 0.00373),
        ("vehicle.block.crush_pressure_psf", 5425.6),
    ];
    let found = slopes(SURVEYOR, 5.0, &parameters.map(|(name, _)| name));
    let [mut sum, mut error, mut size] = [0.0; 3];
    for ((_, value), slope) in parameters.iter().zip(&found) {
        let [derivative, uncertain] = derivative(slope).map(|number| number * value);
        sum += derivative;
        size += derivative.abs();
        error += uncertain.abs();
    }
    assert!(sum.abs() <= error, "{sum} ± {error} of {size}");
    assert!(error < 0.1 * size, "{error} of {size}");
}

/// At 14.3 ft/s downward a lower band of toppling landings begins.
#[test]
fn a_boundary_that_jumps_has_no_derivative() {
    let found = slopes(
        SURVEYOR,
        0.0,
        &["vertical_velocity_fps", "angular_velocity_x_dps"],
    );
    assert_eq!(found[0].dependence, Dependence::Jumps);
    assert!(found[0].step.unwrap() > 0.3);
    assert!(derivative(&found[1])[0].is_finite());
}
