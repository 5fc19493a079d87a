//! The surface from impact times, on the command line.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use crate::common::{Bench, Done};

fn surface(bench: &Bench, options: &[&str]) -> Done {
    let common = ["surface", "--vehicle", "surveyor.toml", "--friction", "0.8"];
    bench.run(&[&common[..], options].concat())
}

/// Contact times of a landing on a slope of 10 deg, drifting across it.
fn impact_times(bench: &Bench) -> String {
    let done = bench.run(&[
        "land",
        "--vehicle",
        "surveyor.toml",
        "--vertical-velocity",
        "12",
        "--horizontal-velocity",
        "4",
        "--cross-slope",
        "150",
        "--slope",
        "10",
        "--roll",
        "-20",
        "--friction",
        "0.8",
        "--tolerance",
        "1e-10",
        "--json",
    ]);
    let result: serde_json::Value = serde_json::from_str(&done.out).unwrap();
    let time = |leg: usize| result["result"][format!("pad_contact_{leg}_s")].to_string();
    [time(1), time(2), time(3)].join(",")
}

#[test]
fn a_landing_tells_its_slope() {
    let bench = Bench::new();
    let times = impact_times(&bench);
    // V_H 4 ft/s at cross-slope 150 deg, in ground axes.
    let options = [
        "--velocity",
        "-2,-3.4641016151377544,12",
        "--roll",
        "-20",
        "--impact-times",
        &times,
    ];
    let done = surface(&bench, &options);
    assert_eq!(done.code, Some(0), "{}", done.err);
    for expected in [
        "ground slope                 10.000000 deg",
        "cross-slope                  150.000000 deg",
        "roll                         -20.000000 deg",
        "horizontal velocity          4.000000 ft/s",
    ] {
        assert!(done.out.contains(expected), "{expected}:\n{}", done.out);
    }
}

#[test]
fn timing_errors_give_standard_deviations_in_proportion() {
    let bench = Bench::new();
    let times = impact_times(&bench);
    let deviation = |sigma: &str| -> (f64, f64) {
        let options = [
            "--velocity",
            "-2,-3.4641016151377544,12",
            "--roll",
            "-20",
            "--impact-times",
            &times,
            "--timing-sigma",
            sigma,
            "--samples",
            "10",
            "--json",
        ];
        let done = surface(&bench, &options);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let result: serde_json::Value = serde_json::from_str(&done.out).unwrap();
        assert_eq!(result["timing"]["with_a_surface"], 10);
        let number = |key: &str| result["timing"][key].as_f64().unwrap();
        (number("slope_sigma_deg"), number("cross_slope_sigma_deg"))
    };
    let (slope, cross_slope) = deviation("0.0005");
    let (finer, _) = deviation("0.00005");
    // Pads 6.5 ft from the centre fall at 12 ft/s: 0.5 ms are hundredths of a degree.
    assert!((0.01..0.2).contains(&slope), "{slope}");
    assert!((0.05..2.0).contains(&cross_slope), "{cross_slope}");
    assert!((slope / finer - 10.0).abs() < 0.5, "{slope} {finer}");
}

#[test]
fn what_cannot_be_is_refused() {
    let bench = Bench::new();
    let velocity = ["--velocity", "0,3,12", "--impact-times"];
    surface(&bench, &[&velocity[..], &["0,-0.1,0.2"]].concat())
        .refused(&["--impact-times = -0.1: expected 0 ≤ value ≤ 100"]);
    let upward = ["--velocity", "0,3,-12", "--impact-times", "0,0.1,0.2"];
    surface(&bench, &upward).refused(&["--velocity = -12"]);
    let sigma = [&velocity[..], &["0,0.1,0.2", "--timing-sigma", "0"]].concat();
    surface(&bench, &sigma).refused(&["--timing-sigma = 0: expected 0 < value ≤ 100"]);
}

/// Impact times so uncertain that most samples have no surface, and take as long as any may.
#[cfg(unix)]
#[test]
fn many_samples_show_their_progress_and_can_be_interrupted() {
    let bench = Bench::new();
    let options = [
        "surface",
        "--vehicle=surveyor.toml",
        "--velocity=0.182,13.496,0.497",
        "--impact-times=0.293,0.244,0.184",
        "--friction=0.228",
        "--pitch=0.489",
        "--angular-velocity=0.77,0.069,0.347",
        "--timing-sigma=0.6",
        "--samples=100000",
    ];
    let mut command = bench.command(&options);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut surface = command.spawn().unwrap();
    let mut told = BufReader::new(surface.stderr.take().unwrap());
    let mut line = String::new();
    told.read_line(&mut line).unwrap();
    assert!(line.contains("/100000 samples, about "), "{line}");
    let kill = Command::new("kill")
        .args(["-INT", &surface.id().to_string()])
        .status();
    assert!(kill.unwrap().success());
    assert_eq!(surface.wait().unwrap().code(), Some(130));
}

/// Options, exit code, and what is said.
#[rustfmt::skip]
const ANSWERS: [(&[&str], i32, &[&str]); 6] = [
    (&["--velocity", "0,3,12", "--impact-times", "0,0,0"], 0, &[
        "ground slope                 0.000000 deg",
        "cross-slope                  none: level ground or no horizontal motion",
        "rotation to ground axes      none: on level ground any axes serve",
        "pitch                        0.000000 deg",
    ]),
    (&["--velocity", "0,0,12", "--impact-times", "0,0.1,0.1"], 0, &[
        "cross-slope                  none: level ground or no horizontal motion",
        "horizontal velocity          0.000000 ft/s",
    ]),
    (&["--velocity", "0,3,12", "--impact-times", "0,0.1,50"], 1, &["wall, steeper than 85 deg"]),
    (&["--velocity", "0,3,12", "--pitch", "90", "--impact-times", "0,0,0"], 1, &["wall"]),
    (&["--velocity", "0,3,14", "--impact-times", "0,1,1"], 1, &[
        "footpad 2 never touches the surface that the impact times suggest",
        "s after first contact",
    ]),
    (&["--velocity", "0,0,0", "--impact-times", "0,0,0"], 1, &["stable-subsided 0.000 s after first contact"]),
];

#[test]
fn what_has_no_direction_or_no_surface_is_told_clearly() {
    let bench = Bench::new();
    for (options, code, fragments) in ANSWERS {
        let done = surface(&bench, options);
        assert_eq!(
            done.code,
            Some(code),
            "{options:?}: {}{}",
            done.out,
            done.err
        );
        let told = if code == 0 { &done.out } else { &done.err };
        for fragment in fragments {
            assert!(told.contains(fragment), "{fragment} is not in: {told}");
        }
        assert_eq!(done.out.is_empty(), code != 0, "{}", done.out);
    }
}
