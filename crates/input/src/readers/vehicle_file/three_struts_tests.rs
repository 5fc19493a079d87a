use std::path::Path;

use touchdown_dynamics::vehicle::Legs;

use super::*;
use crate::documents::document::Document;
use crate::documents::key_path::KeyPath;
use crate::readers::vehicle_file::{VehicleFile, number, numbers};

const APOLLO_LIKE: &str = include_str!("../../../../../sweeps/vehicles/apollo-like.toml");

fn read_file(text: &str) -> Result<VehicleFile, InputError> {
    VehicleFile::from_document(Document::parse(Path::new("v.toml"), text)?)
}

fn designs(text: &str) -> Vec<ThreeStrutDesign> {
    match read_file(text).unwrap().vehicle.legs() {
        Legs::ThreeStrut(legs) => legs.iter().map(|leg| leg.design().clone()).collect(),
        Legs::Hinged(_) => panic!("hinged legs"),
    }
}

fn close(number: f64, metres: f64) -> bool {
    (number * 0.3048 - metres).abs() < 1e-12
}

/// The file with `kind = "tripod"`.
fn tripod() -> String {
    let is_kept = |line: &&str| !line.starts_with("collar_m") && !line.starts_with("bearing_");
    let kept: Vec<&str> = APOLLO_LIKE.split_inclusive('\n').filter(is_kept).collect();
    kept.concat()
        .replace("\"cantilever\"\nfoot", "\"tripod\"\nfoot")
}

#[test]
fn a_cantilever_leg_is_read_in_feet_and_pounds() {
    let legs = designs(APOLLO_LIKE);
    assert_eq!(legs.len(), 4);
    let leg = &legs[1];
    assert_eq!(leg.azimuth, 90f64.to_radians());
    let Arrangement::Cantilever(telescope) = leg.arrangement else {
        panic!("no collar");
    };
    assert!(close(telescope.collar, 2.0) && close(telescope.bearing_overhang, 1.3));
    assert!(close(telescope.bearing_overlap, 1.2) && telescope.bearing_friction == 0.0);
    assert!(close(leg.foot.radius, 4.26) && close(leg.foot.depth, 1.45));
    assert!((leg.foot.mass * 14.593902937206364 - 30.0).abs() < 1e-12);
    assert!(close(leg.primary.hardpoint_height, 1.9) && close(leg.spread, 0.9));
    assert_eq!(leg.primary.stiffness, 1e6);
    assert!((leg.primary.damping * 14.593902937206364 - 1000.0).abs() < 1e-9);
    assert_eq!(leg.primary.square_damping, 0.0);
    let step = 10.0 / 12.0;
    assert_eq!(
        leg.primary.compression_load.as_ref().unwrap().knots(),
        [
            [0.0, 4500.0],
            [step, 4500.0],
            [step, 9500.0],
            [32.0 / 12.0, 9500.0]
        ]
    );
    assert_eq!(leg.primary.tension_load, None);
    assert_eq!(
        leg.secondary.tension_load.as_ref().unwrap().knots()[0],
        [0.0, 500.0]
    );
    assert_eq!(leg.footpad.profile.knots().len(), 4);
}

#[test]
fn a_tripod_has_no_collar_and_a_leg_may_differ() {
    let text = format!("{}[legs.secondary]\nsquare_damping = 3\n", tripod());
    let legs = designs(&text);
    assert_eq!(legs[0].arrangement, Arrangement::Tripod);
    assert_eq!(
        legs[3].secondary.hardpoint_radius,
        legs[0].secondary.hardpoint_radius
    );
    let damping = [0, 3].map(|leg: usize| legs[leg].secondary.square_damping);
    assert_eq!(damping, [0.0, 3.0]);
    let scaled = APOLLO_LIKE.replace(
        "[primary.compression_load]",
        "[primary.compression_load]\nscale = 2",
    );
    let load = designs(&scaled)[0].primary.compression_load.clone();
    assert_eq!(load.unwrap().knots()[0], [0.0, 9000.0]);
}

#[test]
fn every_number_of_a_leg_is_a_number_of_the_file() {
    let file = read_file(APOLLO_LIKE).unwrap();
    let names = numbers(4);
    for (name, _) in own_numbers() {
        for name in [name.clone(), format!("legs[2].{name}")] {
            assert!(names.iter().any(|(known, _)| *known == name), "{name}");
            let value = number(&file.document, &KeyPath::parse(&name).unwrap());
            let is_optional = name.ends_with("square_damping");
            assert!(value.is_some() || is_optional, "{name}");
        }
    }
}

/// Replaced text of the file, its replacement, and text that the error must contain.
#[rustfmt::skip]
const WRONG: [(&str, &str, &str); 14] = [
    ("kind = \"cantilever\"\nfoot", "kind = \"inverted\"\nfoot", "linkage.kind = \"inverted\": expected \"hinged\" or \"tripod\" or \"cantilever\""),
    ("kind = \"cantilever\"\nfoot", "kind = \"tripod\"\nfoot", "linkage.collar_m = 2: only legs of kind \"cantilever\" have this, and this one is of kind \"tripod\""),
    ("kind = \"cantilever\"\nfoot", "foot", "primary = a table: only legs of kind \"tripod\" or \"cantilever\" have this, and this one is of kind \"hinged\""),
    ("[primary]\n", "[strut]\npreload_lb = 100\n[primary]\n", "strut = a table: only legs of kind \"hinged\" have this, and this one is of kind \"cantilever\""),
    ("name = ", "block = \"none\"\nname = ", "block = \"none\": only legs of kind \"hinged\" have this"),
    ("foot_radius_m", "lower_link_length_m = 2\nfoot_radius_m", "linkage.lower_link_length_m = 2: only legs of kind \"hinged\" have this"),
    ("diameter_m", "edge_load_n = 9\ndiameter_m", "footpad.edge_load_n = 9: only legs of kind \"hinged\" have this"),
    ("collar_m", "# ", "linkage.collar_ft is missing: expected 0 < value ≤ 1e9 ft, distance along the primary strut"),
    ("collar_m = 2 ", "collar_m = 3.2 ", "linkage.collar_m = 3.2: expected less than the primary strut is long when it bottoms"),
    ("bearing_friction = 0                    # assumed: none\nbearing_overhang_m = 1.3", "bearing_friction = 0.1\nbearing_overhang_m = 0.5", "linkage.bearing_overhang_m = 0.5: expected"),
    ("compression_stroke_cm = 30.48", "compression_stroke_cm = 150", "secondary.compression_stroke_cm = 150: expected less than the strut is long at rest"),
    ("[primary]\n", "[primary]\nhardpoint_spread_m = 1\n", "primary.hardpoint_spread_m = 1: unknown key"),
    ("azimuth_deg = 180", "azimuth_deg = 180\nlinkage = { kind = \"tripod\" }", "legs[3].linkage.kind = \"tripod\": leg 1 is of kind \"cantilever\" and leg 3 of kind \"tripod\": expected one kind for all legs"),
    ("name = ", "rules = \"1966\"\nname = ", "rules = \"1966\": expected \"physical\": legs of three struts land by no other rules"),
];

#[test]
fn faults_are_told_in_the_words_of_the_file() {
    for (right, wrong, complaint) in WRONG {
        assert!(APOLLO_LIKE.contains(right), "{right}");
        let said = read_file(&APOLLO_LIKE.replacen(right, wrong, 1)).unwrap_err();
        assert!(said.to_string().contains(complaint), "{said}");
    }
    let physical = APOLLO_LIKE.replacen("name = ", "rules = \"physical\"\nname = ", 1);
    assert!(read_file(&physical).is_ok());
}
