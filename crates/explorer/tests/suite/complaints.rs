//! What cannot be answered is said in the words of the command line.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::PathBuf;

use serde_json::{Value, json};
use touchdown_explorer::interface::{Fault, NAMES};
use touchdown_explorer::named::Named;
use touchdown_input::documents::library::{Library, Source};

use crate::common::ask;

fn refused(name: &str, request: &Value, key: Option<&str>, fragment: &str) {
    let complaint = (ask(name, request).map(drop)).expect_err(&format!("{name} {request}"));
    assert_eq!(complaint.fault, Fault::Request);
    assert_eq!(complaint.key.as_deref(), key, "{}", complaint.message);
    assert!(
        complaint.message.contains(fragment),
        "{fragment} is not in: {}",
        complaint.message
    );
}

#[test]
fn values_are_named_with_what_is_allowed() {
    for (name, value, fragment) in [
        (
            "slope_deg",
            json!(95),
            "slope_deg = 95: expected -90 < value < 90",
        ),
        (
            "slope_rad",
            json!(2),
            "slope_rad = 2: expected -90 < value < 90 (in deg: this is 114.592)",
        ),
        (
            "vehicle.strut.preload_n",
            json!(-3),
            "0 < value ≤ 1e9 (in lb: this is -0.674427)",
        ),
        (
            "vehicle.legs[2].strut.minimum_length_ft",
            json!(9),
            "below strut.extended_length_ft",
        ),
        (
            "vehicle.legs[7].strut.preload_lb",
            json!(180),
            "the vehicle has 3",
        ),
        ("footing[5].height_ft", json!(1), "the vehicle has 3"),
        ("slop_deg", json!(1), "did you mean slope_deg?"),
        ("solver.tolerance", json!(1), "1e-12 ≤ value ≤ 1e-2"),
        (
            "solver.crush_rule",
            json!("soft"),
            "one of pivot-rate, section",
        ),
        ("solver.crush_rule", json!(1), "one of pivot-rate, section"),
        ("solver.method", json!("rk4"), "expected located"),
        (
            "solver.time_limit_s",
            json!(5000),
            "at most 1000 s in the explorer",
        ),
        (
            "search.from_fps",
            json!(1),
            "a number of the touchdown, the vehicle or the solver",
        ),
        ("friction", json!([1]), "a number, or a word in quotes"),
        ("friction", json!(null), "a number, or a word in quotes"),
        ("friction", json!("NaN"), "a finite number"),
        ("friction", json!("inf"), "a finite number"),
        ("vehicle.mass_kg", json!(1e300), "0 < value ≤ 1e9"),
    ] {
        refused(
            "landing",
            &json!({"touchdown": {"values": {(name): value}}}),
            Some(name),
            fragment,
        );
    }
    let twice = json!({"touchdown": {"values": {"slope_deg": 1, "slope_rad": 0.1}}});
    refused("landing", &twice, Some("slope_rad"), "under two names");
    let half = json!({"touchdown": {"values": {"tip_deg": 3}}});
    refused("landing", &half, Some("tip_azimuth_deg"), "is missing");
}

#[test]
fn members_are_named_with_what_is_allowed() {
    for (name, request, key, fragment) in [
        (
            "landing",
            json!({"interval_s": 1e-9}),
            Some("interval_s"),
            "at least 0.002 s",
        ),
        (
            "landing",
            json!({"interval_s": -1}),
            Some("interval_s"),
            "at least",
        ),
        (
            "landing",
            json!({"units": "cgs"}),
            Some("units"),
            "\"US\" or \"SI\"",
        ),
        (
            "landing",
            json!({"touchdown": {"source": "x"}}),
            Some("source"),
            "one of surveyor-table-4-1",
        ),
        (
            "landing",
            json!({"touchdown": {"vehicle": "mass_slug = 3"}}),
            Some("name"),
            "name is missing",
        ),
        (
            "landing",
            json!({"touchdown": {"vehicle": "= ="}}),
            None,
            "not TOML",
        ),
        (
            "landing",
            json!({"speed": 3}),
            None,
            "unknown field `speed`",
        ),
        ("landing", json!([]), None, "not a request"),
        ("inputs", json!({"all": true}), None, "unknown field"),
        ("strip", json!({"most": 65}), Some("most"), "1 ≤ value ≤ 64"),
        ("strip", json!({"most": 0}), Some("most"), "1 ≤ value ≤ 64"),
        (
            "strip",
            json!({"resolution_fps": 0}),
            Some("resolution_fps"),
            "≤ value ≤",
        ),
        (
            "strip",
            json!({"from_fps": 5, "to_fps": 5}),
            Some("to_fps"),
            "more than from_fps",
        ),
        (
            "strip",
            json!({"from_fps": 0, "to_fps": 0.001}),
            Some("to_fps"),
            "more than from_fps",
        ),
        (
            "strip",
            json!({"known": [{"speed_fps": 30, "class": "stable"}]}),
            Some("known.speed_fps"),
            "0 ≤ value ≤ 25",
        ),
        (
            "strip",
            json!({"known": [{"speed_fps": 3, "class": "calm"}]}),
            Some("known.class"),
            "stable, unstable",
        ),
        (
            "bands",
            json!({"to_fps": 1e9}),
            Some("to_fps"),
            "0 ≤ value ≤ 10000",
        ),
        (
            "map",
            json!({"results": "x"}),
            Some("results"),
            "one of surface-4-20, figure-4-09",
        ),
        (
            "map",
            json!({"results": "surface-4-20", "axes": ["roll_deg"]}),
            Some("axes"),
            "two different ones",
        ),
        (
            "map",
            json!({"results": "surface-4-20", "axes": ["roll_deg", "roll_deg"]}),
            Some("axes"),
            "two different ones",
        ),
        (
            "map",
            json!({"results": "surface-4-20", "fixed": {"roll_deg": 0}}),
            Some("fixed.roll_deg"),
            "not drawn over",
        ),
        (
            "at",
            json!({"results": "surface-4-20", "place": {"yaw_deg": 0}}),
            Some("place.yaw_deg"),
            "an axis",
        ),
        (
            "at",
            json!({"results": "surface-4-20"}),
            None,
            "missing field `place`",
        ),
        (
            "sample",
            json!({"results": "surface-4-20"}),
            Some("results"),
            "a table of landings",
        ),
    ] {
        refused(name, &request, key, fragment);
    }
}

#[test]
fn a_complaint_has_its_number_the_value_and_what_is_allowed() {
    let steep = json!({"touchdown": {"values": {"slope_deg": 95}}});
    let complaint = ask("landing", &steep).unwrap_err();
    assert_eq!(complaint.value.as_deref(), Some("95"));
    assert_eq!(complaint.allowed.as_deref(), Some("-90 < value < 90"));
    let told: Value = serde_json::from_str(&complaint.json()).unwrap();
    assert_eq!(told["error"]["value"], "95");
}

#[test]
fn no_request_is_answered_by_another_name() {
    let complaint = ask("land", &json!({})).unwrap_err();
    assert_eq!(complaint.fault, Fault::Unknown);
    assert!(complaint.message.contains(&NAMES.join(", ")));
}

#[test]
fn what_cannot_be_explored_is_refused_with_its_file() {
    let complaint = |name: &str, text: &str| {
        let copies = [Source {
            path: PathBuf::from(name),
            text: text.to_owned(),
        }];
        let named = Named::read(&[PathBuf::from(name)], Library::Copies(&copies), None);
        named.unwrap_err().to_string()
    };
    assert!(complaint("a.png", "").starts_with("a.png: expected a vehicle, scene or sweep file"));
    assert!(
        complaint("a.csv", "t_s,x_ft\n0,0\n")
            .starts_with("a.csv: expected a table of transitions or of landings")
    );
    assert!(complaint("a.toml", "mass_slug = 1\n").starts_with("a.toml:1: name is missing"));
    assert!(complaint("a.toml", "[axes]\n").starts_with("a.toml:1: vehicle is missing"));
}
