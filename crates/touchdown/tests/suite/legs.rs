//! Vehicles with other numbers of legs than the Surveyor's three, from their files to tables.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::fs;

use crate::common::{Bench, SWEEP};

/// The Surveyor with so many of its legs, evenly round the centreline.
fn ring(bench: &Bench, legs: usize) -> String {
    let surveyor = bench.read("surveyor.toml");
    let (body, _) = surveyor.split_once("[[legs]]").unwrap();
    let azimuths = (0..legs).map(|leg| 360.0 * leg as f64 / legs as f64);
    let legs_text = azimuths.map(|azimuth| format!("[[legs]]\nazimuth_deg = {azimuth}\n"));
    let name = format!("legs-{legs}.toml");
    bench.write(&name, &(body.to_owned() + &legs_text.collect::<String>()));
    name
}

const TOUCHDOWN: [&str; 10] = [
    "--vertical-velocity",
    "14",
    "--horizontal-velocity",
    "8",
    "--cross-slope",
    "170",
    "--slope",
    "15",
    "--friction",
    "1",
];

#[test]
fn landings_of_four_to_eight_legs_have_a_column_for_each() {
    let bench = Bench::new();
    for legs in [4, 6, 8] {
        let vehicle = ring(&bench, legs);
        let history = format!("history-{legs}.csv");
        let options = [
            "land",
            "--vehicle",
            &vehicle,
            "--json",
            "--history",
            &history,
        ];
        let done = bench.run(&[&options[..], &TOUCHDOWN].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let told: serde_json::Value = serde_json::from_str(&done.out).unwrap();
        assert!(told[format!("strut_work_{legs}_ftlb")].is_number());
        assert!(told.get(format!("strut_work_{}_ftlb", legs + 1)).is_none());
        let last = format!("pad_contact_{legs}_s");
        assert!(told["result"][&last].as_f64().unwrap() > 0.0, "{told}");
        let table = bench.read(&history);
        let heading = table.lines().next().unwrap();
        assert!(heading.contains(&format!("stroke_{legs}_ft")));
        assert!(!heading.contains(&format!("stroke_{}_ft", legs + 1)));
        let picture = format!("history-{legs}.svg");
        let drawn = bench.run(&["plot", &history, "--out", &picture]);
        assert_eq!(drawn.code, Some(0), "{}", drawn.err);
        let last = format!("leg {legs}");
        assert!(bench.read(&picture).contains(&last), "{last}");
    }
}

#[test]
fn a_leg_has_the_number_of_its_place_in_the_file_everywhere() {
    let bench = Bench::new();
    let surveyor = bench.read("surveyor.toml");
    let (body, _) = surveyor.split_once("[[legs]]").unwrap();
    let land = |azimuths: [f64; 3], leg: usize| {
        let legs = azimuths.map(|azimuth| format!("[[legs]]\nazimuth_deg = {azimuth}\n"));
        bench.write("vehicle.toml", &(body.to_owned() + &legs.concat()));
        // On a rock and with little stroke: it touches first and bottoms first.
        let height = format!("footing[{leg}].height_ft=3");
        let length = format!("vehicle.legs[{leg}].strut.minimum_length_ft=3.05");
        let options = ["land", "--vehicle", "vehicle.toml", "--json"];
        let set = ["--set", &height, "--set", &length];
        let done = bench.run(&[&options[..], &TOUCHDOWN, &set].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let told: serde_json::Value = serde_json::from_str(&done.out).unwrap();
        told["result"].clone()
    };
    let azimuths = [0.0, 120.0, 240.0];
    for (order, leg) in [([2, 0, 1], 1), ([2, 0, 1], 2), ([0, 2, 1], 3)] {
        let shuffled = land(order.map(|place| azimuths[place]), leg);
        let ordered = land(azimuths, order[leg - 1] + 1);
        assert_eq!(shuffled["outcome"], format!("bottomed-leg-{leg}"));
        let number = |told: &serde_json::Value, key: &str| told[key].as_f64().unwrap();
        assert!(number(&shuffled, &format!("pad_contact_{leg}_s")) < 1e-6);
        let ends = [&shuffled, &ordered].map(|told| number(told, "end_time_s"));
        assert!((ends[0] - ends[1]).abs() < 1e-6);
    }
}

#[test]
fn cases_with_different_numbers_of_legs_share_a_table() {
    let bench = Bench::new();
    let (four, six) = (ring(&bench, 4), ring(&bench, 6));
    bench.write(
        "cases.csv",
        &format!(
            "vehicle,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction,\
             vehicle.legs[4].azimuth_deg\n\
             {six},14,8,180,15,1,\n{four},14,8,180,15,1,280\n,14,8,180,15,1,\n"
        ),
    );
    let options = ["--cases", "cases.csv", "--out", "table.csv"];
    let done = bench.run(&[&["land", "--vehicle", "surveyor.toml"], &options[..]].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("table.csv");
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let heading = rows.headers().unwrap().clone();
    let column = |name: &str| heading.iter().position(|column| column == name).unwrap();
    let filled: Vec<Vec<bool>> = rows
        .records()
        .map(|row| {
            let row = row.unwrap();
            assert!(!row[column("energy_closure_ftlb")].is_empty());
            let force = |leg: usize| !row[column(&format!("max_strut_force_{leg}_lb"))].is_empty();
            (1..=6).map(force).collect()
        })
        .collect();
    let up_to = |legs: usize| (1..=6).map(|leg| leg <= legs).collect::<Vec<_>>();
    assert_eq!(filled, [up_to(6), up_to(4), up_to(3)]);
}

#[test]
fn a_sweep_may_vary_a_fourth_leg_and_no_fifth() {
    let bench = Bench::new();
    let four = ring(&bench, 4);
    let sweep = |leg: usize| {
        let axis = format!("\"vehicle.legs[{leg}].azimuth_deg\" = [270, 280]");
        SWEEP
            .replace("surveyor.toml", &four)
            .replace("roll_deg = { from = -10, to = 10, step = 10 }", &axis)
    };
    bench.write("sweep.toml", &sweep(4));
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("results/sweep.csv");
    assert!(table.starts_with("vehicle.legs[4].azimuth_deg,"), "{table}");
    // The Surveyor has no such leg.
    let other = ["sweep", "sweep.toml", "--vehicle", "surveyor.toml"];
    bench
        .run(&other)
        .refused(&["vehicle.legs[4].azimuth_deg: the vehicle has 3 legs"]);
    bench.write("sweep.toml", &sweep(5));
    bench
        .run(&["sweep", "sweep.toml"])
        .refused(&["vehicle.legs[5].azimuth_deg", "unknown parameter"]);
}

#[test]
fn two_legs_nine_legs_and_legs_that_are_not_there_are_refused() {
    let bench = Bench::new();
    for (legs, said) in [
        (2, "2 legs: expected three to eight"),
        (9, "9 legs: expected"),
    ] {
        let vehicle = ring(&bench, legs);
        let options = ["land", "--vehicle", &vehicle];
        bench
            .run(&[&options[..], &TOUCHDOWN].concat())
            .refused(&[said, &vehicle]);
    }
    let four = ring(&bench, 4);
    let options = [
        "land",
        "--vehicle",
        &four,
        "--set",
        "vehicle.legs[5].azimuth_deg=9",
    ];
    bench
        .run(&[&options[..], &TOUCHDOWN].concat())
        .refused(&["legs[5].azimuth_deg", "the vehicle has 4 legs"]);
    assert!(fs::exists(bench.path(&four)).unwrap());
}

#[test]
fn the_surface_is_found_from_the_times_of_four_pads() {
    let bench = Bench::new();
    let four = ring(&bench, 4);
    let surface = |times: &str| {
        let options = ["surface", "--vehicle", &four, "--velocity", "0,3,14"];
        let rest = ["--friction", "0.8", "--impact-times", times];
        bench.run(&[&options[..], &rest].concat())
    };
    let done = surface("0,0.1,0.21,0.1");
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.out.contains("ground slope"), "{}", done.out);
    surface("0,0.1,0.21").refused(&["--impact-times = 3: expected 4 times, one for each leg"]);
}
