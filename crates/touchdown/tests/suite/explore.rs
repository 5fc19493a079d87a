//! `touchdown explore`: its numbers are those of `touchdown land`, digit for digit.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::process::Stdio;

use serde_json::{Value, json};
use touchdown_explorer::interface::answer;
use touchdown_explorer::named::Named;
use touchdown_input::documents::library::{Library, Source};

use crate::common::{Bench, SURVEYOR};

/// Touchdowns that have something of everything.
const TOUCHDOWNS: [&str; 6] = [
    r#"{"horizontal_velocity_fps": 11.25}"#,
    r#"{"horizontal_velocity_fps": 11.5, "roll_deg": 10.1, "pitch_deg": -3}"#,
    r#"{"horizontal_velocity_mps": 3.3, "vehicle.strut.preload_n": 800, "vehicle.legs[2].strut.preload_lb": 170}"#,
    r#"{"tip_deg": 5, "tip_azimuth_deg": 30, "nominal_roll_deg": 4, "slope_deg": 20, "gravity_mps2": 3.71}"#,
    r#"{"footing[2].height_ft": 0.5, "footing[3].tilt_along_deg": -5, "angular_velocity_x_dps": 7,
        "soil.bearing_strength_kpa": 30, "soil.bearing_depth_m": 0.06, "soil.rebound": 0.01}"#,
    r#"{"friction": 0.3, "solver.tolerance": 1e-8, "solver.crush_rule": "section", "vertical_velocity_fps": 25}"#,
];

fn named() -> Named {
    let copies = [Source {
        path: PathBuf::from("surveyor.toml"),
        text: SURVEYOR.to_owned(),
    }];
    Named::read(
        &[PathBuf::from("surveyor.toml")],
        Library::Copies(&copies),
        None,
    )
    .unwrap()
}

fn ask(name: &str, request: &Value) -> Value {
    let answered = answer(&named(), name, &request.to_string(), &|| false);
    serde_json::from_str(&answered.unwrap()).unwrap()
}

fn touchdown(values: &str) -> Value {
    json!({"values": serde_json::from_str::<Value>(values).unwrap()})
}

#[test]
fn the_command_repeats_the_landing_and_its_history() {
    let bench = Bench::new();
    for (values, units) in TOUCHDOWNS.into_iter().zip(["US", "SI"].into_iter().cycle()) {
        let request = json!({"touchdown": touchdown(values), "units": units});
        let command = ask("command", &json!({"touchdown": touchdown(values)}))["command"].clone();
        let words: Vec<String> = (command.as_str().unwrap().split(' '))
            .map(|word| word.trim_matches('\'').to_owned())
            .collect();
        let mut arguments: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        arguments.extend([
            "--json",
            "--units",
            units,
            "--history",
            "history.csv",
            "--overwrite",
        ]);
        let done = bench.run(&arguments);
        assert_eq!(done.code, Some(0), "{command}: {}", done.err);
        let mut printed: Value = serde_json::from_str(&done.out).unwrap();
        let mut told = ask("landing", &request)["report"].clone();
        // The page sets everything by name, the command what it has no option for.
        for report in [&mut printed, &mut told] {
            report["set"] = Value::Null;
        }
        assert_eq!(format!("{told:#}"), format!("{printed:#}"), "{command}");
        let history = ask("history_file", &request)["files"][0]["text"].clone();
        assert_eq!(
            history.as_str().unwrap(),
            bench.read("history.csv"),
            "{command}"
        );
    }
}

#[test]
fn the_scene_file_repeats_the_landing() {
    let bench = Bench::new();
    for values in TOUCHDOWNS {
        let request = json!({"touchdown": touchdown(values)});
        for file in ask("scene_file", &request)["files"].as_array().unwrap() {
            bench.write(
                file["name"].as_str().unwrap(),
                file["text"].as_str().unwrap(),
            );
        }
        let done = bench.run(&["land", "touchdown.toml", "--out", "landed", "--overwrite"]);
        assert_eq!(done.code, Some(0), "{values}: {}", done.err);
        let history = ask("history_file", &request)["files"][0]["text"].clone();
        assert_eq!(
            history.as_str().unwrap(),
            bench.read("landed/touchdown-1.csv"),
            "{values}"
        );
    }
}

#[test]
fn columns_of_the_page_are_those_of_the_history_file() {
    let request = json!({"touchdown": touchdown(TOUCHDOWNS[2]), "units": "SI"});
    let file = ask("history_file", &request)["files"][0]["text"].clone();
    let mut reader = csv::Reader::from_reader(file.as_str().unwrap().as_bytes());
    let heading = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let told = ask("landing", &request);
    let columns = told["history"]["columns"].as_array().unwrap();
    assert_eq!(columns.len(), heading.len());
    for (place, column) in columns.iter().enumerate() {
        assert_eq!(column["name"], heading[place]);
        for (row, value) in rows.iter().zip(column["values"].as_array().unwrap()) {
            assert_eq!(row[place].parse::<f64>().ok(), value.as_f64());
        }
    }
}

#[test]
fn the_program_prints_an_address_that_answers() {
    let bench = Bench::new();
    let mut program = bench.command(&["explore", "surveyor.toml"]);
    let mut program = program.stdout(Stdio::piped()).spawn().unwrap();
    let mut url = String::new();
    let out = program.stdout.take().unwrap();
    BufReader::new(out).read_line(&mut url).unwrap();
    let (host, path) = url
        .trim()
        .strip_prefix("http://")
        .unwrap()
        .split_once('/')
        .unwrap();
    let mut stream = TcpStream::connect(host).unwrap();
    let request = format!("GET /{path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
    stream.write_all(request.as_bytes()).unwrap();
    let mut page = String::new();
    stream.read_to_string(&mut page).unwrap();
    program.kill().unwrap();
    program.wait().unwrap();
    assert!(page.starts_with("HTTP/1.1 200 OK"), "{page}");
    assert!(page.contains("<title>touchdown"), "{page}");
}

#[test]
fn a_token_in_a_file_keeps_the_address() {
    let bench = Bench::new();
    let begin = || {
        let mut program = bench.command(&["explore", "surveyor.toml", "--token-file", "token"]);
        let mut program = program.stdout(Stdio::piped()).spawn().unwrap();
        let mut url = String::new();
        let out = program.stdout.take().unwrap();
        BufReader::new(out).read_line(&mut url).unwrap();
        program.kill().unwrap();
        program.wait().unwrap();
        url.trim()
            .trim_end_matches('/')
            .rsplit_once('/')
            .unwrap()
            .1
            .to_owned()
    };
    let first = begin();
    assert_eq!(first.len(), 32);
    assert_eq!(bench.read("token").trim(), first);
    assert_eq!(begin(), first);
    bench.write("token", "short");
    bench
        .run(&["explore", "surveyor.toml", "--token-file", "token"])
        .refused(&["token", "16 to 128 letters and digits"]);
}

#[test]
fn a_page_is_exported_over_nothing_but_a_page() {
    let bench = Bench::new();
    let export = ["explore", "surveyor.toml", "--export", "page.html"];
    assert_eq!(bench.run(&export).code, Some(0));
    assert!(bench.read("page.html").starts_with("<!doctype html>"));
    assert_eq!(bench.run(&export).code, Some(0));
    bench.write("page.html", "mine");
    bench.run(&export).refused(&["page.html"]);
    assert_eq!(bench.read("page.html"), "mine");
    bench
        .run(&["explore", "surveyor.toml", "--export", "surveyor.toml"])
        .refused(&["surveyor.toml"]);
    let beside = "axis,from,to,landings\n";
    bench.write("beside.csv", beside);
    bench
        .run(&["explore", "beside.csv", "--export", "other.html"])
        .refused(&["beside.csv", "table of transitions or of landings"]);
    let done = bench.run(&[
        "explore",
        "surveyor.toml",
        "beside.csv",
        "--export",
        "other.html",
    ]);
    assert_eq!(done.code, Some(0));
    assert!(done.err.contains("beside.csv: skipped"), "{}", done.err);
    bench
        .run(&["explore", "nothing.toml"])
        .refused(&["nothing.toml"]);
}
