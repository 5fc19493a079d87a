//! Landings and parameters.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::path::PathBuf;

use serde_json::{Value, json};
use touchdown_explorer::interface::answer;
use touchdown_explorer::named::Named;
use touchdown_input::documents::library::{Library, Source};

use crate::common::{NAMED, ask, distance, in_ground, named, numbers};

fn landing(values: Value) -> Value {
    ask("landing", &json!({"touchdown": {"values": values}})).unwrap()
}

#[test]
fn there_is_always_something_to_explore() {
    let inputs = ask("inputs", &json!({})).unwrap();
    assert_eq!(inputs["sources"].as_array().unwrap().len(), 3);
    assert_eq!(inputs["results"][0]["kind"], "map");
    assert_eq!(inputs["results"][1]["kind"], "profile");
    let alone = named(&[]);
    assert_eq!(alone.sources[0].name, "surveyor-table-4-1");
}

#[test]
fn every_kind_of_file_is_a_source() {
    let named = named(&[
        "sweeps/figure-4-09.toml",
        "sweeps/vehicles/six-legs.toml",
        "sweeps/figure-4-09.toml",
    ]);
    let names: Vec<&str> = named
        .sources
        .iter()
        .map(|source| source.name.as_str())
        .collect();
    assert_eq!(names, ["figure-4-09", "six-legs", "figure-4-09-2"]);
}

#[test]
fn the_touchdown_beside_results_has_the_search_of_their_record() {
    for (file, to) in [
        ("results/figure-4-09.csv", 25.0),
        ("results/landers/six-legs-map.csv", 6.0 / 0.3048),
    ] {
        let source = &named(&[file]).sources[0];
        assert_eq!(source.search[0], 0.0, "{file}");
        assert!((source.search[1] - to).abs() < 1e-12, "{file}");
        let speed = source.conditions.get("horizontal_velocity_fps").unwrap();
        assert!((speed - 0.5 * to).abs() < 1e-12, "{file}: {speed}");
    }
}

#[test]
fn cases_of_a_scene_are_told_apart_unless_there_is_one() {
    let names = |cases: &str| -> Vec<String> {
        let scene = "vehicle = \"three.toml\"\n[scene]\nvertical_velocity_fps = 10\nhorizontal_velocity_fps = 2\n\
            cross_slope_deg = 180\nslope_deg = 5\nfriction = 1\n";
        let file = |name: &str, text: String| Source {
            path: PathBuf::from(name),
            text,
        };
        let vehicle = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
        let copies = [
            file("drop.toml", format!("{scene}{cases}")),
            file("three.toml", vehicle.to_owned()),
        ];
        let path = [PathBuf::from("drop.toml")];
        let named = Named::read(&path, Library::Copies(&copies), None).unwrap();
        let sources = named.sources.into_iter();
        sources.map(|source| source.name).collect()
    };
    assert_eq!(names(""), ["drop"]);
    let two = "[[case]]\nhorizontal_velocity_fps = 1\n\
        [[case]]\nname = \"fast\"\nhorizontal_velocity_fps = 9\n";
    assert_eq!(names(two), ["drop-1", "drop-fast"]);
}

#[test]
fn a_history_has_the_instants_of_the_interval_and_the_end() {
    let told = landing(json!({"horizontal_velocity_fps": 11.25}));
    assert_eq!(told["outcome"], "stable-rockback");
    let columns = told["history"]["columns"].as_array().unwrap();
    assert_eq!(columns.len(), 17 + 3 * 19);
    let times = numbers(&columns[0]["values"]);
    assert_eq!(times[..3], [0.0, 0.01, 0.02]);
    assert_eq!(times.last(), told["end_time_s"].as_f64().as_ref());
    let drawn = told["drawing"]["instants"]["time_s"].as_array().unwrap();
    assert_eq!(drawn.len(), times.len());
    assert_eq!(
        told["drawing"]["instants"]["legs"]
            .as_array()
            .unwrap()
            .len(),
        3
    );
    let without = ask("landing", &json!({"history": false, "drawing": false})).unwrap();
    assert_eq!(
        (&without["history"], &without["drawing"]),
        (&Value::Null, &Value::Null)
    );
}

#[test]
fn energies_close() {
    let told = landing(json!({"horizontal_velocity_fps": 11.25}));
    let energies = &told["energies"];
    let total = numbers(&energies["total"]);
    let parts = energies["parts"].as_array().unwrap();
    let closure = numbers(&energies["closure"]);
    for (index, total) in total.iter().enumerate() {
        let sum: f64 = parts
            .iter()
            .map(|part| numbers(&part["values"])[index])
            .sum();
        assert!((total - sum - closure[index]).abs() < 1e-9, "{index}");
        assert!(
            closure[index].abs() < 1e-3 * total,
            "{index}: {}",
            closure[index]
        );
    }
}

#[test]
fn the_drawing_is_of_one_piece() {
    let values = json!({"roll_deg": 20, "pitch_deg": -5, "footing[2].height_ft": 0.4, "footing[3].tilt_along_deg": 8,
                        "vehicle.center_of_gravity_offset_x_ft": 0.2});
    let told = landing(values);
    let drawing = &told["drawing"];
    let vehicle = &drawing["vehicle"];
    let instants = &drawing["instants"];
    assert_eq!(vehicle["ring"], json!([1, 2, 3]));
    let count = instants["time_s"].as_array().unwrap().len();
    for index in (0..count).step_by(7) {
        for leg in 0..3 {
            let (shape, moves) = (&vehicle["legs"][leg], &instants["legs"][leg]);
            let pivot = numbers(&moves["pivot"][index]);
            let hinge = in_ground(instants, index, &shape["lower_hardpoint"]);
            let link = distance(&hinge, &pivot);
            assert!((link - shape["link_length"].as_f64().unwrap()).abs() < 1e-4);
            assert_eq!(shape["struts"].as_array().unwrap().len(), 1);
            let strut = &shape["struts"][0];
            let length = distance(&in_ground(instants, index, &strut["from"]), &pivot);
            let stroke = moves["strokes"][index][0].as_f64().unwrap();
            assert!((length + stroke - strut["length"].as_f64().unwrap()).abs() < 1e-4);
        }
    }
}

#[test]
fn forces_of_the_ground_are_those_of_the_history() {
    let told = landing(json!({"horizontal_velocity_fps": 11.25, "cross_slope_deg": 150}));
    let columns = told["history"]["columns"].as_array().unwrap();
    let column = |name: &str| {
        let found = columns
            .iter()
            .find(|column| column["name"] == name)
            .unwrap();
        numbers(&found["values"])
    };
    for leg in 1..=3 {
        let [normal, friction] =
            ["normal", "friction"].map(|kind| column(&format!("pad_{kind}_{leg}_lb")));
        let forces = told["drawing"]["instants"]["legs"][leg - 1]["pad_force"]
            .as_array()
            .unwrap();
        let up = numbers(&told["drawing"]["ground"]["normal"]);
        for (index, force) in forces.iter().enumerate() {
            let force = numbers(force);
            let along: f64 = force.iter().zip(&up).map(|(f, n)| f * n).sum();
            let all: f64 = force.iter().map(|part| part * part).sum::<f64>().sqrt();
            assert!(
                (along - normal[index]).abs() < 0.01 + 1e-5 * all,
                "{along} {}",
                normal[index]
            );
            let across = (all * all - along * along).max(0.0).sqrt();
            assert!(
                (across - friction[index].abs()).abs() < 0.2 + 1e-4 * all,
                "{across} {}",
                friction[index]
            );
        }
    }
}

#[test]
fn patches_are_where_the_feet_would_first_touch_them() {
    let told = landing(json!({"slope_deg": 12, "footing[2].height_ft": 0.5}));
    let ground = &told["drawing"]["ground"];
    let normal = numbers(&ground["normal"]);
    for patch in ground["patches"].as_array().unwrap() {
        let point = numbers(&patch["point"]);
        let height: f64 = normal.iter().zip(&point).map(|(n, p)| n * p).sum();
        let expected = if patch["leg"] == 2 { 0.5 } else { 0.0 };
        assert!((height - expected).abs() < 1e-5, "{patch}");
        assert_eq!(patch["is_even"], json!(patch["leg"] != 2));
    }
}

#[test]
fn events_come_in_order_and_end_with_the_verdict() {
    let told = landing(json!({"horizontal_velocity_fps": 12}));
    let events = told["events"].as_array().unwrap();
    let times: Vec<f64> = events
        .iter()
        .map(|event| event["time_s"].as_f64().unwrap())
        .collect();
    assert!(times.is_sorted());
    let last = events.last().unwrap();
    assert_eq!(
        (&last["kind"], &last["time_s"]),
        (&json!("verdict"), &told["end_time_s"])
    );
    assert!(
        last["title"]
            .as_str()
            .unwrap()
            .starts_with("unstable-pitch: its CG passed")
    );
}

#[test]
fn events_name_the_leg_that_bottoms_and_a_failure_of_the_computation() {
    let ends = |values: Value| -> Vec<(Value, Value)> {
        let told = landing(values);
        let events = told["events"].as_array().unwrap().iter();
        events
            .map(|event| (event["kind"].clone(), event["leg"].clone()))
            .filter(|(kind, _)| {
                ["bottomed", "failure", "verdict"].contains(&kind.as_str().unwrap())
            })
            .collect()
    };
    let short = ends(json!({"vehicle.legs[2].strut.minimum_length_ft": 3.0}));
    assert_eq!(short, [(json!("bottomed"), json!(2))]);
    // The ground reaches into the body.
    let high = ends(json!({"footing[2].block_height_ft": 4}));
    assert_eq!(high, [(json!("failure"), Value::Null)]);
}

#[test]
fn every_slider_end_is_a_landing_or_a_complaint_about_other_numbers() {
    let parameters = ask("parameters", &json!({})).unwrap();
    let parameters = parameters["parameters"].as_array().unwrap();
    assert!(parameters.len() > 100);
    for parameter in parameters
        .iter()
        .filter(|one| one["slider"].is_object() && one["leg"] != 3)
    {
        let (name, slider) = (parameter["name"].as_str().unwrap(), &parameter["slider"]);
        let value = parameter["value"].as_f64().unwrap();
        let [from, to] = ["from", "to"].map(|end| slider[end].as_f64().unwrap());
        assert!(from <= value && value <= to, "{name}");
        // The other form of the attitude wants all of its angles.
        if name.starts_with("tip") || name == "nominal_roll_deg" {
            continue;
        }
        for end in [from, to] {
            let request =
                json!({"touchdown": {"values": {(name): end}}, "history": false, "drawing": false});
            if let Err(complaint) = ask("landing", &request) {
                let depends = [
                    "angle of the extended link",
                    "below strut",
                    "can span",
                    "stands between",
                    "polygon",
                    "positive definite",
                    "sum of the other two",
                    "from another leg",
                    "legs surround",
                ];
                let allowed = complaint.allowed.unwrap_or_default();
                assert!(
                    depends.iter().any(|words| allowed.contains(words)),
                    "{name} = {end}: {}",
                    complaint.message
                );
            }
        }
    }
}

#[test]
fn every_setting_of_the_solver_is_told_and_whether_it_is_given() {
    let settings = |values: Value| -> Vec<(String, Value, bool)> {
        let told = ask("parameters", &json!({"touchdown": {"values": values}})).unwrap();
        let told = told["parameters"].as_array().unwrap().iter();
        told.filter(|one| one["group"] == "solver")
            .map(|one| {
                let name = one["name"].as_str().unwrap().to_owned();
                (name, one["value"].clone(), one["is_given"] == true)
            })
            .collect()
    };
    let own = settings(json!({}));
    let names: Vec<&str> = own.iter().map(|(name, ..)| name.as_str()).collect();
    for name in ["tolerance", "time_limit_s", "stop", "crush_rule"] {
        assert!(
            names.contains(&format!("solver.{name}").as_str()),
            "{names:?}"
        );
    }
    assert!(own.iter().all(|(_, _, is_given)| !is_given), "{own:?}");
    let given = settings(json!({"solver.stop": "time", "solver.tolerance": 1e-7}));
    let changed: Vec<_> = given.iter().filter(|one| !own.contains(one)).collect();
    let expected = [
        ("solver.tolerance".to_owned(), json!(1e-7), true),
        ("solver.stop".to_owned(), json!("time"), true),
    ];
    assert_eq!(changed.len(), 2, "{changed:?}");
    assert!(expected.iter().all(|one| given.contains(one)), "{given:?}");
}

#[test]
fn no_number_is_a_negative_zero() {
    for values in [
        json!({}),
        json!({"roll_deg": -90}),
        json!({"pitch_deg": -10}),
        json!({"yaw_deg": 10}),
        json!({"tip_deg": 10, "tip_azimuth_deg": 0}),
        json!({"tip_deg": 10, "tip_azimuth_deg": 180, "nominal_roll_deg": 0}),
    ] {
        let request = json!({"touchdown": {"values": values}}).to_string();
        let told = answer(&NAMED, "parameters", &request, &|| false).unwrap();
        assert!(!told.contains(":-0.0,"), "{values}");
    }
}

#[test]
fn the_longest_time_limit_is_allowed() {
    let touchdown = json!({"values": {"solver.time_limit_s": 1000}});
    let request = json!({"touchdown": touchdown, "interval_s": 1, "drawing": false});
    assert_eq!(ask("landing", &request).unwrap()["class"], "stable");
}

#[test]
fn what_is_never_allowed_is_refused() {
    let parameters = ask("parameters", &json!({})).unwrap();
    for parameter in parameters["parameters"].as_array().unwrap() {
        let (name, allowed) = (parameter["name"].as_str().unwrap(), &parameter["allowed"]);
        if !parameter["words"].as_array().unwrap().is_empty()
            || name.starts_with("tip")
            || name == "nominal_roll_deg"
        {
            continue;
        }
        assert_ne!(parameter["meaning"], "", "{name}");
        for (end, is_open) in [("lower", "is_lower_open"), ("upper", "is_upper_open")] {
            let bound = allowed[end].as_f64().unwrap();
            let outward = if end == "lower" { -1.0 } else { 1.0 };
            let beyond = match allowed[is_open].as_bool().unwrap() {
                true => bound,
                false => bound + outward * bound.abs().max(1.0) * 1e-3,
            };
            let request = json!({"touchdown": {"values": {(name): beyond}}, "history": false, "drawing": false});
            let complaint =
                (ask("landing", &request).map(drop)).expect_err(&format!("{name} = {beyond}"));
            assert!(complaint.key.is_some(), "{name}: {}", complaint.message);
        }
    }
}

#[test]
fn a_lander_has_the_numbers_of_its_kind_of_legs() {
    let of = |file: &str| -> Vec<(String, String)> {
        let told = answer(&named(&[file]), "parameters", "{}", &|| false).unwrap();
        let told: Value = serde_json::from_str(&told).unwrap();
        let text = |one: &Value, key: &str| one[key].as_str().unwrap().to_owned();
        let all = told["parameters"].as_array().unwrap().iter();
        all.map(|one| (text(one, "name"), text(one, "group")))
            .collect()
    };
    let cantilever = of("sweeps/vehicles/apollo-like.toml");
    for (name, group) in [
        ("vehicle.linkage.collar_ft", "linkage"),
        ("vehicle.primary.damping_lb_s_per_ft", "primary"),
        ("vehicle.primary.compression_load.scale", "primary"),
        ("vehicle.secondary.hardpoint_spread_ft", "secondary"),
        ("vehicle.legs[4].secondary.tension_load.scale", "secondary"),
        ("vehicle.footpad.diameter_ft", "footpad"),
    ] {
        let found = cantilever.iter().find(|(known, _)| known == name);
        assert_eq!(
            found.map(|(_, group)| group.as_str()),
            Some(group),
            "{name}"
        );
    }
    let absent = |name: &str| !cantilever.iter().any(|(known, _)| known == name);
    assert!(absent("vehicle.primary.tension_load.scale"));
    assert!(absent("vehicle.strut.spring_profile.scale"));
    let hinged = of("sweeps/vehicles/four-legs.toml");
    assert!(
        hinged
            .iter()
            .all(|(_, group)| group != "primary" && group != "secondary")
    );
}

#[test]
fn a_value_in_si_is_the_same_value() {
    let si = landing(
        json!({"vertical_velocity_mps": 4.2672, "vehicle.strut.preload_n": 822.9209988231925}),
    );
    let us = landing(json!({"vertical_velocity_fps": 14, "vehicle.strut.preload_lb": 185}));
    assert_eq!(si["report"]["result"], us["report"]["result"]);
}

#[test]
fn a_vehicle_begins_with_a_touchdown_that_it_survives() {
    for (file, vertical) in [
        ("sweeps/vehicles/surveyor-table-4-1.toml", Some(14.0)),
        ("sweeps/vehicles/four-legs.toml", None),
        ("sweeps/vehicles/six-legs.toml", None),
    ] {
        let named = named(&[file]);
        let told = answer(&named, "landing", "{}", &|| false).unwrap();
        let told: Value = serde_json::from_str(&told).unwrap();
        assert_eq!(told["class"], "stable", "{file}: {}", told["outcome"]);
        let source = &named.sources[0];
        let speed = source.conditions.get("vertical_velocity_fps").unwrap();
        assert!(
            vertical.is_none_or(|vertical| speed == vertical),
            "{file}: {speed}"
        );
        assert!(
            speed <= 14.0 && source.search[1] >= 1.5 * speed,
            "{file}: {speed}"
        );
    }
}

/// On soil its numbers are sliders, and a pad stands in its print: crushed by its own crush alone, as deep below the surface as
/// it has sunk. A scene file to take away lands alike.
#[test]
fn a_pad_stands_in_its_print() {
    let told = |values: &Value| {
        let answer = ask("parameters", &json!({"touchdown": {"values": values}})).unwrap();
        let parameters = answer["parameters"].as_array().unwrap();
        let names = parameters.iter().map(|one| one["name"].as_str().unwrap());
        let of_soil = names.filter(|name| name.starts_with("soil."));
        of_soil.map(str::to_owned).collect::<Vec<_>>()
    };
    let rock = json!({"horizontal_velocity_fps": 5});
    let soil = json!({
        "horizontal_velocity_fps": 5, "soil.bearing_strength_psf": 440, "soil.bearing_depth_ft": 0.16, "soil.rebound": 0.004,
    });
    assert_eq!(told(&rock), [""; 0]);
    assert_eq!(told(&soil).len(), 5);
    let depth = |values: &Value, key: &str| {
        let answer = landing(values.clone());
        let all = answer["drawing"]["instants"]["legs"][0][key]
            .as_array()
            .unwrap();
        let depths = numbers(&all[all.len() - 1]);
        depths[0].max(depths[1])
    };
    let [on_rock, on_soil] = [&rock, &soil].map(|values| depth(values, "pad_interference"));
    assert!(
        on_rock > 0.02 && on_soil < 0.5 * on_rock,
        "{on_rock} {on_soil}"
    );
    let files = ask("scene_file", &json!({"touchdown": {"values": soil}})).unwrap();
    assert!(
        files.to_string().contains("bearing_strength_psf = 440"),
        "{files}"
    );
}
