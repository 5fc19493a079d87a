use super::*;
use std::path::Path;

const TEXT: &str = "\
mass_slug = 20
[strut]
preload_lb = 185
damping = 54
[[legs]]
azimuth_deg = 0
[legs.strut]
damping = -60
";
const ROOT: [&str; 3] = ["mass_slug", "strut", "legs"];
const STRUT: [&str; 2] = ["preload_lb", "damping"];

fn document(text: &str) -> Document {
    Document::parse(Path::new("v.toml"), text).unwrap()
}

#[test]
fn upper_layer_wins_and_lower_fills_in() {
    let document = document(TEXT);
    let root = Section::root(&document, &ROOT).unwrap();
    let leg = &root.sections("legs", &["azimuth_deg", "strut"]).unwrap()[0];
    let strut = leg.over(&root).section("strut", &STRUT).unwrap();
    assert_eq!(strut.number("damping").unwrap(), -60.0);
    assert_eq!(strut.number("preload_lb").unwrap(), 185.0);
}

#[test]
fn physics_complaints_find_the_line_of_their_key() {
    let document = document(TEXT);
    let root = Section::root(&document, &ROOT).unwrap();
    let leg = root.sections("legs", &["azimuth_deg", "strut"]).unwrap()[0].over(&root);
    let damping = leg.complain(&Invalid::new("strut.damping", -60.0, "a finite number ≥ 0"));
    assert_eq!(
        damping.to_string(),
        "v.toml:8: legs[1].strut.damping = -60: expected a finite number ≥ 0"
    );
    let preload = leg.complain(&Invalid::new("strut.preload_lb", 185.0, "less"));
    assert_eq!(
        preload.to_string(),
        "v.toml:3: strut.preload_lb = 185: expected less"
    );
    let derived = root.complain(&Invalid::new("mass_slug (of leg 1)", -1.0, "more"));
    assert_eq!(
        derived.to_string(),
        "v.toml:1: mass_slug (of leg 1) = -1: expected more"
    );
}

#[test]
fn unknown_missing_and_mistyped_keys_are_named() {
    let document = document("[strut]\ndamping_lb = 3\n");
    let root = Section::root(&document, &ROOT).unwrap();
    assert_eq!(
        root.section("strut", &STRUT).unwrap_err().to_string(),
        "v.toml:2: strut.damping_lb = 3: unknown key; did you mean damping? \
         known keys: preload_lb, damping"
    );
    assert_eq!(
        root.number("mass_slug").unwrap_err().to_string(),
        "v.toml:1: mass_slug is missing: expected a number"
    );
    let strut = root
        .section("strut", &["damping_lb", "preload_lb"])
        .unwrap();
    assert_eq!(
        strut.text("damping_lb").unwrap_err().to_string(),
        "v.toml:2: strut.damping_lb = 3: expected text in quotes"
    );
    assert_eq!(
        strut.number("preload_lb").unwrap_err().to_string(),
        "v.toml:1: strut.preload_lb is missing: expected a number"
    );
}
