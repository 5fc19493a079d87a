//! Strips, which fill in from request to request.

#![allow(missing_docs, reason = "tests are not an interface")]

use serde_json::{Value, json};

use crate::common::{NAMED, ask};

#[test]
fn a_strip_fills_in_until_it_is_done() {
    let mut known: Vec<Value> = Vec::new();
    let mut rounds = 0;
    let bands = loop {
        let told = ask(
            "strip",
            &json!({"known": known, "most": 16, "resolution_fps": 0.01}),
        )
        .unwrap();
        let new = told["landings"].as_array().unwrap();
        assert!(new.len() <= 16);
        for landing in new {
            assert!(
                known
                    .iter()
                    .all(|one| one["speed_fps"] != landing["speed_fps"])
            );
            known.push(json!({"speed_fps": landing["speed_fps"], "class": landing["class"]}));
        }
        rounds += 1;
        if told["is_done"] == true {
            break told["bands"].clone();
        }
        assert!(rounds < 50);
    };
    let bands = bands.as_array().unwrap();
    assert_eq!(bands[0]["from_fps"], 0.0);
    assert_eq!(bands.last().unwrap()["to_fps"], 25.0);
    assert!(
        bands
            .windows(2)
            .all(|pair| pair[0]["to_fps"] == pair[1]["from_fps"])
    );
    assert!((bands[0]["to_fps"].as_f64().unwrap() - 11.4).abs() < 0.02);

    let found = ask("bands", &json!({})).unwrap();
    let first = &found["first_transition"];
    assert_eq!(
        (&first["to"], &first["certainty"]),
        (&json!("unstable"), &json!("certain"))
    );
    assert!((first["speed_fps"].as_f64().unwrap() - 11.4).abs() < 0.002);
    assert_eq!(found["bands"].as_array().unwrap().len(), bands.len());
    assert_eq!(first["patchy"], json!(null));
    assert!(
        first["stable_landings_below"].as_u64().unwrap() > 20,
        "{first}"
    );

    // At a roll of −35 deg a stable sliver lies just above the transition.
    let rolled = json!({"touchdown": {"values": {"roll_deg": -35}}});
    let first = &ask("bands", &rolled).unwrap()["first_transition"];
    let patchy = &first["patchy"];
    let [landings, not_stable] =
        ["landings", "not_stable"].map(|name| patchy[name].as_u64().unwrap());
    assert!(0 < not_stable && not_stable < landings, "{first}");
    assert!(patchy["to_fps"].as_f64() > first["speed_fps"].as_f64());
}

#[test]
fn the_first_landings_of_a_strip_are_spread_over_its_range() {
    let request = json!({"from_fps": 0, "to_fps": 32, "most": 5});
    let told = ask("strip", &request).unwrap();
    let landings = told["landings"].as_array().unwrap();
    let speeds: Vec<&Value> = landings.iter().map(|one| &one["speed_fps"]).collect();
    assert_eq!(json!(speeds), json!([0.0, 8.0, 16.0, 24.0, 32.0]));
    assert_eq!(told["is_done"], false);
}

#[test]
fn nobody_waits_for_what_is_over() {
    use touchdown_explorer::interface::{Fault, answer};
    for name in ["landing", "history_file", "strip", "bands"] {
        let complaint = answer(&NAMED, name, "{}", &|| true).unwrap_err();
        assert_eq!(complaint.fault, Fault::Over);
    }
    // A landing that is under way is asked at every step.
    for name in ["landing", "history_file", "bands"] {
        let left = std::cell::Cell::new(20);
        let is_over = || left.replace(left.get() - 1) == 0;
        let complaint = answer(&NAMED, name, "{}", &is_over).unwrap_err();
        assert_eq!((complaint.fault, left.get()), (Fault::Over, -1), "{name}");
    }
}
