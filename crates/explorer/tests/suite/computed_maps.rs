//! Maps that a page computes place by place.

#![allow(missing_docs, reason = "tests are not an interface")]

use serde_json::{Value, json};
use touchdown_explorer::interface::{Fault, answer};

use crate::common::{NAMED, ask};

/// A map of the Surveyor over cross-slope and roll, asked for place by place.
fn computed() -> Value {
    let touchdown = json!({"values": {"friction": 0.9, "horizontal_velocity_mps": 2}});
    let axes = ["cross_slope_deg", "roll_deg"];
    let mut lines = Vec::new();
    for place in [[170, 0], [170, 5], [180, 0], [180, 5]] {
        let request = json!({"touchdown": touchdown, "axes": axes, "place": place, "to_fps": 20});
        let told = ask("boundary", &request).unwrap();
        if lines.is_empty() {
            lines.push(told["heading"].as_str().unwrap().to_owned());
        }
        lines.push(told["row"].as_str().unwrap().to_owned());
    }
    let table = lines.join("\n") + "\n";
    json!({"touchdown": touchdown, "axes": axes, "to_fps": 20, "table": table})
}

#[test]
fn a_map_computed_place_by_place_is_drawn_as_one_of_a_file() {
    let computed = computed();
    let map = ask("map", &json!({"computed": computed, "units": "US"})).unwrap();
    assert_eq!(map["axes"][1]["values"], json!([0.0, 5.0]));
    assert_eq!(map["searched_to"], 20.0);
    let conditions = map["conditions"].as_str().unwrap();
    assert!(
        conditions.contains("friction 0.9") && !conditions.contains("horizontal"),
        "{conditions}"
    );
    let speed = &map["grid"]["speeds"][1][0];
    let values = json!({"friction": 0.9, "cross_slope_deg": 180, "roll_deg": 0});
    let bands = ask(
        "bands",
        &json!({"touchdown": {"values": values}, "to_fps": 20}),
    )
    .unwrap();
    assert_eq!(*speed, bands["first_transition"]["speed_fps"]);
    let si = ask("map", &json!({"computed": computed, "units": "SI"})).unwrap();
    assert_eq!(si["speed_unit"], "m/s");
    let ratio = si["grid"]["speeds"][1][0].as_f64().unwrap() / speed.as_f64().unwrap();
    assert!((ratio - 0.3048).abs() < 1e-9, "{ratio}");
}

#[test]
fn landings_on_both_sides_of_a_computed_place_are_those_of_its_touchdown() {
    let place = json!({"cross_slope_deg": 179, "roll_deg": 1});
    let at = ask(
        "at",
        &json!({"computed": computed(), "place": place, "units": "SI"}),
    )
    .unwrap();
    for (side, class) in [("below", "stable"), ("above", "unstable")] {
        let touchdown = &at[side];
        assert_eq!(touchdown["values"]["cross_slope_deg"], 180.0);
        assert_eq!(touchdown["values"]["friction"], 0.9);
        // V_H is given once.
        assert_eq!(touchdown["values"]["horizontal_velocity_mps"], Value::Null);
        let landing = ask(
            "landing",
            &json!({"touchdown": touchdown, "drawing": false}),
        )
        .unwrap();
        assert_eq!(landing["class"], class);
    }
}

#[test]
fn a_computed_map_is_a_table_in_the_units_asked_for() {
    let computed = computed();
    let file = |units: &str| {
        let told = ask("table_file", &json!({"computed": computed, "units": units})).unwrap();
        told["files"][0].clone()
    };
    assert_eq!(
        file("US"),
        json!({"name": "map.csv", "text": computed["table"]})
    );
    let text = file("SI")["text"].to_string();
    assert!(
        text.contains("first_transition_mps") && !text.contains("_fps"),
        "{text}"
    );
}

#[test]
fn what_is_no_computed_map_is_refused() {
    let table = "roll_deg,pitch_deg,first_transition_to\n0,0,none\n";
    for (name, request, fragment) in [
        (
            "boundary",
            json!({"axes": ["roll_deg", "roll_deg"], "place": [0, 0]}),
            "two different numbers",
        ),
        (
            "boundary",
            json!({"axes": ["roll_deg", "horizontal_velocity_mps"], "place": [0, 0]}),
            "not V_H",
        ),
        (
            "boundary",
            json!({"axes": ["roll_deg", "solver.stop"], "place": [0, 0]}),
            "two different numbers",
        ),
        (
            "boundary",
            json!({"axes": ["slope_deg", "roll_deg"], "place": [95, 0]}),
            "-90 < value < 90",
        ),
        (
            "map",
            json!({"computed": {"axes": ["roll_deg", "pitch_deg"], "table": table}}),
            "begins with roll_deg,pitch_deg,first",
        ),
        (
            "map",
            json!({"results": "surface-4-20", "computed": computed()}),
            "either `results` or `computed`",
        ),
        ("at", json!({"place": {}}), "either `results` or `computed`"),
    ] {
        let complaint = ask(name, &request).unwrap_err();
        assert!(
            complaint.message.contains(fragment),
            "{request}: {}",
            complaint.message
        );
    }
    let request = json!({"axes": ["slope_deg", "roll_deg"], "place": [5, 0]}).to_string();
    let left = std::cell::Cell::new(20);
    let is_over = || left.replace(left.get() - 1) == 0;
    let complaint = answer(&NAMED, "boundary", &request, &is_over).unwrap_err();
    assert_eq!((complaint.fault, left.get()), (Fault::Over, -1));
}
