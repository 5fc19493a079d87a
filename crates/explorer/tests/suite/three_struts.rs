//! Landers on legs of three struts.

use serde_json::{Value, json};
use touchdown_explorer::interface::answer;
use touchdown_explorer::named::Named;

use crate::common::{distance, in_ground, named, numbers, of_table};

fn cantilever() -> Named {
    named(&["sweeps/vehicles/apollo-like.toml"])
}

/// The same lander with its secondary struts at the feet.
fn tripod() -> Named {
    let text = include_str!("../../../../sweeps/vehicles/apollo-like.toml");
    let is_kept = |line: &&str| !line.starts_with("collar_m") && !line.starts_with("bearing_");
    let lines = text.lines().filter(is_kept);
    let text: Vec<&str> = lines.collect();
    of_table(
        "tripod.toml",
        &text.join("\n").replace("\"cantilever\"", "\"tripod\""),
    )
}

#[test]
fn the_drawing_is_of_one_piece() {
    const ROUNDING: f64 = 1e-5;
    let values = json!({"vertical_velocity_fps": 6, "pitch_deg": -5, "horizontal_velocity_fps": 4, "slope_deg": 6,
                        "footing[2].height_ft": 0.4, "footing[3].tilt_along_deg": 8,
                        "vehicle.center_of_gravity_offset_x_ft": 0.2});
    let request = json!({"touchdown": {"values": values}, "units": "US"}).to_string();
    for (lander, has_collar) in [(cantilever(), true), (tripod(), false)] {
        let told = answer(&lander, "landing", &request, &|| false).unwrap();
        let told: Value = serde_json::from_str(&told).unwrap();
        let drawing = &told["drawing"];
        let (vehicle, instants) = (&drawing["vehicle"], &drawing["instants"]);
        assert_eq!(vehicle["ring"], json!([1, 2, 3, 4]));
        let count = instants["time_s"].as_array().unwrap().len();
        assert!(count > 50, "{}", told["outcome"]);
        let feet = &instants["critical_edge"][0];
        let [from, to] = [0, 1].map(|end| feet[end].as_u64().unwrap());
        assert_eq!(to, from % 4 + 1, "an edge joins neighbours: {feet}");
        let columns = told["history"]["columns"].as_array().unwrap();
        let column = |name: String| -> Vec<f64> {
            let found = columns.iter().find(|column| column["name"] == name);
            numbers(&found.unwrap_or_else(|| panic!("{name}"))["values"])
        };
        for leg in 0..4 {
            let (shape, moves) = (&vehicle["legs"][leg], &instants["legs"][leg]);
            let struts = shape["struts"].as_array().unwrap();
            assert_eq!((struts.len(), &shape["link_length"]), (3, &Value::Null));
            let ground = &drawing["ground"]["patches"][leg];
            let [point, normal] = ["point", "normal"].map(|key| numbers(&ground[key]));
            let forces =
                ["normal", "friction"].map(|kind| column(format!("pad_{kind}_{}_lb", leg + 1)));
            let mut most = 0.0_f64;
            for index in 0..count {
                let pivot = numbers(&moves["pivot"][index]);
                let primary = in_ground(instants, index, &struts[0]["from"]);
                for (k, strut) in struts.iter().enumerate() {
                    let collar = strut["collar"].as_f64();
                    assert_eq!(collar.is_some(), has_collar && k > 0);
                    let part = collar.map_or(1.0, |collar| collar / distance(&primary, &pivot));
                    let end: Vec<f64> = primary
                        .iter()
                        .zip(&pivot)
                        .map(|(from, to)| from + part * (to - from))
                        .collect();
                    let length = distance(&in_ground(instants, index, &strut["from"]), &end);
                    let stroke = moves["strokes"][index][k].as_f64().unwrap();
                    let rest = strut["length"].as_f64().unwrap();
                    assert!(
                        (length + stroke - rest).abs() < ROUNDING,
                        "{leg} {k} {index}"
                    );
                    most = most.max(stroke.abs());
                }
                // Flat on the ground under it, as deep as the pad is high less the foot's height.
                let axis = numbers(&moves["pad_axis"][index]);
                assert!(axis.iter().zip(&normal).all(|(a, n)| *a == -n));
                let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
                let height = dot(&normal, &pivot) - dot(&normal, &point);
                let deep = shape["footpad"]["height"].as_f64().unwrap() - height;
                let interference = moves["pad_interference"][index][0].as_f64().unwrap();
                assert!(
                    (deep.max(0.0) - interference).abs() < 1e-4,
                    "{deep} {interference}"
                );
                let force = numbers(&moves["pad_force"][index]);
                let along = dot(&force, &normal);
                let across = (dot(&force, &force) - along * along).max(0.0).sqrt();
                let slack = 0.2 + 1e-4 * along;
                assert!((along - forces[0][index]).abs() < slack);
                assert!((across - forces[1][index]).abs() < slack);
            }
            assert!(most > 0.01, "leg {leg} has no stroke: {most}");
        }
    }
}

#[test]
fn every_request_about_a_touchdown_is_answered() {
    let touchdown = json!({"values": {"horizontal_velocity_fps": 3, "solver.time_limit_s": 0.3}});
    let axes = ["slope_deg", "vehicle.primary.damping_lb_s_per_ft"];
    let lander = cantilever();
    let ask = |name: &str, request: Value| -> Value {
        let answered = answer(&lander, name, &request.to_string(), &|| false);
        let told = answered.unwrap_or_else(|complaint| panic!("{name}: {}", complaint.message));
        serde_json::from_str(&told).unwrap()
    };
    ask("inputs", json!({}));
    for name in ["parameters", "scene_file", "history_file", "command"] {
        ask(name, json!({"touchdown": touchdown}));
    }
    ask(
        "strip",
        json!({"touchdown": touchdown, "from_fps": 1, "to_fps": 2, "most": 2}),
    );
    ask(
        "bands",
        json!({"touchdown": touchdown, "from_fps": 1, "to_fps": 2}),
    );
    let mut table = String::new();
    for damping in [100, 200] {
        let place = [3, damping];
        let request = json!({"touchdown": touchdown, "axes": axes, "place": place, "from_fps": 1, "to_fps": 2});
        let told = ask("boundary", request);
        let [heading, row] = ["heading", "row"].map(|key| told[key].as_str().unwrap());
        if table.is_empty() {
            table = format!("{heading}\n");
        }
        table += &format!("{row}\n");
    }
    let computed =
        json!({"touchdown": touchdown, "axes": axes, "from_fps": 1, "to_fps": 2, "table": table});
    ask("map", json!({"computed": computed}));
    ask("table_file", json!({"computed": computed}));
    let place = json!({"slope_deg": 3, "vehicle.primary.damping_lb_s_per_ft": 100});
    ask("at", json!({"computed": computed, "place": place}));
}
