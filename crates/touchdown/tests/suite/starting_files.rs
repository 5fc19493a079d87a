//! Files to start from, completions and manual pages, and how many threads there may be.

use crate::common::{BASELINE, Bench, Done, SWEEP};

#[test]
fn new_files_are_valid_as_written_and_never_replace_another() {
    for units in ["US", "SI"] {
        check_new_files(units);
    }
}

/// Checks the input of all points; landings that end at once, so that their sample takes no time.
fn dry_run(bench: &Bench, sweep: &str) -> Done {
    bench.run(&[
        "sweep",
        sweep,
        "--dry-run",
        "--set",
        "solver.time_limit_s=0.01",
    ])
}

fn check_new_files(units: &str) {
    let bench = Bench::new();
    for (kind, file) in [
        ("vehicle", "lander.toml"),
        ("sweep", "trade.toml"),
        ("scene", "touchdown.toml"),
    ] {
        let done = bench.run(&["new", kind, file, "--units", units]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        assert!(bench.read(file).starts_with("# "), "{file} says what it is");
        let written = bench.read(file);
        bench
            .run(&["new", kind, file])
            .refused(&[file, "exists: expected"]);
        assert_eq!(bench.read(file), written);
    }
    let counted = dry_run(&bench, "trade.toml");
    assert_eq!(counted.code, Some(0), "{}", counted.err);
    let landed = bench.run(&["land", "touchdown.toml", "--out", "landings"]);
    assert_eq!(landed.code, Some(0), "{}", landed.err);
    let cases = bench.list("landings");
    assert!(
        cases.contains(&"touchdown-softer.csv".to_owned()),
        "{cases:?}"
    );
    // Nothing is left in the other units.
    let [other, own] = match units {
        "US" => [["_mps", "_n"], ["_fps", "_lb"]],
        _ => [["_fps", "_lb"], ["_mps", "_n"]],
    };
    for file in ["trade.toml", "touchdown.toml"] {
        let text = bench.read(file);
        assert!(own.iter().all(|ending| text.contains(ending)), "{text}");
        assert!(
            !other
                .iter()
                .any(|ending| text.contains(&format!("{ending} "))),
            "{text}"
        );
    }
    let history = bench.read("landings/touchdown-softer.csv");
    assert_eq!(history.starts_with("t_s,x_m,"), units == "SI");
}

#[test]
fn new_sweeps_name_the_vehicle_that_is_given() {
    let bench = Bench::new();
    let done = bench.run(&["new", "sweep", "of.toml", "--vehicle", "surveyor.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let counted = dry_run(&bench, "of.toml");
    assert_eq!(counted.code, Some(0), "{}", counted.err);
    bench
        .run(&["new", "scene", "no-such-folder/scene.toml"])
        .refused(&["no-such-folder/scene.toml", "cannot be written"]);
}

#[test]
fn new_vehicles_land_alike_in_either_unit() {
    let bench = Bench::new();
    let landed = ["US", "SI"].map(|units| {
        let file = format!("{units}.toml");
        let done = bench.run(&["new", "vehicle", &file, "--units", units]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let named = bench.read(&file).contains("mass_kg = ");
        assert_eq!(named, units == "SI");
        let landed = bench.run(&[&["land", "--vehicle", &file], &BASELINE[3..]].concat());
        assert_eq!(landed.code, Some(0), "{}", landed.err);
        // All but the name of the vehicle.
        landed.out.split_once('\n').unwrap().1.to_owned()
    });
    assert_eq!(landed[0], landed[1]);
}

#[test]
fn new_vehicles_have_the_struts_and_legs_that_are_asked_for() {
    let bench = Bench::new();
    for (kind, legs) in [("honeycomb", 3), ("honeycomb", 8), ("damper", 7)] {
        let file = format!("{kind}-{legs}.toml");
        let done = bench.run(&[
            "new",
            "vehicle",
            &file,
            "--kind",
            kind,
            "--legs",
            &legs.to_string(),
        ]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let text = bench.read(&file);
        assert!(
            text.contains(&format!("name = \"Lander with {legs} legs\"")),
            "{text}"
        );
        assert_eq!(text.contains("[strut.crush_load]"), kind == "honeycomb");
        let landed = bench.run(&[
            "land",
            "--vehicle",
            &file,
            "--vertical-velocity",
            "6",
            "--horizontal-velocity",
            "1",
            "--cross-slope",
            "180",
            "--slope",
            "5",
            "--friction",
            "0.5",
            "--json",
        ]);
        assert_eq!(landed.code, Some(0), "{}", landed.err);
        assert!(
            landed.out.contains(&format!("\"pad_contact_{legs}_s\"")),
            "{}",
            landed.out
        );
        assert!(
            !landed
                .out
                .contains(&format!("\"pad_contact_{}_s\"", legs + 1))
        );
    }
    for (kind, legs) in [
        ("tripod", 3),
        ("cantilever", 4),
        ("tripod", 5),
        ("cantilever", 3),
    ] {
        let file = format!("{kind}-{legs}.toml");
        let count = legs.to_string();
        let options = match (kind, legs) {
            ("tripod", 3) | ("cantilever", 4) => &["--kind", kind][..],
            _ => &["--kind", kind, "--legs", &count],
        };
        let done = bench.run(&[&["new", "vehicle", &file], options].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let text = bench.read(&file);
        assert!(text.contains(&format!("\nkind = \"{kind}\"")), "{text}");
        assert_eq!(text.matches("[[legs]]").count(), legs);
        let sweep = SWEEP.replace("surveyor.toml", &file);
        bench.write("of.toml", &sweep);
        let counted = dry_run(&bench, "of.toml");
        assert_eq!(counted.code, Some(0), "{}", counted.err);
    }
    let done = bench.run(&["new", "vehicle", "four.toml", "--kind", "honeycomb"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(bench.read("four.toml").contains("azimuth_deg = 270"));
    let ask = |options: &[&str]| bench.run(&[&["new", "vehicle", "none.toml"], options].concat());
    ask(&["--kind", "honeycomb", "--units", "US"])
        .refused(&["--units = US", "SI with --kind honeycomb"]);
    ask(&["--kind", "tripod", "--units", "US"]).refused(&["--units = US", "SI with --kind tripod"]);
    ask(&["--legs", "9"]).refused(&["--legs", "3..=8"]);
    assert!(!bench.list(".").contains(&"none.toml".to_owned()));
}

#[test]
fn shells_and_manuals_know_every_command() {
    let bench = Bench::new();
    for shell in ["bash", "zsh", "fish"] {
        let done = bench.run(&["completions", shell]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        assert!(done.out.contains("import-deck"), "{shell}");
    }
    let page = bench.run(&["man"]).out;
    assert!(
        page.contains(".TH touchdown 1") && page.contains("import\\-deck"),
        "{page}"
    );
    let page = bench.run(&["man", "sweep"]).out;
    assert!(page.contains("dry\\-run"), "{page}");
    bench.run(&["man", "swep"]).refused(&["swep", "sweep"]);
}

#[test]
fn more_threads_than_a_machine_bears_are_refused() {
    let bench = Bench::new();
    bench.write("cases.csv", "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,pitch_deg,yaw_deg,roll_deg,slope_deg,friction\na,14,5,180,0,0,0,15,1\n");
    let sweep = [
        "sweep",
        "sweep.toml",
        "--out",
        "results",
        "--threads",
        "5000",
    ];
    bench.run(&sweep).refused(&["5000", "expected 1 to"]);
    assert_eq!(bench.list("results"), Vec::<String>::new());
    let done = bench.land_cases(&["out.csv", "--threads", "5000"]);
    done.refused(&["5000", "expected 1 to"]);
    // However few cores there are, some more threads than cores do no harm.
    let done = bench.run(&[
        "sweep",
        "sweep.toml",
        "--out",
        "results",
        "--quiet",
        "--threads",
        "16",
    ]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(bench.run(&BASELINE).code, Some(0));
}
