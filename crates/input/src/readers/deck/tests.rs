use super::*;
use crate::readers::vehicle_file::VehicleFile;
use std::path::Path;

/// The sample deck of 3.4.5, typed from the report, with a run stacked behind it.
const SAMPLE: &str = include_str!("sample_deck.txt");

fn read(text: &str) -> Result<Deck, InputError> {
    parse(&Place::file(Path::new("cards.txt")), text)
}

fn value(scene: &[(&str, f64)], name: &str) -> f64 {
    scene.iter().find(|(other, _)| *other == name).unwrap().1
}

#[test]
fn the_sample_deck_is_the_sample_vehicle_and_run() {
    let deck = read(SAMPLE).unwrap();
    assert_eq!(deck.runs.len(), 2);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("vehicle.toml");
    std::fs::write(&file, deck.vehicle(&deck.runs[0], "from cards")).unwrap();
    let converted = VehicleFile::read(&file).unwrap();
    let ours = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../sweeps/vehicles/surveyor-sample-deck.toml"
    );
    let ours = VehicleFile::read(Path::new(ours)).unwrap();
    assert_eq!(converted.vehicle, ours.vehicle);

    let scene = deck.runs[0].scene().unwrap();
    for (name, expected) in [
        ("vertical_velocity_fps", 14.24567),
        ("horizontal_velocity_fps", 9.27685),
        ("slope_deg", 15.0),
        ("friction", 0.8),
        ("pitch_deg", 5.0),
    ] {
        assert!((value(&scene, name) - expected).abs() < 1e-12, "{name}");
    }
    assert!((value(&scene, "cross_slope_deg").abs() - 180.0).abs() < 1e-12);
}

#[test]
fn a_stacked_run_tells_only_what_changes() {
    let deck = read(SAMPLE).unwrap();
    let scene = deck.runs[1].scene().unwrap();
    assert_eq!(value(&scene, "horizontal_velocity_fps"), 9.5);
    assert_eq!(value(&scene, "vertical_velocity_fps"), 14.0);
    assert_eq!(value(&scene, "cross_slope_deg"), 180.0);
    assert_eq!(value(&scene, "friction"), 0.8);
    assert_eq!(deck.runs[1].serial_number(), 5.0);
}

#[test]
fn velocities_in_vehicle_axes_are_turned() {
    // Phase 3, pitched by 90 deg: what was along y goes down.
    let card = |number: usize, fields: [&str; 5]| {
        let fields: String = fields.iter().map(|field| format!("{field:>12}")).collect();
        format!("{number:>7}     {fields}\n")
    };
    let extra = card(6, ["1.", "0.", "7.", "0.", ""])
        + &card(9, ["0.", "90.", "0.", "0.", "0."])
        + &card(11, ["8.", "6.", "3.", "", ""]);
    let deck = read(&(SAMPLE.to_owned() + &extra)).unwrap();
    let scene = deck.runs[2].scene().unwrap();
    assert!((value(&scene, "vertical_velocity_fps") - 7.0).abs() < 1e-12);
    assert!(value(&scene, "horizontal_velocity_fps").abs() < 1e-12);
}

#[test]
fn exponents_may_lack_their_letter() {
    let place = Place::file(Path::new("cards.txt"));
    for (text, expected) in [
        (".14222+03", 142.22),
        ("-.92769+01", -9.2769),
        ("1.5E-2", 0.015),
        ("1.5D+2", 150.0),
        ("", 0.0),
    ] {
        let found = number(&place, &format!("{text:>12}"), 0, 12).unwrap();
        assert!((found - expected).abs() < 1e-12, "{text}: {found}");
    }
}

#[test]
fn the_four_diagnostics_have_better_words() {
    let complaint = |from: &str, to: &str| {
        let changed = SAMPLE.replacen(from, to, 1);
        assert_ne!(changed, SAMPLE);
        read(&changed).unwrap_err().to_string()
    };
    // No. 1, first number out of range; 2 and 3, length of the list; 4, tables missing.
    let first = complaint("    11.000", "    41.000");
    assert!(
        first.contains("cards.txt:1") && first.contains("= 41"),
        "{first}"
    );
    let long = complaint("    11.000    14.000", "    11.000    94.000");
    assert!(long.contains("= 94") && long.contains("2 to 49"), "{long}");
    let none = complaint("    11.000    14.000", "    11.000     0.000");
    assert!(none.contains("= 0"), "{none}");
    let missing = complaint("    21.000", "    11.000");
    assert!(missing.contains("no block table of leg 1"), "{missing}");
    // And what the program left to its machine.
    let broken = complaint(".14222", ".1x222");
    assert!(
        broken.contains("cards.txt:16") && broken.contains("columns 25 to 36"),
        "{broken}"
    );
    let card = complaint("      1     ", "     77     ");
    assert!(card.contains("card number = 77"), "{card}");
    let without = complaint("      3     ", "      2     ");
    assert!(without.contains("card 3 is missing"), "{without}");
}
