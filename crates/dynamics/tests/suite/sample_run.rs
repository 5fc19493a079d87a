//! The sample run of 3.4.5. Its 1966 printout lies on a knife-edge of the listing's crush rule:
//! converged, the landing takes the other branch; under the section rule it is near the print.

use crate::common::{reference, sample_deck, scenes, settings};
use touchdown_dynamics::land::land;
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::scene::{CrushRule, Settings};

#[test]
fn converged_branch() {
    let landing = land(
        &sample_deck(),
        &scenes::sample_run(),
        &settings(Settings::DEFAULT_TOLERANCE),
    );
    let rows = reference("sample-1966.csv");
    let expected = |quantity: &str| {
        rows.iter()
            .find(|row| row.text("quantity") == quantity)
            .unwrap_or_else(|| panic!("no row {quantity}"))
            .text("converged_listing_rule")
            .to_string()
    };
    assert_eq!(landing.outcome.to_string(), expected("outcome"));
    let energies = &landing.energies;
    // The file's sum over the elements knows no losses in the stops; the balance does.
    let stops: f64 = energies.legs.iter().map(|leg| leg.stop).sum();
    // The limits are half a unit of the last digit of the file, but the end time's 1e-3 s for what
    // changes with it and 0.01 deg for the angle, as everywhere.
    for (quantity, value, limit) in [
        ("end_time_s", landing.end_time, 1e-3),
        (
            "min_stability_angle_deg",
            landing.min_stability_angle.to_degrees(),
            0.01,
        ),
        ("min_clearance_ft", landing.min_clearance, 5e-6),
        (
            "initial_kinetic_energy_ftlb",
            energies.initial_kinetic,
            5e-4,
        ),
        (
            "potential_energy_change_ftlb",
            energies.potential_change,
            5e-3,
        ),
        (
            "dissipated_energy_ftlb",
            energies.dissipated() - stops,
            5e-3,
        ),
        ("final_kinetic_energy_ftlb", energies.final_kinetic, 5e-3),
        ("pad_contact_2_s", landing.pad_contact[1].unwrap(), 1e-5),
        ("pad_contact_3_s", landing.pad_contact[2].unwrap(), 1e-5),
        ("block_contact_2_s", landing.block_contact[1].unwrap(), 1e-5),
        ("block_contact_3_s", landing.block_contact[2].unwrap(), 1e-5),
    ] {
        let expected: f64 = expected(quantity).parse().unwrap();
        println!("{quantity}: {value} for {expected}");
        assert!(
            (value - expected).abs() <= limit,
            "{quantity}: {value} instead of {expected}"
        );
    }
    assert!(landing.block_contact[0].is_none());
}

#[test]
fn near_the_print_under_the_section_rule() {
    let settings = Settings::new(
        Settings::DEFAULT_TOLERANCE,
        Settings::DEFAULT_TIME_LIMIT,
        CrushRule::Section,
    )
    .unwrap();
    let landing = land(&sample_deck(), &scenes::sample_run(), &settings);
    assert_eq!(landing.outcome, Outcome::StableRockback);
    let angle = landing.min_stability_angle.to_degrees();
    println!("end {} s, angle {angle} deg", landing.end_time);
    assert!(
        (landing.end_time - 2.8166).abs() < 1e-3,
        "{}",
        landing.end_time
    );
    assert!((angle - 14.21).abs() < 0.01, "{angle}");
}
