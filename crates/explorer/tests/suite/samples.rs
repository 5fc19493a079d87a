//! Samples counted over bins of a column, and their rows as files.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::sync::LazyLock;

use serde_json::{Value, json};
use touchdown_explorer::interface::{Complaint, answer};
use touchdown_explorer::named::Named;

use crate::common::of_table;

const TABLE: &str = "friction,vertical_velocity_fps,outcome,end_time_s,failure\n\
    0.80,10,stable-rockback,2.5,\n0.9,12,bottomed-leg-2,0.3,\n1,14,sliding,40,\n1,15,stable-subsided,,\n";

static DRAWN: LazyLock<Named> = LazyLock::new(|| of_table("drawn.csv", TABLE));

fn ask(name: &str, request: &Value) -> Result<Value, Complaint> {
    let told = answer(&DRAWN, name, &request.to_string(), &|| false);
    told.map(|text| serde_json::from_str(&text).unwrap())
}

#[test]
fn bins_count_all_landings_and_those_within_ranges() {
    let within = json!([{"column": "vertical_velocity_fps", "from": 12, "to": 15}]);
    let request = json!({"results": "drawn", "column": "friction", "within": within});
    let told = ask("bins", &request).unwrap();
    let landings = |of: &Value| of["landings"].as_u64().unwrap();
    assert_eq!([&told["all"], &told["within"]].map(landings), [4, 3]);
    let bins = told["bins"].as_array().unwrap();
    let sum = |member: &str| -> u64 { bins.iter().map(|bin| landings(&bin[member])).sum() };
    assert_eq!([sum("all"), sum("within")], [4, 3]);
    for pair in bins.windows(2) {
        assert_eq!(pair[0]["to"], pair[1]["from"]);
    }
    // The greatest number is at the end of the last bin: ends above are in it.
    let last = bins.last().unwrap();
    assert_eq!((&last["to"], landings(&last["all"])), (&json!(1.0), 2));
    let classes = last["within"]["classes"].as_array().unwrap();
    let counts: Vec<u64> = classes.iter().map(landings).collect();
    assert_eq!(counts, [1, 0, 0, 0, 1]);
    // Wilson's interval of one in two.
    let [probability, low, high] =
        ["probability", "low_95", "high_95"].map(|name| classes[0][name].as_f64().unwrap());
    assert_eq!(probability, 0.5);
    assert!((low - 0.0945).abs() < 1e-4 && (high - 0.9055).abs() < 1e-4);
    let nobody = json!([{"column": "friction", "from": 2, "to": 3}]);
    let request = json!({"results": "drawn", "column": "end_time_s", "within": nobody});
    let told = ask("bins", &request).unwrap();
    let first = &told["within"]["classes"][0];
    assert_eq!(
        *first,
        json!({"landings": 0, "probability": null, "low_95": 0.0, "high_95": 1.0})
    );
    // A landing without a number is in no bin.
    let bins = told["bins"].as_array().unwrap();
    let all: u64 = bins.iter().map(|bin| landings(&bin["all"])).sum();
    assert_eq!((all, landings(&told["all"])), (3, 4));
    let words = json!({"results": "drawn", "column": "outcome"});
    assert_eq!(ask("bins", &words).unwrap()["bins"], json!([]));
}

#[test]
fn rows_of_a_sample_are_a_file_as_they_were_written() {
    let file = |request: Value| ask("table_file", &request).unwrap()["files"][0].clone();
    assert_eq!(
        file(json!({"results": "drawn"})),
        json!({"name": "drawn.csv", "text": TABLE})
    );
    let within = json!([
        {"column": "friction", "from": 0.8, "to": 0.9},
        {"column": "end_time_s", "from": 2, "to": 100},
    ]);
    let selected = file(json!({"results": "drawn", "within": within}));
    let rows: Vec<&str> = TABLE.lines().take(2).collect();
    assert_eq!(
        selected,
        json!({"name": "drawn-selected.csv", "text": format!("{}\n{}\n", rows[0], rows[1])})
    );
    let text = file(json!({"results": "drawn", "units": "SI"}))["text"].to_string();
    assert!(
        text.contains("vertical_velocity_mps") && text.contains(",3.048,"),
        "{text}"
    );
}

#[test]
fn columns_that_are_not_there_are_refused() {
    for (request, key) in [
        (json!({"results": "drawn", "column": "slope_deg"}), "column"),
        (
            json!({"results": "drawn", "column": "friction", "within": [{"column": "x", "from": 0, "to": 1}]}),
            "within.column",
        ),
        (json!({"results": "lost", "column": "friction"}), "results"),
    ] {
        let complaint = ask("bins", &request).unwrap_err();
        assert_eq!(complaint.key.as_deref(), Some(key));
    }
}

#[test]
fn a_sample_has_a_scale_of_colours() {
    let told = ask("sample", &json!({"results": "drawn"})).unwrap();
    let ramp = told["ramp"].as_array().unwrap();
    assert_eq!((ramp.len(), &ramp[0]), (12, &json!("#203460")));
}
