//! Maps, places on them, and samples.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::PathBuf;

use serde_json::{Value, json};
use touchdown_explorer::interface::answer;
use touchdown_explorer::named::Named;
use touchdown_input::documents::library::{Library, Source};

use crate::common::{ask, named, of_table};

#[test]
fn a_map_is_a_grid_with_gaps_and_jumps() {
    let map = ask("map", &json!({"results": "surface-4-20"})).unwrap();
    let speeds = map["grid"]["speeds"].as_array().unwrap();
    assert_eq!(
        speeds.len(),
        map["axes"][0]["values"].as_array().unwrap().len()
    );
    assert_eq!(map["points"].as_array().unwrap().len(), 3969);
    assert_eq!(map["words"]["gap"], "stable up to 25 ft/s");
    assert_eq!(
        map["words"]["jump"],
        "V_H jumps by more than 2 ft/s between points"
    );
    assert!(!map["jump_cells"].as_array().unwrap().is_empty());
    let levels = map["levels"].as_array().unwrap();
    assert_eq!(levels.last().unwrap()["speed"], Value::Null);
    assert_eq!(
        map["title"],
        "Figures 4-20, 4-21: first transition V_H over cross-slope and roll"
    );
    let kinds = map["kinds"].as_array().unwrap().iter();
    let kinds: Vec<&Value> = kinds.map(|kind| &kind["class"]).collect();
    assert_eq!(kinds, ["unstable", "bottomed", "failure", "undecided"]);
}

#[test]
fn the_nearest_point_is_so_by_shares_of_the_range_of_each_axis() {
    let text = "friction,roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,certainty\n\
        0.5,0,unstable,10,9,10,certain\n1,40,unstable,11,10,11,certain\n1,100,unstable,12,11,12,certain\n";
    let named = of_table("few.csv", text);
    // A third of the range of roll away from the first, all of that of friction from the second.
    let request = r#"{"results": "few", "place": {"friction": 0.5, "roll_deg": 30}}"#;
    let told: Value =
        serde_json::from_str(&answer(&named, "at", request, &|| false).unwrap()).unwrap();
    assert_eq!(told["place"], json!({"friction": 0.5, "roll_deg": 0.0}));
}

#[test]
fn a_disputed_transition_is_told_with_its_range() {
    let text = "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,certainty,disputed_from_fps,disputed_to_fps\n\
        0,unstable,11,10.5,11,doubtful,10,12\n5,unstable,12,11.5,12,certain,,\n";
    let named = of_table("doubts.csv", text);
    let told: Value = serde_json::from_str(
        &answer(&named, "map", r#"{"results": "doubts"}"#, &|| false).unwrap(),
    )
    .unwrap();
    let disputed = |point: usize| &told["points"][point]["disputed"];
    assert_eq!(
        (disputed(0), disputed(1)),
        (&json!([10.0, 12.0]), &Value::Null)
    );
}

#[test]
fn the_line_on_which_the_feet_are_bisected_is_on_maps_over_cross_slope_and_roll() {
    let map = ask("map", &json!({"results": "surface-4-20"})).unwrap();
    let lines = map["bisector"].as_array().unwrap();
    assert_eq!(lines.len(), 4);
    for place in lines.iter().flat_map(|line| line.as_array().unwrap()) {
        let [cross_slope, roll] = [0, 1].map(|axis| place[axis].as_f64().unwrap());
        // Straight downhill at no roll, and so every third of a turn.
        assert_eq!((cross_slope - 180.0 - roll).rem_euclid(120.0), 0.0);
    }
    assert_eq!(map["words"]["bisector"], "AB: V_H bisects the leading feet");
    let turned = json!({"results": "surface-4-20", "axes": ["roll_deg", "cross_slope_deg"]});
    assert_eq!(ask("map", &turned).unwrap()["bisector"], json!([]));
}

#[test]
fn landings_beside_a_boundary_end_differently() {
    for (results, place) in [
        (
            "surface-4-20",
            json!({"cross_slope_deg": 152, "roll_deg": -31}),
        ),
        ("figure-4-09", json!({"roll_deg": 1})),
    ] {
        let at = ask("at", &json!({"results": results, "place": place})).unwrap();
        let class = |touchdown: &Value| {
            let request = json!({"touchdown": touchdown, "history": false, "drawing": false});
            ask("landing", &request).unwrap()["class"].clone()
        };
        assert_eq!(class(&at["below"]), "stable");
        assert_eq!(class(&at["above"]), at["to"]);
    }
}

#[test]
fn a_refined_map_without_its_triangles_says_what_is_missing() {
    let text = "slope_deg,roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,certainty,level\n\
        10,0,unstable,12,12,12,certain,0\n15,5,unstable,11,11,11,certain,1\n";
    let map = |text: &str, axes: &str| -> Value {
        let told = answer(&of_table("trade.csv", text), "map", axes, &|| false);
        serde_json::from_str(&told.unwrap()).unwrap()
    };
    let told = map(text, r#"{"results": "trade"}"#);
    let missing = told["words"]["missing"].as_str().unwrap();
    assert!(missing.contains("trade-surface.csv"), "{missing}");
    // Its points are coloured by their values all the same.
    let levels = told["levels"].as_array().unwrap();
    assert!(levels.len() > 1, "{levels:?}");
    let grid = map(&text.replace(",level", ",steps"), r#"{"results": "trade"}"#);
    assert_eq!(grid["words"]["missing"], Value::Null);
}

#[test]
fn a_shipped_map_has_the_colours_of_its_values_and_its_edges() {
    let named = named(&["results/landers/four-legs-map.csv"]);
    let told = answer(&named, "map", r#"{"results": "four-legs-map"}"#, &|| false).unwrap();
    let told: Value = serde_json::from_str(&told).unwrap();
    assert!(told["levels"].as_array().unwrap().len() > 4);
    assert!(!told["edges"].as_array().unwrap().is_empty());
    assert_eq!(told["triangles"], Value::Null);
}

#[test]
fn tables_without_landings_are_skipped_unless_nothing_else_is_named() {
    let both = named(&[
        "results/landers/four-legs-map-edges.csv",
        "results/landers/four-legs-map.csv",
        "results/landers/four-legs-dispersions-probabilities.csv",
    ]);
    assert_eq!((both.results.len(), both.files.len()), (1, 1));
    assert_eq!(both.skipped.len(), 2);
    assert!(both.copies.iter().all(|copy| {
        !copy
            .path
            .ends_with("four-legs-dispersions-probabilities.csv")
    }));
    let path = PathBuf::from("beside.csv");
    let copies = [Source {
        path: path.clone(),
        text: "axis,from,to,landings\n".to_owned(),
    }];
    let refused = Named::read(&[path], Library::Copies(&copies), None).unwrap_err();
    let said = refused.to_string();
    assert!(
        said.contains("beside.csv") && said.contains("table of transitions or of landings"),
        "{said}"
    );
}

#[test]
fn any_two_of_more_axes_make_a_map() {
    let table = "friction,slope_deg,roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,certainty\n";
    let mut rows = String::from(table);
    for (index, (friction, slope, roll)) in [0.8, 1.0]
        .into_iter()
        .flat_map(|friction| [10, 15].map(|slope| (friction, slope)))
        .flat_map(|(friction, slope)| [-5, 5].map(|roll| (friction, slope, roll)))
        .enumerate()
    {
        let speed = 10.0 + index as f64;
        rows += &format!("{friction},{slope},{roll},unstable,{speed},{speed},{speed},certain\n");
    }
    let named = of_table("trade.csv", &rows);
    let ask = |request: Value| -> Value {
        serde_json::from_str(&answer(&named, "map", &request.to_string(), &|| false).unwrap())
            .unwrap()
    };
    let map = ask(json!({"results": "trade"}));
    assert_eq!(map["other_axes"][0]["fixed"], -5.0);
    assert_eq!(map["grid"]["speeds"], json!([[10.0, 12.0], [14.0, 16.0]]));
    let map = ask(
        json!({"results": "trade", "axes": ["roll_deg", "friction"], "fixed": {"slope_deg": 15}}),
    );
    assert_eq!(map["grid"]["speeds"], json!([[12.0, 16.0], [13.0, 17.0]]));
}

#[test]
fn landings_of_a_sample_have_their_input_and_their_class() {
    let text = "friction,vehicle.strut.preload_lb,outcome,end_time_s,failure\n0.8,180,stable-rockback,2.5,\n0.9,190,bottomed-leg-2,0.3,\n1,170,sliding,40,\n";
    let named = of_table("drawn.csv", text);
    let told = answer(&named, "sample", r#"{"results": "drawn"}"#, &|| false).unwrap();
    let told: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(told["inputs"][1]["values"], json!([180.0, 190.0, 170.0]));
    assert_eq!(
        told["outcomes"],
        json!(["stable-rockback", "bottomed-leg-2", "sliding"])
    );
    let classes = told["class"].as_array().unwrap().iter();
    let words: Vec<&Value> = classes
        .map(|place| &told["classes"][place.as_u64().unwrap() as usize]["class"])
        .collect();
    assert_eq!(words, ["stable", "bottomed", "undecided"]);
    assert_eq!(told["results"][1]["values"], json!([null, null, null]));
}

#[test]
fn a_map_comes_in_the_units_asked_for_and_its_landings_stay() {
    let text = "vertical_velocity_mps,roll_deg,first_transition_to,first_transition_mps,bracket_low_mps,bracket_high_mps,certainty\n\
        2,0,unstable,3.048,3,3.048,certain\n2,5,unstable,3.1,3.05,3.1,certain\n\
        3.048,0,none,,6,,above\n3.048,5,bottomed,3,2.9,3,certain\n";
    let record = r#"{"title": "Trade", "input": {"vehicle": {"name": "A"}, "scene": {"vertical_velocity_mps": 3.048},
        "search": {"from_mps": 0, "to_mps": 6.096}}}"#;
    let file = |name: &str, text: &str| Source {
        path: PathBuf::from(name),
        text: text.to_owned(),
    };
    // Without a vehicle the record is no source: what is asked for here is only the map.
    let copies = [file("trade.csv", text)];
    let path = [PathBuf::from("trade.csv")];
    let mut named = Named::read(&path, Library::Copies(&copies), None).unwrap();
    named.results[0].record = Some(record.to_owned());
    let ask = |name: &str, request: Value| -> Value {
        let told = answer(&named, name, &request.to_string(), &|| false);
        serde_json::from_str(&told.unwrap()).unwrap()
    };
    let map = ask("map", json!({"results": "trade", "units": "US"}));
    assert_eq!(map["axes"][0]["name"], "vertical_velocity_fps");
    assert_eq!(map["axes"][0]["unit"], "ft/s");
    assert_eq!(map["axes"][0]["values"][1], 10.0);
    assert_eq!(map["points"][0]["speed"], 10.0);
    assert_eq!(
        (&map["speed_unit"], &map["searched_to"]),
        (&json!("ft/s"), &json!(20.0))
    );
    assert_eq!(map["words"]["gap"], "stable up to 20 ft/s");
    assert!(
        map["conditions"]
            .as_str()
            .unwrap()
            .contains("vertical velocity 10 ft/s")
    );
    let own = ask("map", json!({"results": "trade"}));
    assert_eq!(own, ask("map", json!({"results": "trade", "units": "SI"})));
    assert_eq!(own["points"][1]["speed"], 3.1);
    let place = json!({"vertical_velocity_fps": 10, "roll_deg": 5});
    let at = ask(
        "at",
        json!({"results": "trade", "units": "US", "place": place}),
    );
    assert_eq!(at["place"]["vertical_velocity_fps"], 10.0);
    assert_eq!(at["above"]["values"]["vertical_velocity_mps"], 3.048);
    assert_eq!(at["above"]["values"]["horizontal_velocity_mps"], 3.0);
}

#[test]
fn landings_of_a_sample_come_in_the_units_asked_for_and_as_they_were_written() {
    let text = "vertical_velocity_mps,outcome,min_clearance_m\n3.048,sliding,0.3048\n";
    let named = of_table("drawn.csv", text);
    let ask = |request: &str| -> Value {
        serde_json::from_str(&answer(&named, "sample", request, &|| false).unwrap()).unwrap()
    };
    let told = ask(r#"{"results": "drawn", "units": "US"}"#);
    assert_eq!(told["inputs"][0]["name"], "vertical_velocity_fps");
    assert_eq!(told["inputs"][0]["values"], json!([10.0]));
    assert_eq!(told["results"][0]["values"], json!([1.0]));
    let written = json!({"name": "vertical_velocity_mps", "values": [3.048]});
    assert_eq!(told["inputs"][0]["written"], written);
    // In its own units it is the table itself.
    for request in [
        r#"{"results": "drawn"}"#,
        r#"{"results": "drawn", "units": "SI"}"#,
    ] {
        assert_eq!(ask(request)["inputs"][0]["written"], Value::Null);
    }
}

#[test]
fn the_page_begins_in_the_units_of_its_first_file() {
    use touchdown_input::documents::output_units::OutputUnits;
    for (file, units) in [
        ("sweeps/vehicles/surveyor-table-4-1.toml", OutputUnits::Us),
        ("sweeps/vehicles/four-legs.toml", OutputUnits::Si),
        ("sweeps/landers/six-legs-dispersions.toml", OutputUnits::Si),
        ("results/landers/six-legs-map.csv", OutputUnits::Si),
        ("results/figure-4-09.csv", OutputUnits::Us),
    ] {
        assert_eq!(named(&[file]).units, units, "{file}");
    }
}
