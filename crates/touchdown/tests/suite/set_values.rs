//! `--set KEY=VALUE` of `land` and `sweep`: the same as changing the input file, and strict.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{BASELINE, Bench, SURVEYOR, SWEEP};

/// A vehicle file with another preload.
fn other_preload() -> String {
    let changed = SURVEYOR.replace("preload_lb = 185", "preload_lb = 200");
    assert_ne!(changed, SURVEYOR);
    changed
}

#[test]
fn a_landing_with_a_set_value_is_that_of_a_changed_vehicle_file() {
    let bench = Bench::new();
    bench.write("other.toml", &other_preload());
    let changed: Vec<&str> = (BASELINE.iter())
        .map(|word| {
            if *word == "surveyor.toml" {
                "other.toml"
            } else {
                word
            }
        })
        .collect();
    let expected = bench.run(&[&changed[..], &["--history", "a.csv"]].concat());
    assert_eq!(expected.code, Some(0), "{}", expected.err);
    let set = [
        "--set",
        "vehicle.strut.preload_lb=200",
        "--history",
        "b.csv",
    ];
    let done = bench.run(&[&BASELINE[..], &set].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("a.csv"), bench.read("b.csv"));
    let change = "with vehicle.strut.preload_lb = 200\n";
    assert_eq!(done.out.replace(change, ""), expected.out);
    assert_ne!(done.out, expected.out);

    // The same in newtons: 200 lb to the last digit.
    let set = ["--set", "vehicle.strut.preload_n=889.6443230521"];
    let done = bench.run(&[&BASELINE[..], &set].concat());
    let change = "with vehicle.strut.preload_n = 889.6443230521\n";
    assert_eq!(done.out.replace(change, ""), expected.out);
    let steep = [
        &BASELINE[..],
        &["--set", "tip_rad=4", "--set", "tip_azimuth_deg=0"],
    ]
    .concat();
    bench
        .run(&steep)
        .refused(&["--set tip_rad=4: expected 0", "(in deg: this is 229.183)"]);

    // What the file leaves out: a CG downhill of the centreline topples a lander that stands otherwise.
    let outcome = |set: &[&str]| {
        let done = bench.run(&[&BASELINE[..], set].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        done.out.contains("unstable-pitch")
    };
    assert!(!outcome(&[]));
    assert!(outcome(&[
        "--set",
        "vehicle.center_of_gravity_offset_y_ft=-0.4"
    ]));

    // A condition of the touchdown, instead of its option.
    let expected = bench.run(&[&BASELINE[..], &["--roll", "20"]].concat());
    let done = bench.run(&[&BASELINE[..], &["--set", "roll_deg=20"]].concat());
    assert_eq!((done.code, done.out), (Some(0), expected.out));
}

#[test]
fn a_table_of_cases_starts_from_the_set_values() {
    let bench = Bench::new();
    bench.write("other.toml", &other_preload());
    let cases = "vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction,\
                 vehicle.strut.preload_lb\n14,11,180,15,1,\n14,11,180,15,1,150\n";
    bench.write("cases.csv", cases);
    for (vehicle, out, set) in [
        ("other.toml", "a.csv", &[][..]),
        (
            "surveyor.toml",
            "b.csv",
            &["--set", "vehicle.strut.preload_lb=200"],
        ),
    ] {
        let run = [
            "land",
            "--vehicle",
            vehicle,
            "--cases",
            "cases.csv",
            "--out",
            out,
        ];
        let done = bench.run(&[&run[..], set].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    assert_eq!(bench.read("a.csv"), bench.read("b.csv"));
}

#[test]
fn a_sweep_with_set_values_is_that_of_changed_files_also_when_merged() {
    let changed = SWEEP
        .replace("friction = 1.0", "friction = 0.9")
        .replace("to_fps = 12.5", "to_fps = 15");
    let files = Bench::new();
    files.write("surveyor.toml", &other_preload());
    files.write("sweep.toml", &changed);
    let done = files.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let expected = files.read("results/sweep.csv");

    let bench = Bench::new();
    let set = [
        "--set",
        "vehicle.strut.preload_lb=200",
        "--set",
        "friction=0.9",
        "--set",
        "search.to_fps=15",
    ];
    let done = bench.run(&[&["sweep", "sweep.toml", "--out", "set"][..], &set].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("set/sweep.csv"), expected);
    for shard in ["1/2", "2/2"] {
        let run = ["sweep", "sweep.toml", "--out", "parts", "--shard", shard];
        let done = bench.run(&[&run[..], &set].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let done = bench.run(&["merge", "parts"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.read("parts/sweep.csv"), expected);
    assert_eq!(bench.read("parts/sweep.json"), bench.read("set/sweep.json"));
}

#[test]
fn a_set_number_of_the_solver_is_its_option() {
    let bench = Bench::new();
    let told = |more: &[&str]| {
        let done = bench.run(&[&BASELINE[..], more, &["--json"]].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let told: serde_json::Value = serde_json::from_str(&done.out).unwrap();
        [told["result"].clone(), told["solver"].clone()]
    };
    let set = [
        "--set",
        "solver.tolerance=1e-8",
        "--set",
        "solver.rules=physical",
    ];
    assert_eq!(
        told(&set),
        told(&["--tolerance", "1e-8", "--rules", "physical"])
    );
    // The method is one of them, with its own numbers.
    let set = [
        "--set",
        "solver.method=rk4",
        "--set",
        "solver.interval_s=0.001",
    ];
    assert_eq!(
        told(&set),
        told(&["--method", "rk4", "--fixed-interval", "0.001"])
    );
}

#[test]
fn words_of_the_search_can_be_set() {
    let bench = Bench::new();
    bench.write("sweep.toml", SWEEP);
    let words = "bands = \"all\"\ncertainty = \"none\"\nrefinement = \"bisection\"\n";
    bench.write("changed.toml", &format!("{SWEEP}{words}"));
    let run = |more: &[&str]| {
        let done = bench.run(&[&["sweep", "--out", "out"], more].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
    };
    run(&["changed.toml"]);
    let set = ["bands=all", "certainty=none", "refinement=bisection"];
    let set: Vec<String> = set
        .iter()
        .map(|one| format!("--set=search.{one}"))
        .collect();
    let set: Vec<&str> = set.iter().map(String::as_str).collect();
    run(&[&["sweep.toml"][..], &set].concat());
    for end in ["", "-bands"] {
        let [set, changed] =
            ["sweep", "changed"].map(|stem| bench.read(&format!("out/{stem}{end}.csv")));
        assert_eq!(set, changed);
    }
}

#[test]
#[rustfmt::skip]
fn what_cannot_be_set_is_refused() {
    let bench = Bench::new();
    for (set, fragments) in [
        (&["--set", "vehicle.strut.preloed_lb=200"][..], &["did you mean vehicle.strut.preload_lb"][..]),
        (&["--set", "slope_deg=95"], &["--slope", "slope_deg=95"]),
        (&["--set", "vehicle.mass_slug=-1"], &["--set vehicle.mass_slug=-1", "mass_slug = -1"]),
        (&["--set", "roll_deg=1", "--set", "roll_deg=2"], &["roll_deg=2", "twice"]),
        (&["--set", "solver.tolerance=1"], &["--set solver.tolerance = 1", "1e-12 ≤ value ≤ 1e-2"]),
        (&["--set", "search.to_fps=1"], &["search.to_fps=1", "or the solver"]),
        (&["--set", "solver.rules=physical", "--method", "rk4"], &["solver.rules=physical", "solver.method"]),
        (&["--set", "tip_deg=9", "--set", "tip_azimuth_deg=0", "--pitch", "3"], &["not both"]),
    ] {
        bench.run(&[&BASELINE[..], set].concat()).refused(fragments);
    }
    for (set, fragment) in [
        ("roll_deg=1", "varies"),
        ("horizontal_velocity_fps=1", "searches"),
        ("vehicle.mass_slug=0", "mass_slug = 0"),
        ("slope_deg=95", "slope_deg"),
        ("search.to_fps=1", "to_fps = 1"),
        ("search.certainty=some", "one of doubtful, all, none"),
    ] {
        bench.run(&["sweep", "sweep.toml", "--set", set]).refused(&[fragment]);
    }
    assert_eq!(bench.list("."), ["surveyor.toml", "sweep.toml"]);
}

#[test]
fn every_condition_has_an_option_that_does_what_set_does() {
    let bench = Bench::new();
    let help = bench.run(&["land", "--help"]).out;
    let history = |words: &[&str], file: &str| {
        let done = bench.run(&[&["land", "--vehicle", "surveyor.toml"], words].concat());
        assert_eq!(done.code, Some(0), "{words:?}: {}", done.err);
        bench.read(file)
    };
    let given = [
        ("--vertical-velocity", "vertical_velocity_fps", "9"),
        (
            "--horizontal-velocity-mps",
            "horizontal_velocity_mps",
            "1.5",
        ),
        ("--cross-slope", "cross_slope_deg", "150"),
        ("--slope", "slope_deg", "-5"),
        ("--friction", "friction", "0.7"),
        ("--block-friction", "block_friction", "0.3"),
        ("--pitch", "pitch_deg", "-2"),
        ("--yaw", "yaw_deg", "3"),
        ("--roll", "roll_deg", "20"),
        ("--gravity-mps2", "gravity_mps2", "3.71"),
    ];
    let rates = [
        ("angular_velocity_x_dps", "4"),
        ("angular_velocity_y_dps", "-5"),
        ("angular_velocity_z_dps", "6"),
    ];
    let mut options: Vec<&str> = (given.iter())
        .flat_map(|(option, _, value)| [*option, value])
        .collect();
    options.extend(["--angular-velocity", "4,-5,6", "--history", "options.csv"]);
    let named = given.iter().map(|(_, name, value)| (*name, *value));
    let set: Vec<String> = (named.chain(rates))
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    let mut words: Vec<&str> = set.iter().flat_map(|one| ["--set", one]).collect();
    words.extend(["--history", "set.csv"]);
    assert_eq!(history(&options, "options.csv"), history(&words, "set.csv"));

    for option in [
        "--vertical-velocity-mps",
        "--gravity",
        "--tip",
        "--tip-azimuth",
        "--nominal-roll",
    ] {
        assert!(help.contains(&format!("{option} <")), "{option}");
    }
    let both = [&BASELINE[..], &["--vertical-velocity-mps", "3"]].concat();
    bench
        .run(&both)
        .refused(&["--vertical-velocity-mps", "cannot be used with"]);
    let light = [&BASELINE[..], &["--gravity-mps2", "-1"]].concat();
    bench.run(&light).refused(&[
        "--gravity-mps2 = -1: expected 0 < value ≤ 1e9",
        "(in ft/s2: this is",
    ]);
}
